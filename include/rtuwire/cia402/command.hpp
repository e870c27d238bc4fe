// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// The commands of the drive profile and their control words.
#pragma once

#include <cstdint>

#include <rtuwire/cia402/state.hpp>
#include <rtuwire/core/literal.hpp>
#include <rtuwire/core/version.hpp>

namespace rtuwire {
inline namespace RTUWIRE_BUILD {
namespace cia402 {

/// What a control word commands. "Switch on" and "disable operation" are one word; the state decides which it is.
enum class command : std::uint8_t {
    none, ///< a word without a command
    shutdown,
    switch_on,
    enable_operation,
    disable_voltage,
    quick_stop,
    fault_reset,
};

} // namespace cia402

namespace detail {

/// Bits of the control word that are not a command.
inline constexpr std::uint16_t halt_bit = 0x0100;
inline constexpr std::uint16_t fault_reset_bit = 0x0080;

/// The command in bits 0 to 3 of a control word: the tables print an x for bit 7 in all of these.
[[nodiscard]] constexpr cia402::command command_in(std::uint16_t word) noexcept
{
    if ((word & 0x02) == 0) {
        return cia402::command::disable_voltage;
    }
    if ((word & 0x04) == 0) {
        return cia402::command::quick_stop;
    }
    if ((word & 0x01) == 0) {
        return cia402::command::shutdown;
    }
    return (word & 0x08) == 0 ? cia402::command::switch_on : cia402::command::enable_operation;
}

/// Whether a control word resets a fault, given the one before it: by a rising edge of bit 7. In a fault no other bit
/// has an effect; in any other state the edge has none.
[[nodiscard]] constexpr bool is_reset_edge(std::uint16_t before, std::uint16_t word) noexcept
{
    return (word & ~before & fault_reset_bit) != 0;
}

} // namespace detail

namespace cia402 {

/// The control word of a command; 0 for `none`, which is also "disable voltage".
[[nodiscard]] constexpr std::uint16_t word_of(command what) noexcept
{
    switch (what) {
    case command::shutdown: return 0x0006;
    case command::switch_on: return 0x0007;
    case command::enable_operation: return 0x000F;
    case command::quick_stop: return 0x0002;
    case command::fault_reset: return detail::fault_reset_bit;
    case command::none:
    case command::disable_voltage: break;
    }
    return 0x0000;
}

/// A command's name in the profile.
[[nodiscard]] constexpr literal name_of(command what) noexcept
{
    switch (what) {
    case command::none: break;
    case command::shutdown: return "shutdown";
    case command::switch_on: return "switch on";
    case command::enable_operation: return "enable operation";
    case command::disable_voltage: return "disable voltage";
    case command::quick_stop: return "quick stop";
    case command::fault_reset: return "fault reset";
    }
    return "none";
}

/// The same, for what shows any value.
[[nodiscard]] constexpr literal text_of(command of) noexcept { return name_of(of); }

} // namespace cia402
} // namespace RTUWIRE_BUILD
} // namespace rtuwire
