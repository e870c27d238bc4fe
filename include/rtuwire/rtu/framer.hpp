// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// Splits received bytes into frames by length and silence (SL 2.5.1.1). A frame ends where its length rule
// says, if the CRC is right there; otherwise, and where there is no rule, it ends by silence. A CRC match
// alone never ends a frame, and no frame is searched for inside other bytes. Needs memory for one frame.
//
//   state          byte                                   silence
//   synchronising  dropped                                 -> idle
//   idle           -> receiving                            stays
//   receiving      kept; rule met and CRC right -> done,   -> done: a frame, or damaged
//                  or open end
//   open end       -> done, with it if it is 00, or        -> done, after t3.5
//                  without
//   done           -> receiving; an unread frame is        stays; polled -> idle
//                  dropped
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

#include <rtuwire/core/bytes.hpp>
#include <rtuwire/core/constant.hpp>
#include <rtuwire/core/crc16.hpp>
#include <rtuwire/core/result.hpp>
#include <rtuwire/core/time.hpp>
#include <rtuwire/core/version.hpp>
#include <rtuwire/rtu/foreign_exchange.hpp>
#include <rtuwire/rtu/frame_place.hpp>
#include <rtuwire/rtu/line.hpp>
#include <rtuwire/wire/adu.hpp>
#include <rtuwire/wire/errc.hpp>
#include <rtuwire/wire/frame_length.hpp>

namespace rtuwire::inline RTUWIRE_BUILD {

/// Splits a stream of bytes into frames. Call `receive` with the bytes that arrived until all are taken, and
/// `poll_frame` after each call; call `advance` when time has passed, at the latest at `poll_deadline`.
/// Ignores everything until the line has been silent once.
///
/// `Holder` derives from it and holds the line's times, `line_`, and the memory, `bytes_`, behind all other
/// members: small processors reach near members with short instructions.
template <typename Holder, direction Way, std::size_t Front> class frame_cutter {
public:
    constexpr frame_cutter() noexcept = default;

    /// Takes bytes that had arrived by `now`, in chunks of any size, up to the end of one frame; returns how
    /// many were taken. The bytes after that frame belong to the next call.
    constexpr std::size_t receive(byte_view bytes, instant now) noexcept
    {
        if (bytes.empty() or begin_chunk(bytes.size(), now)) {
            return 0;
        }
        std::size_t taken = 0;
        if constexpr (Way == direction::request) {
            if (is_open_end()) {
                state_ = state::done;
                return others_.takes(bytes[0]) ? 1 : 0;
            }
        }
        while (taken < bytes.size() and not push(bytes[taken++])) {
        }
        return taken;
    }

    /// The first part of `receive`: `bytes` bytes, one at least, had arrived by `now`. Returns whether the
    /// silence before them ended a frame, whole or damaged, which must be polled before the first byte is
    /// taken.
    constexpr bool begin_chunk(std::size_t bytes, instant now) noexcept
    {
        // An unread frame is discarded, so receiving never stalls.
        if (state_ == state::done) {
            state_ = state::idle;
        }
        // The first byte of a chunk arrived earlier than the chunk was handed over.
        if (activity_ != activity::unknown and reached(now, last_ + silence() + line().characters(bytes))) {
            on_silence();
        }
        note_activity(now);
        return state_ == state::done;
    }

    /// The second part: takes one byte. Returns whether it was the last of a frame. Not inlined, so that no
    /// caller grows.
    [[gnu::noinline]] constexpr bool push(std::byte byte) noexcept
    {
        if (state_ == state::synchronising) {
            return false;
        }
        if (state_ != state::receiving) {
            begin();
        }
        if (end_ == place_.memory) {
            error_ = error_ == errc::none ? errc::frame_too_long : error_;
            return false;
        }
        storage()[end_++] = byte;
        crc_.add(byte);
        return end_ == rule_at_ and apply_length_rule();
    }

    /// Reports a receive error (parity, framing, overrun): the frame that the damaged byte belongs to is
    /// refused even if its CRC is right. A frame that the silence before the byte ended, and that was not
    /// polled yet, is discarded.
    constexpr void receive_error(instant now) noexcept
    {
        static_cast<void>(begin_chunk(1, now));
        spoil();
    }

    /// The second part of `receive_error`, after `begin_chunk`.
    constexpr void spoil() noexcept
    {
        if (state_ == state::synchronising) {
            return;
        }
        if (state_ != state::receiving) {
            begin();
        }
        error_ = errc::uart_error;
    }

    /// Applies the silence up to `now`. Must be called before the clock has run 35 minutes past a deadline.
    constexpr void advance(instant now) noexcept
    {
        if (activity_ == activity::unknown) {
            note_activity(now);
        }
        if (reached(now, last_ + line().t3_5())) {
            activity_ = activity::quiet;
        }
        if (waits_for_silence() and reached(now, last_ + silence())) {
            on_silence();
        }
    }

    /// When `advance` has something to do.
    [[nodiscard]] constexpr deadline poll_deadline() const noexcept
    {
        earliest next;
        add_to(next);
        return next;
    }

    /// Adds that time to the earliest of several.
    constexpr void add_to(earliest& next) const noexcept
    {
        // The silence that ends a frame is never shorter than the one before sending.
        if (activity_ == activity::busy) {
            next.add(last_ + line().t3_5());
        } else if (activity_ == activity::quiet and waits_for_silence()) {
            next.add(last_ + line().frame_end());
        }
    }

    /// The same for a receiver that does not send: when silence ends the frame being received, or the bytes
    /// being ignored. A separate plain form, which saves 90 bytes of a server.
    [[nodiscard]] constexpr deadline poll_end_deadline() const noexcept
    {
        return activity_ == activity::unknown or not waits_for_silence() ? deadline{} : deadline{last_ + silence()};
    }

    /// The frame that ended, once; or why the bytes that ended are no frame. The view is valid until bytes
    /// are taken again. Errors: `frame_too_short`, `frame_too_long`, `crc_mismatch`, `uart_error`; of a
    /// response also `wrong_length`, where silence ended it at another size than its own bytes tell.
    [[nodiscard]] constexpr std::optional<result<adu>> poll_frame() noexcept
    {
        if (not poll_end()) {
            return std::nullopt;
        }
        errc const wrong = verdict();
        if (wrong != errc::none) {
            return wrong;
        }
        if (Way == direction::response and not matches_size_hint()) {
            return errc::wrong_length;
        }
        return frame();
    }

    /// The same in three parts, for a caller that polls at each byte: whether a frame ended, whole or
    /// damaged, once.
    [[nodiscard, gnu::always_inline]] constexpr bool poll_end() noexcept
    {
        bool const is_end = state_ == state::done;
        if (is_end) {
            state_ = state::idle;
        }
        return is_end;
    }

    /// Why the last frame is refused; none where it is good.
    [[nodiscard]] constexpr errc verdict() const noexcept
    {
        if (error_ != errc::none) {
            return error_;
        }
        if (size() < min_adu_size) {
            return errc::frame_too_short;
        }
        return crc_.value() == 0 ? errc::none : errc::crc_mismatch;
    }

    /// Whether the last frame has the size that its own bytes tell, where they tell one. Silence may have ended
    /// it at another size, where by chance its CRC is right, too.
    [[nodiscard]] constexpr bool matches_size_hint() const noexcept { return rule_at_ == 0 or rule_at_ == end_; }

    /// The last frame, where the verdict is none.
    [[nodiscard]] constexpr adu frame() const noexcept { return adu{{storage().data() + place_.begin(), size()}}; }

    /// Drops what is being received and takes the next byte as the first of a frame: for a line that the
    /// caller knows to be silent, because its own transmission just ended.
    constexpr void restart(instant now) noexcept
    {
        note_activity(now);
        state_ = state::idle;
    }

    /// Ignores everything until the line has been silent.
    constexpr void resynchronise() noexcept { state_ = state::synchronising; }

    /// Records a request to another unit: the response of this unit and function may follow. Frames with
    /// these first two bytes (the function with or without 80) then end at the size by the request's rule or
    /// by the response's, the first of the two where the CRC is right. Where the other size is one byte more,
    /// a byte 00 that follows at once belongs to the frame, but is not kept: of such frames only the first
    /// two bytes are of use. A function of 80 or above ends this.
    constexpr void note_foreign_request(std::uint8_t unit, std::uint8_t function) noexcept
        requires(Way == direction::request)
    {
        others_.expect(unit, function);
    }

    /// Whether the last frame ended at the size of the response that `note_foreign_request` announced.
    [[nodiscard]] constexpr bool is_foreign_response() const noexcept requires(Way == direction::request)
    {
        return others_.is_response();
    }

    /// When the last byte arrived, or the time of a later `note_activity`.
    [[nodiscard]] constexpr instant last_activity() const noexcept { return last_; }

    /// Records that the line was not silent at `now`, and leaves the frame alone. While the line is busy, a time
    /// before the latest recorded one changes nothing.
    constexpr void note_activity(instant now) noexcept
    {
        if (activity_ != activity::busy or reached(now, last_)) {
            last_ = now;
        }
        activity_ = activity::busy;
    }

    /// Whether t3.5 of silence has passed, so that sending is allowed.
    [[nodiscard]] constexpr bool is_quiet() const noexcept { return activity_ == activity::quiet; }

    /// Whether the next byte would be the first of a frame.
    [[nodiscard]] constexpr bool is_at_start() const noexcept { return not waits_for_silence(); }

    /// Whether the last frame had at least the smallest size, and began as a response to this request does:
    /// with its unit and its function.
    [[nodiscard]] constexpr bool looks_addressed_to(byte_view request) const noexcept
    {
        std::byte const* const start = storage().data() + place_.begin();
        return size() >= min_adu_size and start[0] == request[0] and (start[1] & std::byte{0x7F}) == request[1];
    }

    /// The memory of the frame, for a response written in its place.
    [[nodiscard]] constexpr byte_span storage() noexcept { return static_cast<Holder&>(*this).bytes_; }
    [[nodiscard]] constexpr byte_view storage() const noexcept { return static_cast<Holder const&>(*this).bytes_; }

    /// Keeps the first `size` bytes of the memory, at most 256, free: later frames are received behind them.
    constexpr void receive_behind(std::size_t size) noexcept requires(Front > 0)
    {
        place_.leave_room_for(size);
        end_ = place_.begin();
    }

    /// The largest frame that there is room for.
    [[nodiscard]] constexpr std::size_t room() const noexcept { return place_.memory - place_.begin(); }

    [[nodiscard]] constexpr line_timing const& line() const noexcept
    {
        return static_cast<Holder const&>(*this).line_.get();
    }

private:
    /// A constant, so that no constructor computes it.
    static constexpr running_crc16<> no_bytes{0};

    enum class state : std::uint8_t { synchronising, receiving, open_end, idle, done };

    /// What the line did last; unknown before the first time is given.
    enum class activity : std::uint8_t { unknown, busy, quiet };

    /// Always false in a receiver of responses.
    constexpr bool is_open_end() const noexcept { return Way == direction::request and state_ == state::open_end; }

    constexpr bool waits_for_silence() const noexcept { return state_ < state::idle; }

    constexpr void begin() noexcept
    {
        state_ = state::receiving;
        others_.begin_frame();
        end_ = place_.begin();
        rule_at_ = static_cast<std::uint16_t>(place_.begin() + 2);
        crc_ = running_crc16<>{};
        error_ = errc::none;
    }

    /// The silence that ends what is being received.
    constexpr duration silence() const noexcept { return is_open_end() ? line().t3_5() : line().frame_end(); }

    /// Applies the length rule at the byte where it is due. Returns whether the frame ends here. Inlined in
    /// `push`, where it is smaller than a separate function.
    [[gnu::always_inline]] constexpr bool apply_length_rule() noexcept
    {
        end_hint const told = others_.apply({storage().data() + place_.begin(), size()});
        // Zero, which is no byte's position here, where only silence tells the end. Past an end whose CRC is
        // wrong only silence tells where the next frame starts.
        rule_at_ = told.next == 0 ? std::uint16_t{0} : static_cast<std::uint16_t>(place_.begin() + told.next);
        if (not told.is_here or verdict() != errc::none) {
            return false;
        }
        others_.end_frame(told.is_response);
        state_ = told.is_open ? state::open_end : state::done;
        return true;
    }

    constexpr std::size_t size() const noexcept { return std::size_t{end_} - place_.begin(); }

    constexpr void on_silence() noexcept
    {
        if (waits_for_silence()) {
            // Synchronising -> idle and receiving -> done are three values on; an open end is not.
            bool const is_ahead = Way == direction::request and state_ != state::synchronising;
            state_ = is_ahead ? state::done : static_cast<state>(static_cast<std::uint8_t>(state_) + 3U);
        }
    }

    state state_{state::synchronising};
    activity activity_{activity::unknown};
    [[no_unique_address]] running_crc16<> crc_{no_bytes};
    errc error_{errc::none};
    [[no_unique_address]] foreign_exchange<Way> others_{};
    std::uint16_t end_{0};     ///< behind the last byte
    std::uint16_t rule_at_{0}; ///< where the length rule is to be applied; 0 where it has nothing to say
    [[no_unique_address]] frame_place<Front> place_{};
    instant last_{0};
};

/// A frame cutter with its memory.
template <direction Way, typename Line = stored<line_timing>, std::size_t Front = 0>
class framer : public frame_cutter<framer<Way, Line, Front>, Way, Front> {
    using cutter = frame_cutter<framer, Way, Front>;
    friend cutter;

public:
    explicit constexpr framer(line_timing const& line) noexcept : line_{line} {}

    /// For compile-time timing. Zero-initialised, so a `constinit` framer lives in .bss.
    constexpr framer() noexcept requires is_constant<Line> : bytes_{} {}

private:
    [[no_unique_address]] Line line_{};
    std::array<std::byte, frame_place<Front>::memory> bytes_; ///< written up to the frame's end
};

} // namespace rtuwire
