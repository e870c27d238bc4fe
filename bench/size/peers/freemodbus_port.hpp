// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// What a port of FreeMODBUS has on a board and on a host: one event, one timer, a transmitter, in a loop without interrupts. Whoever
// includes it, in one file, says what time it is, and moves the bytes.
#pragma once

#include <cstdint>

#include <mb.h>
#include <mbport.h>

namespace {

bool is_sending;
bool is_timing;
bool has_event;
std::uint32_t silence; ///< microseconds
std::uint32_t since;
eMBEventType event;

std::uint32_t microseconds_now();

bool is_silent() { return is_timing and microseconds_now() - since >= silence; }

} // namespace

BOOL xMBPortEventInit() { return TRUE; }

BOOL xMBPortEventPost(eMBEventType posted)
{
    event = posted;
    has_event = true;
    return TRUE;
}

BOOL xMBPortEventGet(eMBEventType* to)
{
    if (not has_event) {
        return FALSE;
    }
    *to = event;
    has_event = false;
    return TRUE;
}

BOOL xMBPortSerialInit(UCHAR, ULONG, UCHAR, eMBParity, UCHAR) { return TRUE; }

void vMBPortSerialEnable(BOOL, BOOL sends) { is_sending = sends != FALSE; }

BOOL xMBPortTimersInit(USHORT times_50_us)
{
    silence = times_50_us * 50U;
    return TRUE;
}

void vMBPortTimersEnable()
{
    since = microseconds_now();
    is_timing = true;
}

void vMBPortTimersDisable() { is_timing = false; }
