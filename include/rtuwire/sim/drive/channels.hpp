// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// The channels from which a drive takes its commands: its link, which it supervises, its logic inputs, its keypad. Knows
// no registers.
#pragma once

#include <cstddef>
#include <cstdint>

#include <rtuwire/core/time.hpp>
#include <rtuwire/core/version.hpp>

namespace rtuwire {
inline namespace RTUWIRE_BUILD {
namespace detail {

/// The logic inputs of a drive, LI1 first.
class logic_inputs {
public:
    constexpr void set(std::size_t number, bool is_closed) noexcept
    {
        std::uint32_t const bit = number == 0 or number > 16 ? 0U : 1U << (number - 1);
        closed_ = is_closed ? closed_ | bit : closed_ & ~bit;
    }
    [[nodiscard]] constexpr bool is_closed(std::size_t number) const noexcept
    {
        return number > 0 and number <= 16 and ((closed_ >> (number - 1)) & 1U) != 0;
    }

    /// The closed inputs as bits, LI1 in bit 0.
    [[nodiscard]] constexpr std::uint16_t image() const noexcept { return static_cast<std::uint16_t>(closed_); }

private:
    std::uint32_t closed_{0};
};

/// Which channel commands, and how.
struct channel_choice {
    bool is_link{true};          ///< the settings give the command to Modbus
    bool is_forced_local{false}; ///< an input takes it away
    bool is_io_profile{false};   ///< bit 0 of the command word is RUN
    bool is_run_closed{false};   ///< the terminals command to run: LI1, two wires, by level
};

/// Who commands the drive: the link by the settings, unless a key or an input takes the command away, or the link has
/// given it to the terminals.
class command_source {
public:
    constexpr void choose(channel_choice const& now) noexcept { choice_ = now; }
    [[nodiscard]] constexpr channel_choice const& choice() const noexcept { return choice_; }

    /// Whether the settings give the command to the link, and nothing at the drive takes it away.
    [[nodiscard]] constexpr bool may_be_link() const noexcept { return choice_.is_link and not is_forced_local(); }

    /// Whether the link commands.
    [[nodiscard]] constexpr bool is_link() const noexcept { return may_be_link() and not is_released_; }

    /// Whether a key or an input at the drive has taken the command from Modbus.
    [[nodiscard]] constexpr bool is_forced_local() const noexcept { return is_at_keypad_ or choice_.is_forced_local; }
    [[nodiscard]] constexpr bool is_at_keypad() const noexcept { return is_at_keypad_; }
    constexpr void set_at_keypad(bool is_at_keypad) noexcept { is_at_keypad_ = is_at_keypad; }

    /// The link gives the control to the terminals, or takes it back; returns whether that changed it.
    constexpr bool set_released(bool is_released) noexcept
    {
        bool const is_new = is_released_ != is_released;
        is_released_ = is_released;
        return is_new;
    }

private:
    channel_choice choice_{};
    bool is_at_keypad_{false};
    bool is_released_{false};
};

/// How a drive supervises its serial link: after the first request, each next one must come within the time-out.
class link_watchdog {
public:
    /// A request has come.
    constexpr void note_contact(instant now) noexcept
    {
        back_at_ = has_lost_ ? now : back_at_;
        has_lost_ = false;
        is_armed_ = true;
        last_ = now;
    }

    /// Whether the link was lost, and no request has come since.
    [[nodiscard]] constexpr bool has_lost() const noexcept { return has_lost_; }

    /// Whether requests have come again for a second: a drive that restarts by itself waits so long.
    [[nodiscard]] constexpr bool is_back(instant now) const noexcept
    {
        return not has_lost_ and now - back_at_ >= milliseconds(1'000);
    }

    /// Whether the time-out has passed since the last request, reported once; a time-out of 0 never passes.
    [[nodiscard]] constexpr bool is_lost(instant now, duration time_out) noexcept
    {
        bool const is_over =
            is_armed_ and time_out.microseconds != 0 and (now - last_).microseconds >= time_out.microseconds;
        if (is_over) {
            is_armed_ = false;
            has_lost_ = true;
        }
        return is_over;
    }

private:
    instant last_{0};
    instant back_at_{0};
    bool has_lost_{false};
    bool is_armed_{false};
};

} // namespace detail
} // namespace RTUWIRE_BUILD
} // namespace rtuwire
