// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// A drive's EEPROM and the orders of CMI that move settings to and fro.
#pragma once

#include <cstdint>

#include <rtuwire/altivar/profile.hpp>
#include <rtuwire/core/version.hpp>
#include <rtuwire/sim/image.hpp>
#include <rtuwire/sim/places.hpp>

namespace rtuwire::inline RTUWIRE_BUILD::sim {

/// What outlives the power.
template <device_type Device> class memory {
    using registers = image<Device>;

public:
    /// How often it was written; a real one takes 100 000 times.
    [[nodiscard]] constexpr std::uint32_t writes() const noexcept { return writes_; }

    /// Brings back what was saved last.
    constexpr void recall(registers& all) const noexcept { all.restore(saved_); }

    /// Executes the orders in a word of CMI, of a drive that stands; factory settings before saving before
    /// recalling.
    constexpr void execute(registers& all, std::uint16_t word) noexcept
    {
        constexpr places<Device> at{};
        constexpr std::uint16_t orders = factory_bit | altivar::save_bit | recall_bit;
        bool const clears_itself = not Device::profile.shows_eeprom_access;
        if ((word & factory_bit) != 0) {
            all.restore(registers::factory());
        } else if ((word & altivar::save_bit) != 0) {
            saved_ = all.all();
            ++writes_;
        } else if ((word & recall_bit) != 0 and clears_itself) {
            recall(all);
        }
        all.put(at.cmi, clears_itself ? word & ~orders : word);
    }

private:
    static constexpr std::uint16_t factory_bit = 0x0001;
    static constexpr std::uint16_t recall_bit = 0x0004; ///< ATV28

    typename registers::words saved_{registers::factory()};
    std::uint32_t writes_{0};
};

} // namespace rtuwire::sim
