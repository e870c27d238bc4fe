// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// The contents of a simulated drive's monitoring registers: one function for each word, of a drive as it is at one
// moment. Apart from the drive, of which they know no more than that.
#pragma once

#include <cstddef>
#include <cstdint>

#include <rtuwire/altivar/device/drive_layout.hpp>
#include <rtuwire/altivar/device/drive_type.hpp>
#include <rtuwire/cia402/state.hpp>
#include <rtuwire/core/version.hpp>
#include <rtuwire/sim/drive/control.hpp>
#include <rtuwire/sim/drive/image.hpp>
#include <rtuwire/sim/drive/motor.hpp>
#include <rtuwire/sim/drive/parameters.hpp>

namespace rtuwire {
inline namespace RTUWIRE_BUILD {
namespace detail {

/// A drive at one moment, as its registers report it.
struct appearance {
    cia402::state state;
    std::int32_t target; ///< mHz, what the ramp goes to
    bool is_backwards;   ///< the direction that is asked for
    bool is_limited;
    bool is_local; ///< as bit 9 of ETA means it
    bool is_by_link;
    bool is_stopped_by_key;
    bool has_cause; ///< the fault's cause is still present
    bool tripped_in_quick_stop;
    bool is_injecting;
    bool is_memory_busy;

    [[nodiscard]] constexpr bool is_running() const noexcept { return state == cia402::state::operation_enabled; }
};

/// The status word, ETA.
[[nodiscard]] constexpr std::uint16_t status_word_of(appearance const& seen, simulated_motor const& shaft,
                                                     altivar::drive_layout const& layout) noexcept
{
    std::uint32_t word = status_bits(seen.state);
    bool const is_reached = shaft.frequency() == seen.target;
    if (cia402::is_in_fault(seen.state) and seen.tripped_in_quick_stop) {
        word &= ~std::uint32_t{no_quick_stop_bit};
    }
    word |= layout.mains_bit_is_inverted ? 0U : 0x10U;
    word |= seen.is_local ? 0U : altivar::remote_bit;
    word |= seen.is_running() and is_reached ? altivar::reference_reached_bit : 0U;
    word |= seen.is_running() and seen.is_limited ? altivar::reference_limited_bit : 0U;
    word |= seen.is_stopped_by_key ? altivar::stop_key_bit : 0U;
    word |= shaft.frequency() < 0 ? altivar::runs_backwards_bit : 0U;
    return static_cast<std::uint16_t>(word);
}

/// The extended status word, ETI. Bits that the drive does not have stay 0.
[[nodiscard]] constexpr std::uint16_t extended_status_of(appearance const& seen, simulated_motor const& shaft,
                                                         std::uint16_t bits) noexcept
{
    constexpr unsigned memory = 0, fault_is_gone = 2, motor_turns = 4, injects = 5, changes = 6, accelerates = 9,
                       slows = 10, by_link = 14, backwards = 15;
    bool const may_reset = cia402::is_in_fault(seen.state) and not seen.has_cause;
    bool const is_changing = shaft.is_accelerating() or shaft.is_decelerating();
    std::uint32_t word = 0;
    word |= (seen.is_memory_busy ? 1U : 0U) << memory;
    word |= (may_reset ? 1U : 0U) << fault_is_gone;
    word |= (shaft.is_at_rest() ? 0U : 1U) << motor_turns;
    word |= (seen.is_injecting ? 1U : 0U) << injects;
    word |= (is_changing ? 1U : 0U) << changes;
    word |= (shaft.is_accelerating() ? 1U : 0U) << accelerates;
    word |= (shaft.is_decelerating() ? 1U : 0U) << slows;
    word |= (seen.is_by_link ? 1U : 0U) << by_link;
    word |= (seen.is_backwards ? 1U : 0U) << backwards;
    return static_cast<std::uint16_t>(word & bits);
}

/// The state of the product, HMIS.
[[nodiscard]] constexpr std::uint16_t product_state_of(appearance const& seen, simulated_motor const& shaft) noexcept
{
    constexpr std::uint16_t ready = 2, freewheel = 3, runs = 4, accelerates = 5, slows = 6, in_fault = 23;
    if (cia402::is_in_fault(seen.state)) {
        return in_fault;
    }
    if (not cia402::has_power(seen.state)) {
        return seen.state == cia402::state::switch_on_disabled ? freewheel : ready;
    }
    return shaft.is_accelerating() ? accelerates : shaft.is_decelerating() ? slows : runs;
}

/// The threshold bits, ETI2.
template <device_type Device>
[[nodiscard]] constexpr std::uint16_t thresholds_of(image<Device> const& registers, appearance const& seen,
                                                    simulated_motor const& shaft) noexcept
{
    constexpr register_index<Device> at{};
    constexpr unsigned reference = 4, frequency = 5, current = 6;
    std::int32_t const turning = shaft.frequency();
    std::int32_t const size = (turning < 0 ? -turning : turning) / 100;
    bool const is_reached = seen.is_running() and turning == seen.target;
    std::uint32_t word = (is_reached ? 1U : 0U) << reference;
    word |= (size >= registers.get(at.ftd) ? 1U : 0U) << frequency;
    word |= (shaft.current() >= registers.get(at.ctd) ? 1U : 0U) << current;
    return static_cast<std::uint16_t>(word);
}

/// Stores a signed number in a signed register, its magnitude in any other.
template <device_type Device>
constexpr void put_either(image<Device>& registers, std::size_t place, std::int64_t value) noexcept
{
    std::int64_t const size = value < 0 ? -value : value;
    registers.put(place, registers.is_signed(place) ? value : size);
}

/// Updates the monitoring registers.
template <device_type Device>
constexpr void update_status_registers(image<Device>& registers, appearance const& seen,
                                       simulated_motor const& shaft) noexcept
{
    constexpr register_index<Device> at{};
    constexpr std::int64_t volts_of_mains = 400;
    parameters<Device> const set{registers};
    std::int64_t const turning = shaft.frequency();
    std::int64_t const size = turning < 0 ? -turning : turning;
    std::uint16_t const status = status_word_of(seen, shaft, Device::layout);
    registers.put(at.eta, status);
    registers.put(at.etad, status);
    registers.put(at.eti, extended_status_of(seen, shaft, altivar::behaviour_of<Device>.extended_status_bits));
    registers.put(at.eti2, thresholds_of(registers, seen, shaft));
    registers.put(at.hmis, product_state_of(seen, shaft));
    put_either(registers, at.rfr, turning / 100);
    put_either(registers, at.frh, seen.target / 100);
    put_either(registers, at.rfrd, set.to_rpm(turning));
    put_either(registers, at.frhd, set.to_rpm(seen.target));
    registers.put(at.spd, set.to_rpm(size));
    registers.put(at.lcr, shaft.current());
    motor_settings const rated = set.motor();
    std::int64_t const load = shaft.load(rated);
    registers.put(at.otr, load * registers.scale(at.otr));
    registers.put(at.opr, load * size / rated.rated_frequency);
    registers.put(at.uln, volts_of_mains * registers.scale(at.uln));
    registers.put(at.thr, shaft.thermal_state());
    registers.put(at.thd, shaft.thermal_state() / 2);
}

/// The logic inputs; the image of some drives has outputs beside them.
template <device_type Device>
constexpr void show_inputs(image<Device>& registers, logic_inputs const& terminals) noexcept
{
    constexpr register_index<Device> at{};
    constexpr std::uint32_t bits = altivar::behaviour_of<Device>.input_bits;
    registers.put(at.inputs, (registers.get(at.inputs) & ~bits) | (terminals.image() & bits));
}

} // namespace detail
} // namespace RTUWIRE_BUILD
} // namespace rtuwire
