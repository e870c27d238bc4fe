// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Sixteen registers, served by functions 03, 06, 16 and 23 of FreeMODBUS, with its port: the board's UART, one timer and one event, in
// a loop without interrupts.
#include "../images/board.hpp"

#include <array>

#include <mb.h>
#include <mbport.h>

namespace {

std::array<USHORT, 16> bank;

bool is_sending;
bool is_timing;
bool has_event;
std::uint32_t silence;
std::uint32_t since;
eMBEventType event;

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

BOOL xMBPortSerialPutByte(CHAR byte)
{
    board::put(static_cast<std::byte>(byte));
    return TRUE;
}

BOOL xMBPortSerialGetByte(CHAR* to)
{
    *to = static_cast<CHAR>(board::byte());
    return TRUE;
}

BOOL xMBPortTimersInit(USHORT times_50_us)
{
    silence = times_50_us * 50U;
    return TRUE;
}

void vMBPortTimersEnable()
{
    since = board::now().microseconds;
    is_timing = true;
}

void vMBPortTimersDisable() { is_timing = false; }

/// Addresses begin at 1 here.
eMBErrorCode eMBRegHoldingCB(UCHAR* bytes, USHORT first, USHORT count, eMBRegisterMode mode)
{
    if (first < 1 or first - 1 + count > static_cast<int>(bank.size())) {
        return MB_ENOREG;
    }
    for (USHORT* word = &bank[first - 1U]; count > 0; --count, ++word, bytes += 2) {
        if (mode == MB_REG_READ) {
            bytes[0] = static_cast<UCHAR>(*word >> 8);
            bytes[1] = static_cast<UCHAR>(*word);
        } else {
            *word = static_cast<USHORT>(bytes[0] << 8 | bytes[1]);
        }
    }
    return MB_ENOERR;
}

int main()
{
    eMBInit(MB_RTU, 1, 0, 19'200, MB_PAR_EVEN, 1);
    eMBEnable();
    for (;;) {
        if (board::has_byte()) {
            pxMBFrameCBByteReceived();
        }
        if (is_sending) {
            pxMBFrameCBTransmitterEmpty();
        }
        if (is_timing and board::now().microseconds - since >= silence) {
            pxMBPortCBTimerExpired();
        }
        eMBPoll();
    }
}
