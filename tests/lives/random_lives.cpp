// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Random lives of controllers and their drives, held against the law of motion:
//     random_lives COUNT [FIRST | today]
//     random_lives --life SEED
// A life is named by its seed; the second form prints all of it. The first one prints what happened how often, the
// seeds of lives that broke the law, and fails for one of those or where something that can happen never did. Each day (UTC) has
// 100 000 seeds of its own, far from those that are tried with each build.
#include <charconv>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <vector>

#include "lives/blocking_life.hpp"
#include "lives/chance.hpp"

using namespace rtuwire;
using namespace rtuwire::lives;

namespace {

template <typename Link> bool live(life_setting const& how, tally& counts, bool prints)
{
    auto const all = std::make_unique<whole_life<Link>>(how, counts, prints);
    return all->live();
}

/// Whether the law held in the life of a seed.
bool live(std::uint32_t seed, tally& counts, bool prints)
{
    life_setting const how = setting_of(seed);
    ++counts.lives;
    counts.unsupervised += how.is_unsupervised ? 1 : 0;
    if (prints) {
        std::printf("seed %u: %s, %u bit/s, response time-out %.0f ms, %u retries%s\n", seed,
                    how.is_blocking ? "blocking client"
                    : how.is_bus    ? "bus"
                                    : "client",
                    how.bits_per_second, double(how.options.response_timeout.microseconds) / 1e3,
                    unsigned{how.options.retries}, how.is_unsupervised ? ", unsupervised" : "");
        for (std::size_t i = 0; i < how.drives; ++i) {
            drive_setting const& set = how.drive[i];
            std::printf("  drive %u: model %u, SLL %u, time-out %.1f s, ramp %.1f s\n", unsigned{set.address},
                        static_cast<unsigned>(set.which), unsigned{set.sll}, double(set.time_out_us()) / 1e6,
                        set.ramp / 10.0);
        }
    }
    if (how.is_blocking) {
        return std::make_unique<blocking_life>(how, counts, prints)->live();
    }
    return how.is_bus ? live<life_bus>(how, counts, prints) : live<life_client>(how, counts, prints);
}

/// Whether everything happened.
bool print(tally const& counts)
{
    std::printf("%lu lives, %lu of them without supervision, %lu frames\n", counts.lives, counts.unsupervised,
                counts.frames);
    bool is_complete = true;
    for (std::size_t i = 0; i < event_count; ++i) {
        std::printf("%10lu %s\n", counts.events[i], event_names[i]);
        is_complete = is_complete and counts.events[i] != 0;
    }
    for (std::size_t i = 0; i < breach_count; ++i) {
        if (counts.breaches[i] != 0) {
            std::printf("%10lu lives in which %s\n", counts.breaches[i], breach_names[i]);
        }
    }
    std::printf("%lu lives broke the law\n", counts.broken());
    return is_complete;
}

std::uint32_t first_of_today() noexcept
{
    return static_cast<std::uint32_t>(static_cast<std::uint64_t>(std::time(nullptr)) / 86'400 * 100'000);
}

std::uint32_t number(char const* word)
{
    std::uint32_t value = 0;
    char const* const end = word + std::strlen(word);
    if (auto const read = std::from_chars(word, end, value); read.ec != std::errc{} or read.ptr != end) {
        std::fprintf(stderr,
                     "random_lives: '%s' is no number of 32 bits; random_lives COUNT [FIRST | today], or --life SEED\n",
                     word);
        std::exit(2);
    }
    return value;
}

} // namespace

int main(int argc, char** argv)
{
    tally counts;
    if (argc == 3 and std::strcmp(argv[1], "--life") == 0) {
        return live(number(argv[2]), counts, true) ? 0 : 1;
    }
    std::uint32_t const count = argc > 1 ? number(argv[1]) : 10'000;
    std::uint32_t seed = argc < 3 ? 1 : std::strcmp(argv[2], "today") == 0 ? first_of_today() : number(argv[2]);
    std::printf("%u lives from seed %u on\n", count, seed);
    std::fflush(stdout);
    std::array<unsigned, breach_count> printed{};
    for (std::uint32_t i = 0; i < count; ++i, ++seed) {
        auto const before = counts.breaches;
        live(seed, counts, false);
        for (std::size_t kind = 0; kind < breach_count; ++kind) {
            if (counts.breaches[kind] != before[kind] and printed[kind]++ < 5) {
                std::printf("seed %u: %s\n", seed, breach_names[kind]);
            }
        }
    }
    bool const is_complete = print(counts);
    return counts.broken() == 0 and is_complete ? 0 : 1;
}
