// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Random lines, options and requests for a client and its model, and what is held against each other.
#pragma once

#include <rtuwire/client/needs.hpp>
#include <rtuwire/client/statistics.hpp>
#include <rtuwire/rtu/line.hpp>

#include "compare_conversation.hpp"
#include "model_client.hpp"

namespace compare {

/// A line, and where its clock begins.
struct setting {
    std::uint32_t start;
    std::uint32_t bits;
    microseconds end;
    microseconds bits_by_character;
    std::optional<microseconds> silence; ///< before sending, where it is not t3.5
};
inline setting any_setting(random_source& roll)
{
    return {roll.chance(70) ? 0U - 5'000'000U + roll.below(1'000) : static_cast<std::uint32_t>(roll.next()),
            roll.any<std::uint32_t>({4'800, 9'600, 19'200, 38'400, 115'200, 0}),
            roll.any<microseconds>({0, 0, 1'000, 8'000, 50'000}), roll.any<microseconds>({11, 10, 12}),
            any_silence(roll)};
}
inline rtuwire::line_timing timing(setting const& as)
{
    using enum rtuwire::character_format;
    rtuwire::character_format const format = as.bits_by_character == 10   ? none_8_1
                                             : as.bits_by_character == 12 ? odd_8_2
                                                                          : even_8_1;
    return line_of(as.bits, format, as.end, as.silence);
}

/// Between two sendings of one request lie less than 71 minutes: the longest time-out goes without repetitions.
inline unsigned repetitions(microseconds response, unsigned some) { return response == model::longest ? 0 : some; }

/// Whether a request may wait so long that no unit should be held for long beside it.
inline bool is_patient(model::options const& how) { return how.response_timeout > 40'000'000; }

inline model::options any_options(random_source& roll)
{
    model::options how{.response_timeout = roll.chance(4)
                                               ? roll.any<microseconds>({0, 1, model::longest, model::longest / 8})
                                               : 5'000 + microseconds{roll.below(roll.chance(50) ? 60'000 : 1'000'000)},
                       .turnaround = roll.any<microseconds>({0, 100'000, 100'000, 20'000, 3'000'000}),
                       .late_response = roll.any<microseconds>({0, 200'000, 200'000, 30'000, model::longest}),
                       .retries = roll.any<unsigned>({0, 1, 2, 2, 5, 255}),
                       .has_line_echo = roll.chance(20),
                       .max_leading_noise = roll.any<unsigned>({0, 0, 0, 1, 3}),
                       .front = 0,
                       .longest = 256,
                       .places = 0,
                       .rows = 0};
    how.retries = repetitions(how.response_timeout, how.retries);
    if (is_patient(how)) { // times that are compared lie at most 35 minutes apart
        how.late_response = std::min<microseconds>(how.late_response, 200'000);
    }
    return how;
}
inline rtuwire::client_options library(model::options const& of)
{
    return {.response_timeout = length(of.response_timeout),
            .turnaround = length(of.turnaround),
            .late_response = length(of.late_response),
            .retries = static_cast<std::uint8_t>(of.retries),
            .has_line_echo = of.has_line_echo,
            .max_leading_noise = static_cast<std::uint8_t>(of.max_leading_noise)};
}
inline model::retry_policy any_retry_policy(random_source& roll, microseconds response)
{
    return {.response_timeout = roll.chance(70) ? response : 2'000 + microseconds{roll.below(300'000)},
            .retries = repetitions(response, roll.below(4)),
            .busy_retries = repetitions(response, roll.any<unsigned>({0, 1, 2, 9, 255})),
            .busy_pause = roll.any<microseconds>({0, 1'000, 10'000, 50'000, model::longest / 3, model::longest / 2,
                                                  model::longest / 2 - 1, model::longest / 9}),
            .pause = roll.chance(70) ? 0 : roll.any<microseconds>({1, 3'000, 40'000, 700'000})};
}
inline rtuwire::retry_policy library(model::retry_policy const& of)
{
    return {.response_timeout = length(of.response_timeout),
            .retries = static_cast<std::uint8_t>(of.retries),
            .busy_retries = static_cast<std::uint8_t>(of.busy_retries),
            .busy_pause = length(of.busy_pause),
            .pause = length(of.pause)};
}

/// A request that somebody may ask, or one that no client takes.
inline bytes any_request(random_source& roll)
{
    bytes frame{roll.chance(8) ? std::uint8_t{0} : static_cast<std::uint8_t>(1 + roll.below(6))};
    auto const add = [&](std::initializer_list<unsigned> of) {
        for (unsigned const each : of) {
            frame.push_back(static_cast<std::uint8_t>(each));
        }
    };
    auto const data = [&](std::size_t count) {
        for (std::size_t i = 0; i < count; ++i) {
            frame.push_back(roll.byte());
        }
    };
    unsigned const count = roll.chance(90) ? 1 + roll.below(4) : 1 + roll.below(121);
    switch (roll.below(20)) {
    case 0:
    case 1:
    case 2:
    case 3:
    case 4: add({3, roll.below(4), roll.byte(), 0, count}); break;
    case 5: add({4, 0, roll.byte(), roll.chance(10) ? 1U : 0U, count}); break;
    case 6: add({1U + roll.below(2), 0, 1, roll.below(2), count}); break;
    case 7:
    case 8: add({6, 0, roll.byte(), roll.byte(), roll.byte()}); break;
    case 9: add({5, 0, roll.byte(), 0xFF, 0}); break;
    case 10:
        add({16, 0, roll.byte(), 0, count, 2 * count});
        data(2 * count);
        break;
    case 11: {
        unsigned const read = roll.chance(90) ? 1 + roll.below(4) : 125;
        add({23, 0, 1, 0, read, 0, 5, 0, count, 2 * count});
        data(2 * count);
        break;
    }
    case 12: add({22, 0, roll.byte(), 0, 1, 0, 2}); break;
    case 13:
        if (roll.chance(50)) {
            add({8, 0, roll.any<unsigned>({1, 2, 3, 4, 5, 10, 11, 18, 19, 20, 21}), 0, 0});
        } else {
            add({8, 0, 0});
            data(2 * (1 + roll.below(4)));
        }
        break;
    case 14: add({roll.any<unsigned>({7, 11, 12, 17})}); break;
    case 17: add({43, roll.chance(80) ? 14U : 13U, 1 + roll.below(4), roll.below(4)}); break;
    case 18:
        switch (roll.below(3)) {
        case 0: add({24, 0, roll.byte()}); break;
        case 1: add({15, 0, 1, 0, 9, 2, roll.byte(), 1}); break;
        default: add({20U + roll.below(2), 7}); data(7);
        }
        break;
    case 15:
        add({100});
        data(roll.below(7));
        break;
    case 16:
        switch (roll.below(4)) {
        case 0: return {};
        case 1: return bytes(3, 1);
        case 2: return bytes(257, 1);
        default:
            frame[0] = 1;
            add({100});
            data(252);
            return frame;
        }
    default: add({3, 0, 1, 0, 1});
    }
    return model::with_crc(frame);
}
inline procedure any_procedure(random_source& roll)
{
    procedure what{};
    what.is_settled = false;
    what.is_endless = roll.chance(40);
    what.may_be_repeated = not roll.chance(15);
    for (unsigned i = 1 + roll.below(3); i > 0; --i) {
        what.requests.push_back(any_request(roll));
    }
    return what;
}

inline void same_outcomes(report& told, std::vector<outcome> const& engine, std::vector<outcome> const& model)
{
    if (told.failed() or engine == model) {
        return;
    }
    auto const text = [](std::vector<outcome> const& of) {
        std::string out = std::to_string(of.size());
        if (not of.empty()) {
            out += ", the last to " + std::to_string(of.back().whom) + ": error " + std::to_string(of.back().error) +
                   ", " + hex(of.back().pdu);
        }
        return out;
    };
    told.difference = "outcomes: library " + text(engine) + "; model " + text(model);
}
/// A time that a woken engine names has come, and is no more exact than that, or its request ends at `ended`, ahead.
inline void same_deadline(report& told, rtuwire::deadline engine, std::optional<microseconds> model, bool is_woken,
                          microseconds ended, microseconds now, clock const& shown)
{
    if (is_woken and ended > now) {
        model = model ? std::min(*model, ended) : ended;
    } else if (is_woken) {
        told.same("whether it is woken", engine and rtuwire::reached(shown.at(now), *engine), 1);
        return;
    }
    told.same("whether there is a deadline", engine.has_value(), model.has_value());
    if (engine and model) {
        told.same(("deadline, from " + std::to_string(now)).c_str(),
                  static_cast<std::int32_t>(engine->microseconds - shown.at(now).microseconds), *model - now);
    }
}
inline void same_counts(report& told, std::string const& whose, rtuwire::counters const& engine,
                        model::counts const& model)
{
    static char const* const names[] = {"request", "repetition", "reply",     "timeout",   "late", "foreign", "crc",
                                        "length",  "mismatch",   "exception", "collision", "jam",  "noise"};
    for (std::size_t i = 0; i < model::events and not told.failed(); ++i) {
        if (engine.by_event[i] != model.by_event[i]) {
            told.same((whose + ", " + names[i]).c_str(), engine.by_event[i], model.by_event[i]);
        }
    }
    for (std::size_t i = 0; i < 12; ++i) {
        told.same("exceptions by number", engine.by_exception[i], model.by_exception[i]);
    }
    told.same("worst latency", static_cast<std::int32_t>(engine.worst_latency.microseconds), model.worst_latency);
}
template <typename Statistics> void same_counts(report& told, Statistics const& engine, model::statistics const& model)
{
    same_counts(told, "line", engine.line(), model.line);
    for (std::uint8_t unit = 1; unit < 8; ++unit) {
        auto const own = model.units.find(unit);
        rtuwire::counters const* const row = engine.unit(unit);
        told.same("whether a unit has a row", row != nullptr, own != model.units.end());
        if (row != nullptr and own != model.units.end()) {
            same_counts(told, "unit " + std::to_string(unit), *row, own->second);
        }
    }
}

} // namespace compare
