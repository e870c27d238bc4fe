// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// Splits received bytes into frames by length and silence (SL 2.5.1.1). A frame ends where its length rule
// says, if the CRC is right there; otherwise, and where there is no rule, it ends by silence. A CRC match
// alone never ends a frame, and no frame is searched for inside other bytes. Needs memory for one frame.
//
//   state          byte                  damaged byte  t3.5   frame_end  poll_frame  restart  resynchronise
//   synchronising  dropped               stays         stays  idle       stays       idle     stays
//   idle           receiving             receiving     stays  stays      stays       stays    synchronising
//   receiving      kept; at the last     stays         stays  done       stays       idle     synchronising
//                  done or open end
//   open end       done                  receiving     done   done       stays       idle     synchronising
//   done           receiving             receiving     stays  stays      idle        idle     synchronising
//
// The last byte is the one where the rule is met and the CRC is right. An end is open where another unit's response
// may end there or one byte later: a byte 00 is then the last, any other begins the next frame. Done: a frame, or why
// the bytes are none; what was not polled when the next byte arrives is dropped.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>

#include <rtuwire/core/bytes.hpp>
#include <rtuwire/core/constant.hpp>
#include <rtuwire/core/result.hpp>
#include <rtuwire/core/time.hpp>
#include <rtuwire/core/version.hpp>
#include <rtuwire/rtu/frame_cutter.hpp>
#include <rtuwire/rtu/frame_place.hpp>
#include <rtuwire/rtu/line.hpp>
#include <rtuwire/wire/adu.hpp>
#include <rtuwire/wire/errc.hpp>

namespace rtuwire {
inline namespace RTUWIRE_BUILD {

/// Splits a stream of bytes into frames. Call `receive` with the bytes that arrived until all are taken, and
/// `poll_frame` after each call; call `advance` when time has passed, at the latest at `poll_deadline`.
/// Ignores everything until the line has been silent once.
template <detail::direction Way, typename Line = detail::stored<line_timing>> class framer {
    using cutter = detail::frame_cutter<Way, detail::frame_place<0>, Line>;

public:
    explicit constexpr framer(line_timing const& timing) noexcept : memory_{timing} {}

    /// For compile-time timing. Zero-initialised, so a `constinit` framer lives in .bss.
    constexpr framer() noexcept requires(detail::is_constant<Line>) = default;

    /// Takes bytes that had arrived by `now`, in chunks of any size, up to the end of one frame; returns how
    /// many were taken. The bytes after that frame belong to the next call.
    constexpr std::size_t receive(byte_view bytes, instant now) noexcept
    {
        return cutter_.receive(memory_, bytes, now);
    }

    /// Reports a receive error (parity, framing, overrun): the frame that the damaged byte belongs to is
    /// refused even if its CRC is right. A frame that the silence before the byte ended, and that was not
    /// polled yet, is discarded.
    constexpr void receive_error(instant now) noexcept { cutter_.receive_error(memory_, now); }

    /// Applies the silence up to `now`. Must be called before the clock has run 35 minutes past a deadline.
    constexpr void advance(instant now) noexcept { cutter_.advance(memory_, now); }

    /// When `advance` has something to do.
    [[nodiscard]] constexpr deadline poll_deadline() const noexcept
    {
        detail::earliest next;
        cutter_.add_to(memory_, next);
        return next;
    }

    /// The frame that ended, once; or why the bytes that ended are no frame. The view is valid until bytes
    /// are taken again. Errors: `frame_too_short`, `frame_too_long`, `crc_mismatch`, `uart_error`; of a
    /// response also `wrong_length`, where silence ended it at another size than its own bytes tell.
    [[nodiscard]] constexpr std::optional<result<adu>> poll_frame() noexcept
    {
        if (not cutter_.poll_end()) {
            return std::nullopt;
        }
        errc const wrong = cutter_.verdict(memory_);
        if (wrong != errc::none) {
            return wrong;
        }
        if (Way == detail::direction::response and not cutter_.matches_size_hint()) {
            return errc::wrong_length;
        }
        return cutter_.frame(memory_);
    }

    /// Whether t3.5 of silence has passed, so that sending is allowed.
    [[nodiscard]] constexpr bool is_quiet() const noexcept { return cutter_.is_quiet(); }

    /// Whether the next byte would be the first of a frame.
    [[nodiscard]] constexpr bool is_at_start() const noexcept { return cutter_.is_at_start(); }

    /// When the last byte arrived, or the time of a later `note_activity`.
    [[nodiscard]] constexpr instant last_activity() const noexcept { return cutter_.last_activity(); }

    /// By when to judge what was in force then. Internal.
    [[nodiscard]] constexpr instant within_reach_of_line(instant now) const noexcept
    {
        return cutter_.within_reach_of_line(memory_, now);
    }

    /// Records that the line was not silent at a time, and leaves the frame alone.
    constexpr void note_activity(instant now) noexcept { cutter_.note_activity(now); }

    /// Drops what is being received and takes the next byte as the first of a frame: for a line that the
    /// caller knows to be silent, because its own transmission just ended.
    constexpr void restart(instant now) noexcept { cutter_.restart(now); }

    /// Ignores everything until the line has been silent.
    constexpr void resynchronise() noexcept { cutter_.resynchronise(); }

    /// Records a request to another unit, whose response may follow.
    constexpr void note_foreign_request(std::uint8_t unit, std::uint8_t function) noexcept
        requires(Way == detail::direction::request)
    {
        cutter_.note_foreign_request(unit, function);
    }

    /// Whether the last frame ended at the size of the response that `note_foreign_request` announced.
    [[nodiscard]] constexpr bool is_foreign_response() const noexcept requires(Way == detail::direction::request)
    {
        return cutter_.is_foreign_response();
    }

    /// The timing of its line.
    [[nodiscard]] constexpr line_timing const& line() const noexcept { return memory_.timing(); }

private:
    cutter cutter_{};
    typename cutter::memory memory_;
};

} // namespace RTUWIRE_BUILD
} // namespace rtuwire
