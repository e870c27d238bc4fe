// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// Finds out whether a line gives back what is sent. On such a line the echo of a function 06 request
// looks like the response to it, so this is worth one request before the first write.
#pragma once

#include <cstdint>

#include <rtuwire/ask/access.hpp>
#include <rtuwire/core/result.hpp>
#include <rtuwire/core/version.hpp>

namespace rtuwire {
inline namespace RTUWIRE_BUILD {

/// Reads one register of a unit and checks whether the request comes back, while it is sent or before the response.
/// For a client without `has_line_echo`.
class line_echo_probe : public detail::word_read {
public:
    explicit constexpr line_echo_probe(unit_id unit) noexcept : detail::word_read{unit, address} {}

    /// Whether the line echoes; `busy` until it is settled. Errors: those of the client, where the unit did not
    /// respond at all. An exception is a response.
    [[nodiscard]] constexpr result<bool> outcome() const noexcept
    {
        errc const wrong = word().error();
        if (wrong == errc::line_echo) {
            return true;
        }
        if (wrong == errc::none or is_exception(wrong)) {
            return false;
        }
        return wrong;
    }

private:
    /// Any address: an exception is a response, too.
    static constexpr std::uint16_t address = 0x0300;
};

} // namespace RTUWIRE_BUILD
} // namespace rtuwire
