// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// No time limit ends a stop whose word has never left, however often it was given up before, and however long the program
// slept meanwhile.
#include "client_line.hpp"

#include "support/catch.hpp"
#include "support/remembered.hpp"

#include <algorithm>

#include <rtuwire/altivar/atv28.hpp>
#include <rtuwire/altivar/atv320.hpp>
#include <rtuwire/altivar/procedure/motion/stop.hpp>

using namespace rtuwire;
using namespace rtuwire::detail;
using namespace rtuwire::test;
using namespace rtuwire::altivar;

namespace {

constexpr client_options one_try{.response_timeout = milliseconds(100), .retries = 0};

bool is_stop_word(frame_bytes const& frame, unsigned register_of_it)
{
    return frame.size() == 8 and at(frame, 1) == 6 and word_at(frame, 2) == register_of_it;
}

/// A stop whose first words are given up before they leave, behind which the program sleeps; nobody answers.
template <typename Device> void check(stop_by mode, std::uint32_t limit_ms, unsigned given_up, std::uint64_t sleep)
{
    INFO(Device::layout.cmd << ", way " << static_cast<int>(mode) << ", limit " << limit_ms << " ms, given up "
                            << given_up << " times, asleep for " << sleep << " us");
    scripted_line<drive_client<1>> line{drive_client<1>{office_line, one_try}, office_line};
    remembered<stop> rest{station<Device>{unit_id{7}}, mode, milliseconds(limit_ms)};
    unsigned times = 0;
    auto const work = [&](instant now) {
        line.link.converse(rest, now);
        if (times < given_up and line.link.is_asked_by(rest) and rest.intent() == effect::stopping) {
            ++times; // it would leave in this pass
            line.link.cancel(rest, now);
        }
    };
    auto const is_word = [](departure const& each) { return is_stop_word(each.frame, Device::layout.cmd); };
    while (times < given_up and not rest.settled()) {
        line.pass(work, line.time() + 5'000);
    }
    line.stop(sleep);
    std::uint64_t const back = line.time();
    while (not rest.settled() and line.time() < back + 10'000'000U) {
        line.pass(work, line.time() + 5'000);
    }
    CHECK(rest.settled());
    CHECK(rest.reason().kind == outcome_kind::silent);
    CHECK(times == given_up);
    auto const first = std::find_if(line.departures.begin(), line.departures.end(), is_word);
    REQUIRE(first != line.departures.end());
    CHECK(first->begin < back + 1'200'000U); // a look that nobody answers comes before it
    CHECK(line.spinning < 3);
}

} // namespace

// It ended as "silent" without a frame: given up once, a limit of less than 50 ms or a sleep was enough.
TEST_CASE("defect: a stop whose word was given up before it left ends at its limit without one")
{
    for (std::uint64_t const sleep : {std::uint64_t{0}, std::uint64_t{400'000}, std::uint64_t{31'000'000}}) {
        for (std::uint32_t const limit_ms : {20U, 300U, 30'000U}) {
            for (unsigned const given_up : {1U, 2U, 5U}) {
                if (limit_ms == 30'000 and sleep < 31'000'000) {
                    continue; // the limit is not over
                }
                for (stop_by const mode : {stop_by::ramp, stop_by::freewheel, stop_by::quick_stop}) {
                    check<atv320::device>(mode, limit_ms, given_up, sleep);
                    check<atv28::device>(mode, limit_ms, given_up, sleep);
                }
                check<atv28::device>(stop_by::dc_injection, limit_ms, given_up, sleep);
            }
        }
    }
}

// Its 2 s had passed without it: it left when the time-out of its lost unit was over, 28 s later.
TEST_CASE("defect: a stop of a lost unit, begun before the program slept, waits for the unit's silence")
{
    scripted_line<drive_client<1>> line{drive_client<1>{office_line, one_try}, office_line};
    station<atv320::device> const motor{unit_id{7}};
    remembered<stop> first{motor, stop_by::ramp, milliseconds(2'000)};
    line.run(4'000'000, [&](instant now) {
        if (not first.settled()) {
            line.link.converse(first, now);
        }
    });
    REQUIRE(first.reason().kind == outcome_kind::silent);
    REQUIRE(line.link.is_held(motor.unit()));
    stop second{motor};
    auto const visit = [&](instant now) { line.link.converse(second, now); };
    std::size_t const before = line.departures.size();
    line.arrive(line.time(), read_of(9, 3201)); // another master's request: the line is not free
    line.pass(visit, line.time() + 500);
    line.stop(3'000'000);
    std::uint64_t const back = line.time();
    while (line.departures.size() == before and line.time() < back + 40'000'000U) {
        line.pass(visit, line.time() + 5'000);
    }
    REQUIRE(line.departures.size() > before);
    CHECK(is_stop_word(line.departures[before].frame, 8501));
    CHECK(line.departures[before].begin - back < 10'000);
    // From there on it has its 2 s.
    std::uint64_t const begun = line.time();
    line.run(4'000'000, visit);
    CHECK(line.departures.back().begin < begun + 2'000'000);
    CHECK(line.departures.back().begin > begun + 1'700'000);
}
