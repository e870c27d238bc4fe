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
//   receiving      kept; rule met and CRC right -> done,   -> done: a frame, or damaged
//                  or open end
//   open end       -> done, with it if it is 00, or        -> done, after t3.5
//                  without
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
#include <rtuwire/core/version.hpp>
#include <rtuwire/rtu/exchange_of_others.hpp>
#include <rtuwire/rtu/frame_place.hpp>
#include <rtuwire/rtu/line.hpp>
#include <rtuwire/wire/adu.hpp>
#include <rtuwire/wire/errc.hpp>
#include <rtuwire/wire/frame_length.hpp>

namespace rtuwire::inline RTUWIRE_BUILD {

/// Cuts a stream of octets into frames. Call `receive` with what arrived until all of it is taken, and
/// `poll_frame` after each; call `advance` when time has passed, at least when `poll_deadline` says.
/// Starts by ignoring everything until the line has been silent once.
///
/// `Holder` derives from it and holds the line's times, `line_`, and the memory, `octets_`, behind what else it has:
/// small processors reach near members with short instructions.
template <typename Holder, direction Way, std::size_t Front> class frame_cutter {
public:
    constexpr frame_cutter() noexcept = default;

    /// Takes octets that had arrived by `now`, in any chunking, up to the end of one frame; returns how
    /// many were taken. Octets after a frame that were not taken belong to the next call.
    constexpr std::size_t receive(byte_view octets, instant now) noexcept
    {
        if (octets.empty() or hear(octets.size(), now)) {
            return 0;
        }
        std::size_t taken = 0;
        if constexpr (Way == direction::request) {
            if (is_open_end()) {
                state_ = state::done;
                return others_.takes(octets[0]) ? 1 : 0;
            }
        }
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
            reached(now, last_ + silence() + line().characters(octets))) {
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
        if (end_ == place_.memory) {
            trouble_ = trouble_ == errc::none ? errc::frame_too_long : trouble_;
            return false;
        }
        storage()[end_++] = octet;
        crc_.add(octet);
        return end_ == look_at_ and look();
    }

    /// Takes the receiver's word that an octet arrived damaged (parity, framing, overrun): the frame it
    /// belongs to is refused even if its CRC is right. What the silence before it ended, and nobody polled yet,
    /// is dropped.
    constexpr void receive_error(instant now) noexcept
    {
        static_cast<void>(hear(1, now));
        spoil();
    }

    /// The second part of `receive_error`, after `hear`.
    constexpr void spoil() noexcept
    {
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
        if (waits_for_silence() and reached(now, last_ + silence())) {
            fall_silent();
        }
    }

    /// When `advance` has something to do.
    [[nodiscard]] constexpr deadline poll_deadline() const noexcept
    {
        earliest next;
        add_to(next);
        return next;
    }

    /// The same as one of several times.
    constexpr void add_to(earliest& next) const noexcept
    {
        // The silence that ends a frame is never shorter than the one before sending.
        if (activity_ == activity::busy) {
            next.add(last_ + line().t3_5());
        } else if (activity_ == activity::quiet and waits_for_silence()) {
            next.add(last_ + line().frame_end());
        }
    }

    /// The same for who does not send: when the frame that is being received, or what was ignored, ends by
    /// silence. A plain form of its own, which saves 90 bytes of a server.
    [[nodiscard]] constexpr deadline poll_end_deadline() const noexcept
    {
        return activity_ == activity::unknown or not waits_for_silence()
                   ? deadline{}
                   : deadline{last_ + silence()};
    }

    /// The frame that ended, once; or why what ended is none. The view is valid until octets are taken
    /// again. Errors: `frame_too_short`, `frame_too_long`, `crc_mismatch`, `uart_error`; of a response also
    /// `wrong_length`, where silence ended it at another size than its own octets say.
    [[nodiscard]] constexpr std::optional<result<adu>> poll_frame() noexcept
    {
        if (not poll_end()) {
            return std::nullopt;
        }
        errc const wrong = verdict();
        if (wrong != errc::none) {
            return wrong;
        }
        if (Way == direction::response and not has_told_size()) {
            return errc::wrong_length;
        }
        return frame();
    }

    /// The same in three parts, for who asks at each octet: whether something ended, once.
    [[nodiscard, gnu::always_inline]] constexpr bool poll_end() noexcept
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
        if (size() < min_adu_size) {
            return errc::frame_too_short;
        }
        return crc_.value() == 0 ? errc::none : errc::crc_mismatch;
    }

    /// Whether what ended last has the size that its own octets tell, where they tell one. Silence may have ended
    /// it elsewhere, and by chance its CRC is right there, too.
    [[nodiscard]] constexpr bool has_told_size() const noexcept
    {
        return look_at_ == 0 or look_at_ == end_;
    }

    /// The frame that ended last, where the verdict is none.
    [[nodiscard]] constexpr adu frame() const noexcept
    {
        return adu{{storage().data() + place_.begin(), size()}};
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

    /// Takes note of a request that passed: the response of this unit and function may follow. Frames
    /// with these first two bytes (the function with or without 80) then end at the size of the request's
    /// rule or of the response's, the first of the two where the CRC is right. Where the other is one byte
    /// more, a byte 00 that follows at once belongs to the frame, but is not kept: of such frames only the
    /// first two bytes are of use. A function of 80 or above ends that.
    constexpr void overhear(std::uint8_t unit, std::uint8_t function) noexcept
        requires(Way == direction::request)
    {
        others_.expect(unit, function);
    }

    /// Whether the frame that ended last ended at the size of the response that `overhear` spoke of.
    [[nodiscard]] constexpr bool is_overheard() const noexcept requires(Way == direction::request)
    {
        return others_.is_response();
    }

    /// When the last byte arrived, or `note_activity` was called since.
    [[nodiscard]] constexpr instant last_activity() const noexcept { return last_; }

    /// Records that the line was not silent at `now`, and leaves the frame alone. While it is busy, a time before
    /// the latest one that was recorded changes nothing.
    constexpr void note_activity(instant now) noexcept
    {
        if (activity_ != activity::busy or reached(now, last_)) {
            last_ = now;
        }
        activity_ = activity::busy;
    }

    /// Whether t3.5 of silence has passed, so that somebody may send.
    [[nodiscard]] constexpr bool is_quiet() const noexcept { return activity_ == activity::quiet; }

    /// Whether the next octet would be the first of a frame.
    [[nodiscard]] constexpr bool is_at_start() const noexcept { return not waits_for_silence(); }

    /// Whether what ended last had a frame's size, and began as an answer to this question begins: with its
    /// unit and its function.
    [[nodiscard]] constexpr bool claims(byte_view question) const noexcept
    {
        std::byte const* const start = storage().data() + place_.begin();
        return size() >= min_adu_size and start[0] == question[0] and
               (start[1] & std::byte{0x7F}) == question[1];
    }

    /// The memory of the frame, for an answer written in its place.
    [[nodiscard]] constexpr byte_span storage() noexcept { return static_cast<Holder&>(*this).octets_; }
    [[nodiscard]] constexpr byte_view storage() const noexcept
    {
        return static_cast<Holder const&>(*this).octets_;
    }

    /// Keeps the first `size` octets of the memory, at most 256, free of what is received from here on.
    constexpr void receive_behind(std::size_t size) noexcept requires(Front > 0)
    {
        place_.leave_room_for(size);
        end_ = place_.begin();
    }

    /// The largest frame that there is room for.
    [[nodiscard]] constexpr std::size_t room() const noexcept
    {
        return place_.memory - place_.begin();
    }

    [[nodiscard]] constexpr line_timing const& line() const noexcept
    {
        return static_cast<Holder const&>(*this).line_.get();
    }

private:
    /// A constant, so that no constructor reckons it.
    static constexpr running_crc16<> no_octets{0};

    enum class state : std::uint8_t { synchronising, receiving, open_end, idle, done };

    /// What the line did last; nothing is known of it before the clock was seen.
    enum class activity : std::uint8_t { unknown, busy, quiet };

    /// Never among responses.
    constexpr bool is_open_end() const noexcept
    {
        return Way == direction::request and state_ == state::open_end;
    }

    constexpr bool waits_for_silence() const noexcept { return state_ < state::idle; }

    constexpr void begin() noexcept
    {
        state_ = state::receiving;
        others_.begin_frame();
        end_ = place_.begin();
        look_at_ = static_cast<std::uint16_t>(place_.begin() + 2);
        crc_ = running_crc16<>{};
        trouble_ = errc::none;
    }

    /// The silence that ends what is being received.
    constexpr duration silence() const noexcept
    {
        return is_open_end() ? line().t3_5() : line().frame_end();
    }

    /// Applies the length rule at the octet it asked for. Whether the frame ends here. Part of `take`, and
    /// smaller there than apart.
    [[gnu::always_inline]] constexpr bool look() noexcept
    {
        told_end const told = others_.apply({storage().data() + place_.begin(), size()});
        // Zero, which no octet's place is here, where nothing but silence tells the end. Past an end whose CRC
        // is wrong only silence tells where the next frame starts.
        look_at_ = told.next == 0 ? std::uint16_t{0}
                                  : static_cast<std::uint16_t>(place_.begin() + told.next);
        if (not told.is_here or verdict() != errc::none) {
            return false;
        }
        others_.end_frame(told.is_response);
        state_ = told.is_open ? state::open_end : state::done;
        return true;
    }

    constexpr std::size_t size() const noexcept { return std::size_t{end_} - place_.begin(); }

    constexpr void fall_silent() noexcept
    {
        if (waits_for_silence()) {
            // Synchronising -> idle, receiving -> done: three further, unless the end was open.
            bool const is_ahead = Way == direction::request and state_ != state::synchronising;
            state_ =
                is_ahead ? state::done : static_cast<state>(static_cast<std::uint8_t>(state_) + 3U);
        }
    }

    state state_{state::synchronising};
    activity activity_{activity::unknown};
    [[no_unique_address]] running_crc16<> crc_{no_octets};
    errc trouble_{errc::none};
    [[no_unique_address]] exchange_of_others<Way> others_{};
    std::uint16_t end_{0}; ///< behind the last octet
    std::uint16_t look_at_{
        0}; ///< where the length rule is to be applied; 0 where it has nothing to say
    [[no_unique_address]] frame_place<Front> place_{};
    instant last_{0};
};

/// A frame cutter with its memory.
template <direction Way, typename Line = held<line_timing>, std::size_t Front = 0>
class framer : public frame_cutter<framer<Way, Line, Front>, Way, Front> {
    using cutter = frame_cutter<framer, Way, Front>;
    friend cutter;

public:
    explicit constexpr framer(line_timing const& line) noexcept : line_{line} {}

    /// With the times of a line that is fixed: all zero, so that a `constinit` one needs no flash.
    constexpr framer() noexcept requires is_fixed<Line> : octets_{} {}

private:
    [[no_unique_address]] Line line_{};
    std::array<std::byte, frame_place<Front>::memory> octets_; ///< written up to the frame's end
};

} // namespace rtuwire
