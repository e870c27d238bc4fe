// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Slow units, lost frames, late loops, and conversations that come and go:
//     slow_units COUNT [SEED [any | constant [BAD]]]
// Each seed is a line of its own kind and lives for a few hundred requests; COUNT 1 lives one seed again.
// After a fault the seed ends, and what went over the line before is printed for the first three. Ends after
// BAD such seeds, 20 unless told.
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string_view>

#include "application.hpp"

using namespace rtuwire;
using namespace rtuwire::simulation;

namespace {

/// The number that a Poisson count of this mean exceeds once in two hundred times.
double highest_by_chance(double mean)
{
    double term = std::exp(-mean);
    double sum = term;
    double count = 0;
    while (sum < 0.995) {
        count += 1;
        term *= mean / count;
        sum += term;
    }
    return count;
}

bool live(simulation::setting const& how, tally& counts, bool prints)
{
    auto const all = std::make_unique<application>(how, counts);
    bool is_good = true;
    if (how.measures_share) {
        is_good = all->measure_share();
    } else {
        for (unsigned phase = 0; phase < 4 and is_good; ++phase) {
            is_good = all->live(60);
        }
    }
    if (not is_good and prints) {
        std::printf("seed %u: %s%s%s, %u bit/s, response time-out %.3f ms, late response %.3f ms, %u "
                    "retries, "
                    "%u units, %u servers, %u conversations\n",
                    how.seed, how.is_bus ? "bus" : "client", how.is_host ? " of a host" : "",
                    how.has_line_echo ? " with echo" : "", how.bits_per_second, double(how.response_timeout()) / 1e3,
                    double(how.late_response()) / 1e3, unsigned{how.options.retries}, how.units, how.servers,
                    how.conversations);
        for (unsigned i = 0; i < how.units; ++i) {
            std::printf("  unit %u: %.3f to %.3f ms%s\n", i + 1, double(how.unit[i].latency.least) / 1e3,
                        double(how.unit[i].latency.most) / 1e3, how.unit[i].is_dead ? ", dead" : "");
        }
        all->events().print();
    }
    return is_good;
}

} // namespace

int main(int argc, char** argv)
{
    unsigned long const count = argc > 1 ? std::strtoul(argv[1], nullptr, 10) : 100'000;
    auto seed = static_cast<std::uint32_t>(argc > 2 ? std::strtoul(argv[2], nullptr, 10) : 1);
    choice const wanted = argc > 3 and std::string_view{argv[3]} == "constant" ? choice::constant : choice::any;
    unsigned long const most_bad = argc > 4 ? std::strtoul(argv[4], nullptr, 10) : 20;
    constexpr unsigned most_printed = 3;
    tally counts;
    unsigned bad = 0;
    while (counts.inquiries < count and bad < most_bad) {
        simulation::setting const how = setting_of(seed, wanted);
        bool const prints = bad < most_printed;
        bool const is_good = live(how, counts, prints);
        bad += is_good ? 0 : 1;
        ++seed;
    }
    std::printf("%lu requests, %lu answered, %lu failed, %lu given up; %lu got a late response to "
                "themselves, %lu a wrong one that no rule of time can tell\n",
                counts.inquiries, counts.answered, counts.failed, counts.given_up, counts.late_accepted,
                counts.beyond_rule);
    double const expected = double(counts.spoiled) / 65'536;
    std::printf("%lu of %lu spoiled frames passed for a response, at most %.1f by chance\n", counts.by_chance,
                counts.spoiled, highest_by_chance(expected));
    for (std::size_t i = 0; i < fault_count; ++i) {
        if (counts.faults[i] > 0) {
            std::printf("%lu %s, the first after %lu requests\n", counts.faults[i], name_of(static_cast<fault>(i)),
                        counts.first_after[i]);
        }
    }
    bool const is_chance = double(counts.by_chance) <= highest_by_chance(expected);
    std::printf("%u bad seeds\n", bad);
    return bad == 0 and is_chance ? 0 : 1;
}
