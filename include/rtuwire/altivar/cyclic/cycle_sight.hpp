// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// What a cycle has read of its drive: the last status, how often the motor stood, and what happened since that read.
// Internal: may change with any version.
#pragma once

#include <cstdint>
#include <utility>

#include <rtuwire/altivar/device/drive_layout.hpp>
#include <rtuwire/altivar/procedure/procedure.hpp>
#include <rtuwire/ask/commander.hpp>
#include <rtuwire/cia402/state.hpp>
#include <rtuwire/core/version.hpp>

namespace rtuwire {
inline namespace RTUWIRE_BUILD {
namespace altivar {

/// The drive as it was read last.
class cycle_sight {
public:
    /// Takes a status word, and whether the motor is at rest.
    constexpr void take(std::uint16_t status, bool stands) noexcept
    {
        bool const was_in_fault = cia402::is_in_fault(state_);
        status_ = status;
        state_ = cia402::decode(status);
        has_read_fault_ = has_read_fault_ or (cia402::is_in_fault(state_) and not was_in_fault);
        is_known_ = true;
        has_enabled_ = false;
        looks_at_rest_ = not stands           ? std::uint8_t{0}
                         : looks_at_rest_ < 2 ? static_cast<std::uint8_t>(looks_at_rest_ + 1)
                                              : looks_at_rest_;
        power_seen_ = power_in(state_);
    }

    /// The link was lost; `may_run`: the drive may have been running.
    constexpr void lose(bool may_run) noexcept
    {
        was_lost_running_ = may_run;
        is_known_ = false;
        looks_at_rest_ = 0;
        state_ = cia402::state::unknown;
    }

    /// The drive has to be read before an order.
    constexpr void forget() noexcept { is_known_ = false; }

    /// The command to run was given, or was not.
    constexpr void note_command(bool enables) noexcept { has_enabled_ = has_enabled_ or enables; }

    /// What a read found of the motor's power, and whether it found the drive newly in fault; each reported once.
    constexpr detail::power_seen take_power() noexcept
    {
        return std::exchange(power_seen_, detail::power_seen::nothing);
    }
    constexpr bool take_fault() noexcept { return std::exchange(has_read_fault_, false); }

    [[nodiscard]] constexpr std::uint16_t status() const noexcept { return status_; }
    [[nodiscard]] constexpr cia402::state state() const noexcept { return state_; }
    [[nodiscard]] constexpr bool is_in_fault() const noexcept { return cia402::is_in_fault(state_); }
    [[nodiscard]] constexpr bool is_remote() const noexcept { return (status_ & remote_bit) != 0; }
    [[nodiscard]] constexpr bool shows_stop_key() const noexcept { return (status_ & stop_key_bit) != 0; }
    [[nodiscard]] constexpr bool is_known() const noexcept { return is_known_; }
    [[nodiscard]] constexpr bool has_enabled() const noexcept { return has_enabled_; }
    [[nodiscard]] constexpr bool was_lost_running() const noexcept { return was_lost_running_; }

    /// Whether the motor stood at the last two reads.
    [[nodiscard]] constexpr bool stands() const noexcept { return looks_at_rest_ >= 2; }

    /// Whether the drive takes an order: known, under remote control, and neither in fault nor in a quick stop.
    [[nodiscard]] constexpr bool is_able() const noexcept
    {
        return is_known_ and state_ != cia402::state::unknown and state_ != cia402::state::quick_stop_active and
               not is_in_fault() and is_remote();
    }

    /// Whether the motor may turn: with power, in a state that nobody knows, or enabled since the last read.
    [[nodiscard]] constexpr bool may_turn() const noexcept
    {
        bool const has_power = state_ == cia402::state::operation_enabled or
                               state_ == cia402::state::quick_stop_active or
                               (state_ == cia402::state::unknown and is_known_);
        return has_power or has_enabled_;
    }

private:
    std::uint16_t status_{0};
    cia402::state state_{cia402::state::unknown};
    std::uint8_t looks_at_rest_{0}; ///< in a row, up to 2
    bool is_known_{false};
    bool was_lost_running_{false}; ///< it may have been running at the last loss
    bool has_enabled_{false};      ///< the command to run was given since the state was read
    detail::power_seen power_seen_{detail::power_seen::nothing};
    bool has_read_fault_{false};
};

} // namespace altivar
} // namespace RTUWIRE_BUILD
} // namespace rtuwire
