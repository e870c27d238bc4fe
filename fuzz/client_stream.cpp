// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Any octets in any chunking and any pauses to a client that keeps asking: every question ends by its
// deadline, and is sent no more often than it may be.
#include <rtuwire/rtuwire.hpp>

#include "input.hpp"

#include "../tests/support/asking.hpp"

using namespace rtuwire;
using fuzz::require;

extern "C" int LLVMFuzzerTestOneInput(std::uint8_t const* data, std::size_t size)
{
    // From the first sending on; how long a unit is held before it is the simulation's to judge.
    constexpr std::uint32_t longest_us = 30'000'000;
    constexpr unsigned retries = 2, busy_retries = 3;
    static auto const frame = *encode(unit_id{1}, read_holding_registers{3201, 1});
    fuzz::input in{data, size};
    std::uint8_t const flags = in.u8();
    client_options options{.response_timeout = milliseconds(100), .retries = retries};
    options.has_echo = (flags & 1U) != 0;
    options.skip_noise = (flags & 2U) != 0 ? 3 : 0;
    test::asking<basic_client<unit_statistics<2>>> link{line_timing{19'200, character_format::even_8_1}, options};
    instant now{0xFFFF'0000U};
    link.advance(now);
    instant started = now;
    unsigned transmissions = 0;
    while (not in.is_empty()) {
        std::uint8_t const what = in.u8();
        now = now + microseconds(std::uint32_t{in.u8()} * ((what & 0x40U) != 0 ? 4'000U : 40U));
        if ((what & 0x20U) != 0) {
            link.receive_error(now);
        }
        fuzz::frame const heard{in.some(what & 0x1FU), (what & 0x80U) != 0};
        link.receive(heard.view(), now);
        link.advance(now);
        if (auto const outcome = link.poll_outcome()) {
            transmissions = 0;
        }
        if (not link.is_busy()) {
            require(link.start(request{frame}, now).has_value());
            started = now;
        }
        if (not link.poll_transmit().empty()) {
            require(++transmissions <= 1 + retries + busy_retries);
            started = transmissions == 1 ? now : started;
            now = now + milliseconds(5);
            link.sent(now);
        }
        require(link.poll_deadline().has_value());
        require(transmissions == 0 or (now - started).microseconds < longest_us);
    }
    return 0;
}
