// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// Any registers of a device, read with the fewest requests that it allows. The compiler makes the plan: blocks of
// addresses, of which ask/poller.hpp makes the frames. Knows no frame.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include <rtuwire/core/version.hpp>
#include <rtuwire/table/device.hpp>
#include <rtuwire/table/request_plan.hpp>
#include <rtuwire/table/setting.hpp>
#include <rtuwire/table/table.hpp>

namespace rtuwire::inline RTUWIRE_BUILD {

/// The addresses of some registers, rising.
/// Internal.
template <auto const&... Registers> [[nodiscard]] constexpr auto rising_addresses() noexcept
{
    std::array<std::uint16_t, sizeof...(Registers)> addresses{Registers.address...};
    sort_addresses(addresses);
    return addresses;
}

/// The requests that read `Registers` of `Device`, and the type that stores the values.
template <device_type Device, auto const&... Registers> class read_plan {
    static_assert(sizeof...(Registers) > 0, "a plan reads at least one register");
    static_assert((has_register<Device, Registers> and ...), "a plan reads registers of one device only");
    static_assert((has_own_steps<Registers> and ...),
                  "another register sets this register's steps: name them with restepped");
    static_assert(first_duplicate(std::array{Registers.address...}).second == 0, "a plan reads each register once");

    static constexpr auto addresses = rising_addresses<Registers...>();
    static constexpr auto plan =
        plan_blocks<sizeof...(Registers)>(addresses, Device::limits.read, [](std::uint16_t lower, std::uint16_t upper) {
            return is_readable_across<Device>(lower, upper);
        });

public:
    using device = Device;

    static constexpr std::size_t register_count = sizeof...(Registers);
    static constexpr std::size_t request_count = plan.count;

    /// The requests, in the order of their addresses.
    static constexpr std::span<address_block const> requests() noexcept { return plan.view(); }

    template <auto const& R> static constexpr bool contains = (is_same_register<R, Registers> or ...);

    /// The values of one round of reading, in address order.
    class snapshot {
    public:
        /// The value of a register of the plan, 0 before the first round.
        template <auto const& R> [[nodiscard]] constexpr auto get() const noexcept
        {
            static_assert(contains<R>, "this register is not in the plan of this snapshot");
            return from_word<value_of<R>>(words_[place_of(R.address)]);
        }

        /// A value that fits the register's limits as they are now: those that depend on other registers are
        /// taken from this snapshot. Otherwise the reason, as `setting<R>::checked` has it.
        template <auto const& R, typename Value>
        [[nodiscard]] constexpr result<setting<R>> checked(Value value) const noexcept
        {
            static_assert(knows(R.min) and knows(R.max),
                          "the limits of this register hang on a register that is not in the plan");
            return setting<R>::checked(value, R.min.is_open() ? lowest<R>() : limit(R.min),
                                       R.max.is_open() ? highest<R>() : limit(R.max));
        }

        /// Stores the registers of the response to one request.
        template <typename Words> constexpr void store(std::size_t request, Words const& words) noexcept
        {
            address_block const block = plan.blocks[request];
            for (std::size_t i = 0; i < addresses.size(); ++i) {
                if (block.contains(addresses[i])) {
                    words_[i] = words[static_cast<std::size_t>(addresses[i] - block.start)];
                }
            }
        }

    private:
        static constexpr std::array<literal, register_count> codes{Registers.code...};

        static constexpr bool knows(bound const& limit) noexcept
        {
            return limit.is_number() or limit.is_open() or
                   (is_named(limit.code()) and (limit.factor().size() == 0 or is_named(limit.factor())));
        }

        static constexpr bool is_named(literal code) noexcept
        {
            for (literal const each : codes) {
                if (each == code) {
                    return true;
                }
            }
            return false;
        }

        constexpr std::int32_t limit(bound const& of) const noexcept
        {
            return of.with(raw_of(of.code()), of.factor().size() == 0 ? 1 : raw_of(of.factor()));
        }

        /// The raw count of a register of the plan; 0 for no mnemonic.
        constexpr std::int32_t raw_of(literal code) const noexcept
        {
            std::int32_t raw = 0;
            ((raw = Registers.code == code ? raw_count<value_of<Registers>>(words_[place_of(Registers.address)]) : raw),
             ...);
            return raw;
        }

        static constexpr std::size_t place_of(std::uint16_t address) noexcept
        {
            std::size_t place = 0;
            while (addresses[place] != address) {
                ++place;
            }
            return place;
        }

        std::array<std::uint16_t, register_count> words_{};
    };
};

} // namespace rtuwire
