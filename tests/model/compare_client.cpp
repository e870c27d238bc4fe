// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// The client against its model over random schedules: compare_client COUNT [SEED].
#include <rtuwire/client/client.hpp>
#include <rtuwire/client/statistics.hpp>

#include "compare_schedule.hpp"
#include "model_client.hpp"

using compare::both;
using compare::line_event;
using compare::outcome;
using compare::random_source;
using compare::report;
using model::bytes;
using model::microseconds;

namespace {

constexpr std::size_t rows = 3;
constexpr std::size_t slots = 4;

template <std::size_t Places, std::size_t Front, std::size_t Longest>
inline constexpr rtuwire::client_needs<rtuwire::public_functions, rtuwire::unit_statistics<rows>> needs{
    .longest_frame = Longest, .request_room = Front, .quarantine_places = Places};

template <typename Engine> struct world : compare::schedule {
    Engine engine;
    model::client second;
    Engine other_engine; ///< of another line, where nothing ever leaves
    model::client other_second;
    std::vector<both> conversations{slots};
    std::optional<microseconds> advanced{}; ///< the latest `advance`
    bool is_late{false}; ///< stopped, and not advanced since: times in force may lie further apart than the rules hold
    bool is_rested{false}; ///< nothing was due for hours: what begins before the next `advance` may end more than 71
                           ///< minutes after the one before

    world(random_source& with, report& to, compare::setting const& as, model::options const& options)
        : compare::schedule{with, to, as, options, 10}, engine{compare::timing(as), compare::library(options)},
          second{times, options}, other_engine{compare::timing(as), compare::library(options)}, other_second{times,
                                                                                                             options}
    {
        for (both& each : conversations) {
            each.engine.says.told = &engines_outcomes;
            each.second.says.told = &models_outcomes;
        }
    }

    void check()
    {
        if (told.is_told and not told.failed()) {
            tell_state(second.poll_deadline(), second.state(), second.request());
        }
        compare::same_outcomes(told, engines_outcomes, models_outcomes);
        told.same("busy", engine.is_busy(), second.is_busy());
        told.same("quiet", engine.is_quiet(), second.line().is_quiet);
        same_holds(engine, second);
        for (both const& each : conversations) {
            told.same(("asked by " + std::to_string(each.engine.says.id)).c_str(), engine.is_asked_by(each.engine),
                      second.is_asked_by(each.second.whose));
            told.same("how often next was called", each.engine.says.asked, each.second.says.asked);
        }
        compare::same_counts(told, engine.statistics(), second.counted);
        if (not is_late) {
            compare::same_deadline(told, engine.poll_deadline(), second.poll_deadline(), second.is_woken(),
                                   second.ended_at(), now, clock);
        }
    }

    void events()
    {
        while (has_event()) {
            auto const first = line.to_come.begin();
            microseconds const at = roll.chance(70) ? first->first : roll.chance(80) ? now : now + roll.below(3'000);
            line_event const what = first->second;
            line.to_come.erase(first);
            happen(engine, second, what, at);
            check();
        }
    }
    static std::optional<microseconds> earlier(std::optional<microseconds> one, std::optional<microseconds> other)
    {
        return one and other ? std::min(*one, *other) : (one ? one : other);
    }
    void advance()
    {
        step("advance");
        engine.advance(clock.at(now));
        second.advance(now);
        advanced = now;
        is_late = is_rested = false;
        check();
    }
    void pass_time()
    {
        auto const next = second.poll_deadline();
        std::optional<microseconds> const until = next_of(earlier(next, other_second.poll_deadline()));
        switch (roll.below(14)) {
        case 0: break;
        case 1: now += roll.below(3'000); break;
        case 2: now += times.t3_5 + roll.below(3) - 1; break;
        case 3: now += roll.below(60'000); break;
        case 4:
            if (not until and not second.is_woken()) {
                now += microseconds{roll.below(11'000)} * 1'000'000; // nothing is due for hours
                is_rested = true;
            }
            break;
        case 5:
            if (roll.chance(8) and std::max(how.response_timeout, how.late_response) < 10'000'000) {
                now += microseconds{roll.below(1'000)} * 1'000'000; // the program is stopped, whatever is due
                is_late = true;
                // For longer than the counter tells, but no whole turn, and what came meanwhile is lost.
                if (roll.chance(50) and advanced and now - *advanced < 1'001'000'000) {
                    now += microseconds{roll.any<unsigned>({20, 36, 50, 54})} * 60'000'000;
                    line.to_come.clear();
                    advance();
                }
            }
            break;
        default:
            if (until and *until > now and not second.is_woken()) {
                now = std::max(now, *until + (roll.chance(85) ? 0 : microseconds{roll.below(3)} - 1));
            }
        }
    }

    void begin(std::size_t index)
    {
        compare::procedure what = compare::any_procedure(roll);
        what.id = static_cast<int>(index);
        int const prompt =
            roll.chance(25) and what.requests[0].size() >= 4 and what.requests[0][0] != 0 ? what.requests[0][0] : -1;
        told.step("%lld begin %zu: %s, %zu requests%s%s, prompt %d", static_cast<long long>(now), index,
                  compare::hex(what.requests[0]).c_str(), what.requests.size(), what.is_endless ? " for ever" : "",
                  what.may_be_repeated ? "" : " once", prompt);
        conversations[index].say(what, prompt);
    }
    void interfere()
    {
        std::size_t const index = roll.below(slots);
        both& one = conversations[index];
        switch (roll.below(14)) {
        case 0:
            step("cancel");
            engine.cancel(clock.at(now));
            second.cancel(now);
            break;
        case 1:
            number_step("cancel of", static_cast<long long>(index));
            engine.cancel(one.engine, clock.at(now));
            second.cancel(one.second.whose, now);
            break;
        case 2: {
            auto const unit = static_cast<std::uint8_t>(1 + roll.below(compare::manual_unit::units));
            microseconds const end =
                now + (roll.chance(5) and not is_late and not is_rested ? model::longest
                                                                        : microseconds{roll.below(400'000)} - 20'000);
            told.step("%lld hold %d until %lld", static_cast<long long>(now), unit, static_cast<long long>(end));
            engine.hold(*rtuwire::unit_id::checked(unit), clock.at(end));
            second.hold(unit, end);
            break;
        }
        case 3: {
            number_step("another in the place of", static_cast<long long>(index));
            both fresh{};
            fresh.engine.says.told = &engines_outcomes;
            fresh.second.says.told = &models_outcomes;
            one = fresh;
            break;
        }
        case 4: {
            std::size_t const to = roll.below(slots);
            told.step("%lld copy %zu to %zu", static_cast<long long>(now), index, to);
            both const copied = one;
            conversations[to] = copied;
            conversations[to].engine.says.id = conversations[to].second.says.id = static_cast<int>(to);
            break;
        }
        case 5:
            number_step("forget", static_cast<long long>(index));
            one.forget();
            break;
        case 6:
            number_step("settle", static_cast<long long>(index));
            one.engine.says.is_settled = one.second.says.is_settled = true;
            break;
        case 7:
            number_step("think", static_cast<long long>(index));
            one.engine.says.is_thinking = one.second.says.is_thinking = not one.second.says.is_thinking;
            break;
        case 8: begin(index); break;
        case 9:
            begin(index);
            one.forget();
            break;
        case 10:
            number_step("at another line", static_cast<long long>(index));
            other_engine.converse(static_cast<compare::engine_conversation&>(one.engine), clock.at(now));
            other_second.converse(one.second, now, other_second.own_retry_policy(), -1);
            break;
        case 11:
            step("receive nothing");
            engine.receive({}, clock.at(now));
            second.receive({}, now);
            break;
        default: line.disturb(now); return;
        }
        check();
    }

    void converse(std::size_t index)
    {
        both& one = conversations[index];
        number_step("converse", static_cast<long long>(index));
        if (roll.chance(60)) {
            if (one.is_prompt()) {
                engine.converse(one.engine, clock.at(now));
            } else {
                engine.converse(static_cast<compare::engine_conversation&>(one.engine), clock.at(now));
            }
            second.converse(one.second, now);
        } else {
            model::retry_policy const with = compare::any_retry_policy(roll, how.response_timeout);
            rtuwire::retry_policy const same = compare::library(with);
            if (one.is_prompt()) {
                engine.converse(one.engine, clock.at(now), same);
            } else {
                engine.converse(static_cast<compare::engine_conversation&>(one.engine), clock.at(now), same);
            }
            second.converse(one.second, now, with);
        }
        check();
    }

    void pass()
    {
        pass_time();
        other_engine.advance(clock.at(now));
        other_second.advance(now);
        events();
        if (roll.chance(12)) {
            interfere();
        }
        if (roll.chance(96) or is_rested) {
            advance();
        }
        for (std::size_t i = 0; i < slots and not told.failed(); ++i) {
            if (conversations[i].second.settled() and roll.chance(15)) {
                begin(i);
            }
            if (roll.chance(conversations[i].second.settled() ? 50 : 94)) {
                converse(i);
            }
        }
        if (roll.chance(95)) {
            step("poll_transmit");
            bytes const frame = compare::copy(engine.poll_transmit());
            told.same("bytes to send", frame, second.poll_transmit());
            check();
            if (not frame.empty()) {
                line.hear(frame, now);
            }
        }
    }

    void run()
    {
        tell_times();
        told.step("front %zu, longest %zu, places %zu", how.front, how.longest, how.places);
        unsigned const passes = roll.chance(4) ? 250 : 20 + roll.below(41);
        for (unsigned i = 0; i < passes and not told.failed(); ++i) {
            pass();
        }
    }
};

template <std::size_t Places, std::size_t Front, std::size_t Longest = 256>
void schedule(random_source& roll, report& told, compare::setting const& as, model::options how)
{
    how.front = Front;
    how.longest = Longest;
    how.places = Places;
    how.rows = rows;
    world<rtuwire::basic_client<needs<Places, Front, Longest>>>{roll, told, as, how}.run();
}

} // namespace

int main(int argc, char** argv)
{
    return compare::main(argc, argv, [](random_source& roll, report& told) {
        compare::setting const as = compare::any_setting(roll);
        model::options const how = compare::any_options(roll);
        switch (roll.below(4)) {
        case 0: schedule<1, 8>(roll, told, as, how); break;
        case 1: schedule<3, 8>(roll, told, as, how); break;
        case 2: schedule<1, 12, 40>(roll, told, as, how); break;
        default: schedule<2, 256>(roll, told, as, how);
        }
    });
}
