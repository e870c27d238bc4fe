// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// The registers of a whole device as words: found by address for the line, by mnemonic for the model. Checks the
// values that each may hold, including limits that depend on other registers.
// Internal: may change with any version.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include <rtuwire/altivar/device/cycle_registers.hpp>
#include <rtuwire/altivar/device/drive_type.hpp>
#include <rtuwire/core/literal.hpp>
#include <rtuwire/core/version.hpp>
#include <rtuwire/sim/drive/registers/register_rule.hpp>
#include <rtuwire/sim/drive/registers/row_rules.hpp>
#include <rtuwire/table/device.hpp>
#include <rtuwire/table/enumeration.hpp>
#include <rtuwire/table/key_index.hpp>
#include <rtuwire/table/register.hpp>
#include <rtuwire/wire/errc.hpp>

namespace rtuwire::inline RTUWIRE_BUILD::sim {

/// The words of all registers of a device, initially as commissioned.
template <device_type Device> class image {
    using rules = rules_of<typename Device::registers>;
    static constexpr key_index<literal, rules::count> by_code{rules::codes};
    static constexpr key_index<std::uint16_t, rules::count> by_address{rules::addresses};

public:
    /// The place of no register. A word stored there is lost, and it reads 0.
    static constexpr std::size_t nowhere = rules::count;

    using words = std::array<std::uint16_t, rules::count>;

    [[nodiscard]] static constexpr std::size_t at(literal code) noexcept { return by_code.find(code); }
    [[nodiscard]] static constexpr std::size_t at_address(std::size_t address) noexcept
    {
        return address > 0xFFFF ? nowhere : by_address.find(static_cast<std::uint16_t>(address));
    }
    [[nodiscard]] static constexpr register_rule const& rule(std::size_t place) noexcept { return rules::list[place]; }

    [[nodiscard]] constexpr std::uint16_t get(std::size_t place) const noexcept
    {
        return place == nowhere ? std::uint16_t{0} : words_[place];
    }
    [[nodiscard]] constexpr std::int32_t get_signed(std::size_t place) const noexcept
    {
        return static_cast<std::int16_t>(get(place));
    }

    [[nodiscard]] static constexpr bool is_signed(std::size_t place) noexcept
    {
        return place != nowhere and rule(place).is_signed;
    }

    /// How many steps of a register make one whole unit.
    [[nodiscard]] static constexpr std::int32_t scale(std::size_t place) noexcept
    {
        return place == nowhere ? 1 : rule(place).steps_per_unit;
    }

    /// Stores a word as received over the line.
    constexpr void put_word(std::size_t place, std::uint16_t word) noexcept
    {
        put(place, is_signed(place) ? static_cast<std::int16_t>(word) : std::int32_t{word});
    }

    /// Stores a value, limited to the range of a word.
    constexpr void put(std::size_t place, std::int64_t value) noexcept
    {
        if (place == nowhere) {
            return;
        }
        std::int64_t const least = is_signed(place) ? -32'768 : 0;
        std::int64_t const most = is_signed(place) ? 0x7FFF : 0xFFFF;
        std::int64_t const cut = value < least ? least : value > most ? most : value;
        words_[place] = static_cast<std::uint16_t>(cut);
    }

    /// Whether a register accepts a word; `illegal_data_value` outside its limits, or without a meaning.
    [[nodiscard]] constexpr errc check(std::size_t place, std::uint16_t word) const noexcept
    {
        register_rule const& known = rule(place);
        std::int32_t const raw = known.is_signed ? std::int32_t{static_cast<std::int16_t>(word)} : std::int32_t{word};
        bool const is_inside =
            (known.min.is_open() or raw >= limit(known.min)) and (known.max.is_open() or raw <= limit(known.max));
        bool const is_right = is_inside and not known.gap.contains(raw) and has_meaning(known.listed, word);
        return is_right ? errc::none : errc::illegal_data_value;
    }

    [[nodiscard]] constexpr words const& all() const noexcept { return words_; }

    /// Sets every setting that a client may write to its value in `saved`.
    constexpr void restore(words const& saved) noexcept
    {
        for (std::size_t i = 0; i < rules::count; ++i) {
            if (rule(i).mode != access::read_only and not is_order(i)) {
                words_[i] = saved[i];
            }
        }
    }

    /// The words as delivered.
    [[nodiscard]] static constexpr words factory() noexcept
    {
        words all{};
        for (std::size_t i = 0; i < rules::count; ++i) {
            all[i] = rule(i).factory;
        }
        map_scanner(all);
        return all;
    }

    /// The words of a drive that was commissioned.
    [[nodiscard]] static constexpr words commissioned() noexcept
    {
        words all{};
        for (std::size_t i = 0; i < rules::count; ++i) {
            all[i] = rule(i).commissioned;
        }
        map_scanner(all);
        return all;
    }

private:
    /// No setting: by its mnemonic, or an output word of the scanner.
    static constexpr bool is_order(std::size_t place) noexcept
    {
        bool is_output = false;
        if constexpr (altivar::has_all_parts<Device>) {
            is_output = Device::scanner.is_output(rules::addresses[place]);
        }
        return is_output or rule(place).is_order;
    }

    /// A scanner stands, as delivered, for the registers of the cycle.
    static constexpr void map_scanner(words& all) noexcept
    {
        if constexpr (altivar::has_all_parts<Device>) {
            if (Device::cycle.by_scanner) {
                map(all, Device::scanner.input_addresses, Device::cycle.reads);
                map(all, Device::scanner.output_addresses, Device::cycle.writes);
            }
        }
    }
    static constexpr void map(words& all, std::uint16_t first, altivar::cycle_addresses const& list) noexcept
    {
        for (std::size_t i = 0; i < list.size(); ++i) {
            all[at_address(first + i)] = list[i];
        }
    }

    constexpr std::int32_t limit(bound const& of) const noexcept
    {
        std::int32_t const factor = of.factor().size() == 0 ? 1 : std::int32_t{get(at(of.factor()))};
        return of.with(get(at(of.code())), factor);
    }

    words words_{commissioned()};
};

} // namespace rtuwire::sim
