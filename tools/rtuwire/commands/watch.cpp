// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Reads registers again and again, a line each time, for minutes or days: to a terminal, a pipe or a file.
#include <array>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <string>

#include "../support/signals.hpp"
#include "commands/commands.hpp"
#include "line/asked_registers.hpp"
#include "line/end_wish.hpp"
#include "line/reading.hpp"
#include "line/time_text.hpp"

namespace tool {

namespace {

using std::chrono::steady_clock;

class watching {
public:
    explicit watching(choices const& chosen)
        : chosen_{chosen}, line_{chosen.line}, asked_{registers_asked(chosen, line_)},
          reader_{asked_.registers, asked_.drive}, results_{chosen.form, true}
    {}

    exit_status run()
    {
        auto const began = steady_clock::now();
        std::chrono::duration<double> const period{chosen_.every.value_or(1.0)};
        for (unsigned long rounds = 0; goes_on(began); ++rounds) {
            reader_.read(line_, asked_.unit.unit);
            show(std::chrono::duration<double>{steady_clock::now() - began}.count());
            // Counted from the beginning: no round makes the next one late for good.
            auto const next =
                began + std::chrono::duration_cast<steady_clock::duration>(period * static_cast<double>(rounds + 1));
            wait_until(next, began);
        }
        results_.finish();
        return status_of(last_error_);
    }

private:
    bool is_over(steady_clock::time_point began) const
    {
        return chosen_.last and steady_clock::now() - began >= std::chrono::duration<double>{*chosen_.last};
    }
    bool goes_on(steady_clock::time_point began) const
    {
        return noted_signal() == 0 and noted.suspend == 0 and results_.is_open() and not is_over(began);
    }

    /// The port is read meanwhile, so that what arrives late is not taken for a response.
    void wait_until(steady_clock::time_point next, steady_clock::time_point began)
    {
        while (goes_on(began) and steady_clock::now() < next) {
            auto const left = std::chrono::ceil<std::chrono::microseconds>(next - steady_clock::now());
            auto const most = std::chrono::microseconds{100'000};
            auto const step = left < most ? left : most;
            std::array<std::byte, 256> place;
            auto const now = line_.port().now();
            auto const heard =
                line_.port().read(place, now + rtuwire::microseconds(static_cast<std::uint32_t>(step.count())));
            if (not heard) {
                throw ended{exit_status::port, line_.port().failure()};
            }
        }
    }

    void show(double seconds)
    {
        bool const is_table = chosen_.form == output_form::table;
        record line{{"time", time_text(unix_now())}, {"seconds", std::round(seconds * 1'000.0) / 1'000.0}};
        for (chosen_register const& each : asked_.registers) {
            reading const it = reading_of(each, reader_, asked_.drive);
            line.add(it.label, is_table ? cell{it.text} : it.value);
        }
        rtuwire::errc const why = reader_.first_error();
        last_error_ = why;
        line.add("error", why != rtuwire::errc::none ? cell{reader_.first_failure()} : cell{});
        results_.put(line);
    }

    choices const& chosen_;
    open_line line_;
    asked_registers asked_;
    register_reader reader_;
    output results_;
    rtuwire::errc last_error_{};
};

} // namespace

exit_status run_watch(choices const& chosen)
{
    note_signals();
    take_signal(SIGTSTP);
    exit_status const status = watching{chosen}.run();
    if (noted.suspend != 0) {
        // Asleep it would keep the device from the `stop` of whoever has suspended it: the line is closed by now.
        std::fputs("rtuwire: suspended, and the line is closed: this watch is over\n", stderr);
        suspend();
    }
    return status;
}

} // namespace tool
