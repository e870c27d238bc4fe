// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// What a client knows of units that it has not commanded.
#include <rtuwire/ask/unit_order.hpp>

#include <array>
#include <bit>
#include <cstddef>

#include "support/proof.hpp"

namespace {

constexpr bool is_all_zero()
{
    using bytes = std::array<std::byte, sizeof(rtuwire::detail::unit_order)>;
    bool ok = true;
    for (std::byte const each : std::bit_cast<bytes>(rtuwire::detail::nothing_known)) {
        ok = ok and each == std::byte{0};
    }
    return ok;
}
PROOF("nothing known of a unit is all zero, so that a constant client needs no flash", is_all_zero)

} // namespace
