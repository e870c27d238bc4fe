// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// How long a character and the silences around a frame last on a line (SL 2.5.1), from its bit rate
// and character format; where an engine has its line from; and how it gets what arrives there at a host's port. Knows no frame
// and no clock.
#pragma once

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <type_traits>

#include <rtuwire/core/bytes.hpp>
#include <rtuwire/core/result.hpp>
#include <rtuwire/core/time.hpp>
#include <rtuwire/core/version.hpp>

namespace rtuwire {
inline namespace RTUWIRE_BUILD {

namespace detail {

/// A setting that is given when the object is constructed, and copied into it. Read by `get`, as `constant` is.
template <typename T> class stored {
public:
    explicit constexpr stored(T const& its_value) noexcept : value_{its_value} {}
    [[nodiscard]] constexpr T const& get() const noexcept { return value_; }

private:
    T value_;
};

/// A setting that is a constant of the program: it takes no memory and lets the compiler calculate with it.
template <auto const& Value> struct constant {
    [[nodiscard]] static constexpr auto const& get() noexcept { return Value; }
};

/// Whether a setting takes no memory.
template <typename Setting> inline constexpr bool is_constant = std::is_empty_v<Setting>;

} // namespace detail

/// Data bits, parity and stop bits. The specification requires 11 bits, `even_8_1` by default (SL 2.5.1). Others are met
/// in the field, and are not its own: `none_8_1`, of 10 bits, as the ATV28 has it; parity and two stop bits, of 12.
enum class character_format : std::uint8_t { even_8_1, odd_8_1, none_8_1, none_8_2, even_8_2, odd_8_2 };

/// Not constexpr, so that in a constant expression the compiler reports its name. At run time it does nothing.
inline void the_bit_rate_of_a_line_is_at_least_65() noexcept {}

namespace detail {

/// Bits of one character, start bit included: 10 to 12.
[[nodiscard]] constexpr std::uint32_t bits_per_character(character_format format) noexcept
{
    return format == character_format::none_8_1 ? 10 : format < character_format::even_8_2 ? 11 : 12;
}

} // namespace detail

/// The times of one line. All are rounded up to whole microseconds.
class line_timing {
public:
    /// Times for a receiver that gets each character as it ends, or has a hardware buffer of a few: a frame
    /// without a length rule ends after t3.5. `bits_per_second` is at least 65, where a frame lasts 47 s: what is below
    /// does not compile in a constant expression and counts as 65 at run time, 0 too.
    constexpr line_timing(std::uint32_t bits_per_second, character_format format) noexcept
        : character_{bit_times(2, bits_per_second, format)}, t3_5_{bits_per_second > 19'200
                                                                       ? microseconds(1750)
                                                                       : bit_times(7, bits_per_second, format)},
          frame_end_{t3_5_}, silence_{t3_5_}
    {}

    /// Times for a host, where an operating system or a USB adapter delivers characters late and in chunks:
    /// silence counts only after `frame_end`, 50 ms by default (adapters leave gaps of 16 to 70 ms inside a
    /// frame when their latency timer is not lowered).
    [[nodiscard]] static constexpr line_timing host(std::uint32_t bits_per_second, character_format format,
                                                    duration frame_end = milliseconds(50)) noexcept
    {
        line_timing line{bits_per_second, format};
        if (frame_end > line.frame_end_) {
            line.frame_end_ = frame_end;
        }
        return line;
    }

    /// Times for a client on a host behind a USB adapter: those of `host`, above 38 400 bit/s without a silence before
    /// sending. The adapter has kept the bytes meanwhile, until 62 had come or its timer ended, 1 to 16 ms, and the line has
    /// rested for some of that; t3.5 more from their arrival on makes a transaction take up to 2.0 times as long at 115 200
    /// bit/s, 3.0 at 1 Mbit/s (bench/hosts/usb_adapter.cpp). No adapter promises that rest: a unit that misses a request
    /// which comes that soon needs `host`, or a pause of its own. Up to 38 400 bit/s t3.5 stays: drives want their three
    /// characters, and the wire is slower than the adapter. Frames end as for `host`.
    [[nodiscard]] static constexpr line_timing usb(std::uint32_t bits_per_second, character_format format,
                                                   duration frame_end = milliseconds(50)) noexcept
    {
        constexpr std::uint32_t slower_than_adapter = 38'400;
        line_timing const line = host(bits_per_second, format, frame_end);
        return bits_per_second > slower_than_adapter ? line.with_silence(duration{}) : line;
    }

    /// Times for what is no wire, where bytes take no time, need no silence between frames and are not lost: a
    /// pseudo-terminal, a socket. What has no length rule ends after `frame_end` there, too, and so does all that a server
    /// receives. A client on a host waits for the rest of a response that tells its length until its response time-out; on
    /// a microcontroller no longer than `frame_end`, which is to be above the longest pause within a response there.
    [[nodiscard]] static constexpr line_timing without_wire(duration frame_end = milliseconds(50)) noexcept
    {
        constexpr std::uint32_t usual = 19'200;
        line_timing line = host(usual, character_format::even_8_1, frame_end).with_silence(duration{});
        line.character_ = duration{};
        return line;
    }

    /// Times for what is no wire either, and numbers each response as its request (Modbus TCP): it comes whole, needs no
    /// silence, and one that is late is known by its number. So a client on a host keeps no unit from being asked because
    /// of responses that are outstanding; one on a microcontroller does. For a port that lets no other response pass, as
    /// `mbap_stream` does.
    [[nodiscard]] static constexpr line_timing numbered() noexcept
    {
        line_timing line = without_wire(milliseconds(1));
        line.t3_5_ = duration{};
        return line;
    }

    /// The same with another silence before sending than t3.5: more for units that miss a request that comes that soon,
    /// less behind an adapter that hands bytes over late, so that the line has rested already. At most 40 s. It changes
    /// nothing of when a frame ends.
    [[nodiscard]] constexpr line_timing with_silence(duration silence) const noexcept
    {
        line_timing line = *this;
        line.silence_ = silence;
        return line;
    }

    /// The same with a silence before sending that follows the rate where a character is shorter than 87 us, its length at
    /// 115 200 bit/s and 10 bits: 3.5 characters there, 39 us at 1 Mbit/s and 11 bits, or `least` where that is more. The
    /// specification fixes t3.5 at 1 750 us above 19 200 bit/s to spare receivers the interrupts (SL 2.5.1.1), so take as
    /// `least` what the slowest unit needs between two frames. On a slower line, and without a wire, nothing changes.
    [[nodiscard]] constexpr line_timing with_silence_by_rate(duration least) const noexcept
    {
        constexpr duration shortest_usual = microseconds(87);
        if (not has_wire() or character_ >= shortest_usual) {
            return *this;
        }
        duration const by_rate{(character_.microseconds * 7U + 1U) / 2U};
        return with_silence(least > by_rate ? least : by_rate);
    }

    /// Whether bytes take time on a wire, which may lose some; not so of `without_wire`.
    [[nodiscard]] constexpr bool has_wire() const noexcept { return character_.microseconds != 0; }

    /// Whether the number of a response tells its request, as of `numbered`.
    [[nodiscard]] constexpr bool has_numbers() const noexcept { return t3_5_.microseconds == 0; }

    /// The time that `count` characters take, at most a frame's: 47 s at 65 bit/s and 12 bits.
    [[nodiscard]] constexpr duration characters(std::size_t count) const noexcept
    {
        return duration{character_.microseconds * static_cast<std::uint32_t>(count)};
    }

    /// The sum of a duration and the time that a frame's characters take. Not by `+`, which costs 20 bytes
    /// more on a Cortex-M0+: `longest_duration` leaves room for a frame, so the sum fits.
    [[nodiscard]] constexpr duration with_characters(duration length, std::size_t count) const noexcept
    {
        return duration{length.microseconds + characters(count).microseconds};
    }

    /// The longest gap inside a frame: 1.5 characters, 750 us above 19 200 bit/s.
    [[nodiscard]] constexpr duration t1_5() const noexcept { return duration{(t3_5_.microseconds * 3U + 6U) / 7U}; }

    /// The shortest silence between frames: 3.5 characters, 1 750 us above 19 200 bit/s.
    [[nodiscard]] constexpr duration t3_5() const noexcept { return t3_5_; }

    /// The silence after which a receiver treats what it has as complete; never below t3.5.
    [[nodiscard]] constexpr duration frame_end() const noexcept { return frame_end_; }

    /// The silence before sending: t3.5 where no other was given.
    [[nodiscard]] constexpr duration silence() const noexcept { return silence_; }

private:
    static constexpr duration bit_times(std::uint32_t half_characters, std::uint32_t bits_per_second,
                                        character_format format) noexcept
    {
        constexpr std::uint32_t lowest = 65;
        if (bits_per_second < lowest) {
            the_bit_rate_of_a_line_is_at_least_65();
            bits_per_second = lowest;
        }
        std::uint32_t const bits_by_million = half_characters * detail::bits_per_character(format) * 500'000U;
        return duration{1 + (bits_by_million - 1) / bits_per_second};
    }

    duration character_;
    duration t3_5_;
    duration frame_end_;
    duration silence_;
};

namespace detail {

/// A port that knows which bytes arrived damaged: `read` then stops before one, leaves it out, and
/// `take_receive_error` reports it, once. Other ports only read.
template <typename T>
concept reports_receive_errors = requires(T& port)
{
    {
        port.take_receive_error()
        } -> std::same_as<bool>;
};

} // namespace detail

/// Passes to an engine what has arrived at a port, or arrives until `until`. `place` is working memory.
/// Errors: those of the port. A port whose `take_receive_error()` reports a damaged byte before which `read` stopped, once,
/// has it told to the engine.
template <typename Engine, typename Port>
result<void> receive_from(Port& port, Engine& engine, byte_span place, instant until)
{
    auto const bytes = port.read(place, until);
    if (not bytes) {
        return bytes.error();
    }
    engine.receive(*bytes, port.now());
    if constexpr (detail::reports_receive_errors<Port>) {
        if (port.take_receive_error()) {
            engine.receive_error(port.now());
        }
    }
    return {};
}

} // namespace RTUWIRE_BUILD
} // namespace rtuwire
