// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// What a terminal delivers when it marks damaged bytes (termios, PARMRK): FF 00 x is a byte x with a parity
// or framing error, FF 00 00 also a break, and FF FF is an undamaged byte FF.
#pragma once

#include <cstddef>
#include <cstdint>

#include <rtuwire/core/bytes.hpp>
#include <rtuwire/core/version.hpp>

namespace rtuwire {
inline namespace RTUWIRE_BUILD {

namespace detail {

/// Removes the marks from a stream of bytes, in chunks of any size.
class error_marks {
public:
    /// What one call did.
    struct part {
        std::size_t taken{0};  ///< so many marked bytes are used up
        std::size_t size{0};   ///< so many bytes were written
        bool has_error{false}; ///< a damaged byte came after them
    };

    /// Writes the bytes without their marks to `place`, until `place` is full or a byte was damaged. The
    /// damaged byte itself is left out. What was not taken belongs to the next call.
    constexpr part take(byte_view marked, byte_span place) noexcept
    {
        part done{};
        while (done.taken < marked.size() and done.size < place.size() and not done.has_error) {
            std::byte const byte = marked[done.taken];
            bool const is_first = byte == std::byte{0xFF};
            if (state_ == state::begun and not is_first and byte != std::byte{0}) {
                // An FF that marks nothing: bytes are missing here. This byte is examined again.
                state_ = state::outside;
                done.has_error = true;
                continue;
            }
            ++done.taken;
            if (state_ == state::damaged) {
                state_ = state::outside;
                done.has_error = true;
            } else if (state_ == state::outside and is_first) {
                state_ = state::begun;
            } else if (state_ == state::begun and not is_first) {
                state_ = state::damaged;
            } else {
                state_ = state::outside;
                place[done.size++] = byte;
            }
        }
        return done;
    }

    /// Forgets an incomplete mark.
    constexpr void restart() noexcept { state_ = state::outside; }

private:
    enum class state : std::uint8_t {
        outside,
        begun,   ///< after FF
        damaged, ///< after FF 00
    };

    state state_{state::outside};
};

} // namespace detail

} // namespace RTUWIRE_BUILD
} // namespace rtuwire
