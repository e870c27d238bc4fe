// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// The module beside the doors that need an operating system: a blocking client asks a server over a pseudo-terminal, and
// a stream shows what it read.
#include <array>
#include <atomic>
#include <sstream>
#include <thread>

// Headers stand before the import, or after it with -DIMPORT_FIRST.
#ifndef IMPORT_FIRST
#include <rtuwire/port.hpp>
#include <rtuwire/print.hpp>
#endif

import rtuwire;

#ifdef IMPORT_FIRST
#include <rtuwire/port.hpp>
#include <rtuwire/print.hpp>
#endif

using namespace rtuwire;

namespace {

std::atomic<bool> has_missed{false};
inline constexpr reg<signed_decihertz> speed{.code = "SPEED", .address = 3};

struct meter {
    static constexpr literal name{"meter"};
    static constexpr function_set functions{read_holding_registers::code};
    static constexpr unit_range units{};
    static constexpr std::array<address_range, 0> readable{};
    static constexpr device_limits limits{};
    using registers = table<speed>;
};

} // namespace

// As with the headers, a program may define this hook.
void rtuwire::on_missing_value(rtuwire::errc) noexcept { has_missed = true; }

int main()
{
    constexpr line_timing timing = line_timing::host(19'200, character_format::even_8_1);
    pseudo_terminal far;
    posix_serial port;
    if (not far.open() or not port.open(far.path().c_str(), {.bits_per_second = 19'200})) {
        return 2;
    }
    std::atomic<bool> ends{false};
    std::thread serving{[&] {
        server node{unit_id{7}, timing};
        bank<speed> registers;
        registers.set<speed>(signed_decihertz{-52});
        while (not ends and serve_once(node, far, registers, milliseconds(20))) {
        }
    }};
    blocking_client line{port, timing};
    auto const value = line.run(read<speed>(station<meter>{unit_id{7}}));
    ends = true;
    serving.join();

    std::ostringstream shown;
    if (value) {
        shown << *value;
    } else {
        shown << value.error();
    }
    rtuwire::on_missing_value(errc::timed_out);
    return shown.str() == "-5.2 Hz" and has_missed ? 0 : 1;
}
