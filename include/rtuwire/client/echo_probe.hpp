// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// Finds out whether a line gives back what is sent. On such a line the echo of a function 06 request
// looks like the answer to it, so this is worth one question before the first write.
#pragma once

#include <cstdint>

#include <rtuwire/client/access.hpp>
#include <rtuwire/core/result.hpp>
#include <rtuwire/core/version.hpp>

namespace rtuwire::inline RTUWIRE_BUILD {

/// Asks a unit for one register and looks whether the question comes back, while it is sent or before the
/// answer. For a client without `has_echo`.
class echo_probe : public word_reading {
public:
    explicit constexpr echo_probe(unit_id unit) noexcept : word_reading{unit, address} {}

    /// Whether the line echoes; `pending` until it is settled. Errors: those of the client, where the
    /// unit did not answer at all. A refusal is an answer.
    [[nodiscard]] constexpr result<bool> outcome() const noexcept
    {
        errc const wrong = word().error();
        if (wrong == errc::echoed) {
            return true;
        }
        if (wrong == errc::none or is_exception(wrong)) {
            return false;
        }
        return wrong;
    }

private:
    /// Any address whose high octet is 3: as an answer, the question then has the length it claims, so
    /// that it is told from an answer that follows at once.
    static constexpr std::uint16_t address = 0x0300;
};

} // namespace rtuwire
