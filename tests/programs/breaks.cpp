// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Runs a motor with the parts of the demo, and breaks: breaks DEVICE UNIT throw|missing|deep
#include <chrono>
#include <stdexcept>
#include <string>

#include "../../examples/support/command_line.hpp"
#include "../../examples/support/demonstration.hpp"

using namespace rtuwire;
using namespace examples;

namespace {

/// Uses the stack up.
int go_deeper(int depth)
{
    char volatile room[4'096];
    room[0] = static_cast<char>(depth);
    return depth < 0 ? 0 : go_deeper(depth + 1) + room[0];
}

void break_by(std::string const& how)
{
    if (how == "throw") {
        throw std::runtime_error{"on purpose"};
    }
    if (how == "missing") {
        result<int> const none{errc::timed_out};
        say("%d\n", *none);
    }
    if (how == "deep") {
        say("%d\n", go_deeper(0));
    }
}

} // namespace

void rtuwire::on_missing_value(rtuwire::errc) noexcept { emergency.stop_motor(); }

int main(int argc, char** argv)
{
    using device = altivar::atv320::device;
    auto const unit = argc == 4 ? number_in(argv[2]) : std::nullopt;
    posix_serial port;
    if (not unit or not port.open(argv[1])) {
        return 2;
    }
    stop_motor_before_dying();
    demonstration<device> demo{port, line_timing::host(19'200, character_format::even_8_1, milliseconds(5)),
                               station_at<device>(*unit, "atv320")};
    bool const runs =
        demo.take_command() and demo.start(altivar::run_direction::forward) and demo.watch(milliseconds(1'500));
    if (runs) {
        break_by(argv[3]);
    }
    return 1;
}
