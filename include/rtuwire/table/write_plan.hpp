// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// Any settings of a device, written with the fewest requests that it allows: neighbours go into one request,
// and only registers that were named are written.
// Internal: may change with any version.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include <rtuwire/core/version.hpp>
#include <rtuwire/table/device.hpp>
#include <rtuwire/table/read_plan.hpp>
#include <rtuwire/table/setting.hpp>

namespace rtuwire::inline RTUWIRE_BUILD {

/// The requests that write `Registers` of `Device`, and the words of their settings.
template <device_type Device, auto const&... Registers> class write_plan {
    static_assert(sizeof...(Registers) > 0, "a plan writes at least one register");
    static_assert((has_register<Device, Registers> and ...), "a plan writes registers of one device only");
    static_assert((has_own_steps<Registers> and ...),
                  "another register sets this register's steps: name them with restepped");
    static_assert(((Registers.mode != access::read_only) and ...), "this register is read-only");
    static_assert(first_duplicate(std::array{Registers.address...}).second == 0, "a plan writes each register once");

    static constexpr auto addresses = rising_addresses<Registers...>();
    static constexpr auto plan = plan_blocks<sizeof...(Registers)>(
        addresses, Device::limits.write, [](std::uint16_t lower, std::uint16_t upper) { return upper - lower == 1; });

public:
    using device = Device;
    static constexpr std::size_t register_count = sizeof...(Registers);
    static constexpr std::size_t request_count = plan.count;

    explicit constexpr write_plan(setting<Registers>... values) noexcept
    {
        (put(Registers.address, values.word()), ...);
    }

    /// The requests, in the order of their addresses.
    static constexpr std::span<address_block const> requests() noexcept { return plan.view(); }

    /// The words of one request, in address order.
    [[nodiscard]] constexpr std::span<std::uint16_t const> words(std::size_t request) const noexcept
    {
        std::size_t first = 0;
        while (addresses[first] != plan.blocks[request].start) {
            ++first;
        }
        return std::span{words_}.subspan(first, plan.blocks[request].count);
    }

private:
    constexpr void put(std::uint16_t address, std::uint16_t word) noexcept
    {
        for (std::size_t i = 0; i < addresses.size(); ++i) {
            if (addresses[i] == address) {
                words_[i] = word;
            }
        }
    }

    std::array<std::uint16_t, sizeof...(Registers)> words_{};
};

} // namespace rtuwire
