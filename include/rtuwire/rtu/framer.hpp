// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// Frames out of octets and silence (SL 2.5.1.1). A frame ends by its length rule when its CRC is right
// there; otherwise, and where there is no rule, it ends by silence. A CRC match alone never ends one,
// and no frame is looked for anywhere but at its start. Needs one frame of memory.
//
//   state          octet                                   silence
//   synchronising  dropped                                 -> idle
//   idle           -> receiving                            stays
//   receiving      kept; rule met and CRC right -> done    -> done: a frame, or damaged
//   done           a new frame starts                      -> idle
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

#include <rtuwire/core/bytes.hpp>
#include <rtuwire/core/crc16.hpp>
#include <rtuwire/core/result.hpp>
#include <rtuwire/core/time.hpp>
#include <rtuwire/rtu/line.hpp>
#include <rtuwire/wire/adu.hpp>
#include <rtuwire/wire/errc.hpp>
#include <rtuwire/wire/frame_length.hpp>

namespace rtuwire {

/// Cuts a stream of octets into frames. Call `receive` with what arrived until all of it is taken, and
/// `poll_frame` after each; call `advance` when time has passed, at least when `poll_deadline` says.
/// Starts by ignoring everything until the line has been silent once.
class framer {
public:
    constexpr framer(direction way, line_timing const& line) noexcept : line_{line}, way_{way} {}

    /// Takes octets that had arrived by `now`, in any chunking, up to the end of one frame; returns how
    /// many were taken. Octets after a frame that were not taken belong to the next call.
    constexpr std::size_t receive(byte_view octets, instant now) noexcept
    {
        if (octets.empty()) {
            return 0;
        }
        // What nobody polled is dropped, so that taking octets always gets on.
        polled_ = true;
        // The first octet of a lump arrived earlier than the lump was handed over.
        if (started_ and now - last_ >= line_.frame_end() + line_.characters(octets.size())) {
            fall_silent();
        }
        if (state_ == state::done and not polled_) {
            return 0;
        }
        note_activity(now);
        std::size_t taken = 0;
        while (taken < octets.size()) {
            take(octets[taken++]);
            if (state_ == state::done) {
                break;
            }
        }
        return taken;
    }

    /// Takes the receiver's word that an octet arrived damaged (parity, framing, overrun): the frame it
    /// belongs to is refused even if its CRC is right.
    constexpr void receive_error(instant now) noexcept
    {
        note_activity(now);
        if (state_ == state::synchronising) {
            return;
        }
        if (state_ != state::receiving) {
            begin();
        }
        poisoned_ = true;
    }

    /// Lets silence take effect. To be called before the clock has run 35 minutes past a deadline.
    constexpr void advance(instant now) noexcept
    {
        if (not started_) {
            note_activity(now);
        }
        if (busy_ and reached(now, last_ + line_.t3_5())) {
            busy_ = false;
        }
        if (waits_for_silence() and reached(now, last_ + line_.frame_end())) {
            fall_silent();
        }
    }

    /// When `advance` has something to do.
    [[nodiscard]] constexpr deadline poll_deadline() const noexcept
    {
        deadline const quiet = busy_ ? deadline{last_ + line_.t3_5()} : deadline{};
        deadline const end = waits_for_silence() ? deadline{last_ + line_.frame_end()} : deadline{};
        return started_ ? earlier(quiet, end) : std::nullopt;
    }

    /// The frame that ended, once; or why what ended is none. The view is valid until octets are taken
    /// again. Errors: `frame_too_short`, `frame_too_long`, `crc_mismatch`, `uart_error`.
    [[nodiscard]] constexpr std::optional<result<adu>> poll_frame() noexcept
    {
        if (state_ != state::done or polled_) {
            return std::nullopt;
        }
        polled_ = true;
        if (errc const wrong = verdict(); wrong != errc::none) {
            return wrong;
        }
        return adu{to_u8(octets_[0]), byte_view{octets_}.subspan(1, size_ - adu_overhead)};
    }

    /// Drops what is being received and takes the next octet for the first of a frame: for a line whose
    /// silence the caller vouches for, because its own transmission just ended.
    constexpr void restart(instant now) noexcept
    {
        note_activity(now);
        state_ = state::idle;
    }

    /// Ignores everything until the line has been silent.
    constexpr void resynchronise() noexcept { state_ = state::synchronising; }

    /// Takes note that a request to another unit passed: a frame of that unit and function is then its
    /// answer and ends as one, so that what follows is heard without a silence before it. Any other
    /// frame is read as before; the unit may never answer.
    constexpr void overhear(std::uint8_t unit, std::uint8_t function) noexcept
    {
        overheard_ = {unit, function, true};
    }

    /// Whether the frame that ended last was the answer that `overhear` spoke of.
    [[nodiscard]] constexpr bool is_overheard() const noexcept { return is_overheard_; }

    /// Records that the line was not silent at `now`, and leaves the frame alone.
    constexpr void note_activity(instant now) noexcept
    {
        last_ = now;
        busy_ = true;
        started_ = true;
    }

    /// Whether t3.5 of silence has passed, so that somebody may send.
    [[nodiscard]] constexpr bool is_quiet() const noexcept { return started_ and not busy_; }

    /// Whether the next octet would be the first of a frame.
    [[nodiscard]] constexpr bool is_at_start() const noexcept
    {
        return state_ == state::idle or state_ == state::done;
    }

    /// The first octet of what ended last, when it had a frame's size: who it claims to be for or from.
    [[nodiscard]] constexpr std::optional<std::uint8_t> claimed_unit() const noexcept
    {
        if (size_ < min_adu_size) {
            return std::nullopt;
        }
        return to_u8(octets_[0]);
    }

    /// The memory of the frame, for an answer written in its place.
    [[nodiscard]] constexpr byte_span storage() noexcept { return octets_; }

    [[nodiscard]] constexpr line_timing const& line() const noexcept { return line_; }

private:
    enum class state : std::uint8_t { synchronising, idle, receiving, done };

    /// A question between others whose answer may come.
    struct exchange_of_others {
        std::uint8_t unit{0};
        std::uint8_t function{0};
        bool is_open{false};

        /// Of at least two octets.
        [[nodiscard]] constexpr bool answers(byte_view so_far) const noexcept
        {
            return is_open and to_u8(so_far[0]) == unit and
                   (to_u8(so_far[1]) & ~exception_bit) == function;
        }
    };

    constexpr bool waits_for_silence() const noexcept
    {
        return state_ != state::idle and state_ != state::done;
    }

    constexpr void begin() noexcept
    {
        state_ = state::receiving;
        is_overheard_ = false;
        size_ = 0;
        look_at_ = 2;
        crc_ = {};
        poisoned_ = false;
        overlong_ = false;
    }

    constexpr void take(std::byte octet) noexcept
    {
        if (state_ == state::synchronising) {
            return;
        }
        if (state_ != state::receiving) {
            begin();
        }
        if (size_ == max_adu_size) {
            overlong_ = true;
            return;
        }
        octets_[size_++] = octet;
        crc_.add(octet);
        if (size_ == look_at_) {
            look();
        }
    }

    /// Applies the length rule at the octet it asked for.
    constexpr void look() noexcept
    {
        byte_view const so_far = byte_view{octets_}.first(size_);
        bool const is_foreign = overheard_.answers(so_far);
        length_so_far const known = frame_length(is_foreign ? direction::response : way_, so_far);
        bool const is_end = known.is_final and known.size == size_;
        if (is_end and verdict() == errc::none) {
            is_overheard_ = is_foreign;
            overheard_.is_open = overheard_.is_open and not is_foreign;
            finish();
        }
        // Past an end whose CRC is wrong only silence tells where the next frame starts.
        look_at_ = is_end ? std::uint16_t{0} : known.size;
    }

    constexpr void finish() noexcept
    {
        state_ = state::done;
        polled_ = false;
    }

    constexpr errc verdict() const noexcept
    {
        if (poisoned_) {
            return errc::uart_error;
        }
        if (overlong_) {
            return errc::frame_too_long;
        }
        if (size_ < min_adu_size) {
            return errc::frame_too_short;
        }
        return crc_.value() == 0 ? errc::none : errc::crc_mismatch;
    }

    constexpr void fall_silent() noexcept
    {
        switch (state_) {
        case state::synchronising: state_ = state::idle; break;
        case state::receiving: finish(); break;
        case state::idle:
        case state::done: break;
        }
    }

    line_timing line_;
    instant last_{};
    std::uint16_t size_{0};
    std::uint16_t look_at_{0};
    running_crc16<> crc_{};
    direction way_;
    exchange_of_others overheard_{};
    bool is_overheard_{false};
    state state_{state::synchronising};
    bool poisoned_{false};
    bool overlong_{false};
    bool polled_{true};
    bool busy_{true};
    bool started_{false};
    std::array<std::byte, max_adu_size> octets_; ///< the first `size_` are written
};

} // namespace rtuwire
