// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Stands for the header of this name in raspberrypi/pico-sdk 2.2.0, of which it declares what the board's file calls.
// ../../../facts/pico_sdk.cpp holds it to that.
#pragma once

#include <stddef.h>
#include <stdint.h>

typedef unsigned int uint;
typedef uint64_t absolute_time_t;
