// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A status word of each state, as a drive commanded over its line shows it, and all answers to a read of the status.
#pragma once

#include <array>
#include <cstdint>

#include "altivar/procedure/step_table.hpp"

namespace rtuwire::test {

inline constexpr std::uint16_t not_ready_word = 0x0200, disabled_word = 0x0250, ready_word = 0x0231, on_word = 0x0233;
inline constexpr std::uint16_t enabled_word = 0x0237, quick_stop_word = 0x0217, reaction_word = 0x023F;
inline constexpr std::uint16_t fault_word = 0x0238, no_state_word = 0x0201;

/// Every state, and whatever else may come of a read of the status.
inline constexpr std::array<answer, 12> looks{{
    {"not ready to switch on", word(not_ready_word)},
    {"switch on disabled", word(disabled_word)},
    {"ready to switch on", word(ready_word)},
    {"switched on", word(on_word)},
    {"operation enabled", word(enabled_word)},
    {"quick stop active", word(quick_stop_word)},
    {"fault reaction active", word(reaction_word)},
    {"fault", word(fault_word)},
    {"no state", word(no_state_word)},
    {"no response", failed(errc::timed_out)},
    {"refused", failed(errc::server_device_failure)},
    {"limit over", late},
}};

} // namespace rtuwire::test
