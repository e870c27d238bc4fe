// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// What may come before a response: the echo of the transmission, on a line that gives back what is sent; noise.
#pragma once

#include <cstddef>
#include <cstdint>

#include <rtuwire/core/bytes.hpp>
#include <rtuwire/core/constant.hpp>
#include <rtuwire/core/version.hpp>

namespace rtuwire {
inline namespace RTUWIRE_BUILD {

namespace detail {

/// Compares the received bytes with the bytes of one transmission, in their order, and keeps what the transmissions before
/// have shown: a line that has given back a whole one echoes, until a response comes without.
class line_echo {
public:
    /// A transmission begins.
    constexpr void begin() noexcept { next_ = 1; }

    /// Expects no echo from here on.
    constexpr void end() noexcept { next_ = 0; }

    /// All of it has come, and is the beginning of a frame that may be a response; or the response repeats it as a whole.
    constexpr void begin_frame(bool goes_on) noexcept { next_ = goes_on ? in_front : std::uint16_t{0}; }

    /// Whether the frame that is being received is an echo where it is no response.
    [[nodiscard]] constexpr bool is_in_front() const noexcept { return next_ == in_front; }

    /// Something else has come that may have been an echo, damaged or in part. Not inlined: it is called in several places.
    [[gnu::noinline]] constexpr void suspect() noexcept { next_ = next_ == 0 ? suspected : next_; }

    /// Whether nothing has come of an echo.
    [[nodiscard]] constexpr bool is_absent() const noexcept { return next_ == 0; }

    /// Whether the next byte may belong to the echo.
    [[nodiscard]] constexpr bool is_open() const noexcept { return next_ != 0 and next_ < in_front; }

    /// Whether this transmission has come back whole.
    [[nodiscard]] constexpr bool is_whole() const noexcept { return next_ == whole; }

    /// How many bytes have come, while more are to come.
    [[nodiscard]] constexpr std::size_t taken() const noexcept { return is_open() ? next_ - 1U : 0U; }

    /// Takes bytes while the echo is open. Returns how many of them equal what was sent; after one that differs, and after
    /// the last one, the echo is over.
    constexpr std::size_t take(byte_view bytes, byte_view sent) noexcept
    {
        std::size_t same = 0;
        while (is_open() and same < bytes.size()) {
            if (bytes[same] != sent[next_ - 1U]) {
                end();
                break;
            }
            ++same;
            next_ = next_ == sent.size() ? whole : static_cast<std::uint16_t>(next_ + 1);
        }
        return same;
    }

    /// Whether the line has echoed.
    [[nodiscard]] constexpr bool is_known() const noexcept { return seen_ != 0; }
    /// Whether it has done so twice.
    [[nodiscard]] constexpr bool is_proven() const noexcept { return seen_ == twice; }
    constexpr void note_seen() noexcept { seen_ = is_known() ? twice : std::uint8_t{1}; }
    /// What comes next decides again.
    constexpr void doubt() noexcept { seen_ = is_known() ? std::uint8_t{1} : std::uint8_t{0}; }
    constexpr void forget() noexcept { seen_ = 0; }

private:
    static constexpr std::uint16_t in_front = 0xFFFD;
    static constexpr std::uint16_t suspected = 0xFFFE;
    static constexpr std::uint16_t whole = 0xFFFF;
    static constexpr std::uint8_t twice = 2;

    std::uint16_t next_{0}; ///< the next byte's number, from 1; 0 where none is expected
    std::uint8_t seen_{0};
};

/// How many bytes of noise may still be skipped before a response; constant options that allow none take no memory.
template <typename Options> class noise_allowance {
public:
    constexpr void begin(std::uint8_t most) noexcept { left_ = most; }
    [[nodiscard]] constexpr bool is_left() const noexcept { return left_ != 0; }
    constexpr void take() noexcept { --left_; }

private:
    std::uint8_t left_{0};
};
template <typename Options>
    requires(is_constant<Options>and Options::get().max_leading_noise == 0)
class noise_allowance<Options> {
public:
    static constexpr void begin(std::uint8_t) noexcept {}
    [[nodiscard]] static constexpr bool is_left() noexcept { return false; }
    static constexpr void take() noexcept {}
};

} // namespace detail

} // namespace RTUWIRE_BUILD
} // namespace rtuwire
