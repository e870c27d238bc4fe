// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// What time simulated units are told. All time is this test's own.
#include "port/simulated_line.hpp"

#include <algorithm>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "support/catch.hpp"

using rtuwire::instant;
using rtuwire::milliseconds;

namespace {

/// A port whose `read` may come back before its deadline without a byte, as where a client has come.
class early_port {
public:
    instant time{5'000};
    std::vector<std::byte> coming{};

    rtuwire::result<rtuwire::byte_span> read(rtuwire::byte_span place, instant until)
    {
        if (coming.empty()) {
            time = is_early ? time : until + late_by;
        }
        std::size_t const size = std::min(place.size(), coming.size());
        std::copy_n(coming.begin(), size, place.begin());
        coming.clear();
        return place.first(size);
    }
    rtuwire::result<void> write(rtuwire::byte_view, instant) { return {}; }
    instant now() const { return time; }

    bool is_early{true};
    rtuwire::duration late_by{};
};

/// Answers each byte at once, and keeps the times that it was told.
class noting_unit final : public tool::simulated_drive {
public:
    explicit noting_unit(std::vector<instant>& times) : times_{times} {}

    void receive(rtuwire::byte_view bytes, instant now) override
    {
        times_.push_back(now);
        has_answer_ = not bytes.empty();
    }
    void receive_error(instant now) override { times_.push_back(now); }
    void sent(instant now) override { times_.push_back(now); }
    void advance(instant now) override { times_.push_back(now); }
    rtuwire::byte_view poll_transmit() override
    {
        return std::exchange(has_answer_, false) ? rtuwire::byte_view{answer_} : rtuwire::byte_view{};
    }
    rtuwire::deadline poll_deadline() const override { return {}; }
    rtuwire::unit_id address() const override { return rtuwire::unit_id{7}; }
    bool is_at_rest() const override { return true; }
    std::string shown() const override { return {}; }
    bool suffer(std::string const&, instant) override { return false; }

private:
    std::vector<instant>& times_;
    std::vector<std::byte> answer_{std::byte{7}};
    bool has_answer_{false};
};

} // namespace

TEST_CASE("simulate: no unit is told a time that has not come, nor one that goes back")
{
    early_port port;
    std::vector<instant> times;
    tool::simulated_line<early_port> line{port, rtuwire::line_timing::without_wire()};
    line.add(std::make_unique<noting_unit>(times));
    for (unsigned i = 0; i < 20; ++i) {
        if (i % 3 != 0) {
            port.coming = {std::byte{7}};
        }
        REQUIRE(line.pass(milliseconds(10)));
        REQUIRE(reached(port.time, times.back()));
        port.time = port.time + rtuwire::microseconds(200);
    }
    REQUIRE(std::ranges::is_sorted(times, {}, &instant::microseconds));
}

TEST_CASE("simulate: what comes while the program was stopped comes when it goes on")
{
    early_port port;
    port.is_early = false;
    port.late_by = rtuwire::milliseconds(3'600'000);
    std::vector<instant> times;
    tool::simulated_line<early_port> line{port, rtuwire::line_timing::without_wire()};
    line.add(std::make_unique<noting_unit>(times));
    instant const until = port.time + milliseconds(10);
    REQUIRE(line.pass(milliseconds(10)));
    REQUIRE(times.back() == until);
}
