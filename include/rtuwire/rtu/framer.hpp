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
#include <optional>

#include <rtuwire/core/bytes.hpp>
#include <rtuwire/core/constant.hpp>
#include <rtuwire/core/result.hpp>
#include <rtuwire/core/time.hpp>
#include <rtuwire/core/version.hpp>
#include <rtuwire/rtu/frame_cutter.hpp>
#include <rtuwire/rtu/line.hpp>
#include <rtuwire/wire/adu.hpp>
#include <rtuwire/wire/errc.hpp>

namespace rtuwire::inline RTUWIRE_BUILD {

/// Splits a stream of bytes into frames. Call `receive` with the bytes that arrived until all are taken, and
/// `poll_frame` after each call; call `advance` when time has passed, at the latest at `poll_deadline`.
/// Ignores everything until the line has been silent once.
template <direction Way, typename Line = stored<line_timing>> class framer : private detail::frame_receiver<Way, Line> {
    using receiver = detail::frame_receiver<Way, Line>;

public:
    explicit constexpr framer(line_timing const& timing) noexcept : receiver{timing} {}

    /// For compile-time timing. Zero-initialised, so a `constinit` framer lives in .bss.
    constexpr framer() noexcept requires is_constant<Line> : receiver{} {}

    /// Takes bytes that had arrived by `now`, in chunks of any size, up to the end of one frame; returns how
    /// many were taken. The bytes after that frame belong to the next call.
    constexpr std::size_t receive(byte_view bytes, instant now) noexcept { return receiver::receive(bytes, now); }

    /// Reports a receive error (parity, framing, overrun): the frame that the damaged byte belongs to is
    /// refused even if its CRC is right. A frame that the silence before the byte ended, and that was not
    /// polled yet, is discarded.
    constexpr void receive_error(instant now) noexcept { receiver::receive_error(now); }

    /// Applies the silence up to `now`. Must be called before the clock has run 35 minutes past a deadline.
    constexpr void advance(instant now) noexcept { receiver::advance(now); }

    /// When `advance` has something to do.
    [[nodiscard]] constexpr deadline poll_deadline() const noexcept
    {
        earliest next;
        this->add_to(next);
        return next;
    }

    /// The frame that ended, once; or why the bytes that ended are no frame. The view is valid until bytes
    /// are taken again. Errors: `frame_too_short`, `frame_too_long`, `crc_mismatch`, `uart_error`; of a
    /// response also `wrong_length`, where silence ended it at another size than its own bytes tell.
    [[nodiscard]] constexpr std::optional<result<adu>> poll_frame() noexcept
    {
        if (not this->poll_end()) {
            return std::nullopt;
        }
        errc const wrong = this->verdict();
        if (wrong != errc::none) {
            return wrong;
        }
        if (Way == direction::response and not this->matches_size_hint()) {
            return errc::wrong_length;
        }
        return this->frame();
    }

    /// Whether t3.5 of silence has passed, so that sending is allowed.
    using receiver::is_quiet;

    /// Whether the next byte would be the first of a frame.
    using receiver::is_at_start;

    /// When the last byte arrived, or the time of a later `note_activity`.
    using receiver::last_activity;

    /// By when to judge what was in force then. Internal.
    using receiver::within_reach_of_line;

    /// Records that the line was not silent at a time, and leaves the frame alone.
    using receiver::note_activity;

    /// Drops what is being received and takes the next byte as the first of a frame: for a line that the
    /// caller knows to be silent, because its own transmission just ended.
    using receiver::restart;

    /// Ignores everything until the line has been silent.
    using receiver::resynchronise;

    /// Records a request to another unit, whose response may follow.
    using receiver::note_foreign_request;

    /// Whether the last frame ended at the size of the response that `note_foreign_request` announced.
    using receiver::is_foreign_response;

    /// The timing of its line.
    using receiver::line;
};

} // namespace rtuwire
