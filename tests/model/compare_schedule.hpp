// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// What a random schedule of the client and one of the bus have in common: their random numbers and clock, the line with its
// units, what both engines told, and the steps as they are written down.
#pragma once

#include <rtuwire/wire/unit_id.hpp>

#include "compare_conversation.hpp"
#include "compare_line.hpp"
#include "compare_requests.hpp"

namespace compare {

struct schedule {
    random_source& roll;
    report& told;
    compare::clock clock;
    model::line_times times;
    model::options how;
    manual_unit line;
    microseconds now{0};
    std::vector<outcome> engines_outcomes{};
    std::vector<outcome> models_outcomes{};

    schedule(random_source& with, report& to, setting const& as, model::options const& options,
             unsigned percent_of_echoes)
        : roll{with}, told{to}, clock{as.start}, times{as.bits, as.bits_by_character, as.end, as.silence}, how{options},
          line{with, times, options.response_timeout, options.has_line_echo or with.chance(percent_of_echoes)}
    {}

    void step(char const* what, bytes const& of = {})
    {
        told.step("%lld %s %s", static_cast<long long>(now), what, hex(of).c_str());
    }
    void number_step(char const* what, long long number)
    {
        told.step("%lld %s %lld", static_cast<long long>(now), what, number);
    }
    void tell_times()
    {
        told.step("times: character %lld, t3.5 %lld, frame end %lld; R %lld, L %lld, turnaround "
                  "%lld, retries %u, echo %d, skip %u",
                  static_cast<long long>(times.character), static_cast<long long>(times.t3_5),
                  static_cast<long long>(times.frame_end), static_cast<long long>(how.response_timeout),
                  static_cast<long long>(how.late_response), static_cast<long long>(how.turnaround), how.retries,
                  how.has_line_echo, how.max_leading_noise);
    }
    /// What the model says of itself, behind the step that led there; only where steps are written down.
    void tell_state(std::optional<microseconds> next, std::string const& state, bytes const& request)
    {
        told.steps.back() += "  [next " + (next ? std::to_string(*next) : "never") + state + ", request " +
                             hex(request).substr(0, 24) + "]";
    }

    /// The same units are held; one more than there are, which is nobody's.
    template <typename Engine, typename Model> void same_holds(Engine const& engine, Model const& second)
    {
        for (std::uint8_t unit = 1; unit <= manual_unit::units + 1; ++unit) {
            told.same("held", engine.is_held(*rtuwire::unit_id::checked(unit)), second.is_held(unit));
        }
    }

    template <typename Engine, typename Model>
    void happen(Engine& engine, Model& second, line_event const& what, microseconds at)
    {
        switch (what.what) {
        case line_event::kind::chunk:
            step("receive", what.of);
            receive(engine, what.of, clock.at(now));
            second.receive(what.of, now);
            break;
        case line_event::kind::damage:
            step("receive_error");
            engine.receive_error(clock.at(now));
            second.receive_error(now);
            break;
        case line_event::kind::sent:
            number_step("sent at", at);
            engine.sent(clock.at(at));
            second.sent(at);
        }
    }
    bool has_event() const
    {
        return not line.to_come.empty() and line.to_come.begin()->first <= now and not told.failed();
    }
    /// When something has to be done, or the line does something.
    std::optional<microseconds> next_of(std::optional<microseconds> deadline) const
    {
        if (line.to_come.empty()) {
            return deadline;
        }
        microseconds const event = line.to_come.begin()->first;
        return deadline ? std::min(*deadline, event) : event;
    }
};

} // namespace compare
