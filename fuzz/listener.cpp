// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Any bytes in any chunks and at any times to a listener: it hands out each byte once, in order, in a frame that is
// judged by its own bytes, and gives a response no request but the last
// that passed, or a late one that it said was unanswered.
#include <array>
#include <cstddef>
#include <cstdint>

#include <rtuwire/rtuwire.hpp>
#include <rtuwire/trace.hpp>

#include "input.hpp"

using namespace rtuwire;
using namespace rtuwire::detail;

namespace {

/// What was put in, and what came out of it.
struct accounts {
    static constexpr std::size_t most = 1U << 16U;

    std::array<std::byte, most> heard{};
    std::size_t put_in{0};
    std::size_t handed_out{0};
    fuzz::frame asked{{}, false};    ///< the last request
    fuzz::frame given_up{{}, false}; ///< the last one that got no response in time

    void put(byte_view bytes)
    {
        for (std::byte const byte : bytes) {
            heard[put_in++] = byte;
        }
    }

    void operator()(heard_frame const& it)
    {
        byte_view const bytes = it.frame.bytes;
        fuzz::require(it.is_unanswered == bytes.empty());
        fuzz::require(handed_out + bytes.size() <= put_in);
        fuzz::require(same_bytes(bytes, byte_view{heard}.subspan(handed_out, bytes.size())));
        handed_out += bytes.size();
        bool const is_response = it.frame.role == frame_role::response;
        if (it.is_unanswered) {
            fuzz::require(same_bytes(it.request, asked.view()));
            given_up = fuzz::frame{it.request, false};
        }
        if (is_response and it.frame.verdict != frame_verdict::stray) {
            bool const is_late = it.frame.verdict == frame_verdict::late;
            fuzz::require(same_bytes(it.request, is_late ? given_up.view() : asked.view()));
        }
        if (it.frame.role != frame_role::unknown) {
            fuzz::require(check_frame(bytes) == errc::none);
            fuzz::require(reached(it.frame.at, it.first_byte));
        }
        static_cast<void>(it.unit());
        static_cast<void>(it.start());
        static_cast<void>(it.is_exception());
        if (it.frame.role == frame_role::request) {
            asked = fuzz::frame{bytes, false};
        }
    }
};

accounts told;

} // namespace

extern "C" int LLVMFuzzerTestOneInput(std::uint8_t const* data, std::size_t size)
{
    told.put_in = told.handed_out = 0;
    told.asked = told.given_up = fuzz::frame{{}, false};
    fuzz::input in{data, size};
    bool const is_host = in.u8() % 2 == 1;
    line_timing const timing = is_host ? line_timing::host(19'200, character_format::even_8_1)
                                       : line_timing{19'200, character_format::even_8_1};
    line_listener tap{timing};
    instant now{0xFFFE'0000U};
    tap.advance(now, told);
    while (not in.is_empty() and told.put_in + 2 * max_adu_size < accounts::most) {
        // One byte says what comes, another how long the pause before it is.
        std::uint8_t const what = in.u8();
        std::uint8_t const pause = in.u8();
        now = now + (pause < 0xF0 ? microseconds(pause * 97U) : milliseconds((pause - 0xEFU) * 100U));
        if ((what & 0x40U) != 0) {
            tap.advance(now, told);
        }
        if (what == 0xFF) {
            tap.receive_error(now, told);
            continue;
        }
        fuzz::frame const frame{in.some(what & 0x1FU), (what & 0x20U) != 0};
        told.put(frame.view());
        if ((what & 0x80U) != 0) {
            for (std::byte const byte : frame.view()) {
                now = now + timing.characters(1);
                tap.receive({&byte, 1}, now, told);
            }
        } else {
            now = now + timing.characters(frame.view().size());
            tap.receive(frame.view(), now, told);
        }
        fuzz::require(told.put_in - told.handed_out <= 2 * max_adu_size);
    }
    // All bytes end with silence, and what is remembered of a late response after 35 minutes.
    for (int pass = 0; pass < 3; ++pass) {
        now = now + milliseconds(2'000);
        tap.advance(now, told);
    }
    fuzz::require(told.handed_out == told.put_in);
    for (int pass = 0; pass < 3; ++pass) {
        now = now + milliseconds(900'000);
        tap.advance(now, told);
    }
    fuzz::require(not tap.poll_deadline());
    return 0;
}
