// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// Listens to a line without taking part: cuts both directions into frames and gives each response its request.
//
// A frame ends where its length rule is met and the CRC is right: gaps alone do not end it, since an adapter hands
// bytes over late and in lumps. Where both rules may fit, a response to the request that passed last goes before, if it
// fits that request in all fields; then a request; then a response alone. What has no rule ends by silence
// (`frame_end`), and is a frame if its CRC is right.
//
// Bytes that are no frame end by silence, too. Before that, and among them, a frame counts only where more than a CRC
// speaks for it: it is a response that fits the request that waits for one; a request with such a response right behind
// it; or a request that ends where silence begins. Everything before it is then damaged, and a response behind damage
// has no request. A CRC of 16 bits lets one of 65 536 wrong frames through.
//
// The bytes that it has not handed out yet are kept each with the time when it had arrived, and between which of them
// damaged ones lay, in one piece, so that a view of a frame is one span. Whether bytes are a frame is a question apart,
// which knows no time: trace/frame_match.hpp.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

#include <rtuwire/core/bytes.hpp>
#include <rtuwire/core/time.hpp>
#include <rtuwire/core/version.hpp>
#include <rtuwire/rtu/line.hpp>
#include <rtuwire/trace/frame_match.hpp>
#include <rtuwire/trace/traced_frame.hpp>
#include <rtuwire/wire/function.hpp>
#include <rtuwire/wire/functions.hpp>

namespace rtuwire {
inline namespace RTUWIRE_BUILD {

namespace detail {

/// Room for two of the longest frames.
class heard_bytes {
public:
    static constexpr std::size_t capacity = 2 * max_adu_size;

    [[nodiscard]] constexpr std::size_t size() const noexcept { return end_ - begin_; }
    [[nodiscard]] constexpr bool is_empty() const noexcept { return begin_ == end_; }
    [[nodiscard]] constexpr bool is_full() const noexcept { return size() == capacity; }

    /// The first `count` of them; valid until a byte is pushed.
    [[nodiscard]] constexpr byte_view first(std::size_t count) const noexcept
    {
        return byte_view{bytes_}.subspan(begin_, count);
    }

    /// When one of them had arrived.
    [[nodiscard]] constexpr instant time(std::size_t at) const noexcept { return instant{times_[begin_ + at]}; }

    /// Appends one; there must be room.
    constexpr void push(std::byte byte, instant at) noexcept
    {
        if (end_ == capacity) {
            move_to_front();
        }
        bytes_[end_] = byte;
        times_[end_] = at.microseconds;
        ++end_;
    }

    /// A damaged byte, which is not kept, came behind the last one.
    constexpr void note_damage() noexcept
    {
        first_damage_ = has_damage_ ? first_damage_ : end_;
        last_damage_ = end_;
        has_damage_ = true;
    }

    [[nodiscard]] constexpr bool has_damage() const noexcept { return has_damage_; }

    /// Nothing that comes from here on belongs to what was damaged.
    constexpr void forget_damage() noexcept { has_damage_ = false; }

    /// Whether damaged bytes lay before the last of `count` bytes from `from`. Between the first damage and the last
    /// all count as damaged.
    [[nodiscard]] constexpr bool is_damaged(std::size_t from, std::size_t count) const noexcept
    {
        std::size_t const at = begin_ + from;
        return has_damage_ and first_damage_ < at + count and last_damage_ >= at;
    }

    /// Removes bytes from the front.
    constexpr void pop(std::size_t count) noexcept
    {
        begin_ += count;
        has_damage_ = has_damage_ and last_damage_ > begin_;
        first_damage_ = first_damage_ < begin_ ? begin_ : first_damage_;
    }

private:
    constexpr void move_to_front() noexcept
    {
        std::size_t const count = size();
        for (std::size_t i = 0; i < count; ++i) {
            bytes_[i] = bytes_[begin_ + i];
            times_[i] = times_[begin_ + i];
        }
        first_damage_ -= has_damage_ ? begin_ : 0;
        last_damage_ -= has_damage_ ? begin_ : 0;
        begin_ = 0;
        end_ = count;
    }

    std::array<std::byte, capacity> bytes_{};
    std::array<std::uint32_t, capacity> times_{};
    std::size_t begin_{0};
    std::size_t end_{0};
    std::size_t first_damage_{0}; ///< an index of the byte behind it
    std::size_t last_damage_{0};
    bool has_damage_{false};
};

/// The bytes of one frame, or none, and when it ended.
class passed_request {
public:
    constexpr void note(byte_view bytes, instant end) noexcept
    {
        size_ = static_cast<std::uint16_t>(bytes.size());
        for (std::size_t i = 0; i < bytes.size(); ++i) {
            bytes_[i] = bytes[i];
        }
        end_ = end;
    }
    constexpr void forget() noexcept { size_ = 0; }

    [[nodiscard]] constexpr bool is_any() const noexcept { return size_ != 0; }
    [[nodiscard]] constexpr byte_view bytes() const noexcept { return byte_view{bytes_}.first(size_); }
    [[nodiscard]] constexpr instant end() const noexcept { return end_; }

private:
    std::array<std::byte, max_adu_size> bytes_{};
    std::uint16_t size_{0};
    instant end_{0};
};

} // namespace detail

/// What a listener heard: a frame, or bytes that are none, or (`is_unanswered`, and then no bytes) that a request got
/// no response. Its views are valid until the listener is called again.
struct heard_frame {
    /// Its bytes, the time of its last byte, role and verdict. A request and a response that fit each other are `good`;
    /// a response after the time-out is `late`; an undamaged response without its request, and up to 3 bytes of noise,
    /// are `stray`; all else is `damaged`.
    traced_frame frame;
    /// When its first byte had arrived.
    instant first_byte{0};
    /// The request that this answers, or that was not answered: address to CRC. Empty otherwise. Damaged bytes that
    /// came in the place of a response have it, too.
    byte_view request{};
    /// From the end of that request to the start of the response; or until it was given up, in time or at the end of
    /// the next frame.
    duration response_time{};
    /// Whether the request got no undamaged response in time, or before the next request.
    bool is_unanswered{false};

    /// The request's bytes, be it the frame itself or the one that it answers; empty where it is not known.
    [[nodiscard]] constexpr byte_view asked() const noexcept
    {
        return frame.role == frame_role::request and not is_unanswered ? frame.bytes : request;
    }

    /// Which unit, 0 in a broadcast: of the request, or where that is not known, the first byte; 0 where there is none.
    [[nodiscard]] constexpr std::uint8_t unit() const noexcept { return head(0); }

    /// The function, exception bit removed; 0 where there is none.
    [[nodiscard]] constexpr function_code function() const noexcept
    {
        return static_cast<function_code>(head(1) & ~detail::exception_bit & 0xFF);
    }

    /// Whether it is an undamaged refusal.
    [[nodiscard]] constexpr bool is_exception() const noexcept
    {
        return frame.role == frame_role::response and frame.verdict != frame_verdict::damaged and
               (detail::to_u8(frame.bytes[1]) & detail::exception_bit) != 0;
    }

    /// The first register, coil or input that the request names; of function 23, the first to be read.
    [[nodiscard]] constexpr std::optional<std::uint16_t> start() const noexcept
    {
        return quantity() ? std::optional{detail::u16_at(asked(), 2)} : std::nullopt;
    }

    /// How many the request names: those whose values the response holds, or that it says are written. Empty for
    /// functions that name none.
    [[nodiscard]] constexpr std::optional<std::uint16_t> quantity() const noexcept
    {
        constexpr std::size_t shortest = 8;
        if (asked().size() < shortest) {
            return std::nullopt;
        }
        constexpr function_code with_quantity[] = {function_code::read_coils,
                                                   function_code::read_discrete_inputs,
                                                   function_code::read_holding_registers,
                                                   function_code::read_input_registers,
                                                   function_code::write_multiple_coils,
                                                   function_code::write_multiple_registers,
                                                   function_code::read_write_multiple_registers};
        constexpr function_code of_one[] = {function_code::write_single_coil, function_code::write_single_register,
                                            function_code::mask_write_register};
        for (function_code const each : with_quantity) {
            if (function() == each) {
                return detail::u16_at(asked(), 4);
            }
        }
        for (function_code const each : of_one) {
            if (function() == each) {
                return std::uint16_t{1};
            }
        }
        return std::nullopt;
    }

private:
    [[nodiscard]] constexpr std::uint8_t head(std::size_t at) const noexcept
    {
        byte_view const from = asked().empty() ? frame.bytes : asked();
        return at < from.size() ? detail::to_u8(from[at]) : std::uint8_t{0};
    }
};

/// Give it all bytes of a line, from both directions, and let time pass; it calls `take(heard_frame const&)` for each
/// frame, for bytes that are none, and for each request that got no response in time. Each byte is handed out once,
/// in order; damaged bytes (`receive_error`) are not handed out. About 4 KB; nothing is allocated.
///
///     line_listener tap{line_timing{19'200, character_format::even_8_1}};
///     tap.receive(uart.take(), now, [](heard_frame const& it) { show(it); });
///     tap.advance(now, ...);
class line_listener {
public:
    /// A request without a response after `response_limit` is unanswered; the response is late from then on, for up to 35
    /// minutes. Let it be shorter than the time after which the line's client repeats a request: before, a repetition of
    /// functions 05, 06, 08 and 22 is taken for the response, whose bytes are the same.
    explicit constexpr line_listener(line_timing const& timing, duration response_limit = milliseconds(400)) noexcept
        : timing_{timing}, limit_{response_limit}
    {}

    /// Takes bytes that had arrived by `now`, in chunks of any size.
    template <typename Take> constexpr void receive(byte_view bytes, instant now, Take&& take)
    {
        while (not bytes.empty()) {
            std::size_t const count = bytes.size() < piece ? bytes.size() : piece;
            duration const behind = timing_.characters(bytes.size() - count);
            receive_piece(bytes.first(count), now - behind, take);
            bytes = bytes.subspan(count);
        }
    }

    /// A byte arrived damaged (parity, framing, overrun).
    template <typename Take> constexpr void receive_error(instant now, Take&& take)
    {
        let_pass(now - timing_.characters(1), take);
        held_.note_damage();
        last_ = now;
    }

    /// Lets time pass; at the latest at `poll_deadline`.
    template <typename Take> constexpr void advance(instant now, Take&& take) { let_pass(now, take); }

    /// When `advance` has something to do.
    [[nodiscard]] constexpr deadline poll_deadline() const noexcept
    {
        detail::earliest next;
        if (not held_.is_empty() or held_.has_damage()) {
            next.add(last_ + timing_.frame_end());
        } else if (pending_.is_any()) {
            next.add(pending_.end() + limit_);
        }
        if (lost_.is_any()) {
            next.add(lost_.end() + limit_);
        }
        if (given_up_.is_any()) {
            next.add(given_up_.end() + detail::longest_duration);
        }
        return next;
    }

private:
    using frame_match = detail::frame_match;

    static constexpr std::size_t piece = 64;
    /// Bytes that wait for a silence; no frame is longer.
    static constexpr std::size_t most_waiting = max_adu_size;

    template <typename Take> constexpr void receive_piece(byte_view bytes, instant now, Take& take)
    {
        let_pass(now - timing_.characters(bytes.size()), take);
        for (std::size_t i = 0; i < bytes.size(); ++i) {
            instant const at = now - timing_.characters(bytes.size() - 1 - i);
            last_ = held_.is_empty() or reached(at, last_) ? at : last_;
            held_.push(bytes[i], last_);
        }
        cut(false, take);
    }

    /// The line was as it is up to a time.
    template <typename Take> constexpr void let_pass(instant now, Take& take)
    {
        instant const until = detail::within_reach(seen_, now, timing_.characters(max_adu_size));
        seen_ = now;
        if (reached(until, last_ + timing_.frame_end())) {
            cut(true, take);
            held_.forget_damage();
        }
        if (held_.is_empty() and pending_.is_any() and reached(until, pending_.end() + limit_)) {
            give_up(pending_.end() + limit_, take);
        }
        if (lost_.is_any() and reached(until, lost_.end() + limit_)) {
            lost_.forget();
        }
        if (given_up_.is_any() and reached(until, given_up_.end() + detail::longest_duration)) {
            given_up_.forget();
        }
    }

    /// Hands out what has ended; after a silence everything has.
    template <typename Take> constexpr void cut(bool is_silent, Take& take)
    {
        while (not held_.is_empty()) {
            byte_view const bytes = held_.first(held_.size());
            frame_match const found = match_at(0, is_silent);
            if (found.is_whole()) {
                hand_out(found, take);
            } else if (is_silent and has_no_rule(bytes)) {
                hand_out({frame_match::outcome::whole, bytes.size(), role_of(bytes)}, take);
            } else if (found.is_open() and not is_silent and bytes.size() < most_waiting) {
                return;
            } else if (std::size_t const next = find_frame(is_silent); next != 0) {
                hand_out_damaged(next, take);
            } else if (is_silent) {
                hand_out_damaged(bytes.size(), take);
            } else if (bytes.size() > most_waiting) {
                hand_out_damaged(bytes.size() - most_waiting, take);
            } else {
                return;
            }
        }
    }

    template <typename Take> constexpr void hand_out(frame_match const& found, Take& take)
    {
        byte_view const bytes = held_.first(found.size);
        lost_.forget();
        heard_frame it{{bytes, held_.time(found.size - 1), found.role}, held_.time(0)};
        if (found.role == frame_role::request) {
            if (pending_.is_any()) {
                give_up(it.frame.at, take);
            }
            take(it);
            pending_.note(detail::to_u8(bytes[0]) == 0 ? byte_view{} : bytes, it.frame.at);
        } else {
            answer(it, take);
        }
        held_.pop(found.size);
    }

    /// Gives a response its request, if one passed.
    template <typename Take> constexpr void answer(heard_frame& it, Take& take)
    {
        bool const is_expected = pending_.is_any() and detail::begins_response(it.frame.bytes, pending_.bytes()) and
                                 (not has_rule(it.frame.bytes) or detail::answers(pending_.bytes(), it.frame.bytes));
        bool const is_late =
            not is_expected and given_up_.is_any() and detail::answers(given_up_.bytes(), it.frame.bytes);
        detail::passed_request& asked = is_late ? given_up_ : pending_;
        it.frame.verdict = is_expected ? frame_verdict::good : is_late ? frame_verdict::late : frame_verdict::stray;
        if (is_expected or is_late) {
            it.request = asked.bytes();
            it.response_time = since(asked.end(), it.first_byte);
        }
        take(it);
        if (is_expected or is_late) {
            asked.forget();
        }
    }

    template <typename Take> constexpr void hand_out_damaged(std::size_t count, Take& take)
    {
        constexpr std::size_t most_noise = 3;
        frame_verdict const verdict = count <= most_noise ? frame_verdict::stray : frame_verdict::damaged;
        heard_frame it{{held_.first(count), held_.time(count - 1), frame_role::unknown, verdict}, held_.time(0)};
        it.request = pending_.bytes();
        take(it);
        held_.pop(count);
        if (verdict == frame_verdict::damaged) {
            lose_exchange(it, take);
        }
    }

    /// What was damaged may have been the response, or a newer request: whatever comes next answers neither for sure.
    /// Where no request waited, it may have been one, whose response may repeat it.
    template <typename Take> constexpr void lose_exchange(heard_frame const& it, Take& take)
    {
        byte_view const bytes = it.frame.bytes;
        bool const is_response = pending_.is_any() or detail::resembles(bytes, lost_.bytes());
        if (pending_.is_any()) {
            give_up(it.frame.at, take);
        }
        given_up_.forget();
        lost_.note(is_response or bytes.size() > max_adu_size ? byte_view{} : bytes, it.frame.at);
    }

    /// In a lump a byte's time is computed from that of the last: it may lie before what another lump brought.
    static constexpr duration since(instant begin, instant end) noexcept
    {
        return reached(end, begin) ? end - begin : duration{};
    }

    /// The request that waits gets no response any more, or a late one.
    template <typename Take> constexpr void give_up(instant at, Take& take)
    {
        heard_frame it{{{}, at}, at};
        it.request = pending_.bytes();
        it.response_time = since(pending_.end(), at);
        it.is_unanswered = true;
        take(it);
        given_up_ = pending_;
        pending_.forget();
    }

    // Where among the bytes that were not handed out yet frames are.

    /// What begins at a byte, undamaged.
    constexpr frame_match match_at(std::size_t from, bool is_over) const noexcept
    {
        byte_view const bytes = held_.first(held_.size()).subspan(from);
        frame_match found = detail::match_frame(bytes, pending_.bytes(), is_over);
        if (not found.is_whole() and detail::begins_response(bytes, given_up_.bytes())) {
            frame_match const late = detail::match_response(bytes, given_up_.bytes());
            found = late.is_verified ? detail::response_or_longer(bytes, late, detail::match_request(bytes), is_over)
                                     : found;
        }
        if (found.is_whole() and found.role == frame_role::request and lost_.is_any() and
            detail::match_by_rule(detail::direction::response, bytes).size == found.size and
            detail::resembles(bytes.first(found.size), lost_.bytes())) {
            found.role = frame_role::response;
        }
        if (found.is_whole() and held_.is_damaged(from, found.size)) {
            found.is = frame_match::outcome::refuted;
        }
        return found;
    }

    /// Where among the bytes a frame begins for which more than a CRC speaks; 0 for nowhere.
    constexpr std::size_t find_frame(bool is_silent) const noexcept
    {
        for (std::size_t from = 1; from + min_adu_size <= held_.size(); ++from) {
            frame_match const found = match_at(from, is_silent);
            std::size_t const behind = from + found.size;
            bool const is_request = found.is_whole() and found.role == frame_role::request;
            if (found.is_verified or
                (is_request and ((is_silent and behind == held_.size()) or is_answered(from, found.size)))) {
                return from;
            }
        }
        return 0;
    }

    /// Whether right behind a request its response stands.
    constexpr bool is_answered(std::size_t from, std::size_t size) const noexcept
    {
        byte_view const bytes = held_.first(held_.size()).subspan(from);
        frame_match const found = detail::match_response(bytes.subspan(size), bytes.first(size));
        return found.is_verified and not held_.is_damaged(from + size, found.size);
    }

    constexpr bool has_no_rule(byte_view bytes) const noexcept
    {
        return bytes.size() >= min_adu_size and bytes.size() <= max_adu_size and
               not held_.is_damaged(0, bytes.size()) and detail::has_right_crc(bytes) and
               detail::frame_length(detail::direction::request, bytes).size() == 0;
    }

    constexpr frame_role role_of(byte_view bytes) const noexcept
    {
        return detail::begins_response(bytes, pending_.bytes()) ? frame_role::response : frame_role::request;
    }

    static constexpr bool has_rule(byte_view bytes) noexcept
    {
        return detail::frame_length(detail::direction::response, bytes).size() != 0;
    }

    detail::heard_bytes held_{};
    detail::passed_request pending_{};
    detail::passed_request given_up_{};
    detail::passed_request lost_{}; ///< damaged bytes in the place of a request
    line_timing timing_;
    duration limit_;
    instant last_{0};
    instant seen_{0}; ///< up to when time has passed
};

} // namespace RTUWIRE_BUILD
} // namespace rtuwire
