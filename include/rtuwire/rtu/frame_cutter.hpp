// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// Internal: the framer in parts, for a server and a client, which take a frame at the byte that ends it. Its table of
// states stands in rtu/framer.hpp; what silence does to them, in rtu/line_silence.hpp.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include <rtuwire/core/bytes.hpp>
#include <rtuwire/core/constant.hpp>
#include <rtuwire/core/time.hpp>
#include <rtuwire/core/version.hpp>
#include <rtuwire/rtu/foreign_exchange.hpp>
#include <rtuwire/rtu/frame_bytes.hpp>
#include <rtuwire/rtu/frame_place.hpp>
#include <rtuwire/rtu/frame_sum.hpp>
#include <rtuwire/rtu/line.hpp>
#include <rtuwire/rtu/line_silence.hpp>
#include <rtuwire/wire/adu.hpp>
#include <rtuwire/wire/errc.hpp>
#include <rtuwire/wire/frame_length.hpp>

namespace rtuwire::inline RTUWIRE_BUILD::detail {

/// Internal: a framer without its memory. `Holder` derives from it and holds the line's times, `line_`, and the
/// memory, `bytes_`, behind all other members: small processors reach near members with short instructions.
template <typename Holder, direction Way, std::size_t Front>
class frame_cutter : public frame_bytes<Holder, Way, Front> {
    using store = frame_bytes<Holder, Way, Front>;
    using store::end_;
    using store::is_open_end;
    using store::place_;
    using store::rule_at_;
    using store::size;
    using store::state_;
    using typename store::state;

public:
    using store::begin_chunk;
    using store::storage;

    constexpr frame_cutter() noexcept = default;

    /// Takes bytes that had arrived by `now`, in chunks of any size, up to the end of one frame; returns how
    /// many were taken. The bytes after that frame belong to the next call.
    constexpr std::size_t receive(byte_view arrived, instant now) noexcept
    {
        if (arrived.empty() or begin_chunk(arrived.size(), now)) {
            return 0;
        }
        if (is_open_end()) {
            return takes_behind_open_end(arrived[0]) ? 1 : 0;
        }
        return take_many(arrived.data(), arrived.size());
    }

    /// The same of one byte. Returns whether it was taken.
    constexpr bool receive(std::byte byte, instant now) noexcept
    {
        if (begin_chunk(1, now)) {
            return false;
        }
        if (is_open_end()) {
            return takes_behind_open_end(byte);
        }
        static_cast<void>(push(byte));
        return true;
    }

    /// The second part of `receive`, after `begin_chunk`: takes bytes up to the end of one frame. Returns how many. Not
    /// inlined: a receiver that is given single bytes never calls it.
    [[gnu::noinline]] constexpr std::size_t take_many(std::byte const* at, std::size_t count) noexcept
    {
        if (state_ == state::synchronising) {
            return count;
        }
        if (state_ != state::receiving) {
            begin();
            look_ahead({at, count});
        }
        for (std::size_t left = count; left != 0;) {
            std::size_t const taken = copy_to_look(at, left);
            if (taken == 0) {
                error_ = error_ == errc::none ? errc::frame_too_long : error_;
                break;
            }
            at += taken;
            left -= taken;
            if (end_ == rule_at_ and apply_length_rule()) {
                return count - left;
            }
        }
        return count;
    }

    /// The second part of `receive`, after `begin_chunk`: takes one byte. Returns whether it was the last of a frame.
    constexpr bool push(std::byte byte) noexcept
    {
        if (state_ == state::synchronising) {
            return false;
        }
        if (state_ != state::receiving) {
            begin();
        }
        if (end_ == place_.memory) {
            if (error_ == errc::none) {
                error_ = errc::frame_too_long;
            }
            return false;
        }
        storage()[end_++] = byte;
        sum_.add(byte);
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

    /// Whether the bytes so far of the frame that is being received, all of them good, tell that more are to come.
    [[nodiscard]] constexpr bool lacks_bytes() const noexcept { return error_ == errc::none and rule_at_ > end_; }

    /// Why the last frame is refused; none where it is good.
    [[nodiscard]] constexpr errc verdict() const noexcept
    {
        return error_ != errc::none               ? error_
               : size() < min_adu_size            ? errc::frame_too_short
               : not sum_.is_right(this->bytes()) ? errc::crc_mismatch
                                                  : errc::none;
    }

    /// The last frame, where the verdict is none.
    [[nodiscard]] constexpr adu frame() const noexcept { return adu{this->bytes()}; }

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

private:
    constexpr bool takes_behind_open_end(std::byte next) noexcept
    {
        state_ = state::done;
        return others_.takes(next);
    }

    constexpr void begin() noexcept
    {
        state_ = state::receiving;
        others_.begin_frame();
        this->begin_bytes();
        sum_.begin();
        error_ = errc::none;
    }

    /// Spares looks at the first bytes of a frame that tell less than the next ones.
    constexpr void look_ahead(byte_view first) noexcept
    {
        if (first.size() < 3) {
            return;
        }
        if constexpr (default_crc_form == crc_form::host) {
            // 0 and 1 say that only silence ends it, and are no bytes to look at.
            if (std::size_t const told = size_hint(Way, first); told > 3 and not others_.is_expected(first)) {
                return this->look_at(told);
            }
        }
        this->look_at(3); // no frame is so short, and most responses tell their size here
    }

    /// Copies bytes up to where the length rule is to be applied next. Returns how many; 0 where there is no room.
    constexpr std::size_t copy_to_look(std::byte const* at, std::size_t count) noexcept
    {
        std::size_t const room = this->bytes_to_look();
        count = count < room ? count : room;
        sum_.copy(at, count, storage().data() + end_);
        end_ = static_cast<std::uint16_t>(end_ + count);
        return count;
    }

    /// Applies the length rule at the byte where it is due. Returns whether the frame ends here. Force-inlined,
    /// which is smaller (docs/size-notes.md).
    [[gnu::always_inline]] constexpr bool apply_length_rule() noexcept
    {
        end_hint const told = others_.apply(this->bytes());
        // Past an end whose CRC is wrong only silence tells where the next frame starts.
        this->look_at(told.next);
        if (not told.is_here or verdict() != errc::none) {
            return false;
        }
        sum_.note_right();
        others_.end_frame(told.is_response);
        state_ = told.is_open ? state::open_end : state::done;
        return true;
    }

    [[no_unique_address]] frame_sum<> sum_{};
    errc error_{errc::none};
    [[no_unique_address]] foreign_exchange<Way> others_{};
};

/// Internal: a frame cutter with its memory.
template <direction Way, typename Line = stored<line_timing>, std::size_t Front = 0>
class frame_receiver : public frame_cutter<frame_receiver<Way, Line, Front>, Way, Front> {
    friend frame_cutter<frame_receiver, Way, Front>;
    friend line_silence<frame_receiver, Way>;
    friend frame_bytes<frame_receiver, Way, Front>;

public:
    explicit constexpr frame_receiver(line_timing const& its_timing) noexcept : line_{its_timing} {}
    constexpr frame_receiver() noexcept requires is_constant<Line> : bytes_{} {}

private:
    static constexpr bool awaits_rest() noexcept { return false; } ///< nothing but silence ends a frame without its end

    [[no_unique_address]] Line line_{};
    std::array<std::byte, frame_place<Front>::memory> bytes_; ///< written up to the frame's end
};

} // namespace rtuwire::detail
