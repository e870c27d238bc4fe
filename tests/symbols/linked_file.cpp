// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// One of the two files of linked_main.cpp: built twice, with different switches and FACTS as the function's name.
#include "linked.hpp"

#include <array>

#include <sys/wait.h>
#include <unistd.h>

#include <rtuwire/wire/adu.hpp>
#include <rtuwire/wire/errc.hpp>

namespace {

/// Whether a child that reads a missing value is ended by a signal.
bool traps()
{
    pid_t const child = ::fork();
    if (child == 0) {
        rtuwire::result<unsigned> const none{rtuwire::errc::buffer_too_small};
        unsigned volatile value = *none;
        ::_exit(value == 0 ? 0 : 1);
    }
    int status = 0;
    return ::waitpid(child, &status, 0) == child and WIFSIGNALED(status);
}

} // namespace

facts FACTS()
{
    std::array<std::byte, 9> digits{};
    for (std::size_t i = 0; i < digits.size(); ++i) {
        digits[i] = static_cast<std::byte>('1' + i);
    }
    rtuwire::errc (*const check)(rtuwire::byte_view) noexcept = rtuwire::check_frame;
    return {rtuwire::crc16(digits), static_cast<unsigned>(rtuwire::detail::default_crc_form), RTUWIRE_CHECKED != 0,
            reinterpret_cast<void const*>(check), traps()};
}
