// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// What a drive keeps: its settings, in an EEPROM; its last faults, in registers, beside those that show the present one.
// Apart from the drive for the tables of faults, and for what takes time in an EEPROM alone.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include <rtuwire/altivar/device/drive_layout.hpp>
#include <rtuwire/altivar/device/drive_type.hpp>
#include <rtuwire/core/literal.hpp>
#include <rtuwire/core/time.hpp>
#include <rtuwire/core/version.hpp>
#include <rtuwire/sim/drive/image.hpp>

namespace rtuwire {
inline namespace RTUWIRE_BUILD {
namespace detail {

/// The EEPROM: what is kept without power, and the orders of CMI that save and restore it, which take time.
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
        begin_work(now);
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
            begin_work(now);
        }
        all.put(at.cmi, behaviour.clears_eeprom_orders ? word & ~orders : word);
    }

private:
    static constexpr std::uint16_t factory_bit = 0x0001;
    static constexpr std::uint16_t orders = Device::layout.cmi_orders;
    static constexpr altivar::simulated_behaviour const& behaviour = altivar::behaviour_of<Device>;

    constexpr void begin_work(instant now) noexcept
    {
        is_busy_ = true;
        busy_until_ = now + behaviour.eeprom_work;
    }

    typename registers::words saved_{registers::commissioned()};
    instant busy_until_{0};
    std::uint32_t writes_{0};
    bool is_busy_{false};
};

} // namespace detail

namespace sim {

/// LFT of a lost serial link, on every Altivar.
inline constexpr std::uint16_t link_fault = 5;

} // namespace sim

namespace detail {

/// One fault: its LFT, its number in the drive profile (ERRD), its bit in DF1 or DF2 where a
/// drive has them.
struct fault_form {
    std::uint16_t code;
    std::uint16_t profile;
    std::uint16_t df1;
    std::uint16_t df2;
};

/// As the bulletin of the drive with ERRD lists them; SCF and tnF have no number of their own there.
inline constexpr std::array<fault_form, 13> fault_forms{{
    {1, 0x6100, 0x0001, 0x0000},
    {2, 0x5520, 0x0008, 0x0000},
    {5, 0x7510, 0x0100, 0x0000},
    {9, 0x2310, 0x0000, 0x0008},
    {16, 0x4210, 0x0000, 0x0080},
    {17, 0x1000, 0x0000, 0x0100},
    {18, 0x3310, 0x0000, 0x0400},
    {19, 0x3110, 0x0000, 0x0800},
    {20, 0x3310, 0x0000, 0x1000},
    {21, 0x3130, 0x0000, 0x2000},
    {22, 0x3120, 0x0000, 0x4000},
    {23, 0x1000, 0x2000, 0x0000},
    {25, 0x1000, 0x0000, 0x0000},
}};

/// The entry for a fault by its LFT: a generic error for one that the list does not have, an empty one for 0.
[[nodiscard]] constexpr fault_form fault_form_of(std::uint16_t code) noexcept
{
    for (fault_form const& each : fault_forms) {
        if (each.code == code) {
            return each;
        }
    }
    constexpr std::uint16_t generic = 0x1000;
    return {code, code == 0 ? std::uint16_t{0} : generic, 0, 0};
}

/// A register that shows a value, and the first of those that keep it as it was at the last faults, the most recent first.
struct kept_value {
    std::uint16_t first;
    literal source;
};

/// As the public lists of ATV12 and ATV320 name them; an ATV12 has fewer, and none of the moment of the most recent fault but
/// its state.
inline constexpr std::array<kept_value, 12> kept_values{{
    {7210, "ETA"},
    {7220, "ETI"},
    {7230, "CMD"},
    {7240, "LCR"},
    {7250, "RFR"},
    {7260, "RTH"},
    {7270, "ULN"},
    {7280, "THR"},
    {7320, "HMIS"},
    {7330, "OTR"},
    {7340, "THD"},
    {7360, "SFR"},
}};

/// The registers that keep a drive's last faults, each with its moment.
template <device_type Device> class fault_record {
    using registers = image<Device>;
    static constexpr std::size_t nowhere = registers::nowhere;

public:
    /// Records a fault by its LFT, before the other registers show it: as the last one, as the first of the record, and by
    /// its CiA 402 code.
    constexpr void add(registers& all, std::uint16_t code) noexcept
    {
        constexpr std::size_t dp0 = registers::at("DP0"), dp1 = registers::at("DP1"), count = registers::at("FNB");
        constexpr std::array<std::size_t, 9> codes{dp0 == nowhere ? dp1 : dp0, dp1,
                                                   registers::at("DP2"),       registers::at("DP3"),
                                                   registers::at("DP4"),       registers::at("DP5"),
                                                   registers::at("DP6"),       registers::at("DP7"),
                                                   registers::at("DP8")};
        for (std::size_t i = codes.size() - 1; i > 0; --i) {
            all.put(codes[i], all.get(codes[i - 1]));
        }
        all.put(codes[0], code);
        all.put(count, std::int64_t{all.get(count)} + 1);
        all.put(register_index<Device>{}.lft, code);
        all.put(registers::at("ERRD"), fault_form_of(code).profile);
        if constexpr (is_whole<Device>) {
            keep_moment(all);
        }
    }

private:
    static constexpr std::size_t before = 8; ///< faults before the most recent one
    static constexpr std::size_t values = is_whole<Device> ? kept_values.size() : 0;

    static constexpr std::size_t place(std::size_t value, std::size_t back) noexcept
    {
        return registers::at_address(kept_values[value].first + back);
    }

    constexpr void keep_moment(registers& all) noexcept
    {
        for (std::size_t i = 0; i < values; ++i) {
            for (std::size_t back = before; back > 1; --back) {
                all.put_word(place(i, back), all.get(place(i, back - 1)));
            }
            all.put_word(place(i, 1), latest_[i]);
            latest_[i] = static_cast<std::uint16_t>(shown(all, i));
            all.put_word(place(i, 0), latest_[i]);
        }
    }

    /// In the steps of the register that keeps it.
    static constexpr std::int64_t shown(registers const& all, std::size_t value) noexcept
    {
        constexpr std::int64_t hertz_a_step = 100; // of SFR
        std::size_t const source = registers::at(kept_values[value].source);
        std::size_t const kept = place(value, place(value, 0) == nowhere ? 1 : 0);
        std::int64_t const word = registers::is_signed(source) ? all.get_signed(source) : std::int32_t{all.get(source)};
        if (source == registers::at("SFR")) {
            return word * hertz_a_step;
        }
        bool const is_short = source == register_index<Device>{}.eta and registers::at("IP0") == nowhere;
        return is_short ? short_state(all) : word * registers::scale(kept) / registers::scale(source);
    }

    /// The bits of ETA and ETI in one word, as an ATV12 keeps them; its bit 3 is that of local control, 0 where it is in force.
    static constexpr std::int64_t short_state(registers const& all) noexcept
    {
        constexpr register_index<Device> at{};
        unsigned const status = all.get(at.eta);
        unsigned const extended = all.get(at.eti);
        constexpr unsigned same_place = 0xFE80; // 7 and 9 to 15
        return (status >> 1U & 1U) | (status >> 5U & 1U) << 1U | (status >> 6U & 1U) << 2U | (status >> 9U & 1U) << 3U |
               (status >> 15U & 1U) << 4U | (extended >> 4U & 3U) << 5U | (extended & same_place);
    }

    std::array<std::uint16_t, values> latest_{};
};

/// Shows the present fault; 0 for none.
template <device_type Device> constexpr void show_active_fault(image<Device>& registers, std::uint16_t code) noexcept
{
    fault_form const form = fault_form_of(code);
    registers.put(image<Device>::at("DF1"), form.df1);
    registers.put(image<Device>::at("DF2"), form.df2);
}

} // namespace detail
} // namespace RTUWIRE_BUILD
} // namespace rtuwire
