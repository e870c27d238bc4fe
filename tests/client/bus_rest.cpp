// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A bus at the edges of its slots, its passes and its rests: docs/engine-rules.md, rules 29 and 30.
#include <rtuwire/client/bus.hpp>

#include <array>
#include <cstdint>

#include "support/proof.hpp"

#include <rtuwire/ask/single_request.hpp>
#include <rtuwire/wire/registers.hpp>

using namespace rtuwire;
using namespace rtuwire::detail;

namespace {

constexpr line_timing line{19'200, character_format::even_8_1};

/// Asks the same of a unit that never answers, for ever.
struct vain : asker {
    single_request<read_holding_registers> request;
    unsigned failures{0};

    explicit constexpr vain(std::uint32_t unit) : request{*unit_id::checked(unit), read_holding_registers{3201, 1}} {}
    constexpr std::optional<request_frame> next() const { return request.next(); }
    constexpr void accept(result<response> const&) { ++failures; }
    static constexpr bool settled() { return false; }
};

/// A bus on which nobody answers. Its slots come by from the last to the first; the program looks at the time so
/// often before they do.
template <std::size_t Slots> struct vain_bus {
    bus<Slots> link;
    std::array<vain, 6> conversations{vain{1}, vain{2}, vain{3}, vain{4}, vain{5}, vain{6}};
    unsigned looks{1};
    instant now{0xFFFF'FF00};
    std::uint64_t time{0};
    std::uint64_t asked_at{0};
    std::uint64_t lost_at{0}; ///< when it was told last that nobody answered
    std::uint8_t asked{0};

    constexpr vain_bus(client_options const& options, bus_options const& share) : link{line, options, share} {}

    /// Whether a request left.
    constexpr bool pass()
    {
        for (unsigned i = 0; i < looks; ++i) {
            link.advance(now);
        }
        unsigned const before = failures();
        for (std::size_t i = Slots; i-- > 0;) {
            link.converse(i, conversations[i], now);
        }
        lost_at = failures() != before ? time : lost_at;
        if (byte_view const frame = link.poll_transmit(); not frame.empty()) {
            asked_at = time;
            asked = to_u8(frame[0]);
            go_on(line.characters(frame.size()));
            link.sent(now);
            return true;
        }
        deadline const next = link.poll_deadline();
        go_on(next and not reached(now, *next) ? *next - now : duration{});
        return false;
    }
    constexpr bool asks()
    {
        for (unsigned i = 0; i < 40; ++i) {
            if (pass()) {
                return true;
            }
        }
        return false;
    }
    constexpr unsigned failures() const
    {
        unsigned all = 0;
        for (std::size_t i = 0; i < Slots; ++i) {
            all += conversations[i].failures;
        }
        return all;
    }

private:
    constexpr void go_on(duration length)
    {
        now = now + length;
        time += length.microseconds;
    }
};

constexpr bool leaves_other_slots_out()
{
    bus<2> link{line};
    vain conversation{1};
    link.advance(instant{0});
    link.advance(instant{0} + milliseconds(10));
    link.converse(2, conversation, instant{0} + milliseconds(10));
    link.converse(0xFFFF, conversation, instant{0} + milliseconds(10));
    link.set(2, {.least_idle = milliseconds(1)});
    return link.poll_transmit().empty() and conversation.failures == 0 and not link.is_silent(2) and
           not link.poll_deadline();
}
PROOF("a slot that there is not asks nothing", leaves_other_slots_out)

/// From the last of so many losses of ten seconds, one of each slot, to the next request.
template <std::size_t Slots> constexpr std::uint64_t rest_after_losses()
{
    vain_bus<Slots> it{{.response_timeout = milliseconds(10'000), .late_response = {}, .retries = 0},
                       {.silent_share = 1}};
    for (std::size_t i = 0; i < Slots; ++i) {
        if (not it.asks()) {
            return 0;
        }
    }
    while (it.failures() < Slots) {
        it.pass();
    }
    std::uint64_t const end = it.lost_at;
    return it.asks() ? it.asked_at - end : 0;
}
constexpr bool rests_half_an_hour_at_most()
{
    constexpr std::uint64_t ten_minutes = 600'000'000;
    // Each loss puts off by ten minutes more than what was left of the one before when it was asked.
    return rest_after_losses<1>() == ten_minutes and rest_after_losses<2>() == 2 * ten_minutes and
           rest_after_losses<4>() == 3 * ten_minutes and rest_after_losses<6>() == 3 * ten_minutes;
}
PROOF("losses of several units add up, to half an hour at most", rests_half_an_hour_at_most)

constexpr std::uint8_t first_probed(unsigned looks)
{
    vain_bus<2> it{{.response_timeout = milliseconds(50), .late_response = {}, .retries = 0}, {}};
    it.looks = looks;
    bool const both = it.asks() and it.asks();
    return both and it.asks() ? it.asked : std::uint8_t{0};
}
constexpr bool is_one_pass_however_often_it_looks()
{
    return first_probed(1) == 1 and first_probed(2) == 1 and first_probed(3) == 1;
}
PROOF("a slot that came by in the pass before keeps its turn, however often the time was looked at",
      is_one_pass_however_often_it_looks)

} // namespace
