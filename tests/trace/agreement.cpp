// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A traced client and a traced server on a line with faults, and a third that only listens and knows nothing of either:
// it cuts by silence and reckons the CRC bit by bit. Whatever it saw undamaged stands in both traces, in order; whatever
// a trace says was received undamaged was on the line.
#include <rtuwire/client.hpp>
#include <rtuwire/server.hpp>
#include <rtuwire/sim.hpp>
#include <rtuwire/trace.hpp>

#include <algorithm>
#include <array>
#include <vector>

#include "support/catch.hpp"
#include "trace/asked_at_random.hpp"

using namespace rtuwire;
using namespace rtuwire::detail;

namespace {

using byte_list = std::vector<std::byte>;

constexpr line_timing timing{19'200, character_format::even_8_1};

struct record {
    byte_list bytes;
    frame_verdict verdict;
    bool is_own;
};

/// A trace without an end.
class record_list {
public:
    void take(traced_frame const& frame) noexcept
    {
        all.push_back({byte_list(frame.bytes.begin(), frame.bytes.end()), frame.verdict, frame.is_own});
        goes_back = goes_back or (all.size() > 1 and not reached(frame.at, last_));
        last_ = frame.at;
    }
    std::size_t count(frame_verdict which) const
    {
        return static_cast<std::size_t>(
            std::count_if(all.begin(), all.end(), [&](record const& each) { return each.verdict == which; }));
    }
    std::vector<record> all;
    bool goes_back{false};

private:
    instant last_{0};
};

bool has_right_crc(byte_list const& frame)
{
    unsigned crc = 0xFFFF;
    for (std::byte const each : frame) {
        crc ^= std::to_integer<unsigned>(each);
        for (unsigned bit = 0; bit < 8; ++bit) {
            crc = crc % 2 != 0 ? crc / 2 ^ 0xA001U : crc / 2;
        }
    }
    return frame.size() >= 4 and crc == 0; // of a frame with its own CRC behind it
}

/// Listens.
class tap {
public:
    explicit tap(std::vector<byte_list>& bursts, std::vector<bool>& whole) : bursts_{&bursts}, whole_{&whole} {}

    void receive(byte_view bytes, instant now) noexcept
    {
        begin(timing.characters(bytes.size()), now);
        bursts_->back().insert(bursts_->back().end(), bytes.begin(), bytes.end());
    }
    void receive_error(instant now) noexcept
    {
        begin(timing.characters(1), now);
        whole_->back() = false;
    }
    void sent(instant) noexcept {}
    void advance(instant) noexcept {}
    byte_view poll_transmit() noexcept { return {}; }
    deadline poll_deadline() const noexcept { return {}; }

private:
    /// Frames of one sender are 3.5 characters apart; what a fault puts beside one is nearer.
    void begin(duration length, instant now)
    {
        constexpr std::uint32_t bit_ns = 52'083;
        bool const is_new =
            bursts_->empty() or (now - last_).microseconds >= length.microseconds + 365U * bit_ns / 10'000U;
        if (is_new) {
            bursts_->emplace_back();
            whole_->push_back(true);
        }
        last_ = now;
    }

    std::vector<byte_list>* bursts_;
    std::vector<bool>* whole_;
    instant last_{0};
};

/// Looks for a frame in a trace from `from` on: as one record, or as the pieces of one that nobody waited for.
bool find(std::vector<record> const& trace, byte_list const& frame, std::size_t& from)
{
    for (std::size_t start = from; start < trace.size(); ++start) {
        byte_list all;
        for (std::size_t end = start; end < trace.size() and all.size() < frame.size(); ++end) {
            record const& each = trace[end];
            bool const is_piece = each.verdict == frame_verdict::late or each.verdict == frame_verdict::stray;
            if (end > start and not is_piece) {
                break;
            }
            all.insert(all.end(), each.bytes.begin(), each.bytes.end());
            if (all == frame) {
                from = end + 1;
                return true;
            }
        }
    }
    return false;
}

struct totals {
    std::size_t seen{0};
    std::size_t damaged{0};
    std::size_t late{0};
    std::size_t good{0};
};

void check_run(std::uint32_t seed, sim::line_faults const& faults, totals& sum)
{
    CAPTURE(seed);
    record_list at_client;
    record_list at_server;
    std::vector<byte_list> bursts;
    std::vector<bool> whole;
    client_options const options{
        .response_timeout = milliseconds(30), .late_response = milliseconds(100), .retries = 1};
    using traced_client = client::traced_by<record_list>;
    sim::line wire{timing, seed};
    wire.set_faults(faults);
    detail::basic_bench<traced_client, sim::line, test::slow_unit<record_list>, tap> bench{
        timing, wire, traced_client{timing, options}, test::slow_unit{unit_id{7}, timing, seed, at_server},
        tap{bursts, whole}};
    bench.link().trace_to(at_client);
    test::asks_anything asking{seed};
    bench.run_for(milliseconds(20'000), asking);

    CHECK_FALSE(at_client.goes_back);
    CHECK_FALSE(at_server.goes_back);
    std::size_t client_from = 0;
    std::size_t server_from = 0;
    for (std::size_t i = 0; i + 2 < bursts.size(); ++i) {
        if (not whole[i] or not has_right_crc(bursts[i])) {
            continue;
        }
        ++sum.seen;
        CAPTURE(i);
        REQUIRE(find(at_client.all, bursts[i], client_from));
        REQUIRE(find(at_server.all, bursts[i], server_from));
    }
    for (record_list const* trace : {&at_client, &at_server}) {
        byte_list line;
        for (byte_list const& each : bursts) {
            line.insert(line.end(), each.begin(), each.end());
        }
        auto place = line.begin();
        for (record const& each : trace->all) {
            if (each.is_own or each.verdict == frame_verdict::stray or each.verdict == frame_verdict::damaged) {
                continue;
            }
            place = std::search(place, line.end(), each.bytes.begin(), each.bytes.end());
            REQUIRE(place != line.end());
            place += static_cast<std::ptrdiff_t>(each.bytes.size());
        }
        sum.damaged += trace->count(frame_verdict::damaged);
        sum.late += trace->count(frame_verdict::late);
        sum.good += trace->count(frame_verdict::good);
    }
}

TEST_CASE("the traces of both ends agree with who only listens")
{
    totals sum;
    for (std::uint32_t seed = 1; seed <= 6; ++seed) {
        check_run(seed, {}, sum);
        check_run(seed, {.bit_errors = 300}, sum);
        check_run(seed, {.bursts = 50'000, .dropped = 2'000, .added = 2'000, .lost = 50'000}, sum);
        check_run(seed, {.repeated = 50'000, .delayed = 50'000, .glitches = 50'000, .delay = milliseconds(3)}, sum);
    }
    CHECK(sum.seen > 10'000);
    CHECK(sum.good > 20'000);
    CHECK(sum.damaged > 500);
    CHECK(sum.late > 500);
}

} // namespace
