// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// Any registers of a device, read with the fewest requests that it allows. The compiler makes the plan: blocks of
// addresses, of which ask/poller.hpp makes the frames. Knows no frame. A register of several words is read by one
// request with that of its scale, and so are registers that are named `together`: no value is ever put together from two
// moments.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <type_traits>

#include <rtuwire/core/version.hpp>
#include <rtuwire/table/device.hpp>
#include <rtuwire/table/form/form.hpp>
#include <rtuwire/table/register.hpp>
#include <rtuwire/table/request_plan.hpp>
#include <rtuwire/table/setting.hpp>
#include <rtuwire/table/table.hpp>

namespace rtuwire {
inline namespace RTUWIRE_BUILD {

namespace detail {

/// Some registers, as a type. What is made of them is made by `apply`: GCC takes half
/// a minute to find out by itself which thousand registers a list has.
template <auto const&... Registers> struct register_list {
    static constexpr std::size_t size = sizeof...(Registers);
    static constexpr bool is_plain = are_all<Registers.is_plain...>;

    template <template <auto const&...> typename Template> using apply = Template<Registers...>;
    template <auto const&... Front> using behind = register_list<Front..., Registers...>;
    template <typename Other> using followed_by = typename Other::template behind<Registers...>;
};

/// Registers that a plan reads by one request; see `together`.
template <auto const&... Registers> struct kept_together : register_list<Registers...> {
    static_assert(sizeof...(Registers) > 1, "together names at least two registers");
};

/// The registers that an argument of a plan names.
template <auto const& Item, typename Kind = std::remove_cvref_t<decltype(Item)>> struct registers_named {
    using type = register_list<Item>;
    static constexpr bool is_group = false;
};
template <auto const& Item, auto const&... Registers> struct registers_named<Item, kept_together<Registers...>> {
    using type = register_list<Registers...>;
    static constexpr bool is_group = true;
};

/// Lists one behind the other; eight at a time, because each step names all registers so far.
template <typename... Lists> struct joined_lists;
template <typename List> struct joined_lists<List> {
    using type = List;
};
template <typename First, typename Second, typename... Others>
struct joined_lists<First, Second, Others...> : joined_lists<typename First::template followed_by<Second>, Others...> {
};
template <typename First, typename L1, typename L2, typename L3, typename L4, typename L5, typename L6, typename L7,
          typename L8, typename... Others>
struct joined_lists<First, L1, L2, L3, L4, L5, L6, L7, L8, Others...>
    : joined_lists<typename First::template followed_by<typename joined_lists<L1, L2, L3, L4, L5, L6, L7, L8>::type>,
                   Others...> {};

/// All registers that a plan's arguments name. Named in one list where none of them is a group.
template <bool IsAnyGroup, auto const&... Items> struct all_named {
    using type = register_list<Items...>;
};
template <auto const&... Items> struct all_named<true, Items...> {
    using type = typename joined_lists<register_list<>, typename registers_named<Items>::type...>::type;
};

/// The raw count of a register: at which address, where it has one. One of several words has none.
struct raw_place {
    std::uint32_t key{0};
    bool is_known{false};
    bool is_signed{false};
};
template <auto const& R> [[nodiscard]] constexpr raw_place raw_place_of() noexcept
{
    raw_place place{key_of(R.space, R.address)};
    if constexpr (register_value<value_of<R>>) {
        place.is_known = true;
        place.is_signed = raw_count<value_of<R>>(0xFFFF) < 0;
    }
    return place;
}

/// What a plan has to know of all its registers.
template <auto const&... Registers> struct facts_of {
private:
    static constexpr std::size_t count = sizeof...(Registers);
    static constexpr std::array<std::uint32_t, count> keys{key_of(Registers.space, Registers.address)...};
    static constexpr key_index<std::uint32_t, count> by_key{keys};
    static constexpr std::array<void const*, count> places{&Registers...};
    static constexpr std::array<literal, count> codes{Registers.code...};

    static constexpr std::size_t named(literal code) noexcept
    {
        std::size_t at = 0;
        while (at < count and not(codes[at] == code)) {
            ++at;
        }
        return at;
    }

public:
    template <typename Device> static constexpr bool are_of = Device::registers::template holds_all<Registers...>();
    template <typename Device> static constexpr bool have_scales = are_all<has_scale<Device, Registers>...>;
    static constexpr bool have_readable_steps = are_all<has_readable_steps<Registers>...>;
    static constexpr bool are_different = by_key.duplicate().second == 0;

    template <auto const& R>
    static constexpr bool contain = [] {
        std::size_t const at = by_key.find(key_of(R.space, R.address));
        return at < count and places[at] == &R;
    }();

    /// Whether one of them is called so.
    static constexpr bool has_code(literal code) noexcept { return named(code) < count; }

    /// The raw count of the one that is called so; none for no mnemonic.
    static constexpr raw_place raw_called(literal code) noexcept
    {
        constexpr std::array<raw_place, count> all{raw_place_of<Registers>()...};
        std::size_t const at = named(code);
        return at < count ? all[at] : raw_place{};
    }
};

/// Of all registers of a list.
template <auto const& First, auto const&... Rest>
[[nodiscard]] constexpr key_range range_of(register_list<First, Rest...>) noexcept
{
    key_range range = range_of<First>();
    for (key_range const& each : std::array<key_range, sizeof...(Rest)>{range_of<Rest>()...}) {
        range = range.with(each);
    }
    return range;
}

/// The addresses of some registers, rising.
template <auto const&... Registers> [[nodiscard]] constexpr auto rising_addresses() noexcept
{
    std::array<std::uint16_t, sizeof...(Registers)> addresses{Registers.address...};
    sort_addresses(addresses);
    return addresses;
}

/// How many words a register's value takes, that of its scale included.
template <auto const& R>
inline constexpr std::size_t words_with_scale = std::size_t{R.word_count} + (has_scale_register<R> ? 1U : 0U);

/// Adds the words of a register to a list.
template <auto const& R, std::size_t Most>
constexpr std::size_t add_words(std::array<std::uint32_t, Most>& keys, std::size_t at) noexcept
{
    for (std::uint32_t word = 0; word < R.word_count; ++word) {
        keys[at++] = key_of(R.space, R.address) + word;
    }
    if constexpr (has_scale_register<R>) {
        at = add_words<std::remove_cvref_t<decltype(R)>::form::scale_register>(keys, at);
    }
    return at;
}

/// The words of some registers as keys, rising, each once, at the front; and how many there are.
template <std::size_t Most> struct rising_keys {
    std::array<std::uint32_t, Most> keys{};
    std::size_t count{0};

    /// The place of a key in the list.
    [[nodiscard]] constexpr std::size_t place_of(std::uint32_t key) const noexcept
    {
        std::size_t low = 0;
        for (std::size_t end = count; low < end;) {
            std::size_t const middle = (low + end) / 2;
            if (keys[middle] < key) {
                low = middle + 1;
            } else {
                end = middle;
            }
        }
        return low;
    }
};
template <auto const&... Registers> [[nodiscard]] constexpr auto rising_words() noexcept
{
    rising_keys<sum_of<words_with_scale<Registers>...>()> all;
    std::size_t size = 0;
    [[maybe_unused]] std::array<std::size_t, sizeof...(Registers)> const sizes{
        (size = add_words<Registers>(all.keys, size))...};
    sort_addresses(all.keys);
    for (std::uint32_t const key : all.keys) {
        if (all.count == 0 or all.keys[all.count - 1] != key) {
            all.keys[all.count++] = key;
        }
    }
    return all;
}

/// What a plan reads, and by which requests.
template <std::size_t Words> struct read_requests {
    std::array<std::uint16_t, Words> addresses{}; ///< of each word, by space and rising
    std::array<register_space, Words> spaces{};   ///< of each word
    block_list<Words> blocks{};                   ///< no block where no plan can be
    std::array<register_space, Words> block_spaces{};
};

/// For each word that a plan reads, whether the request that reads the word before it reads it, too.
template <std::size_t Words, std::size_t Most, std::size_t Ranges>
[[nodiscard]] constexpr std::array<bool, Words> joined_words(rising_keys<Most> const& of,
                                                             std::array<key_range, Ranges> const& ranges) noexcept
{
    std::array<bool, Words> joined{};
    for (key_range const& range : ranges) {
        if (range.first == range.last) {
            continue;
        }
        std::size_t at = of.place_of(range.first) + 1;
        for (; at < Words and of.keys[at] <= range.last; ++at) {
            joined[at] = true;
        }
    }
    return joined;
}

/// Whether one request may read from one register of a device to the next that a plan names: what lies between them can
/// be read.
template <typename Device>
[[nodiscard]] constexpr bool is_crossed(std::uint16_t lower, std::uint16_t upper, register_space space) noexcept
{
    return upper - lower == 1 or is_readable_across<Device>(static_cast<std::uint16_t>(lower + 1),
                                                            static_cast<std::uint16_t>(upper - 1), space);
}

/// Plans the words of several spaces, of which ranges must not be cut.
template <typename Device, std::size_t Words, std::size_t Most, std::size_t Ranges>
[[nodiscard]] constexpr read_requests<Words> plan_spaces(rising_keys<Most> const& of,
                                                         std::array<key_range, Ranges> const& ranges) noexcept
{
    read_requests<Words> plan;
    for (std::size_t i = 0; i < Words; ++i) {
        plan.addresses[i] = static_cast<std::uint16_t>(of.keys[i] & 0xFFFFU);
        plan.spaces[i] = static_cast<register_space>(of.keys[i] >> 16U);
    }
    auto const joined = joined_words<Words>(of, ranges);
    for (std::size_t first = 0, end = 0; first < Words; first = end) {
        register_space const space = plan.spaces[first];
        while (end < Words and plan.spaces[end] == space) {
            ++end;
        }
        auto const is_joined = [&](std::size_t index) { return joined[first + index]; };
        auto const part = plan_blocks<Words>(
            std::span{plan.addresses}.subspan(first, end - first),
            is_space_of_bits(space) ? max_bit_quantity : Device::limits.read,
            [&](std::uint16_t lower, std::uint16_t upper) { return is_crossed<Device>(lower, upper, space); },
            is_joined);
        if (part.count == 0) {
            plan.blocks.count = 0;
            return plan;
        }
        for (address_block const& block : part.view()) {
            plan.block_spaces[plan.blocks.count] = space;
            plan.blocks.blocks[plan.blocks.count++] = block;
        }
    }
    return plan;
}

} // namespace detail

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
