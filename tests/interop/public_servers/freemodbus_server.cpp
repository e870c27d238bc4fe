// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A server of FreeMODBUS with all of its functions, unit 1: freemodbus_server DEVICE. 128 of each, from address 0. The port is ours:
// one device, one timer, one event, in a loop; bytes are handed over one by one, each with the time when the system had it.
#include <array>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <cstdio>

#include <poll.h>
#include <unistd.h>

#include "freemodbus_port.hpp"
#include "serial_line.hpp"

namespace {

constexpr std::size_t size = 128;
std::array<USHORT, size> holding, input;
std::array<bool, size> coils, contacts;

int device = -1;
std::array<UCHAR, 512> came, left;
std::size_t came_size, next_byte, left_size;

std::uint32_t microseconds_now()
{
    auto const now = std::chrono::steady_clock::now().time_since_epoch();
    return static_cast<std::uint32_t>(std::chrono::duration_cast<std::chrono::microseconds>(now).count());
}

bool has(USHORT first, USHORT count) { return first >= 1 and first - 1U + count <= size; }

/// Addresses begin at 1 here.
eMBErrorCode serve_words(std::array<USHORT, size>& bank, UCHAR* bytes, USHORT first, USHORT count, bool reads)
{
    if (not has(first, count)) {
        return MB_ENOREG;
    }
    for (std::size_t at = first - 1U; count > 0; --count, ++at, bytes += 2) {
        if (reads) {
            bytes[0] = static_cast<UCHAR>(bank[at] >> 8);
            bytes[1] = static_cast<UCHAR>(bank[at]);
        } else {
            bank[at] = static_cast<USHORT>(bytes[0] << 8 | bytes[1]);
        }
    }
    return MB_ENOERR;
}

eMBErrorCode serve_bits(std::array<bool, size>& bank, UCHAR* bytes, USHORT first, USHORT count, bool reads)
{
    if (not has(first, count)) {
        return MB_ENOREG;
    }
    for (std::size_t i = 0; reads and i < (count + 7U) / 8U; ++i) {
        bytes[i] = 0;
    }
    for (std::size_t i = 0; i < count; ++i) {
        auto const mask = static_cast<UCHAR>(1U << i % 8U);
        if (not reads) {
            bank[first - 1U + i] = (bytes[i / 8] & mask) != 0;
        } else if (bank[first - 1U + i]) {
            bytes[i / 8] = static_cast<UCHAR>(bytes[i / 8] | mask);
        }
    }
    return MB_ENOERR;
}

/// What has come, until the timer is due; whether something had, however late this loop came to look.
bool hear()
{
    std::uint32_t const passed = microseconds_now() - since;
    std::uint32_t const rest = not is_timing ? 200'000 : passed < silence ? silence - passed : 0;
    pollfd waiting{device, POLLIN, 0};
    if (poll(&waiting, 1, static_cast<int>((rest + 999) / 1'000)) <= 0) {
        return false;
    }
    ssize_t const some = read(device, came.data(), came.size());
    came_size = some > 0 ? static_cast<std::size_t>(some) : 0;
    for (next_byte = 0; next_byte < came_size;) {
        pxMBFrameCBByteReceived();
    }
    return true;
}

} // namespace

BOOL xMBPortSerialPutByte(CHAR byte)
{
    left[left_size++] = static_cast<UCHAR>(byte);
    return TRUE;
}

BOOL xMBPortSerialGetByte(CHAR* to)
{
    *to = static_cast<CHAR>(came[next_byte++]);
    return TRUE;
}

eMBErrorCode eMBRegHoldingCB(UCHAR* bytes, USHORT first, USHORT count, eMBRegisterMode mode)
{
    return serve_words(holding, bytes, first, count, mode == MB_REG_READ);
}

eMBErrorCode eMBRegInputCB(UCHAR* bytes, USHORT first, USHORT count)
{
    return serve_words(input, bytes, first, count, true);
}

eMBErrorCode eMBRegCoilsCB(UCHAR* bytes, USHORT first, USHORT count, eMBRegisterMode mode)
{
    return serve_bits(coils, bytes, first, count, mode == MB_REG_READ);
}

eMBErrorCode eMBRegDiscreteCB(UCHAR* bytes, USHORT first, USHORT count)
{
    return serve_bits(contacts, bytes, first, count, true);
}

int main(int argc, char** argv)
{
    device = argc == 2 ? open_serial_line(argv[1]) : -1;
    if (device < 0 or eMBInit(MB_RTU, 1, 0, 19'200, MB_PAR_NONE, 1) != MB_ENOERR or eMBEnable() != MB_ENOERR) {
        std::fprintf(stderr, "FreeMODBUS cannot serve on the device\n");
        return 2;
    }
    std::puts("ready");
    std::fflush(stdout);
    for (;;) {
        if (not hear() and is_silent()) {
            pxMBPortCBTimerExpired();
        }
        while (has_event or is_sending) {
            eMBPoll();
            if (is_sending) {
                pxMBFrameCBTransmitterEmpty();
            }
        }
        if (left_size > 0) {
            static_cast<void>(write(device, left.data(), left_size) > 0);
            left_size = 0;
        }
    }
}
