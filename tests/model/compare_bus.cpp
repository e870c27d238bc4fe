// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// The bus against its model over random schedules: compare_bus COUNT [SEED].
#include <rtuwire/client/bus.hpp>
#include <rtuwire/client/statistics.hpp>

#include "compare_schedule.hpp"
#include "model_bus.hpp"

using compare::line_event;
using compare::outcome;
using compare::random_source;
using compare::report;
using model::bytes;
using model::microseconds;

namespace {

constexpr std::size_t rows = 3;
constexpr std::size_t slots = 4;
constexpr std::size_t first = slots; ///< from here on: the conversations that come before all slots
constexpr std::size_t all = first + 2;

/// Pauses between its requests, where `pause` is not zero.
struct pacing {
    microseconds pause{0};
    microseconds due{0};
    microseconds seen{0};
    bool is_waiting{false};
};

/// With the library. The bus is given the base that is of the conversation's kind: with a time of its own or not,
/// with a unit of its own or not.
struct plain : compare::engine_conversation {
    pacing pace{};
    compare::clock shown{0};
    microseconds const* now{nullptr};
    std::uint8_t own_unit{1};

    std::optional<rtuwire::request_frame> next()
    {
        says.is_thinking = pace.is_waiting;
        return compare::engine_conversation::next();
    }
    void accept(rtuwire::result<rtuwire::response> const& outcome)
    {
        compare::engine_conversation::accept(outcome);
        pace.is_waiting = pace.pause > 0;
        pace.due = pace.seen + pace.pause;
    }
};
struct timed : virtual plain {
    timed() = default;
    timed(timed const&) = default;
    timed& operator=(timed const&) = default;
    ~timed() = default;

    void advance(rtuwire::instant)
    {
        pace.seen = *now; // who sleeps for hours has a clock that does not wrap
        if (*now >= pace.due) {
            pace.is_waiting = false;
        }
    }
    rtuwire::deadline poll_deadline() const
    {
        return pace.is_waiting ? rtuwire::deadline{shown.at(pace.due)} : std::nullopt;
    }
};
struct prompt : virtual plain {
    static constexpr rtuwire::conversation_properties properties{.freshness = rtuwire::freshness::when_free};

    prompt() = default;
    prompt(prompt const&) = default;
    prompt& operator=(prompt const&) = default;
    ~prompt() = default;

    rtuwire::unit_id unit() const { return *rtuwire::unit_id::checked(own_unit); }
};
struct timed_prompt : timed, prompt {
    timed_prompt() = default;
    timed_prompt(timed_prompt const&) = default;
    timed_prompt& operator=(timed_prompt const&) = default;
    ~timed_prompt() = default;
};

struct model_conversation : model::bus_conversation {
    compare::procedure says{};
    pacing pace{};

    std::optional<model::request_frame> next() override
    {
        says.is_thinking = pace.is_waiting;
        bytes const* const frame = says.next();
        if (frame == nullptr) {
            return std::nullopt;
        }
        return model::request_frame{*frame, says.may_be_repeated};
    }
    void accept(model::fault error, bytes const& pdu) override
    {
        says.accept(error, pdu);
        pace.is_waiting = pace.pause > 0;
        pace.due = pace.seen + pace.pause;
    }
    bool settled() const override { return says.is_settled; }
    void advance(microseconds now) override
    {
        pace.seen = now;
        if (now >= pace.due) {
            pace.is_waiting = false;
        }
    }
    std::optional<microseconds> poll_deadline() const override
    {
        return pace.is_waiting ? std::optional{pace.due} : std::nullopt;
    }
};

/// One conversation with both; its kind may change when it begins anew.
struct both {
    timed_prompt engine{};
    model_conversation second{};

    template <typename Do> void as_its_kind(Do what)
    {
        if (second.prompt_unit >= 0 and second.is_timed) {
            what(engine);
        } else if (second.prompt_unit >= 0) {
            what(static_cast<prompt&>(engine));
        } else if (second.is_timed) {
            what(static_cast<timed&>(engine));
        } else {
            what(static_cast<plain&>(engine));
        }
    }
};

rtuwire::bus_options library(model::share const& of)
{
    return {static_cast<std::uint8_t>(of.silent_share), static_cast<std::uint8_t>(of.silent_after)};
}

struct world : compare::schedule {
    rtuwire::bus<slots, rtuwire::observed_by<rtuwire::unit_statistics<rows>>> engine;
    model::bus second;
    std::vector<both> conversations{all};
    std::optional<microseconds> advanced{}; ///< the latest `advance`
    bool is_rested{false}; ///< nothing was due for hours: what begins before the next `advance` may end more than 71
                           ///< minutes after the one before

    world(random_source& with, report& to, compare::setting const& as, model::options const& options,
          model::share const& share)
        : compare::schedule{with, to, as, options, 5},
          engine{compare::timing(as), compare::library(options), library(share)}, second{times, options, share, slots}
    {
        for (both& each : conversations) {
            clear(each);
        }
    }
    void clear(both& one)
    {
        one = both{};
        one.engine.shown = clock;
        one.engine.now = &now;
        one.engine.says.told = &engines_outcomes;
        one.second.says.told = &models_outcomes;
        one.engine.pace.seen = one.second.pace.seen = now;
    }

    void check()
    {
        if (told.is_told and not told.failed()) {
            tell_state(second.poll_deadline(), second.inner.state() + second.state(), second.inner.request());
        }
        compare::same_outcomes(told, engines_outcomes, models_outcomes);
        for (std::size_t i = 0; i < slots; ++i) {
            told.same(("silent " + std::to_string(i)).c_str(), engine.is_silent(i), second.is_silent(i));
        }
        same_holds(engine, second.inner);
        for (both const& each : conversations) {
            told.same(("how often next was called by " + std::to_string(each.second.says.id)).c_str(),
                      each.engine.says.asked, each.second.says.asked);
        }
        compare::same_counts(told, engine.statistics(), second.inner.counted);
        compare::same_deadline(told, engine.poll_deadline(), second.poll_deadline(), second.inner.is_woken(),
                               second.inner.ended_at(), now, clock);
    }

    void events()
    {
        while (has_event()) {
            auto const next = line.to_come.begin();
            microseconds const at = next->first;
            line_event const what = next->second;
            line.to_come.erase(next);
            happen(engine, second.inner, what, at);
            second.happened();
            check();
        }
    }
    void advance()
    {
        step("advance");
        engine.advance(clock.at(now));
        second.advance(now);
        advanced = now;
        is_rested = false;
        check();
    }
    void pass_time()
    {
        std::optional<microseconds> const until = next_of(second.poll_deadline());
        bool const may_sleep = not second.inner.is_woken();
        switch (roll.below(14)) {
        case 0: break;
        case 1: now += roll.below(3'000); break;
        case 2: now += roll.below(60'000); break;
        case 3:
            if (not until and may_sleep) {
                now += microseconds{roll.below(11'000)} * 1'000'000; // nothing is due for hours
                is_rested = true;
            } else if (roll.chance(5) and advanced and now - *advanced < 1'000'000 and
                       std::max(how.response_timeout, how.late_response) < 10'000'000) {
                // The program is stopped, whatever is due, but no whole turn, and what comes meanwhile is lost.
                now += microseconds{roll.below(1'000) + 60 * roll.any<unsigned>({0, 20, 36, 50, 54})} * 1'000'000;
                line.to_come.clear();
                advance();
            }
            break;
        default:
            if (until and *until > now and may_sleep) {
                now = std::max(now, *until + (roll.chance(85) ? 0 : microseconds{roll.below(3)} - 1));
            }
        }
    }

    void begin(std::size_t index)
    {
        both& one = conversations[index];
        compare::procedure what = compare::any_procedure(roll);
        what.id = static_cast<int>(index);
        std::uint8_t const unit = static_cast<std::uint8_t>(index >= first ? 0 : 1 + index);
        for (bytes& each : what.requests) {
            if (each.size() >= 4 and roll.chance(85)) {
                each.resize(each.size() - 2);
                each[0] = unit;
                each = model::with_crc(each);
            }
        }
        if (index >= first) {
            what.is_endless = false;
        }
        what.asked = one.second.says.asked;
        auto* const engines = one.engine.says.told;
        auto* const models = one.second.says.told;
        one.engine.says = one.second.says = what;
        one.engine.says.told = engines;
        one.second.says.told = models;
        bool const is_prompt = roll.chance(25) and what.requests[0].size() >= 4 and what.requests[0][0] != 0;
        one.second.prompt_unit = is_prompt ? what.requests[0][0] : -1;
        one.engine.own_unit = is_prompt ? what.requests[0][0] : std::uint8_t{1};
        one.second.is_timed = roll.chance(40);
        one.second.pace.is_waiting = one.engine.pace.is_waiting = false;
        one.second.pace.pause = one.engine.pace.pause =
            one.second.is_timed ? roll.any<microseconds>({0, 20'000, 100'000, 1'000'000}) : 0;
        told.step("%lld begin %zu: %s, %zu requests%s%s, prompt %d, timed %d, pause %lld", static_cast<long long>(now),
                  index, compare::hex(what.requests[0]).c_str(), what.requests.size(),
                  what.is_endless ? " for ever" : "", what.may_be_repeated ? "" : " once", one.second.prompt_unit,
                  one.second.is_timed, static_cast<long long>(one.second.pace.pause));
    }
    void set(std::size_t index)
    {
        model::slot_options const as{.with = compare::any_retry_policy(roll, how.response_timeout),
                                     .least_idle = roll.any<microseconds>({0, 0, 5'000, 50'000, 700'000}),
                                     .longest_gap = roll.any<microseconds>({0, 0, 0, 300'000, 1'000'000, 5'000'000})};
        told.step("%lld set %zu: R %lld, retries %u, busy %u, idle %lld, gap %lld", static_cast<long long>(now), index,
                  static_cast<long long>(as.with.response_timeout), as.with.retries, as.with.busy_retries,
                  static_cast<long long>(as.least_idle), static_cast<long long>(as.longest_gap));
        engine.set(index, {.with = compare::library(as.with),
                           .least_idle = compare::length(as.least_idle),
                           .longest_gap = compare::length(as.longest_gap)});
        second.set(index, as);
    }
    void interfere()
    {
        std::size_t const index = roll.below(all);
        both& one = conversations[index];
        switch (roll.below(13)) {
        case 0:
            step("cancel");
            engine.cancel(clock.at(now));
            second.inner.cancel(now);
            second.happened();
            break;
        case 1:
            number_step("cancel of", static_cast<long long>(index));
            engine.cancel(one.engine, clock.at(now));
            second.inner.cancel(one.second.whose, now);
            second.happened();
            break;
        case 2: {
            auto const unit = static_cast<std::uint8_t>(1 + roll.below(compare::manual_unit::units));
            microseconds const end = now + roll.below(400'000);
            told.step("%lld hold %d until %lld", static_cast<long long>(now), unit, static_cast<long long>(end));
            engine.hold(*rtuwire::unit_id::checked(unit), clock.at(end));
            second.inner.hold(unit, end);
            break;
        }
        case 3:
            number_step("another in the place of", static_cast<long long>(index));
            clear(one);
            break;
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
            one.engine.forget();
            one.second.whose.forget();
            break;
        case 6:
            number_step("settle", static_cast<long long>(index));
            one.engine.says.is_settled = one.second.says.is_settled = true;
            break;
        case 7:
            if (index < slots) {
                set(index);
            }
            break;
        case 8: begin(index); break;
        case 9:
            begin(index);
            one.engine.forget();
            one.second.whose.forget();
            break;
        case 10: begin(first + roll.below(all - first)); break;
        default: line.disturb(now); return;
        }
    }

    void converse(std::size_t index)
    {
        both& one = conversations[index];
        number_step(index >= first ? "converse first" : "converse", static_cast<long long>(index));
        one.as_its_kind([&](auto& conversation) {
            if (index >= first) {
                engine.run_urgent(conversation, clock.at(now));
            } else {
                engine.converse(index, conversation, clock.at(now));
            }
        });
        if (index >= first) {
            second.run_urgent(one.second, now);
        } else {
            second.converse(index, one.second, now);
        }
        check();
    }

    void pass()
    {
        pass_time();
        events();
        if (roll.chance(10)) {
            interfere();
        }
        if (roll.chance(97) or is_rested) {
            advance();
        }
        for (std::size_t i = first; i < all; ++i) {
            if (roll.chance(conversations[i].second.settled() ? 10 : 95)) {
                converse(i);
            }
        }
        for (std::size_t i = 0; i < slots and not told.failed(); ++i) {
            if (conversations[i].second.settled() and roll.chance(15)) {
                begin(i);
            }
            if (roll.chance(conversations[i].second.settled() ? 50 : 95)) {
                converse(i);
            }
        }
        if (roll.chance(96)) {
            step("poll_transmit");
            bytes const frame = compare::copy(engine.poll_transmit());
            told.same("bytes to send", frame, second.inner.poll_transmit());
            check();
            if (not frame.empty()) {
                line.hear(frame, now);
            }
        }
    }

    void run(model::share const& share)
    {
        tell_times();
        told.step("share %u, silent after %u", share.silent_share, share.silent_after);
        for (std::size_t i = 0; i < slots; ++i) {
            if (roll.chance(40)) {
                set(i);
            }
        }
        unsigned const passes = 20 + roll.below(61);
        for (unsigned i = 0; i < passes and not told.failed(); ++i) {
            pass();
        }
    }
};

} // namespace

int main(int argc, char** argv)
{
    return compare::main(argc, argv, [](random_source& roll, report& told) {
        compare::setting const as = compare::any_setting(roll);
        model::options how = compare::any_options(roll);
        how.response_timeout = std::min(how.response_timeout, model::longest / 8);
        how.front = 8;
        how.places = slots;
        how.rows = rows;
        model::share const share{roll.any<unsigned>({1, 10, 10, 50, 99, 100}),
                                 roll.any<unsigned>({0, 1, 2, 2, 3, 255})};
        world{roll, told, as, how, share}.run(share);
    });
}
