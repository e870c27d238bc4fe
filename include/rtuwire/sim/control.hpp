// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// Who commands a simulated drive and what the command words did: its chart, the edges of the words, direct
// control, the keys on the drive, the fault. Knows neither registers nor a motor.
#pragma once

#include <cstdint>

#include <rtuwire/altivar/profile.hpp>
#include <rtuwire/cia402/command.hpp>
#include <rtuwire/core/version.hpp>
#include <rtuwire/sim/chart.hpp>

namespace rtuwire::inline RTUWIRE_BUILD::sim {

/// The command side of a drive.
class control {
public:
    explicit constexpr control(altivar::drive_profile const& profile) noexcept
        : profile_{&profile}, chart_{profile.chart}
    {}

    [[nodiscard]] constexpr sim::chart const& chart() const noexcept { return chart_; }

    /// LFT of the fault that the drive is in; 0 in none.
    [[nodiscard]] constexpr std::uint16_t fault() const noexcept { return fault_; }
    [[nodiscard]] constexpr bool has_cause() const noexcept { return has_cause_; }
    [[nodiscard]] constexpr bool is_local() const noexcept { return is_local_; }
    [[nodiscard]] constexpr bool is_stopped_by_key() const noexcept { return is_stopped_by_key_; }
    [[nodiscard]] constexpr bool has_fault() const noexcept
    {
        return cia402::is_in_fault(chart_.state());
    }

    /// Whether the command asks for the other direction.
    [[nodiscard]] constexpr bool is_reversed() const noexcept
    {
        return (last_command_ & altivar::reverse_bit) != 0;
    }

    [[nodiscard]] constexpr bool is_stopping() const noexcept
    {
        std::uint16_t const stop_bits =
            is_direct(last_command_) ? ramp_stop | dc_stop | fast_stop : profile_->halt;
        return chart_.is_leaving() or (last_command_ & stop_bits) != 0 or
               chart_.state() != cia402::state::operation_enabled;
    }

    [[nodiscard]] constexpr bool is_stopping_fast() const noexcept
    {
        bool const is_ordered = is_direct(last_command_) and (last_command_ & fast_stop) != 0;
        return is_ordered or chart_.state() == cia402::state::quick_stop_active;
    }

    /// Switched on; of what was before it knows nothing.
    constexpr void power_up() noexcept
    {
        *this = control{*profile_};
        chart_.power_up();
    }
    constexpr void initialised() noexcept { chart_.initialised(); }

    /// The motor stands.
    constexpr void at_rest() noexcept { chart_.at_rest(); }

    /// STOP key, local control or a configuration write.
    constexpr void fall_back() noexcept { chart_.fall_back(); }

    /// A command word; whether it reset a fault.
    constexpr bool obey(std::uint16_t word) noexcept
    {
        std::uint16_t const before = last_command_;
        last_command_ = word;
        if (is_local_) {
            return false;
        }
        bool const was_in_fault = has_fault();
        if (is_direct(word)) {
            obey_directly(word);
        } else {
            chart_.obey(cia402::recognise(chart_.state(), before, word), not has_cause_);
        }
        if (chart_.state() == cia402::state::operation_enabled) {
            is_stopped_by_key_ = false;
        }
        bool const is_reset = was_in_fault and not has_fault();
        fault_ = is_reset ? std::uint16_t{0} : fault_;
        return is_reset;
    }

    /// The drive itself takes the command back.
    constexpr void forget_command() noexcept { last_command_ = 0; }

    /// A fault by its LFT; false where the drive is in one already, which counts.
    constexpr bool trip(std::uint16_t code) noexcept
    {
        if (has_fault()) {
            return false;
        }
        fault_ = code;
        chart_.trip();
        return true;
    }

    /// While a fault has its cause, no reset ends it.
    constexpr void set_cause(bool is_there) noexcept { has_cause_ = is_there; }

    /// Somebody takes the command at the keypad, or gives it back.
    constexpr void set_local(bool is_local) noexcept
    {
        is_local_ = is_local;
        if (is_local) {
            chart_.fall_back();
        }
    }

    /// The STOP key: the drive falls back, and says so until it runs again.
    constexpr void press_stop() noexcept
    {
        is_stopped_by_key_ = true;
        chart_.fall_back();
    }

private:
    static constexpr std::uint16_t release_link = 0x0100; ///< CMD, with the bit of direct control
    static constexpr std::uint16_t ramp_stop = 0x1000;
    static constexpr std::uint16_t dc_stop = 0x2000;
    static constexpr std::uint16_t fast_stop = 0x4000;

    constexpr bool is_direct(std::uint16_t word) const noexcept
    {
        return (word & profile_->direct_control) != 0;
    }

    constexpr void obey_directly(std::uint16_t word) noexcept
    {
        constexpr std::uint16_t enabled = 0x000A;
        if ((word & release_link) != 0) {
            set_local(true);
        } else if ((word & enabled) == enabled) {
            chart_.enable_directly();
        } else {
            chart_.fall_back();
        }
    }

    altivar::drive_profile const* profile_;
    sim::chart chart_;
    std::uint16_t last_command_{0};
    std::uint16_t fault_{0};
    bool has_cause_{false};
    bool is_local_{false};
    bool is_stopped_by_key_{false};
};

} // namespace rtuwire::sim
