// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// What the words of a drive's settings mean to its model: ramps, speed limits, the motor's nameplate, the supervision of
// the link, the channels of command and reference; and what they demand of the motor, together with the commands.
#pragma once

#include <cstddef>
#include <cstdint>

#include <rtuwire/altivar/device/drive_type.hpp>
#include <rtuwire/cia402/state.hpp>
#include <rtuwire/core/time.hpp>
#include <rtuwire/core/version.hpp>
#include <rtuwire/sim/drive/control.hpp>
#include <rtuwire/sim/drive/image.hpp>
#include <rtuwire/sim/drive/memory.hpp>
#include <rtuwire/sim/drive/motor.hpp>

namespace rtuwire {
inline namespace RTUWIRE_BUILD {
namespace detail {

/// The reactions to a lost link, by the values of SLL. With 1, and from 6 on, the drive trips; with 4 it continues at
/// a speed that no available table has, 0 as delivered.
enum class loss_reaction : std::uint16_t {
    ignore = 0,
    freewheel = 1,
    stop_without_fault = 2, ///< as STT says
    fall_back_to_a_speed = 4,
    keep_the_speed = 5,
    ramp = 6,
    fast = 7,
    injection = 8,
};

/// Whether a lost link is a fault.
[[nodiscard]] constexpr bool is_fault(loss_reaction how) noexcept
{
    return how == loss_reaction::freewheel or how >= loss_reaction::ramp;
}

/// A drive's line settings, as values of its registers.
struct line_setting {
    std::uint16_t rate{0};
    std::uint16_t format{0};

    friend constexpr bool operator==(line_setting const&, line_setting const&) noexcept = default;
};

/// A view of the settings in an image, which outlives it.
template <device_type Device> class parameters {
    static constexpr register_index<Device> at{};

public:
    explicit constexpr parameters(image<Device> const& its_registers) noexcept : registers_{its_registers} {}

    [[nodiscard]] constexpr motor_settings motor() const noexcept
    {
        std::int64_t const step = ramp_step();
        std::size_t const current = at.has(at.ncr) ? at.ncr : at.inv;
        std::int32_t const rated = get(at.frs) == 0 ? 500 : get(at.frs);
        return {rated * 100, step * get(at.acc), step * get(at.dec), get(current), get(at.ith)};
    }

    /// A frequency in mHz limited to LSP and HSP, in the direction of the reference: LSP applies to a reference of 0,
    /// too.
    [[nodiscard]] constexpr std::int32_t limited(std::int32_t frequency, bool is_backwards) const noexcept
    {
        std::int32_t const most = get(at.hsp) * 100;
        std::int32_t const least = get(at.lsp) * 100;
        std::int32_t const size = frequency < 0 ? -frequency : frequency;
        std::int32_t const cut = size > most ? most : size < least ? least : size;
        return is_backwards ? -cut : cut;
    }

    /// mHz for revolutions a minute: by the motor's nameplate, or by SDS where there is none.
    [[nodiscard]] constexpr std::int64_t to_millihertz(std::int64_t speed) const noexcept
    {
        if (not at.has(at.nsp)) {
            std::int32_t const per_hertz = get(at.sds);
            return per_hertz == 0 ? 0 : speed * 1'000 / per_hertz;
        }
        return speed * pole_pairs() * 50 / 3;
    }
    [[nodiscard]] constexpr std::int64_t to_rpm(std::int64_t millihertz) const noexcept
    {
        return at.has(at.nsp) ? millihertz / 50 * 3 / pole_pairs() : millihertz / 100 * get(at.sds) / 10;
    }

    /// The time without a request after which the link is lost; 0 where the drive does not supervise it.
    [[nodiscard]] constexpr duration time_out() const noexcept
    {
        if (not at.has(at.tto)) {
            bool const is_ignored = (get(at.cmi) & at.guards.nto) != 0;
            return is_ignored ? duration{} : at.guards.fixed_timeout;
        }
        bool const is_ignored = reaction_to_loss() == loss_reaction::ignore;
        return is_ignored ? duration{} : milliseconds(100) * registers_.get(at.tto);
    }

    /// The reaction to a lost link (SLL); freewheel where it cannot be set.
    [[nodiscard]] constexpr loss_reaction reaction_to_loss() const noexcept
    {
        return at.has(at.sll) ? static_cast<loss_reaction>(get(at.sll)) : loss_reaction::freewheel;
    }

    /// Whether it resets the fault of a lost link once the link is back, and continues as commanded (ATR).
    [[nodiscard]] constexpr bool restarts_by_itself() const noexcept
    {
        constexpr std::int32_t always = 1;
        return at.has(at.atr) and get(at.atr) == always;
    }

    /// Whether "disable operation" removes the torque (DOTD) instead of following the ramp.
    [[nodiscard]] constexpr bool freewheels_when_disabled() const noexcept
    {
        return at.has(at.dotd) and get(at.dotd) == 0;
    }

    /// How STT sets a motor to stop.
    [[nodiscard]] constexpr stopping as_set() const noexcept
    {
        constexpr altivar::simulated_behaviour const& numbers = altivar::behaviour_of<Device>;
        switch (registers_.get(at.stt)) {
        case numbers.fast_stop: return stopping::fast;
        case numbers.freewheel: return stopping::freewheel;
        case numbers.dc_injection: return stopping::injection;
        default: return stopping::ramp;
        }
    }

    /// The line settings in the registers. BDR is that of another line where a drive has TBR, too.
    [[nodiscard]] constexpr line_setting line() const noexcept
    {
        return {registers_.get(at.has(at.tbr) ? at.tbr : at.bdr), registers_.get(at.tfo)};
    }

    /// Which channel commands.
    [[nodiscard]] constexpr channel_choice choose(logic_inputs const& inputs) const noexcept
    {
        return {commands_by_link(), is_forced_local(inputs), registers_.get(at.chcf) == io_profile,
                inputs.is_closed(1)};
    }

    /// Whether Modbus gives the reference.
    [[nodiscard]] constexpr bool refers_to_link() const noexcept
    {
        return not at.has(at.fr1) or registers_.get(at.fr1) == reference_by_modbus;
    }

private:
    static constexpr std::uint16_t together = 1, io_profile = 3;            ///< CHCF
    static constexpr std::uint16_t reference_by_modbus = 164;               ///< FR1
    static constexpr std::uint16_t command_by_modbus = 10;                  ///< CD1
    static constexpr std::uint16_t first_input = 129, first_inverted = 145; ///< FLO: LI1, L1L
    static constexpr std::uint16_t forces_local = 17;                       ///< LI3 and LI4

    [[nodiscard]] constexpr std::int32_t get(std::size_t place) const noexcept { return registers_.get(place); }

    /// What one count of ACC and DEC is, in us: INR 0, 1 and 2 where a drive has it, else 0.1 s.
    constexpr std::int64_t ramp_step() const noexcept
    {
        if (not at.has(at.inr)) {
            return 100'000;
        }
        return get(at.inr) == 0 ? 10'000 : get(at.inr) == 2 ? 1'000'000 : 100'000;
    }

    constexpr std::int32_t pole_pairs() const noexcept
    {
        std::int32_t const speed = get(at.nsp);
        std::int32_t const pairs = speed == 0 ? 1 : (get(at.frs) * 6 + speed / 2) / speed;
        return pairs == 0 ? 1 : pairs;
    }

    /// With CHCF 1 the reference's channel also commands, whatever CD1 holds.
    constexpr bool commands_by_link() const noexcept
    {
        bool const is_together = not at.has(at.cd1) or registers_.get(at.chcf) == together;
        return is_together ? refers_to_link() : registers_.get(at.cd1) == command_by_modbus;
    }

    constexpr bool is_forced_local(logic_inputs const& inputs) const noexcept
    {
        std::size_t const by = registers_.get(at.flo);
        constexpr std::size_t most = 16;
        bool const by_high = by >= first_input and by < first_inverted and inputs.is_closed(by - first_input + 1);
        bool const by_low =
            by >= first_inverted and by < first_inverted + most and not inputs.is_closed(by - first_inverted + 1);
        return by_high or by_low or (registers_.get(at.li3) == forces_local and inputs.is_closed(3)) or
               (registers_.get(at.li4) == forces_local and inputs.is_closed(4));
    }

    image<Device> const& registers_;
};

/// What a drive demands of its motor: a frequency in a direction, or a kind of stop; from its commands, its channels, its
/// limits and a link that may be lost. A view of a drive's registers and commands, which outlive it.
template <device_type Device> class demand {
    static constexpr register_index<Device> at{};

public:
    /// `analog` is the reference at the terminals, in mHz.
    constexpr demand(image<Device> const& its_registers, control const& commands, std::int32_t analog,
                     bool is_link_lost) noexcept
        : registers_{its_registers}, commands_{commands}, analog_{analog}, is_link_lost_{is_link_lost}
    {}

    /// The reference, in mHz, before the limits and without the direction of the command.
    [[nodiscard]] constexpr std::int32_t asked() const noexcept
    {
        bool const falls_back = is_link_lost_ and set().reaction_to_loss() == loss_reaction::fall_back_to_a_speed;
        std::int32_t const given = refers_to_link() ? registers_.get_signed(at.lfr) * 100 : analog_;
        return falls_back ? 0 : given;
    }

    /// The direction that is asked for: that of the reference and of the command. A reference has one even where it is no
    /// step of LFR, or another speed is taken for it.
    [[nodiscard]] constexpr bool is_backwards() const noexcept
    {
        bool const is_negative = registers_.get_signed(at.lfr) < 0 or registers_.get_signed(at.lfrd) < 0;
        return (refers_to_link() ? is_negative : analog_ < 0) != commands_.is_reversed();
    }

    /// How the motor is being stopped; `none` while it may turn.
    [[nodiscard]] constexpr stopping how_it_stops() const noexcept
    {
        if (commands_.state_machine().state() == cia402::state::fault_reaction_active) {
            return how_a_fault_stops();
        }
        if (commands_.state_machine().is_leaving() and commands_.is_by_link() and set().freewheels_when_disabled()) {
            return stopping::freewheel;
        }
        stopping const how = commands_.how_it_stops();
        return how == stopping::as_set ? set().as_set() : how;
    }

    /// The target of the ramp, in mHz.
    [[nodiscard]] constexpr std::int32_t target() const noexcept
    {
        return how_it_stops() == stopping::none ? set().limited(asked(), is_backwards()) : 0;
    }

    /// Whether the reference lies outside LSP and HSP.
    [[nodiscard]] constexpr bool is_limited() const noexcept { return set().limited(asked(), asked() < 0) != asked(); }

private:
    constexpr parameters<Device> set() const noexcept { return parameters<Device>{registers_}; }

    constexpr bool refers_to_link() const noexcept { return commands_.is_by_link() and set().refers_to_link(); }

    /// A fault removes the torque, unless it is a lost link with another reaction in SLL.
    constexpr stopping how_a_fault_stops() const noexcept
    {
        if (commands_.fault() != sim::link_fault) {
            return stopping::freewheel;
        }
        switch (set().reaction_to_loss()) {
        case loss_reaction::ramp: return stopping::ramp;
        case loss_reaction::fast: return stopping::fast;
        case loss_reaction::injection: return stopping::injection;
        case loss_reaction::ignore:
        case loss_reaction::freewheel:
        case loss_reaction::stop_without_fault:
        case loss_reaction::fall_back_to_a_speed:
        case loss_reaction::keep_the_speed: break;
        }
        return stopping::freewheel;
    }

    image<Device> const& registers_;
    control const& commands_;
    std::int32_t analog_;
    bool is_link_lost_;
};

/// Moves a motor for the time `passed`, as demanded.
template <device_type Device>
constexpr void drive_motor(simulated_motor& shaft, demand<Device> const& asked, bool has_power, duration passed,
                           motor_settings settings) noexcept
{
    constexpr std::int64_t fast = 4; ///< of the ramp, as dCF is delivered
    stopping const how = asked.how_it_stops();
    if (not has_power or how == stopping::freewheel) {
        shaft.coast(passed, settings);
    } else if (how == stopping::injection) {
        shaft.inject(passed, settings);
    } else {
        settings.deceleration /= how == stopping::fast ? fast : 1;
        shaft.drive(asked.target(), passed, settings);
    }
}

} // namespace detail
} // namespace RTUWIRE_BUILD
} // namespace rtuwire
