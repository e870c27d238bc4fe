// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// Any registers of a device, read with the fewest requests that it allows. The compiler makes the plan: blocks of
// addresses, of which ask/poller.hpp makes the frames. Knows no frame. A register of several words is read by one
// request, and so are registers that are named `together`.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <type_traits>

#include <rtuwire/core/version.hpp>
#include <rtuwire/table/device.hpp>
#include <rtuwire/table/form/form.hpp>
#include <rtuwire/table/key_index.hpp>
#include <rtuwire/table/plan_words.hpp>
#include <rtuwire/table/request_plan.hpp>
#include <rtuwire/table/setting.hpp>
#include <rtuwire/table/table.hpp>

namespace rtuwire {
inline namespace RTUWIRE_BUILD {

/// In a plan, instead of registers one by one: registers whose values have to be of one moment, so that one request
/// reads them: `read_plan<device, together<power, power_factor>, energy>`.
template <auto const&... Registers> inline constexpr detail::kept_together<Registers...> together{};

namespace detail {

/// Which words a plan reads, by which requests: of holding registers of one word each, of which none has to stay with
/// another, as drives have them.
template <typename Device, auto const&... Registers> struct plain_layout {
    static constexpr bool is_of_one_space = true;
    static constexpr auto addresses = rising_addresses<Registers...>();
    static constexpr auto blocks = [rising = addresses] {
        return plan_blocks<sizeof...(Registers)>(rising, Device::limits.read,
                                                 [](std::uint16_t lower, std::uint16_t upper) {
                                                     return is_crossed<Device>(lower, upper, register_space::holding);
                                                 });
    }();

    static constexpr register_space space_of(std::size_t) noexcept { return register_space::holding; }
    static constexpr register_space space_at(std::size_t) noexcept { return register_space::holding; }
};

/// Of any registers, among which the items may keep some together.
template <typename Device, auto const&... Items> struct any_layout {
    template <auto const&... Registers> struct of;
};
template <typename Device, auto const&... Items>
template <auto const&... Registers>
struct any_layout<Device, Items...>::of {
    static_assert(are_all<range_of<Registers>().is_of_one_space()...>, "a scale is a register of the same kind");
    static_assert(are_all<range_of(typename registers_named<Items>::type{}).is_of_one_space()...>,
                  "no request reads registers of two kinds: these cannot be kept together");

private:
    static constexpr auto words = rising_words<Registers...>();
    static constexpr std::array<key_range, sizeof...(Registers) + sizeof...(Items)> ranges{
        range_of<Registers>()..., range_of(typename registers_named<Items>::type{})...};
    static constexpr auto plan = [read = words, uncut = ranges] {
        return plan_spaces<Device, words.count>(read, uncut);
    }();
    static_assert(plan.blocks.count > 0,
                  "a register with all its words, or registers kept together, do not fit one request of this device");

public:
    static constexpr bool is_of_one_space = plan.spaces[0] == plan.spaces[words.count - 1];
    static constexpr auto addresses = plan.addresses;
    static constexpr auto blocks = plan.blocks;

    static constexpr register_space space_of(std::size_t request) noexcept { return plan.block_spaces[request]; }
    static constexpr register_space space_at(std::size_t place) noexcept { return plan.spaces[place]; }
};

} // namespace detail

/// The requests that read registers of `Device`, and the type that stores the values. `Items` are registers, of all four
/// kinds, and groups of them that are read `together`.
template <device_type Device, auto const&... Items> class read_plan {
    static constexpr bool is_any_group = detail::is_any<detail::registers_named<Items>::is_group...>;
    using registers = typename detail::all_named<is_any_group, Items...>::type;
    using facts = typename registers::template apply<detail::facts_of>;

    static_assert(sizeof...(Items) > 0, "a plan reads at least one register");
    static_assert(facts::template are_of<Device>, "a plan reads registers of one device only");
    static_assert(facts::template have_scales<Device>, "this device lacks the register that holds the scale");
    static_assert(facts::have_readable_steps, "another register sets this register's steps: name them with restepped");
    static_assert(facts::are_different, "a plan reads each register once");

    using layout =
        std::conditional_t<is_any_group,
                           typename registers::template apply<detail::any_layout<Device, Items...>::template of>,
                           std::conditional_t<registers::is_plain, detail::plain_layout<Device, Items...>,
                                              typename detail::any_layout<Device>::template of<Items...>>>;
    static constexpr auto addresses = layout::addresses;
    static constexpr auto plan = layout::blocks;

    /// Finds the place of a word by its address and its kind.
    static constexpr detail::key_index<std::uint32_t, addresses.size()> word_places{[] {
        std::array<std::uint32_t, addresses.size()> keys{};
        for (std::size_t i = 0; i < keys.size(); ++i) {
            keys[i] = detail::key_of(layout::space_at(i), addresses[i]);
        }
        return keys;
    }()};

public:
    using device = Device;

    static constexpr std::size_t register_count = registers::size;
    static constexpr std::size_t request_count = plan.count;

    /// Whether function 03 reads all of them.
    /// Internal.
    static constexpr bool is_plain = layout::is_of_one_space and layout::space_of(0) == register_space::holding;

    /// The requests, by kind of register and in the order of their addresses.
    static constexpr std::span<detail::address_block const> requests() noexcept { return plan.view(); }

    /// Which kind of registers a request reads.
    /// Internal.
    static constexpr register_space space_of(std::size_t request) noexcept { return layout::space_of(request); }

    template <auto const& R> static constexpr bool contains = facts::template contain<R>;

    /// The values of one round of reading, in address order.
    class snapshot {
    public:
        /// The value of a register of the plan, 0 before the first round. Of a register whose words may be no value (a
        /// floating point number, `known` enumerators, a scaled count) it is a result.
        template <auto const& R> [[nodiscard]] constexpr auto get() const noexcept
        {
            static_assert(contains<R>, "this register is not in the plan of this snapshot");
            constexpr std::size_t place = place_of<R>();
            if constexpr (R.is_plain) {
                return detail::from_word<value_of<R>>(words_[place]);
            } else if constexpr (detail::is_always_a_value<R>) {
                return *detail::value_in<R>(words_, place, place);
            } else {
                return detail::value_in<R>(words_, place, scale_place_of<R>());
            }
        }

        /// A value that fits the register's limits as they are now: those that depend on other registers are
        /// taken from this snapshot. Otherwise the reason, as `setting<R>::checked` has it.
        template <auto const& R, typename Value>
        [[nodiscard]] constexpr result<setting<R>> checked(Value value) const noexcept
        {
            static_assert(knows(R.min) and knows(R.max),
                          "the limits of this register hang on a register that is not in the plan");
            if constexpr (detail::register_value<value_of<R>>) {
                constexpr raw_limit low = limit_of(R.min);
                constexpr raw_limit high = limit_of(R.max);
                return setting<R>::checked(value, R.min.is_open() ? lowest<R>() : limit(R.min, low),
                                           R.max.is_open() ? highest<R>() : limit(R.max, high));
            } else {
                static_assert((R.min.is_number() or R.min.is_open()) and (R.max.is_number() or R.max.is_open()),
                              "the limits of a register of several words are numbers");
                return setting<R>::checked(value);
            }
        }

        /// Stores the registers of the response to one request.
        template <typename Words> constexpr void store(std::size_t request, Words const& words) noexcept
        {
            detail::address_block const block = plan.blocks[request];
            for (std::size_t i = 0; i < addresses.size(); ++i) {
                if (block.contains(addresses[i]) and
                    (layout::is_of_one_space or layout::space_of(request) == layout::space_at(i))) {
                    words_[i] = words[static_cast<std::size_t>(addresses[i] - block.start)];
                }
            }
        }

    private:
        static constexpr bool knows(bound const& limit) noexcept
        {
            return limit.is_number() or limit.is_open() or
                   (facts::has_code(limit.code()) and (limit.factor().size() == 0 or facts::has_code(limit.factor())));
        }

        /// The registers that a limit hangs on, and the places of their words.
        struct raw_limit {
            detail::raw_place share;
            detail::raw_place factor;
            std::size_t share_at{word_places.find(share.key)};
            std::size_t factor_at{word_places.find(factor.key)};
        };
        static constexpr raw_limit limit_of(bound const& limit) noexcept
        {
            return {facts::raw_called(limit.code()), facts::raw_called(limit.factor())};
        }

        constexpr std::int32_t limit(bound const& of, raw_limit const& by) const noexcept
        {
            return of.with(raw(by.share, by.share_at), of.factor().size() == 0 ? 1 : raw(by.factor, by.factor_at));
        }

        /// The raw count of a register of the plan; 0 for none, and for a register of several words.
        constexpr std::int32_t raw(detail::raw_place const& of, std::size_t at) const noexcept
        {
            if (not of.is_known) {
                return 0;
            }
            return of.is_signed ? std::int32_t{static_cast<std::int16_t>(words_[at])} : std::int32_t{words_[at]};
        }

        template <auto const& R> static constexpr std::size_t place_of() noexcept
        {
            return word_places.find(detail::key_of(R.space, R.address));
        }
        template <auto const& R> static constexpr std::size_t scale_place_of() noexcept
        {
            if constexpr (detail::has_scale_register<R>) {
                return place_of<std::remove_cvref_t<decltype(R)>::form::scale_register>();
            } else {
                return 0;
            }
        }

        std::array<std::uint16_t, addresses.size()> words_{};
    };
};

} // namespace RTUWIRE_BUILD
} // namespace rtuwire
