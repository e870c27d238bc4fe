// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// The states of a drive (CiA 402, IEC 61800-7-201) and how the status word encodes them. Vendor neutral: knows
// neither a bus nor a drive. A word that matches no state decodes to `unknown`; no state is guessed.
#pragma once

#include <array>
#include <cstdint>

#include <rtuwire/core/literal.hpp>
#include <rtuwire/core/version.hpp>

namespace rtuwire {
inline namespace RTUWIRE_BUILD {
namespace cia402 {

/// The state of a drive.
enum class state : std::uint8_t {
    unknown, ///< the status word matches no state of the profile
    not_ready_to_switch_on,
    switch_on_disabled,
    ready_to_switch_on,
    switched_on,
    operation_enabled,
    quick_stop_active,
    fault_reaction_active,
    fault,
};

} // namespace cia402

namespace detail {

/// Bit 5 of the status word, low during a quick stop.
inline constexpr std::uint16_t no_quick_stop_bit = 0x20;

/// The bits of a status word that encode one state.
struct state_pattern {
    std::uint16_t mask;
    std::uint16_t value;
    cia402::state meaning;
};

/// The eight patterns; no word matches two of them.
inline constexpr std::array<state_pattern, 8> state_patterns{{
    {0x4F, 0x00, cia402::state::not_ready_to_switch_on},
    {0x4F, 0x40, cia402::state::switch_on_disabled},
    {0x6F, 0x21, cia402::state::ready_to_switch_on},
    {0x6F, 0x23, cia402::state::switched_on},
    {0x6F, 0x27, cia402::state::operation_enabled},
    {0x6F, 0x07, cia402::state::quick_stop_active},
    {0x4F, 0x0F, cia402::state::fault_reaction_active},
    {0x4F, 0x08, cia402::state::fault},
}};

/// The bits 0 to 6 of a drive's status word in a state, without bit 4; 0 for `unknown`. Bit 5 is open in some states:
/// low in "switch on disabled" and before, as the manuals print it; high in a fault, unless a quick stop led there.
[[nodiscard]] constexpr std::uint16_t status_bits(cia402::state of) noexcept
{
    bool const is_fault = of == cia402::state::fault or of == cia402::state::fault_reaction_active;
    for (state_pattern const& each : state_patterns) {
        if (each.meaning == of) {
            return static_cast<std::uint16_t>(each.value | (is_fault ? no_quick_stop_bit : 0));
        }
    }
    return 0;
}

} // namespace detail

namespace cia402 {

/// The state in a status word. Bit 4 is not used here: drives differ in its sense.
[[nodiscard]] constexpr state decode(std::uint16_t status_word) noexcept
{
    for (detail::state_pattern const& each : detail::state_patterns) {
        if ((status_word & each.mask) == each.value) {
            return each.meaning;
        }
    }
    return state::unknown;
}

/// Whether the drive may be turning its motor by itself.
[[nodiscard]] constexpr bool has_power(state of) noexcept
{
    return of == state::operation_enabled or of == state::quick_stop_active or of == state::fault_reaction_active;
}

/// Whether the motor is known to be without power.
[[nodiscard]] constexpr bool is_at_rest(state of) noexcept { return of != state::unknown and not has_power(of); }

/// Whether only a fault reset leads out of the state, now or as soon as the motor is at rest.
[[nodiscard]] constexpr bool is_in_fault(state of) noexcept
{
    return of == state::fault or of == state::fault_reaction_active;
}

/// A state's name in the profile.
[[nodiscard]] constexpr literal name_of(state of) noexcept
{
    switch (of) {
    case state::unknown: break;
    case state::not_ready_to_switch_on: return "not ready to switch on";
    case state::switch_on_disabled: return "switch on disabled";
    case state::ready_to_switch_on: return "ready to switch on";
    case state::switched_on: return "switched on";
    case state::operation_enabled: return "operation enabled";
    case state::quick_stop_active: return "quick stop active";
    case state::fault_reaction_active: return "fault reaction active";
    case state::fault: return "fault";
    }
    return "unknown";
}

/// The same, for what shows any value.
[[nodiscard]] constexpr literal text_of(state of) noexcept { return name_of(of); }

} // namespace cia402
} // namespace RTUWIRE_BUILD
} // namespace rtuwire
