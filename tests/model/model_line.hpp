// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A model of the line's receiving end: bytes, silences and frames, written from the specification and from
// docs/engine-rules.md. Shares no code with the headers: 64-bit time, vectors, a CRC bit by bit.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace model {

using bytes = std::vector<std::uint8_t>;
/// Microseconds that never wrap.
using microseconds = std::int64_t;

/// Durations, and sums of them, stop here.
inline constexpr microseconds longest = 35LL * 60 * 1'000'000;
constexpr microseconds limited(microseconds length) { return std::min(length, longest); }

/// Causes, with the numbers that the errors of the library have.
enum fault : int {
    none = 0,
    illegal_function = 1,
    illegal_data_address = 2,
    illegal_data_value = 3,
    server_device_failure = 4,
    unlisted_exception = 0x7F,
    buffer_too_small = 0x80,
    frame_too_short = 0x8C,
    frame_too_long,
    wrong_length,
    crc_mismatch,
    uart_error,
    wrong_unit,
    wrong_function,
    response_mismatch,
    malformed,
    line_echo,
    collision,
    timed_out,
    bus_jam,
    transmit_stalled,
    cancelled,
    never_advanced = 0xA8,
};

/// The check bytes, low one first.
inline std::uint16_t crc(bytes const& of, std::size_t size)
{
    unsigned value = 0xFFFF;
    for (std::size_t i = 0; i < size; ++i) {
        value ^= of[i];
        for (int bit = 0; bit < 8; ++bit) {
            value = (value & 1U) != 0 ? (value >> 1U) ^ 0xA001U : value >> 1U;
        }
    }
    return static_cast<std::uint16_t>(value);
}
inline bool is_whole(bytes const& frame)
{
    std::size_t const size = frame.size();
    return size >= 2 and crc(frame, size - 2) == (frame[size - 2] | frame[size - 1] << 8);
}
inline bytes with_crc(bytes frame)
{
    std::uint16_t const value = crc(frame, frame.size());
    frame.push_back(static_cast<std::uint8_t>(value & 0xFFU));
    frame.push_back(static_cast<std::uint8_t>(value >> 8U));
    return frame;
}

/// How long characters and silences last. Without a bit rate there is no wire: a character takes no time, and nothing has
/// to be silent before sending; t3.5 is that of 19 200 bit/s.
struct line_times {
    microseconds character;
    microseconds t3_5;
    microseconds frame_end;
    microseconds silence; ///< before sending

    line_times(microseconds bits_per_second, microseconds bits, microseconds host_frame_end,
               std::optional<microseconds> before_sending = {})
        : character{bits_per_second == 0 ? 0 : up(bits * 1'000'000, bits_per_second)},
          t3_5{bits_per_second > 19'200 ? 1750
               : bits_per_second == 0   ? up(7 * 11 * 1'000'000, 2 * 19'200)
                                        : up(7 * bits * 1'000'000, 2 * bits_per_second)},
          frame_end{std::max(t3_5, host_frame_end)}, silence{before_sending.value_or(bits_per_second == 0 ? 0 : t3_5)}
    {}
    static microseconds up(microseconds dividend, microseconds divisor) { return (dividend + divisor - 1) / divisor; }
    microseconds characters(std::size_t count) const { return character * static_cast<microseconds>(count); }
};

/// The size that a frame's first bytes tell, if it is more than a frame can be as well; none where they do not tell it
/// yet, or never.
inline std::optional<std::size_t> size_hint(bytes const& frame, bool is_request)
{
    std::size_t const n = frame.size();
    auto const counted = [&](std::size_t at, std::size_t base) -> std::optional<std::size_t> {
        return n > at ? std::optional{base + frame[at]} : std::nullopt;
    };
    if (n < 2) {
        return std::nullopt;
    }
    unsigned const function = frame[1];
    if (function >= 0x80) {
        return is_request ? std::nullopt : std::optional<std::size_t>{5};
    }
    switch (function) {
    case 1:
    case 2:
    case 3:
    case 4: return is_request ? std::optional<std::size_t>{8} : counted(2, 5);
    case 5:
    case 6: return 8;
    case 7: return is_request ? 4 : 5;
    case 8:
        if (n < 4 or (frame[2] == 0 and frame[3] == 0)) {
            return std::nullopt;
        }
        return 8;
    case 11: return is_request ? 4 : 8;
    case 12:
    case 17: return is_request ? std::optional<std::size_t>{4} : counted(2, 5);
    case 15:
    case 16: return is_request ? counted(6, 9) : std::optional<std::size_t>{8};
    case 20:
    case 21: return counted(2, 5);
    case 22: return 10;
    case 23: return is_request ? counted(10, 13) : counted(2, 5);
    case 24:
        if (is_request) {
            return 6;
        }
        return n >= 4 ? std::optional<std::size_t>{6 + 256U * frame[2] + frame[3]} : std::nullopt;
    case 43: {
        if (n < 3 or frame[2] != 14) {
            return std::nullopt;
        }
        if (is_request) {
            return 7;
        }
        if (n < 8) {
            return std::nullopt;
        }
        std::size_t at = 8;
        for (unsigned left = frame[7]; left > 0; --left) {
            if (n < at + 2) {
                return std::nullopt;
            }
            at += 2U + frame[at + 1];
        }
        return at + 2;
    }
    default: return std::nullopt;
    }
}

/// Whether the first bytes of a response tell that more are to come.
inline bool lacks_bytes(bytes const& frame)
{
    std::size_t const n = frame.size();
    if (auto const told = size_hint(frame, false)) {
        return *told > n and *told <= 256;
    }
    if (n < 2) {
        return true;
    }
    unsigned const function = frame[1];
    bool const is_counted = (function >= 1 and function <= 4) or function == 12 or function == 17 or function == 20 or
                            function == 21 or function == 23;
    if (function != 43) {
        return (is_counted and n < 3) or ((function == 8 or function == 24) and n < 4);
    }
    std::size_t next = 8; // the first byte that tells more
    for (unsigned left = n < 8 ? 0 : frame[7]; left > 0 and n >= next + 2; --left) {
        next += 2U + frame[next + 1];
    }
    return n < 3 or (frame[2] == 14 and next <= 254);
}

/// What the receiver knows of the line, and the frame that it is in (rules 1 to 3).
struct receiver {
    enum class state { unheard, between, inside };

    line_times times;
    std::size_t room{256};
    state at{state::unheard};
    bytes frame{};
    fault error{none};
    bool is_known{false}; ///< the clock was seen
    bool is_quiet{false};
    microseconds last{0};

    /// Whether silence of `length` lies before so many characters that were there at `now`.
    bool is_gap(std::size_t count, microseconds now) const
    {
        return is_known and now >= last + times.frame_end + times.characters(count);
    }
    /// 10: nothing has come for a while, whatever the silence before sending.
    bool is_at_rest(microseconds now) const { return is_quiet or now >= last + times.t3_5; }
    /// Without a wire silence does not end a response that lacks bytes while one is awaited.
    bool lacks_rest() const
    {
        return times.character == 0 and at == state::inside and error == none and lacks_bytes(frame);
    }
    void note_activity(microseconds now)
    {
        last = is_known and not is_quiet ? std::max(last, now) : now;
        is_known = true;
        is_quiet = false;
    }
    void begin()
    {
        at = state::between;
        frame.clear();
        error = none;
    }
    /// A byte of a frame. Whether its size tells that it ended.
    bool take(std::uint8_t byte, bool is_request)
    {
        if (at == state::between) {
            begin();
            at = state::inside;
        }
        if (frame.size() == room) {
            error = error == none ? frame_too_long : error;
            return false;
        }
        frame.push_back(byte);
        return error == none and size_hint(frame, is_request) == frame.size() and is_whole(frame);
    }
    void damage()
    {
        if (at == state::between) {
            begin();
            at = state::inside;
        }
        error = uart_error; // also behind frame_too_long, where rule 3 says otherwise
    }
    /// Why what ended is no frame.
    fault verdict() const
    {
        if (error != none) {
            return error;
        }
        if (frame.size() < 4) {
            return frame_too_short;
        }
        return is_whole(frame) ? none : crc_mismatch;
    }
};

} // namespace model
