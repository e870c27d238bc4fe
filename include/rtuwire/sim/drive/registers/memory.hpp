// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// A drive's EEPROM and the orders of CMI that save and restore settings, which take time.
// Internal: may change with any version.
#pragma once

#include <cstdint>

#include <rtuwire/altivar/device/drive_layout.hpp>
#include <rtuwire/altivar/device/drive_type.hpp>
#include <rtuwire/core/time.hpp>
#include <rtuwire/core/version.hpp>
#include <rtuwire/sim/drive/registers/image.hpp>
#include <rtuwire/sim/drive/registers/register_index.hpp>

namespace rtuwire::inline RTUWIRE_BUILD::sim {

/// What is kept without power.
template <device_type Device> class memory {
    using registers = image<Device>;
    static constexpr register_index<Device> at{};

public:
    /// How often it was written; a real one takes 100 000 times.
    [[nodiscard]] constexpr std::uint32_t writes() const noexcept { return writes_; }

    /// Whether an order is being executed.
    [[nodiscard]] constexpr bool is_busy() const noexcept { return is_busy_; }

    constexpr void advance(instant now) noexcept { is_busy_ = is_busy_ and not reached(now, busy_until_); }

    /// Restores what was saved last.
    constexpr void recall(registers& all) const noexcept { all.restore(saved_); }

    /// Sets and saves the unit address, as at commissioning.
    constexpr void commission(registers& all, std::uint16_t address) noexcept
    {
        all.put(at.add, address);
        saved_ = all.all();
    }

    /// Sets the factory settings while the motor is at rest.
    constexpr void deliver(registers& all, instant now) noexcept
    {
        all.restore(registers::factory());
        is_busy_ = true;
        busy_until_ = now + behaviour.eeprom_work;
    }

    /// Executes the orders in a word of CMI while the motor is at rest; factory settings before saving before
    /// recalling.
    constexpr void execute(registers& all, std::uint16_t word, instant now) noexcept
    {
        std::uint32_t const ordered = word & orders;
        if ((ordered & factory_bit) != 0) {
            all.restore(registers::factory());
        } else if ((ordered & altivar::save_bit) != 0) {
            saved_ = all.all();
            ++writes_;
        } else if (ordered != 0) {
            recall(all);
        }
        if (ordered != 0) {
            is_busy_ = true;
            busy_until_ = now + behaviour.eeprom_work;
        }
        all.put(at.cmi, behaviour.clears_eeprom_orders ? word & ~orders : word);
    }

private:
    static constexpr std::uint16_t factory_bit = 0x0001;
    static constexpr std::uint16_t orders = Device::layout.cmi_orders;
    static constexpr altivar::simulated_behaviour const& behaviour = altivar::behaviour_of<Device>;

    typename registers::words saved_{registers::commissioned()};
    instant busy_until_{0};
    std::uint32_t writes_{0};
    bool is_busy_{false};
};

} // namespace rtuwire::sim
