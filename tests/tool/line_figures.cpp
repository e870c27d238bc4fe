// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// What `timing` counts, of frames that a listener heard.
#include "frame/line_figures.hpp"

#include "support/catch.hpp"

#include <rtuwire/core/hex.hpp>

using namespace rtuwire;

namespace {

constexpr auto wire = line_timing::host(19'200, character_format::even_8_1);
constexpr auto read_3202 = "07 03 0C 82 00 01 27 14"_hex;
constexpr auto response_500 = "07 03 02 01 F4 30 53"_hex;
constexpr auto response_of_two = "07 03 04 01 F4 01 F4 DC 2A"_hex;

/// Hands each piece of a line's time to a listener, and what that hears to the figures.
struct heard_line {
    line_listener listener{wire};
    tool::line_figures figures{};
    instant now{0};

    heard_line() { pass(milliseconds(2'000)); }
    void pass(duration length)
    {
        now = now + length;
        listener.advance(now, [this](heard_frame const& it) { take(it); });
    }
    void hear(byte_view bytes)
    {
        now = now + wire.characters(bytes.size());
        listener.receive(bytes, now, [this](heard_frame const& it) { take(it); });
        pass(milliseconds(10));
    }
    void take(heard_frame const& it) { figures.take({it, now.microseconds, wire}); }
    tool::unit_figures const& unit() const { return figures.units().at(7); }
};

} // namespace

TEST_CASE("a response to what was asked is counted as one, with its time")
{
    heard_line it;
    it.hear(read_3202);
    it.hear(response_500);
    CHECK(it.unit().requests == 1);
    CHECK(it.unit().answered == 1);
    CHECK(it.unit().response_times.quantile(1) > 0);
    CHECK(it.figures.stray_bytes() == 0);
}

TEST_CASE("a response to nothing that was asked answers nothing: its bytes are stray")
{
    heard_line it;
    it.hear(response_500);
    CHECK(it.unit().answered == 0);
    CHECK(it.figures.stray_bytes() == response_500.size());
    it.hear(read_3202);
    it.hear(response_of_two);
    it.pass(milliseconds(3'000));
    CHECK(it.unit().requests == 1);
    CHECK(it.unit().answered == 0);
    CHECK(it.unit().unanswered == 1);
    CHECK(it.figures.stray_bytes() == response_500.size() + response_of_two.size());
}
