// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Reads registers of one or several units again and again, a line each time, for minutes or days: to a terminal, a pipe or
// a file.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "../support/signals.hpp"
#include "commands/commands.hpp"
#include "line/asked_less.hpp"
#include "line/asked_registers.hpp"
#include "line/asked_units.hpp"
#include "line/end_wish.hpp"
#include "line/reading.hpp"
#include "line/time_text.hpp"

namespace tool {

namespace {

using std::chrono::steady_clock;

class watching {
public:
    explicit watching(choices const& chosen, std::vector<named_unit> const& units)
        : chosen_{chosen}, line_{chosen.line}, results_{chosen.form, true}
    {
        std::vector<asked_registers> const all = registers_asked(chosen.words, units, line_);
        tell_left_out(all);
        for (asked_registers const& each : all) {
            units_.push_back({each});
        }
        for (std::size_t i = 0; i < units_.size(); ++i) {
            add_parts(i);
        }
    }

    exit_status run()
    {
        auto const began = steady_clock::now();
        for (part& each : parts_) {
            each.next = began;
        }
        while (not parts_.empty() and goes_on(began)) {
            read_due(began);
            show(std::chrono::duration<double>{steady_clock::now() - began}.count());
            wait_until(std::ranges::min(parts_, {}, &part::next).next, began);
        }
        results_.finish();
        return status();
    }

private:
    struct watched_unit {
        asked_registers asked;
        asked_less patience{1};
        std::string failure{}; ///< of the last round in which it was read
    };

    /// Registers of one unit and one period.
    struct part {
        std::size_t unit;
        std::chrono::duration<double> period;
        register_reader reader;
        unsigned long rounds{0};
        steady_clock::time_point next{};
        bool is_read{false}; ///< in this round
    };

    /// What --every says, else the register's group.
    double period_of(watched_unit const& unit, chosen_register const& which) const
    {
        named_group const* const group =
            which.named == nullptr ? nullptr : unit.asked.unit.names->group_named(which.named->group);
        return chosen_.every.value_or(group == nullptr ? 1.0 : group->period);
    }

    void add_parts(std::size_t which)
    {
        asked_registers const& asked = units_[which].asked;
        std::map<double, std::vector<chosen_register>> by_period;
        for (chosen_register const& each : asked.registers) {
            by_period[period_of(units_[which], each)].push_back(each);
        }
        for (auto& [period, registers] : by_period) {
            register_reader reader{registers, {asked.drive, asked.unit.names}};
            parts_.push_back({which, std::chrono::duration<double>{period}, std::move(reader)});
        }
    }

    void read_due(steady_clock::time_point began)
    {
        auto const now = steady_clock::now();
        std::vector<bool> is_read(units_.size(), false); // in this round
        for (part& each : parts_) {
            bool const is_due = each.next <= now;
            each.is_read = is_due and units_[each.unit].patience.is_due(steady_clock::now());
            if (is_due) {
                // Counted from the beginning: no round makes the next one late for good.
                auto const passed = each.period * static_cast<double>(++each.rounds);
                each.next = began + std::chrono::duration_cast<steady_clock::duration>(passed);
            }
            if (each.is_read) {
                read(each, not is_read[each.unit]);
                is_read[each.unit] = true;
            }
        }
    }

    /// The first that fails in a round is told.
    void read(part& one, bool is_first)
    {
        watched_unit& unit = units_[one.unit];
        one.reader.read(line_, unit.asked.unit.unit, has_several());
        rtuwire::errc const why = one.reader.first_error();
        if (is_first or unit.failure.empty()) {
            unit.failure = one.reader.first_failure();
        }
        bool const is_silent = has_several() and status_of(why) == exit_status::no_answer;
        unit.patience.note(not is_silent, steady_clock::now());
    }

    bool has_several() const { return units_.size() > 1; }

    /// What several units have each is told apart by the unit behind it.
    std::string column(std::string const& label, watched_unit const& of) const
    {
        return has_several() ? label + '@' + name_of(of.asked.unit) : label;
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
            line_.let_pass(std::min(left, std::chrono::microseconds{100'000}));
        }
    }

    void show(double seconds)
    {
        record line{{"time", time_text(unix_now())}, {"seconds", std::round(seconds * 1'000.0) / 1'000.0}};
        for (std::size_t i = 0; i < units_.size(); ++i) {
            add_unit(line, i);
        }
        results_.put(line);
    }

    void add_unit(record& line, std::size_t which) const
    {
        bool const is_table = chosen_.form == output_form::table;
        watched_unit const& unit = units_[which];
        for (chosen_register const& each : unit.asked.registers) {
            auto const of = std::ranges::find_if(parts_, [&](part const& one) {
                return one.unit == which and one.period.count() == period_of(unit, each);
            });
            reading const it = reading_of(each, of->reader, unit.asked.drive);
            line.add(column(it.label, unit), not of->is_read ? cell{} : is_table ? cell{it.text} : it.value);
            if (not is_table and has_measure(each)) {
                line.add(column(it.label, unit) + " measure", of->is_read ? cell{it.measure} : cell{});
            }
        }
        bool const is_read =
            std::ranges::any_of(parts_, [which](part const& one) { return one.unit == which and one.is_read; });
        std::string const why = unit.asked.failure                     ? unit.asked.failure->what()
                                : is_read or unit.patience.is_silent() ? unit.failure
                                                                       : std::string{};
        line.add(column("error", unit), why.empty() ? cell{} : cell{why});
    }

    /// Of the last time that each register was read; of several units that of the first which lacks something.
    exit_status status() const
    {
        for (std::size_t i = 0; i < units_.size(); ++i) {
            if (exit_status const its = status_of_unit(i); its != exit_status::done) {
                return its;
            }
        }
        return exit_status::done;
    }

    exit_status status_of_unit(std::size_t which) const
    {
        auto const lacks = std::ranges::find_if(parts_, [which](part const& one) {
            return one.unit == which and one.reader.first_error() != rtuwire::errc::none;
        });
        return units_[which].asked.failure ? units_[which].asked.failure->status
               : lacks == parts_.end()     ? exit_status::done
                                           : status_of(lacks->reader.first_error());
    }

    choices const& chosen_;
    open_line line_;
    std::vector<watched_unit> units_{};
    std::vector<part> parts_{};
    output results_;
};

} // namespace

exit_status run_watch(choices const& chosen)
{
    note_signals();
    take_suspension();
    exit_status const status = watching{chosen, units_asked(chosen.line)}.run();
    if (noted.suspend != 0) {
        // Asleep it would keep the device from the `stop` of whoever has suspended it: the line is closed by now.
        std::fputs("rtuwire: suspended, and the line is closed: this watch is over\n", stderr);
        suspend();
    }
    return status;
}

} // namespace tool
