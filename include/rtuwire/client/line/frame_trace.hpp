// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// What a client that is traced tells of the bytes that arrive. In any other client these functions are empty.
// Internal: may change with any version.
#pragma once

#include <cstddef>

#include <rtuwire/client/line/request_steps.hpp>
#include <rtuwire/core/bytes.hpp>
#include <rtuwire/core/time.hpp>
#include <rtuwire/core/version.hpp>
#include <rtuwire/trace/tracing.hpp>
#include <rtuwire/wire/errc.hpp>

namespace rtuwire::inline RTUWIRE_BUILD {

/// The base of a client's reception.
template <typename Statistics, typename Line, typename Options, typename Debts, std::size_t Front>
class frame_trace : public request_steps<Statistics, Line, Options, Debts, Front> {
    using steps = request_steps<Statistics, Line, Options, Debts, Front>;

public:
    using steps::steps;

protected:
    using steps::echo_;
    using steps::framer;
    using steps::options;
    using steps::quarantine_;
    using steps::statistics_;

    /// Bytes have arrived.
    [[gnu::always_inline]] constexpr void pass_heard(instant now) noexcept
    {
        if constexpr (is_traced<Statistics>) {
            statistics_.note_heard(now);
        }
    }

    /// Traces a byte that is skipped before a response.
    [[gnu::always_inline]] constexpr void pass_noise(std::byte byte) noexcept
    {
        if constexpr (is_traced<Statistics>) {
            statistics_.pass({&byte, 1}, frame_role::unknown, frame_verdict::stray);
        }
    }

    /// Traces a frame that arrived while a response was awaited, by the error that was found in it.
    [[gnu::always_inline]] constexpr void pass_frame(byte_view bytes, errc wrong) noexcept
    {
        if constexpr (is_traced<Statistics>) {
            if (not bytes.empty()) {
                bool const has_end = framer().verdict() == errc::none and framer().matches_size_hint();
                statistics_.pass(bytes, has_end ? frame_role::response : frame_role::unknown, verdict_of(bytes, wrong));
            }
        }
    }

    /// Traces a frame that ended in a collision.
    [[gnu::always_inline]] constexpr void pass_collision(bool is_end) noexcept
    {
        if constexpr (is_traced<Statistics>) {
            pass_frame(is_end ? framer().bytes() : byte_view{}, errc::collision);
        }
    }

    /// Traces an echo that has come back whole, or up to a byte that differs, which begins `rest`; `before` bytes had come
    /// before.
    [[gnu::always_inline]] constexpr void pass_echoed(std::size_t before, std::size_t same, byte_view rest) noexcept
    {
        if constexpr (is_traced<Statistics>) {
            if (echo_.is_open()) {
                return;
            }
            bool const is_all = echo_.is_whole() or this->expects_echo() or steps::phase_ != client_phase::awaiting;
            this->pass_echo(is_all ? before + same : this->outside_frame(before));
            if (not echo_.is_whole() and this->expects_echo()) {
                statistics_.pass(rest.first(1), frame_role::unknown, frame_verdict::damaged);
            }
        }
    }

private:
    constexpr frame_verdict verdict_of(byte_view bytes, errc wrong) const noexcept
    {
        if (framer().verdict() != errc::none or not framer().matches_size_hint()) {
            return frame_verdict::damaged;
        }
        if (wrong == errc::none or is_exception(wrong)) {
            return frame_verdict::good;
        }
        if (wrong == errc::wrong_unit) {
            return quarantine_.covers(to_u8(bytes[0])) ? frame_verdict::late : frame_verdict::foreign;
        }
        return wrong == errc::line_echo ? frame_verdict::echo : frame_verdict::stray;
    }
};

} // namespace rtuwire
