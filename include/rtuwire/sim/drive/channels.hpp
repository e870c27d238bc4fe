// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// The channels from which a drive takes its commands and its reference, by its settings and its logic inputs.
// Internal: may change with any version.
#pragma once

#include <cstddef>
#include <cstdint>

#include <rtuwire/core/version.hpp>
#include <rtuwire/sim/drive/registers/image.hpp>
#include <rtuwire/sim/drive/registers/register_index.hpp>

namespace rtuwire::inline RTUWIRE_BUILD::sim {

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

/// A view of the channel settings in an image, which outlives it.
template <device_type Device> class channels {
    static constexpr register_index<Device> at{};

public:
    explicit constexpr channels(image<Device> const& its_registers) noexcept : registers_{its_registers} {}

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

} // namespace rtuwire::sim
