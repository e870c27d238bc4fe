// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// What the page of bad lines shows: how long a client waits and how often it repeats, and what that costs with a unit that
// does not answer.
//! [head]
#include <iostream>

#include <rtuwire/client.hpp>
#include <rtuwire/print.hpp>
#include <rtuwire/server.hpp>
#include <rtuwire/sim.hpp>

using namespace rtuwire;
//! [head]

namespace {

constexpr line_timing timing{19'200, character_format::even_8_1};

// The defaults that the page tells.
static_assert(client_options{}.response_timeout == milliseconds(1'000));
static_assert(client_options{}.late_response == milliseconds(200));
static_assert(client_options{}.retries == 2 and client_options{}.turnaround == milliseconds(100));
static_assert(retry_policy{}.response_timeout == milliseconds(1'000) and retry_policy{}.retries == 2);
static_assert(retry_policy{}.busy_retries == 3 and retry_policy{}.busy_pause == milliseconds(50));

/// How long a client is busy with a unit that is not there.
template <typename Link> std::uint32_t wait_for_nobody(Link const& link)
{
    word_bank<4> registers{0};
    sim::bench bench{link, bank_at{unit_id{3}, registers}};
    bench.cut();
    auto const error = bench.run(single_request{unit_id{3}, read_holding_registers{.start = 0, .count = 1}}).error();
    std::uint32_t const length = (bench.now() - instant{0}).microseconds / 1'000U;
    std::cout << error << ", after " << length << " ms\n";
    return length;
}

//! [counts]
using counting = host_client::observed_by<unit_statistics<30>>;

void tell(counting const& link)
{
    counters const& all = link.statistics().line();
    std::cout << all[line_event::request] << " requests, " << all[line_event::crc]
              << " damaged responses, the slowest after " << all.worst_latency.microseconds << " us\n";
    if (counters const* const unit = link.statistics().unit(3)) { // null where it was never asked
        std::cout << unit->by_exception[2] << " refused by unit 3 as exception 02\n";
    }
}
//! [counts]

} // namespace

int main()
{
    //! [options]
    constexpr client_options options{
        .response_timeout = milliseconds(300), // from the end of a request to the first byte of its response
        .late_response = milliseconds(400),    // how much later than that a response may still come
        .retries = 1,                          // how often it is sent again after no response, or a damaged one
    };
    host_client link{timing, options}; // likewise blocking_client{port, timing, options} and bus<30>{timing, options}
    //! [options]

    bus<2> line{timing, options};
    //! [unit]
    line.set(1, {.with = {.response_timeout = milliseconds(2'000), .retries = 0}}); // the slow unit in slot 1 of a bus
    //! [unit]
    //! [pause]
    line.set(0, {.with = {.pause = milliseconds(700)}});               // of the unit in slot 0
    line_timing const slow = timing.with_silence(milliseconds(1'000)); // of all units: blocking_client{port, slow}
    //! [pause]
    if (slow.silence() != milliseconds(1'000) or slow.frame_end() != timing.frame_end()) {
        return 1;
    }

    word_bank<4> registers{0};
    sim::bench bench{counting{timing}, bank_at{unit_id{3}, registers}};
    bool const is_read =
        bench.run(single_request{unit_id{3}, read_holding_registers{.start = 0, .count = 1}}).has_value();
    bool const is_refused =
        not bench.run(single_request{unit_id{3}, read_holding_registers{.start = 9, .count = 1}}).has_value();
    tell(bench.link());
    counters const* const of_unit = bench.link().statistics().unit(3);
    if (not is_read or not is_refused or of_unit == nullptr or (*of_unit)[line_event::request] != 2 or
        of_unit->by_exception[2] != 1) {
        return 1;
    }

    std::uint32_t const as_delivered = wait_for_nobody(host_client{timing});
    std::uint32_t const as_set = wait_for_nobody(link);
    return as_delivered > 3'000 and as_delivered < 3'100 and as_set > 600 and as_set < 700 ? 0 : 1;
}
