// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// What a receiver of requests knows of the exchanges between other stations: after a request to another unit
// its response may come, which the length rules of requests would misread. It is not certain to come: the
// next frame of that unit and function may be a request again. A receiver of responses needs none of this,
// and it costs nothing there.
#pragma once

#include <cstddef>
#include <cstdint>

#include <rtuwire/core/bytes.hpp>
#include <rtuwire/core/version.hpp>
#include <rtuwire/wire/function.hpp>
#include <rtuwire/wire/functions.hpp>

namespace rtuwire {
inline namespace RTUWIRE_BUILD {

namespace detail {

/// What the length rules say of a frame with these bytes.
struct end_hint {
    std::size_t next;         ///< the size to apply them again at; 0 where only silence ends it
    bool is_here;             ///< whether it ends here, if its CRC is right
    bool is_response = false; ///< ... by the rule of responses
    bool is_open = false;     ///< ... and the size by the other rule is one byte more
};

/// For a receiver of responses to these functions.
template <direction Way, typename Functions = public_functions> class foreign_exchange {
public:
    [[gnu::always_inline]] static constexpr end_hint apply(byte_view so_far) noexcept
    {
        std::size_t const size = size_hint<Functions>(Way, so_far);
        return {size, size == so_far.size()};
    }
    static constexpr bool is_expected(byte_view) noexcept { return false; }
    static constexpr void begin_frame() noexcept {}
    static constexpr void end_frame(bool) noexcept {}
    static constexpr bool takes(std::byte) noexcept { return false; }
};

/// For a receiver of requests, to others of any function.
template <typename Functions> class foreign_exchange<direction::request, Functions> {
public:
    /// A request to another unit passed; a function of 80 or above expects no response.
    constexpr void expect(std::uint8_t unit, std::uint8_t function) noexcept
    {
        unit_ = unit;
        function_ = function;
    }

    /// Whether the first bytes of a frame, two at least, may be those of the response.
    [[nodiscard]] constexpr bool is_expected(byte_view so_far) const noexcept
    {
        return to_u8(so_far[0]) == unit_ and (to_u8(so_far[1]) & ~exception_bit) == function_;
    }

    /// Applies the rule of requests, and where the response may have begun, that of responses as well.
    [[nodiscard, gnu::always_inline]] constexpr end_hint apply(byte_view so_far) const noexcept
    {
        std::size_t const size = so_far.size();
        std::size_t const request = rule_size(direction::request, so_far);
        if (not is_expected(so_far)) {
            return {request, request == size};
        }
        std::size_t const response = rule_size(direction::response, so_far);
        bool const may = may_be_request(so_far);
        bool const is_request = may and request == size;
        // A size already passed, or 0, wraps to a large distance.
        std::size_t const next = request - size - 1U < response - size - 1U ? request : response;
        return {next, is_request or response == size, not is_request, may and next == size + 1U};
    }

    /// The size by the rule of one direction; 0 where it gives none.
    static constexpr std::size_t rule_size(direction dir, byte_view so_far) noexcept { return size_hint(dir, so_far); }

    /// Whether a frame with these first bytes may be a request. One response in 65 536 has a right CRC where
    /// a request would have it; few of these hold a quantity that functions 01 to 04 allow.
    [[nodiscard]] constexpr bool may_be_request(byte_view so_far) const noexcept
    {
        constexpr std::uint8_t last_read = 4, last_bit_read = 2;
        constexpr std::size_t quantity_at = 4;
        constexpr std::uint8_t most_of_bits = 7, most = 0; // high bytes of 2000 and 125
        return function_ > last_read or so_far.size() <= quantity_at or
               to_u8(so_far[quantity_at]) <= (function_ > last_bit_read ? most : most_of_bits);
    }

    /// A frame begins.
    constexpr void begin_frame() noexcept { end_frame(false); }

    /// A frame ended at the size of a response, or at that of a request.
    constexpr void end_frame(bool is_response) noexcept { is_response_ = is_response; }

    /// Whether this byte, which follows at once, belongs to the frame: the CRC stays right with 00 only.
    constexpr bool takes(std::byte next) noexcept
    {
        bool const is_part = next == std::byte{0};
        is_response_ = is_response_ != is_part;
        return is_part;
    }

    /// Whether the last frame was the response.
    [[nodiscard]] constexpr bool is_response() const noexcept { return is_response_; }

private:
    std::uint8_t unit_{0};
    std::uint8_t function_{exception_bit};
    bool is_response_{false};
};

} // namespace detail

} // namespace RTUWIRE_BUILD
} // namespace rtuwire
