// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Sixteen registers, served by functions 03, 06, 16 and 23 of FreeMODBUS, with its port: the board's UART, one timer and one event, in
// a loop without interrupts.
#include "../images/board.hpp"

#include <array>

#include "freemodbus_port.hpp"

namespace {

std::array<USHORT, 16> bank;

std::uint32_t microseconds_now() { return board::now().microseconds; }

} // namespace

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
        if (is_silent()) {
            pxMBPortCBTimerExpired();
        }
        eMBPoll();
    }
}
