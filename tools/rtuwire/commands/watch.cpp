// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Reads registers again and again, a line each time, for minutes or days: to a terminal, a pipe or a file.
#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <map>
#include <string>
#include <utility>
#include <vector>

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
        : chosen_{chosen}, line_{chosen.line}, asked_{registers_asked(chosen, line_)}, results_{chosen.form, true}
    {
        std::map<double, std::vector<chosen_register>> by_period;
        for (chosen_register const& each : asked_.registers) {
            by_period[period_of(each)].push_back(each);
        }
        for (auto& [period, registers] : by_period) {
            register_reader reader{registers, {asked_.drive, asked_.unit.names}};
            parts_.push_back({std::chrono::duration<double>{period}, std::move(reader)});
        }
    }

    exit_status run()
    {
        auto const began = steady_clock::now();
        for (part& each : parts_) {
            each.next = began;
        }
        while (goes_on(began)) {
            read_due(began);
            show(std::chrono::duration<double>{steady_clock::now() - began}.count());
            wait_until(std::ranges::min(parts_, {}, &part::next).next, began);
        }
        results_.finish();
        return status_of(last_error_);
    }

private:
    /// Registers of one period.
    struct part {
        std::chrono::duration<double> period;
        register_reader reader;
        unsigned long rounds{0};
        steady_clock::time_point next{};
        bool is_read{false}; ///< in this round
    };

    /// What --every says, else the register's group.
    double period_of(chosen_register const& which) const
    {
        named_group const* const group =
            which.named == nullptr ? nullptr : asked_.unit.names->group_named(which.named->group);
        return chosen_.every.value_or(group == nullptr ? 1.0 : group->period);
    }

    void read_due(steady_clock::time_point began)
    {
        auto const now = steady_clock::now();
        for (part& each : parts_) {
            each.is_read = each.next <= now;
            if (each.is_read) {
                each.reader.read(line_, asked_.unit.unit);
                // Counted from the beginning: no round makes the next one late for good.
                auto const passed = each.period * static_cast<double>(++each.rounds);
                each.next = began + std::chrono::duration_cast<steady_clock::duration>(passed);
            }
        }
    }

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
            part const& of =
                *std::ranges::find(parts_, period_of(each), [](part const& one) { return one.period.count(); });
            reading const it = reading_of(each, of.reader, asked_.drive);
            line.add(it.label, not of.is_read ? cell{} : is_table ? cell{it.text} : it.value);
        }
        auto const failed = std::ranges::find_if(
            parts_, [](part const& one) { return one.is_read and one.reader.first_error() != rtuwire::errc::none; });
        last_error_ = failed == parts_.end() ? rtuwire::errc::none : failed->reader.first_error();
        line.add("error", failed == parts_.end() ? cell{} : cell{failed->reader.first_failure()});
        results_.put(line);
    }

    choices const& chosen_;
    open_line line_;
    asked_registers asked_;
    std::vector<part> parts_{};
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
