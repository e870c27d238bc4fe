// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A client of a host that has nothing to send sleeps, whatever its conversation says of its deadlines.
#include <rtuwire/client/blocking.hpp>

#include <vector>

#include "support/catch.hpp"

#include <rtuwire/core/hex.hpp>
#include <rtuwire/port/posix_serial.hpp>
#include <rtuwire/port/pseudo_terminal.hpp>
#include <rtuwire/wire/registers.hpp>

using namespace rtuwire;

namespace {

constexpr line_timing timing{19'200, character_format::even_8_1};
constexpr read_holding_registers registers{0x0C81, 1};
constexpr auto response_of_unit_1 = "01 03 02 12 34 B5 33"_hex;

/// A port whose clock jumps to each deadline where nothing arrives, and that counts how often it is read. A pass that takes no
/// time takes 10 us, as a fast host's does.
struct counted_port {
    instant clock{0xFFFF'0000U};
    unsigned reads{0};
    bool responds{true};
    bool has_response{false};

    instant now() const { return clock; }
    result<void> write(byte_view, instant)
    {
        has_response = responds;
        return {};
    }
    result<byte_span> read(byte_span place, instant until)
    {
        ++reads;
        clock = has_response or reached(clock, until) ? clock + microseconds(10) : until;
        std::size_t const count = has_response ? response_of_unit_1.size() : 0;
        for (std::size_t i = 0; i < count; ++i) {
            place[i] = response_of_unit_1[i];
        }
        has_response = false;
        return place.first(count);
    }
};

/// A port that counts how often it is read.
template <typename Port> struct counted_reads : Port {
    unsigned reads{0};

    result<byte_span> read(byte_span place, instant until)
    {
        ++reads;
        return Port::read(place, until);
    }
};

/// Asks when something outside says so, here a time that it tells nobody.
template <typename Port> class request_on_demand : public asker {
public:
    request_on_demand(Port const& port, instant at) : port_{port}, at_{at} {}

    std::optional<request_frame> next() const { return reached(port_.now(), at_) ? asks_.next() : std::nullopt; }
    void accept(result<response> const& outcome) { asks_.accept(outcome); }
    bool settled() const { return asks_.settled(); }
    auto outcome() const& { return asks_.outcome(); }

private:
    single_request<read_holding_registers> asks_{unit_id{1}, registers};
    Port const& port_;
    instant at_;
};

/// The same, with a deadline that is over all the time.
template <typename Port> class overdue_request : public request_on_demand<Port> {
public:
    overdue_request(Port const& port, instant at) : request_on_demand<Port>{port, at} {}
    void advance(instant now) { now_ = now; }
    deadline poll_deadline() const { return now_; }

private:
    instant now_{0};
};

/// Wants to be asked for its request only when the line is free for its unit.
class prompt_request : public asker {
public:
    static constexpr conversation_properties properties{.freshness = freshness::when_free};

    explicit prompt_request(instant due) : due_{due} {}

    unit_id unit() const { return unit_id{1}; }
    void advance(instant) {}
    deadline poll_deadline() const { return due_; }
    std::optional<request_frame> next() const { return asks_.next(); }
    void accept(result<response> const& outcome) { asks_.accept(outcome); }
    bool settled() const { return asks_.settled(); }

private:
    single_request<read_holding_registers> asks_{unit_id{1}, registers};
    instant due_;
};

} // namespace

TEST_CASE("defect: (k) a conversation that pauses without a deadline lets the client sleep")
{
    counted_port port;
    blocking_client line{port, timing};
    request_on_demand conversation{port, port.clock + milliseconds(1'000)};
    instant const before = port.clock;
    REQUIRE(line.run(conversation));
    CHECK(conversation.outcome());
    CHECK(port.reads <= 110);
    CHECK((port.clock - before).microseconds < 1'050'000);
}

TEST_CASE("defect: (k) a deadline that stays over lets the client sleep")
{
    counted_port port;
    blocking_client line{port, timing};
    overdue_request conversation{port, port.clock + milliseconds(1'000)};
    REQUIRE(line.run(conversation));
    CHECK(conversation.outcome());
    CHECK(port.reads <= 110);
}

TEST_CASE("defect: (k) a unit that may not be asked yet lets the client sleep")
{
    counted_port port;
    blocking_client line{port, timing, {.late_response = milliseconds(2'000), .retries = 0}};
    port.responds = false;
    CHECK(line.ask(unit_id{1}, registers) == errc::timed_out);
    port.responds = true;
    port.reads = 0;
    instant const before = port.clock;
    prompt_request conversation{port.clock};
    REQUIRE(line.run(conversation));
    CHECK((port.clock - before).microseconds >= 1'900'000);
    CHECK(port.reads <= 300);
}

TEST_CASE("defect: (k) a pause costs a host's processor next to nothing")
{
    pseudo_terminal far;
    REQUIRE(far.open());
    counted_reads<posix_serial> port;
    REQUIRE(port.open(far.path()));
    blocking_client line{port, timing, {.response_timeout = milliseconds(20), .retries = 0}};
    request_on_demand conversation{port, port.now() + milliseconds(1'000)};
    REQUIRE(line.run(conversation) == errc::timed_out);
    // Counted, not timed: each pass waits in its read, and a machine that is busy only makes fewer of them.
    CHECK(port.reads <= 110);
}
