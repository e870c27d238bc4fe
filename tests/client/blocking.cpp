// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// The client that waits, over a port that is played by hand.
#include <rtuwire/client/blocking.hpp>

#include <type_traits>
#include <vector>

#include "support/catch.hpp"

#include <rtuwire/ask/access.hpp>
#include <rtuwire/client/statistics.hpp>
#include <rtuwire/core/hex.hpp>
#include <rtuwire/wire/registers.hpp>
#include <rtuwire/wire/serial_line/file_records.hpp>

using namespace rtuwire;
using namespace rtuwire::detail;

namespace {

/// A port whose clock jumps to each deadline, and that answers each request with the next script line.
struct scripted_port {
    std::vector<std::vector<std::byte>> answers{};
    std::vector<std::byte> input{};
    std::vector<std::vector<std::byte>> sent{};
    instant clock{0xFFFF'FF00U};
    bool is_broken{false};

    instant now() { return clock = clock + microseconds(10); }

    result<void> write(byte_view bytes, instant)
    {
        if (is_broken) {
            return errc::device_vanished;
        }
        sent.emplace_back(bytes.begin(), bytes.end());
        if (sent.size() <= answers.size()) {
            input = answers[sent.size() - 1];
        }
        return {};
    }

    result<byte_span> read(byte_span place, instant until)
    {
        if (is_broken) {
            return errc::device_vanished;
        }
        if (input.empty() and not reached(clock, until)) {
            clock = until;
        }
        std::size_t const count = input.size() < place.size() ? input.size() : place.size();
        for (std::size_t i = 0; i < count; ++i) {
            place[i] = input[i];
        }
        input.erase(input.begin(), input.begin() + static_cast<std::ptrdiff_t>(count));
        return place.first(count);
    }
};

template <std::size_t Size> std::vector<std::byte> line_of(std::array<std::byte, Size> const& bytes)
{
    return {bytes.begin(), bytes.end()};
}

constexpr auto response_1234 = "01 03 02 12 34 B5 33"_hex;
constexpr auto response_5678 = "01 03 02 56 78 87 C6"_hex;
constexpr auto refusal = "01 83 02 C0 F1"_hex;
constexpr auto stop_all = "00 06 21 35 00 00 92 29"_hex;

template <std::size_t Size> scripted_port responding(std::array<std::byte, Size> const& bytes)
{
    scripted_port port;
    port.answers.push_back(line_of(bytes));
    return port;
}

constexpr line_timing timing{19'200, character_format::even_8_1};
constexpr read_holding_registers request{0x0C81, 1};

} // namespace

TEST_CASE("a waiting client gives the response")
{
    scripted_port port = responding(response_1234);
    blocking_client line{port, timing};
    auto const response = line.ask(unit_id{1}, request);
    REQUIRE(response);
    CHECK(response->registers[0] == 0x1234);
    CHECK(port.sent.size() == 1);
}

TEST_CASE("a waiting client gives exceptions, time-outs and refusals as errors")
{
    scripted_port port = responding(refusal);
    blocking_client line{port, timing, {.retries = 1}};
    CHECK(line.ask(unit_id{1}, request) == errc::illegal_data_address);
    CHECK(line.ask(unit_id{1}, request) == errc::timed_out);
    CHECK(port.sent.size() == 3);
    CHECK(line.ask(unit_id{1}, read_holding_registers{0, 126}) == errc::invalid_quantity);
    CHECK(port.sent.size() == 3);
}

TEST_CASE("a request without a response takes its time, and no more")
{
    scripted_port port;
    blocking_client line{port, timing, {.response_timeout = milliseconds(300), .retries = 0}};
    instant const before = port.clock;
    CHECK(line.ask(unit_id{1}, request) == errc::timed_out);
    std::uint32_t const least = 300'000 + timing.characters(8 + 7).microseconds;
    CHECK((port.clock - before).microseconds - least < 5'000);
}

TEST_CASE("where there is no wire a client waits for nothing but responses")
{
    for (bool const is_wire : {true, false}) {
        scripted_port port = responding(response_1234);
        port.answers.push_back(line_of(response_5678));
        blocking_client line{port, is_wire ? timing : line_timing::without_wire()};
        instant const before = port.clock;
        CHECK(line.ask(unit_id{1}, request));
        CHECK(line.ask(unit_id{1}, request));
        std::uint32_t const silences = 2 * timing.t3_5().microseconds;
        CHECK(((port.clock - before).microseconds < 1'000) != is_wire);
        CHECK(((port.clock - before).microseconds >= silences) == is_wire);
    }
}

TEST_CASE("what lay in the port before the request does not answer it")
{
    scripted_port port = responding(response_1234);
    port.input = line_of(response_5678);
    blocking_client line{port, timing};
    auto const response = line.ask(unit_id{1}, request);
    REQUIRE(response);
    CHECK(response->registers[0] == 0x1234);
}

TEST_CASE("a waiting client takes the records of another read of a file for none")
{
    scripted_port port = responding("01 14 04 03 06 33 CD CC 34"_hex);
    port.answers.push_back(line_of("01 14 06 05 06 0D FE 00 20 8B 4E"_hex));
    blocking_client line{port, timing};
    read_file_record const two_records{file_run{.file = 4, .record = 1, .count = 2}};
    CHECK(line.ask(unit_id{1}, two_records) == errc::response_mismatch);
    auto const told = line.ask(unit_id{1}, two_records);
    REQUIRE(told);
    CHECK((*told->run(0))[1] == 0x0020);
}

TEST_CASE("a command to all ends without a response")
{
    scripted_port port;
    blocking_client line{port, timing};
    instant const before = port.clock;
    CHECK(line.send_broadcast(write_single_register{8501, 0}));
    duration const least = timing.t3_5() + timing.characters(8) + milliseconds(100);
    CHECK(port.clock - before >= least);
    CHECK((port.clock - before).microseconds - least.microseconds < 1000);
    REQUIRE(port.sent.size() == 1);
    CHECK(port.sent[0] == line_of(stop_all));
}

TEST_CASE("a port that fails ends the request, and the next one can be asked")
{
    scripted_port port = responding(response_1234);
    blocking_client line{port, timing};
    port.is_broken = true;
    CHECK(line.ask(unit_id{1}, request) == errc::device_vanished);
    port.is_broken = false;
    CHECK(line.ask(unit_id{1}, request));
}

namespace {

/// Pauses before its one request.
class patient_request : public asker {
public:
    void advance(instant now)
    {
        if (not begun_) {
            begun_ = true;
            start_ = now + milliseconds(30);
        }
        is_due_ = is_due_ or reached(now, start_);
    }
    deadline poll_deadline() const { return is_due_ ? deadline{} : deadline{start_}; }
    std::optional<request_frame> next() const { return is_due_ ? conversation_.next() : std::nullopt; }
    void accept(result<response> const& outcome) { conversation_.accept(outcome); }
    bool settled() const { return conversation_.settled(); }
    auto outcome() const& { return conversation_.outcome(); }

private:
    single_request<read_holding_registers> conversation_{unit_id{1}, request};
    instant start_{0};
    bool begun_{false};
    bool is_due_{false};
};

} // namespace

TEST_CASE("a conversation that pauses is waited for")
{
    scripted_port port = responding(response_1234);
    blocking_client line{port, timing};
    patient_request conversation;
    instant const before = port.clock;
    REQUIRE(line.run(conversation));
    CHECK(conversation.outcome());
    CHECK((port.clock - before).microseconds >= 30'000);
}

TEST_CASE("a port that breaks while a response is awaited settles the conversation")
{
    struct breaking_port : scripted_port {
        result<byte_span> read(byte_span place, instant until)
        {
            is_broken = is_broken or not sent.empty();
            return scripted_port::read(place, until);
        }
    };
    breaking_port port;
    blocking_client line{port, timing};
    single_request conversation{unit_id{1}, request};
    CHECK(line.run(conversation) == errc::device_vanished);
    CHECK(conversation.outcome().error() == errc::cancelled);
}

TEST_CASE("a port that breaks while a broadcast leaves is reported")
{
    struct mute_port : scripted_port {
        static result<void> write(byte_view, instant) { return errc::device_failed; }
    };
    mute_port port;
    blocking_client line{port, timing};
    CHECK(line.send_broadcast(write_single_register{8501, 0}) == errc::device_failed);
}

namespace {

/// Keeps how long it was given for each call.
struct watched_port : scripted_port {
    std::vector<duration> for_writing{};
    std::vector<duration> for_reading{};

    result<void> write(byte_view bytes, instant until)
    {
        for_writing.push_back(until - clock);
        return scripted_port::write(bytes, until);
    }
    result<byte_span> read(byte_span place, instant until)
    {
        // A time that has just come is one to look at what is there.
        for_reading.push_back(until + milliseconds(1) - clock);
        return scripted_port::read(place, until);
    }
};

} // namespace

TEST_CASE("a port has the response time-out to send, and never waits for a time that is long over")
{
    watched_port port;
    port.answers = {line_of(response_1234), {}, line_of(response_5678)};
    blocking_client<watched_port> client{port, timing, {.response_timeout = milliseconds(250), .retries = 1}};
    CHECK(client.ask(unit_id{1}, request));
    CHECK(client.ask(unit_id{1}, request));
    REQUIRE(port.sent.size() == 3);
    for (duration const each : port.for_writing) {
        CHECK(each == milliseconds(250));
    }
    for (duration const each : port.for_reading) {
        CHECK(each <= milliseconds(600));
    }
    // The line has to be silent before the first request.
    CHECK(port.for_reading.front() > milliseconds(1));
}

TEST_CASE("the end of a pass has a second to send, and reads until its time")
{
    watched_port port;
    port.answers = {line_of(response_1234)};
    client link{timing};
    single_request conversation{unit_id{1}, request};
    std::array<std::byte, 256> place{};
    for (int pass = 0; pass < 6 and not conversation.settled(); ++pass) {
        instant const now = port.now();
        link.advance(now);
        link.converse(conversation, now);
        REQUIRE(finish_pass(link, port, place, now + milliseconds(20)));
    }
    CHECK(conversation.outcome());
    CHECK(port.for_writing == std::vector<duration>{milliseconds(1'000)});
}

namespace {

/// Has nothing to ask at first, and does not say when it will have.
struct silent_at_first : single_request<read_holding_registers> {
    using single_request::single_request;
    int looks_left{3};

    std::optional<request_frame> next() { return looks_left-- > 0 ? std::nullopt : single_request::next(); }
};

} // namespace

namespace {

/// Ends with a reason, as orders to drives do: that of its one request.
struct reasoned : patient_request {
    struct ending {
        bool is_done;
        errc error;
    };
    ending reason() const { return {settled(), settled() ? last_ : errc::none}; }
    void accept(result<response> const& outcome)
    {
        last_ = outcome.error();
        patient_request::accept(outcome);
    }
    void outcome() const = delete;

private:
    errc last_{errc::none};
};

/// Breaks at its first read after so many frames.
struct port_that_breaks : scripted_port {
    std::size_t frames{0};

    result<byte_span> read(byte_span place, instant until)
    {
        is_broken = is_broken or sent.size() >= frames;
        return scripted_port::read(place, until);
    }
};

} // namespace

TEST_CASE("a waiting client gives the outcome of what it ran")
{
    scripted_port port = responding(response_1234);
    port.answers.push_back(line_of(refusal));
    blocking_client line{port, timing};
    register_read<count16> speed{unit_id{1}, 0x0C81};
    auto const told = line.run(speed);
    static_assert(std::is_same_v<decltype(told), result<count16> const>);
    REQUIRE(told);
    CHECK(*told == count16{std::uint16_t{0x1234}});
    CHECK(line.run(register_read<count16>{unit_id{1}, 0x0C81}) == errc::illegal_data_address);
}

TEST_CASE("the outcome of a request without a name is no view of it")
{
    scripted_port port = responding(response_1234);
    port.answers.push_back(line_of(refusal));
    blocking_client line{port, timing};
    auto const told = line.run(single_request{unit_id{1}, request});
    static_assert(std::is_same_v<decltype(told), result<void> const>);
    CHECK(told);
    CHECK(line.run(single_request{unit_id{1}, request}) == errc::illegal_data_address);
}

TEST_CASE("a request that the device refuses is no success of its run")
{
    scripted_port port = responding(refusal);
    blocking_client line{port, timing};
    single_request conversation{unit_id{1}, request};
    CHECK(line.run(conversation) == errc::illegal_data_address);
}

TEST_CASE("what ends with a reason gives it, with the port's error where the port failed")
{
    scripted_port port = responding(refusal);
    blocking_client line{port, timing};
    reasoned conversation;
    auto const ended = line.run(conversation);
    CHECK(ended.is_done);
    CHECK(ended.error == errc::illegal_data_address);
    for (std::size_t const frames : {0U, 1U}) {
        INFO("after " << frames << " frames");
        port_that_breaks broken;
        broken.frames = frames;
        blocking_client other{broken, timing};
        reasoned asked;
        auto const cut = other.run(asked);
        CHECK(cut.error == errc::device_vanished);
        CHECK(cut.is_done == (frames == 1));
    }
}

TEST_CASE("a conversation that does not say when it goes on is looked at again within ten milliseconds")
{
    scripted_port port = responding(response_1234);
    blocking_client line{port, timing};
    silent_at_first conversation{unit_id{1}, request};
    instant const before = port.clock;
    REQUIRE(line.run(conversation));
    CHECK(conversation.outcome());
    CHECK(port.clock - before >= milliseconds(30));
    CHECK(port.clock - before < milliseconds(31) + timing.t3_5());
}

namespace {

constexpr client_needs<public_functions, line_statistics> of_one_line{
    .timing = timing, .options = {.response_timeout = milliseconds(60), .retries = 0}};
constexpr client_needs<> of_one_motor{.timing = timing, .motors = 1};

struct port_with_times : scripted_port {
    line_timing timing() const { return {19'200, character_format::even_8_1}; }
};

template <typename Port, auto const& Needs, typename... Arguments>
constexpr bool is_made_of = std::is_constructible_v<blocking_client<Port, Needs>, Port&, Arguments...>;

// A port that tells no times is given some; needs that have a timing have their options, too.
static_assert(is_made_of<port_with_times, host_needs> and is_made_of<port_with_times, host_needs, client_options>);
static_assert(is_made_of<port_with_times, host_needs, line_timing, client_options>);
static_assert(not is_made_of<scripted_port, host_needs> and not is_made_of<scripted_port, host_needs, client_options>);
static_assert(is_made_of<scripted_port, host_needs, line_timing>);
static_assert(is_made_of<scripted_port, of_one_line> and is_made_of<port_with_times, of_one_line>);
static_assert(not is_made_of<port_with_times, of_one_line, client_options>);
static_assert(not is_made_of<port_with_times, of_one_line, line_timing>);

template <auto const& Needs>
constexpr bool tells_orders = requires(blocking_client<scripted_port, Needs> line, unit_id unit)
{
    line.is_ordered(unit);
    line.release(unit);
    line.release_all();
};
static_assert(tells_orders<of_one_motor> and tells_orders<host_needs> and not tells_orders<of_one_line>);

} // namespace

TEST_CASE("a blocking client whose needs have a timing is made of its port alone, and counts")
{
    scripted_port port = responding(response_1234);
    blocking_client<scripted_port, of_one_line> line{port};
    CHECK(line.ask(unit_id{1}, read_holding_registers{3201, 1}));
    instant const before = port.clock;
    CHECK(line.ask(unit_id{1}, read_holding_registers{3201, 1}).error() == errc::timed_out); // nobody answers any more
    CHECK(port.clock - before < milliseconds(100));
    CHECK(line.statistics().line()[line_event::request] == 2);
    CHECK(line.statistics().line()[line_event::reply] == 1);
}
