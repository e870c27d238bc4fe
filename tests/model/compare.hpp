// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// What the programs that hold a model against the library share: random numbers, the clock that wraps, how a difference
// is told.
#pragma once

#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <optional>
#include <string>
#include <vector>

#include <rtuwire/core/bytes.hpp>
#include <rtuwire/core/time.hpp>

#include "model_line.hpp"

namespace compare {

/// Random numbers that repeat with their seed.
class random_source {
public:
    explicit random_source(std::uint64_t seed) : state_{seed * 0x9E37'79B9'7F4A'7C15U + 0x1234'5678'9ABC'DEFU} {}
    std::uint64_t next()
    {
        state_ += 0x9E37'79B9'7F4A'7C15U;
        std::uint64_t value = state_;
        value = (value ^ (value >> 30U)) * 0xBF58'476D'1CE4'E5B9U;
        value = (value ^ (value >> 27U)) * 0x94D0'49BB'1331'11EBU;
        return value ^ (value >> 31U);
    }
    std::uint32_t below(std::uint64_t limit) { return static_cast<std::uint32_t>(next() % limit); }
    bool chance(unsigned percent) { return below(100) < percent; }
    std::uint8_t byte() { return static_cast<std::uint8_t>(next()); }
    template <typename T> T any(std::initializer_list<T> of) { return of.begin()[below(of.size())]; }

private:
    std::uint64_t state_;
};

/// The model's time as the library's clock shows it.
struct clock {
    std::uint32_t start;

    rtuwire::instant at(model::microseconds now) const
    {
        return rtuwire::instant{start + static_cast<std::uint32_t>(now)};
    }
};

inline rtuwire::byte_view view(model::bytes const& of) { return std::as_bytes(std::span{of}); }
inline model::bytes copy(rtuwire::byte_view of)
{
    model::bytes out;
    for (std::byte const each : of) {
        out.push_back(std::to_integer<std::uint8_t>(each));
    }
    return out;
}
inline rtuwire::duration length(model::microseconds of) { return rtuwire::microseconds(of); }

/// A line of the library: of a microcontroller, of a host that ends a frame after `end`, or without a bit rate no wire.
inline rtuwire::line_timing line_of(std::uint32_t bits, rtuwire::character_format format, model::microseconds end,
                                    std::optional<model::microseconds> silence)
{
    auto const line = bits == 0 ? rtuwire::line_timing::without_wire(length(end))
                      : end > 0 ? rtuwire::line_timing::host(bits, format, length(end))
                                : rtuwire::line_timing{bits, format};
    return silence ? line.with_silence(length(*silence)) : line;
}

/// A silence before sending, where it is not t3.5.
inline std::optional<model::microseconds> any_silence(random_source& roll)
{
    return roll.chance(60) ? std::nullopt
                           : std::optional{roll.any<model::microseconds>({0, 0, 1, 700, 4'000, 60'000, 900'000})};
}

inline std::string hex(model::bytes const& of)
{
    std::string out;
    char place[4];
    for (std::uint8_t const each : of) {
        std::snprintf(place, sizeof place, "%02X ", each);
        out += place;
    }
    return out;
}

/// One schedule: what was done, and the first difference.
struct report {
    bool is_told{false}; ///< whether the steps are written down
    std::vector<std::string> steps{};
    std::string difference{};

    bool failed() const { return not difference.empty(); }
    template <typename... Args> void step(char const* format, Args... args)
    {
        if (is_told and not failed()) {
            char place[1200];
            std::snprintf(place, sizeof place, format, args...);
            steps.emplace_back(place);
        }
    }
    void same(char const* what, long long engine, long long model)
    {
        if (engine != model and not failed()) {
            difference = std::string{what} + ": library " + std::to_string(engine) + ", model " + std::to_string(model);
        }
    }
    void same(char const* what, model::bytes const& engine, model::bytes const& model)
    {
        if (engine != model and not failed()) {
            difference = std::string{what} + ": library " + hex(engine) + ", model " + hex(model);
        }
    }
};

/// Runs `COUNT [SEED]` schedules; each is `run(random_source, report)`. The exit status.
template <typename Run> int main(int argc, char** argv, Run run)
{
    unsigned long const count = argc > 1 ? std::strtoul(argv[1], nullptr, 0) : 1000;
    unsigned long const first = argc > 2 ? std::strtoul(argv[2], nullptr, 0) : 1;
    for (unsigned long seed = first; seed < first + count; ++seed) {
        report quick;
        random_source rolled{seed};
        run(rolled, quick);
        if (quick.failed()) {
            report whole{.is_told = true};
            random_source again{seed};
            run(again, whole);
            for (std::string const& step : whole.steps) {
                std::printf("%s\n", step.c_str());
            }
            std::printf("seed %lu, step %zu: %s\n", seed, whole.steps.size(), whole.difference.c_str());
            return 1;
        }
    }
    std::printf("%lu schedules from seed %lu: equal\n", count, first);
    return 0;
}

/// One byte by the call for one, of which half are odd; all else in a chunk.
template <typename Engine> void receive(Engine& engine, model::bytes const& of, rtuwire::instant at)
{
    if (of.size() == 1 and of[0] % 2 == 1) {
        engine.receive(std::byte{of[0]}, at);
    } else {
        engine.receive(view(of), at);
    }
}

} // namespace compare
