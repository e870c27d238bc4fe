/* SPDX-FileCopyrightText: 2026 The rtuwire authors
   SPDX-License-Identifier: BSL-1.0
   The types and macros that FreeMODBUS asks of a port, for one without interrupts. */
#ifndef RTUWIRE_BENCH_PORT_H
#define RTUWIRE_BENCH_PORT_H

#include <assert.h>
#include <stdint.h>

#define PR_BEGIN_EXTERN_C extern "C" {
#define PR_END_EXTERN_C }
#define ENTER_CRITICAL_SECTION()
#define EXIT_CRITICAL_SECTION()

#define TRUE 1
#define FALSE 0

typedef uint8_t BOOL;
typedef unsigned char UCHAR;
typedef char CHAR;
typedef uint16_t USHORT;
typedef int16_t SHORT;
typedef uint32_t ULONG;
typedef int32_t LONG;

#endif
