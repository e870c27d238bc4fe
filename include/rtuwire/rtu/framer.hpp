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
//   done           -> receiving; what nobody polled is     stays; polled -> idle
//                  dropped
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

#include <rtuwire/core/bytes.hpp>
#include <rtuwire/core/crc16.hpp>
#include <rtuwire/core/fixed.hpp>
#include <rtuwire/core/result.hpp>
#include <rtuwire/core/time.hpp>
#include <rtuwire/rtu/exchange_of_others.hpp>
#include <rtuwire/rtu/line.hpp>
#include <rtuwire/wire/adu.hpp>
#include <rtuwire/wire/errc.hpp>
#include <rtuwire/wire/frame_length.hpp>

namespace rtuwire {

/// Cuts a stream of octets into frames. Call `receive` with what arrived until all of it is taken, and
/// `poll_frame` after each; call `advance` when time has passed, at least when `poll_deadline` says.
/// Starts by ignoring everything until the line has been silent once.
template <direction Way, typename Line = held<line_timing>> class framer {
public:
    explicit constexpr framer(line_timing const& line) noexcept : line_{line} {}

    /// With the times of a line that is fixed: all zero, so that a `constinit` one needs no flash.
    constexpr framer() noexcept requires is_fixed<Line> : octets_{} {}

    /// Takes octets that had arrived by `now`, in any chunking, up to the end of one frame; returns how
    /// many were taken. Octets after a frame that were not taken belong to the next call.
    constexpr std::size_t receive(byte_view octets, instant now) noexcept
    {
        if (octets.empty() or hear(octets.size(), now)) {
            return 0;
        }
        std::size_t taken = 0;
        while (taken < octets.size() and not take(octets[taken++])) {
        }
        return taken;
    }

    /// The first part of `receive`: so many octets, one at least, had arrived by `now`. Whether the silence
    /// before them ended something, which is to be polled before the first is taken.
    constexpr bool hear(std::size_t octets, instant now) noexcept
    {
        // What nobody polled is dropped, so that taking octets always gets on.
        if (state_ == state::done) {
            state_ = state::idle;
        }
        // The first octet of a lump arrived earlier than the lump was handed over.
        if (activity_ != activity::unknown and
            now - last_ >= line().frame_end() + line().characters(octets)) {
            fall_silent();
        }
        note_activity(now);
        return state_ == state::done;
    }

    /// The second part: takes one of them. Whether it was the last of a frame. A function of its own, so that
    /// no caller makes it larger.
    [[gnu::noinline]] constexpr bool take(std::byte octet) noexcept
    {
        if (state_ == state::synchronising) {
            return false;
        }
        if (state_ != state::receiving) {
            begin();
        }
        if (size_ == max_adu_size) {
            trouble_ = trouble_ == errc::none ? errc::frame_too_long : trouble_;
            return false;
        }
        octets_[size_++] = octet;
        crc_.add(octet);
        return size_ == look_at_ and look();
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
        trouble_ = errc::uart_error;
    }

    /// Lets silence take effect. To be called before the clock has run 35 minutes past a deadline.
    constexpr void advance(instant now) noexcept
    {
        if (activity_ == activity::unknown) {
            note_activity(now);
        }
        if (reached(now, last_ + line().t3_5())) {
            activity_ = activity::quiet;
        }
        if (waits_for_silence() and reached(now, last_ + line().frame_end())) {
            fall_silent();
        }
    }

    /// When `advance` has something to do.
    [[nodiscard]] constexpr deadline poll_deadline() const noexcept
    {
        // The silence that ends a frame is never shorter than the one before sending.
        if (activity_ == activity::busy) {
            return last_ + line().t3_5();
        }
        return activity_ == activity::quiet and waits_for_silence()
                   ? deadline{last_ + line().frame_end()}
                   : deadline{};
    }

    /// The frame that ended, once; or why what ended is none. The view is valid until octets are taken
    /// again. Errors: `frame_too_short`, `frame_too_long`, `crc_mismatch`, `uart_error`.
    [[nodiscard]] constexpr std::optional<result<adu>> poll_frame() noexcept
    {
        if (not poll_end()) {
            return std::nullopt;
        }
        errc const wrong = verdict();
        return wrong == errc::none ? result<adu>{frame()} : result<adu>{wrong};
    }

    /// The same in three parts, for who asks at each octet: whether something ended, once.
    [[nodiscard]] constexpr bool poll_end() noexcept
    {
        bool const is_end = state_ == state::done;
        if (is_end) {
            state_ = state::idle;
        }
        return is_end;
    }

    /// Why what ended last is no frame; none where it is one.
    [[nodiscard]] constexpr errc verdict() const noexcept
    {
        if (trouble_ != errc::none) {
            return trouble_;
        }
        if (size_ < min_adu_size) {
            return errc::frame_too_short;
        }
        return crc_.value() == 0 ? errc::none : errc::crc_mismatch;
    }

    /// The frame that ended last, where the verdict is none.
    [[nodiscard]] constexpr adu frame() const noexcept { return adu{{octets_.data(), size_}}; }

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
        requires(Way == direction::request)
    {
        others_.expect(unit, function);
    }

    /// Whether the frame that ended last was the answer that `overhear` spoke of.
    [[nodiscard]] constexpr bool is_overheard() const noexcept requires(Way == direction::request)
    {
        return others_.has_ended();
    }

    /// Records that the line was not silent at `now`, and leaves the frame alone.
    constexpr void note_activity(instant now) noexcept
    {
        last_ = now;
        activity_ = activity::busy;
    }

    /// Whether t3.5 of silence has passed, so that somebody may send.
    [[nodiscard]] constexpr bool is_quiet() const noexcept { return activity_ == activity::quiet; }

    /// Whether the next octet would be the first of a frame.
    [[nodiscard]] constexpr bool is_at_start() const noexcept { return not waits_for_silence(); }

    /// Whether what ended last had a frame's size, and a unit's address at its start.
    [[nodiscard]] constexpr bool claims(std::uint8_t unit) const noexcept
    {
        return size_ >= min_adu_size and to_u8(octets_[0]) == unit;
    }

    /// The memory of the frame, for an answer written in its place.
    [[nodiscard]] constexpr byte_span storage() noexcept { return octets_; }

    [[nodiscard]] constexpr line_timing const& line() const noexcept { return line_.get(); }

private:
    enum class state : std::uint8_t { synchronising, receiving, idle, done };

    /// What the line did last; nothing is known of it before the clock was seen.
    enum class activity : std::uint8_t { unknown, busy, quiet };

    constexpr bool waits_for_silence() const noexcept { return state_ <= state::receiving; }

    constexpr void begin() noexcept
    {
        state_ = state::receiving;
        others_.begin_frame();
        size_ = 0;
        look_at_ = 2;
        crc_ = running_crc16<>{};
        trouble_ = errc::none;
    }

    /// Applies the length rule at the octet it asked for. Whether the frame ends here. Part of `take`, and
    /// smaller there than apart.
    [[gnu::always_inline]] constexpr bool look() noexcept
    {
        byte_view const so_far{octets_.data(), size_};
        bool const is_foreign = others_.answers(so_far);
        length_so_far const known = frame_length(is_foreign ? direction::response : Way, so_far);
        if (not known.is_final() or known.size() != size_) {
            look_at_ = static_cast<std::uint16_t>(known.size());
            return false;
        }
        // Past an end whose CRC is wrong only silence tells where the next frame starts.
        look_at_ = 0;
        if (verdict() != errc::none) {
            return false;
        }
        others_.end_frame(is_foreign);
        state_ = state::done;
        return true;
    }

    constexpr void fall_silent() noexcept
    {
        if (waits_for_silence()) {
            // Synchronising -> idle, receiving -> done: two further in both cases.
            state_ = static_cast<state>(static_cast<std::uint8_t>(state_) + 2U);
        }
    }

    // Small first and the frame last: small processors reach near members with short instructions.
    state state_{state::synchronising};
    activity activity_{activity::unknown};
    errc trouble_{errc::none};
    [[no_unique_address]] exchange_of_others<Way> others_{};
    running_crc16<> crc_{0};
    std::uint16_t size_{0};
    std::uint16_t look_at_{0};
    instant last_{};
    [[no_unique_address]] Line line_{};
    std::array<std::byte, max_adu_size> octets_; ///< the first `size_` are written
};

} // namespace rtuwire
