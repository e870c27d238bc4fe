// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A byte that arrived damaged spoils the frame that it belongs to, even if the rest of it is a frame with
// a right CRC. A pseudo-terminal damages nothing: the marks are read as a pure function here, and a
// pseudo-terminal shows that the kernel is told to make them.
#include <rtuwire/port/posix_serial.hpp>

#include <string>
#include <vector>

#include "support/proof.hpp"
#include "support/soon.hpp"

#include <rtuwire/client/blocking.hpp>
#include <rtuwire/core/hex.hpp>
#include <rtuwire/port/pseudo_terminal.hpp>
#include <rtuwire/server/banks.hpp>
#include <rtuwire/server/blocking.hpp>
#include <rtuwire/wire/registers.hpp>

using namespace rtuwire;
using namespace rtuwire::detail;
using test::soon;

namespace {

using byte_list = std::vector<std::byte>;

template <std::size_t Size> byte_list list(std::array<std::byte, Size> const& bytes)
{
    return {bytes.begin(), bytes.end()};
}

/// What a receiver saw, one number each: 0 to 255 a byte, `damaged` one that was not as sent.
using line_events = std::vector<int>;
constexpr int damaged = -1;

/// What termios says a device hands over for them (PARMRK set, ISTRIP clear).
byte_list as_marked(line_events const& events, std::byte damaged_byte = std::byte{0x55})
{
    byte_list marked;
    for (int const event : events) {
        if (event == damaged) {
            marked.push_back(std::byte{0xFF});
            marked.push_back(std::byte{0x00});
            marked.push_back(damaged_byte);
        } else {
            marked.insert(marked.end(), event == 0xFF ? 2 : 1, static_cast<std::byte>(event));
        }
    }
    return marked;
}

/// Reads marks from chunks of `chunk` bytes into places of `room` bytes.
line_events as_read(byte_list const& marked, std::size_t chunk, std::size_t room)
{
    error_marks marks;
    line_events seen;
    byte_list place(room);
    for (std::size_t from = 0; from < marked.size(); from += chunk) {
        std::size_t const left = marked.size() - from;
        byte_view rest{marked.data() + from, left < chunk ? left : chunk};
        while (not rest.empty()) {
            auto const part = marks.take(rest, place);
            REQUIRE(part.taken + part.size + (part.has_error ? 1U : 0U) > 0);
            rest = rest.subspan(part.taken);
            for (std::size_t i = 0; i < part.size; ++i) {
                seen.push_back(static_cast<int>(place[i]));
            }
            if (part.has_error) {
                seen.push_back(damaged);
            }
        }
    }
    return seen;
}

void check_every_split(line_events const& events, std::byte damaged_byte = std::byte{0x55})
{
    byte_list const marked = as_marked(events, damaged_byte);
    for (std::size_t chunk = 1; chunk <= marked.size() + 1; ++chunk) {
        for (std::size_t room = 1; room <= 4; ++room) {
            CHECK(as_read(marked, chunk, room) == events);
        }
    }
}

constexpr auto one_damaged = "01 FF FF 02 FF 00 41 03"_hex;

constexpr bool reads_a_mark()
{
    error_marks marks;
    std::array<std::byte, 8> place{};
    auto const part = marks.take(one_damaged, place);
    return part.size == 3 and part.taken == 7 and part.has_error and place[1] == std::byte{0xFF} and
           place[2] == std::byte{2};
}
STATIC_CHECK(reads_a_mark());

constexpr line_timing timing{19'200, character_format::even_8_1};
constexpr auto request = "01 03 0C 81 00 01 D7 72"_hex;
constexpr auto reply = "01 03 02 12 34 B5 33"_hex;

/// A port whose device marks what is damaged, played by hand: each request, or reading at all, lets the next
/// line of events arrive, byte by byte.
class marking_port {
public:
    std::vector<line_events> procedure{};
    instant clock{0xFFFF'FF00U};
    std::vector<byte_list> sent{};

    instant now() { return clock = clock + microseconds(10); }
    result<void> write(byte_view bytes, instant)
    {
        sent.emplace_back(bytes.begin(), bytes.end());
        arrive();
        return {};
    }
    void arrive()
    {
        if (next_ < procedure.size()) {
            input_ = as_marked(procedure[next_++]);
        }
    }
    result<byte_span> read(byte_span place, instant until)
    {
        if (input_.empty() and not reached(clock, until)) {
            clock = until;
        }
        auto const part = marks_.take(input_, place);
        has_error_ = part.has_error;
        input_.erase(input_.begin(), input_.begin() + static_cast<std::ptrdiff_t>(part.taken));
        return place.first(part.size);
    }
    bool take_receive_error() { return std::exchange(has_error_, false); }

private:
    std::size_t next_{0};
    byte_list input_{};
    error_marks marks_{};
    bool has_error_{false};
};

/// A frame, and a damaged byte in front of its byte number `at`.
template <std::size_t Size> line_events with_damage(std::array<std::byte, Size> const& frame, std::size_t at)
{
    line_events events;
    for (std::size_t i = 0; i < Size; ++i) {
        if (i == at) {
            events.push_back(damaged);
        }
        events.push_back(static_cast<int>(frame[i]));
    }
    return events;
}

} // namespace

TEST_CASE("defect: (i) marks of damaged bytes are read in any chunking")
{
    check_every_split({1, 2, 3});
    check_every_split({0xFF});
    check_every_split({0xFF, 0xFF, 0xFF});
    check_every_split({0xFF, 0x00, 0x41});
    check_every_split({0x00, 0xFF, 0x00});
    check_every_split({damaged});
    check_every_split({damaged, damaged, 7, damaged});
    check_every_split({0xFF, damaged, 0xFF, 0xFF, 0x00, damaged, 0x00, 0xFF});
    // The damaged byte may look like a mark itself; 00 is also what a break looks like.
    check_every_split({1, damaged, 0xFF, damaged, 2}, std::byte{0xFF});
    check_every_split({1, damaged, 0xFF, damaged, 2}, std::byte{0x00});
}

TEST_CASE("defect: (i) a mark that was cut short is an error, and the next byte is read as it is")
{
    CHECK(as_read(list("01 FF 42 03"_hex), 4, 4) == line_events{1, damaged, 0x42, 3});
    CHECK(as_read(list("01 FF 42 03"_hex), 1, 1) == line_events{1, damaged, 0x42, 3});
}

TEST_CASE("defect: (i) an answer with a damaged byte is no answer, wherever it was")
{
    for (std::size_t at = 1; at < reply.size(); ++at) {
        CAPTURE(at);
        marking_port port;
        port.procedure = {with_damage(reply, at)};
        blocking_client line{port, timing, {.retries = 0}};
        auto const got = line.ask(unit_id{1}, read_holding_registers{0x0C81, 1});
        CHECK(got == errc::uart_error);
    }
    marking_port port;
    port.procedure = {with_damage(reply, reply.size())};
    blocking_client line{port, timing, {.retries = 0}};
    CHECK(line.ask(unit_id{1}, read_holding_registers{0x0C81, 1}));
}

TEST_CASE("defect: (i) a request with a damaged byte is not served, wherever it was")
{
    for (std::size_t at = 0; at <= request.size(); ++at) {
        CAPTURE(at);
        marking_port port;
        port.procedure = {with_damage(request, at)};
        server node{unit_id{1}, timing};
        word_bank<16> bank{0x0C81};
        REQUIRE(serve_once(node, port, bank, milliseconds(100)));
        REQUIRE(serve_once(node, port, bank, milliseconds(100)));
        port.arrive();
        for (int i = 0; i < 10; ++i) {
            REQUIRE(serve_once(node, port, bank, milliseconds(100)));
        }
        CHECK(port.sent.size() == (at == request.size() ? 1U : 0U));
    }
}

TEST_CASE("defect: (i) a device is told to mark what arrives damaged")
{
    pseudo_terminal far;
    REQUIRE(far.open());
    descriptor const look{::open(far.path().c_str(), O_RDWR | O_NOCTTY | O_CLOEXEC)};
    for (auto const format : {character_format::even_8_1, character_format::none_8_2, character_format::odd_8_2}) {
        posix_serial port;
        REQUIRE(port.open(far.path(), {.format = format}));
        termios line{};
        REQUIRE(::tcgetattr(look.number(), &line) == 0);
        CHECK((line.c_iflag & INPCK) != 0);
        CHECK((line.c_iflag & PARMRK) != 0);
        CHECK((line.c_iflag & (IGNPAR | ISTRIP | IGNBRK | BRKINT)) == 0);
    }
}

TEST_CASE("defect: (i) bytes FF arrive as they were sent, however they are read")
{
    pseudo_terminal far;
    REQUIRE(far.open());
    posix_serial port;
    REQUIRE(port.open(far.path()));
    auto const sent = list("FF 00 41 FF FF FF 00 00 FF 01 FF"_hex);
    for (std::size_t room = 1; room <= 2 * sent.size(); ++room) {
        REQUIRE(far.write(sent, soon()));
        byte_list seen;
        byte_list place(room);
        while (seen.size() < sent.size()) {
            auto const part = port.read(place, soon());
            REQUIRE(part);
            REQUIRE_FALSE(part->empty());
            seen.insert(seen.end(), part->begin(), part->end());
            CHECK_FALSE(port.take_receive_error());
        }
        CHECK(seen == sent);
    }
    auto const nothing = port.read({}, soon());
    CHECK(nothing);
}

TEST_CASE("defect: (i) a device hands over its marks as errors in their place")
{
    // The marks of a device, made by hand: another program took the flag away and sends what the kernel would.
    pseudo_terminal far;
    REQUIRE(far.open());
    descriptor const look{::open(far.path().c_str(), O_RDWR | O_NOCTTY | O_CLOEXEC)};
    posix_serial port;
    REQUIRE(port.open(far.path()));
    termios line{};
    REQUIRE(::tcgetattr(look.number(), &line) == 0);
    line.c_iflag &= ~tcflag_t{PARMRK};
    REQUIRE(::tcsetattr(look.number(), TCSANOW, &line) == 0);
    REQUIRE(far.write(list("01 FF 00 41 02 FF FF 03"_hex), soon()));
    std::array<std::byte, 8> place{};
    auto const first = port.read(place, soon());
    REQUIRE(first);
    CHECK(first->size() == 1);
    CHECK(port.take_receive_error());
    CHECK_FALSE(port.take_receive_error());
    // The rest is there already.
    auto const second = port.read(place, steady_now());
    REQUIRE(second);
    CHECK(second->size() == 3);
    CHECK(to_u8((*second)[1]) == 0xFF);
    CHECK_FALSE(port.take_receive_error());
}
