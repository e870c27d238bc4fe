// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// A server's registers by type: each has its own address, limits and access, which the bank enforces. For a device of
// your own as well as for a drive.
//
// In this order: the rule of a register, made by its type and not by the register, so that a compiler makes a thousand of
// them by one function; the registers of one kind, in the order of their addresses, with their rules and their words; the
// bank, which has one of these for each kind.
#pragma once

#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <span>
#include <type_traits>

#include <rtuwire/core/bytes.hpp>
#include <rtuwire/core/version.hpp>
#include <rtuwire/table/enumeration.hpp>
#include <rtuwire/table/form/form.hpp>
#include <rtuwire/table/register.hpp>
#include <rtuwire/table/request_plan.hpp>
#include <rtuwire/table/setting.hpp>
#include <rtuwire/table/table.hpp>
#include <rtuwire/wire/errc.hpp>
#include <rtuwire/wire/views.hpp>

namespace rtuwire {
inline namespace RTUWIRE_BUILD {

namespace detail {

/// The words of a register as delivered; 0 where its factory value is not known.
template <typename T, register_space Space> [[nodiscard]] constexpr auto factory_words(reg<T, Space> const& of) noexcept
{
    using form = typename as_form<T>::type;
    using value_type = typename reg<T, Space>::value_type;
    if constexpr (register_value<value_type>) {
        return std::array{static_cast<std::uint16_t>(of.factory.value_or(0))};
    } else if constexpr (requires { typename form::count_type; }) {
        return form::to_words(value_type{static_cast<typename form::count_type>(of.factory.value_or(0))});
    } else if constexpr (std::same_as<value_type, bool>) {
        return form::to_words(of.factory.value_or(0) != 0);
    } else {
        return form::to_words(value_type{});
    }
}

/// What holds for a holding register of one word.
struct word_rule {
    std::uint16_t address;
    bool is_writable;
    bool is_signed;
    std::int32_t lowest;
    std::int32_t highest;
    std::span<std::uint16_t const> listed;
    count_range gap;

    /// Of a register; nothing of one that is not such a register.
    template <typename T, register_space Space> [[nodiscard]] static constexpr word_rule of(reg<T, Space> const& from)
    {
        if constexpr (reg<T, Space>::is_plain) {
            std::int32_t const least = lowest_count<T>(from.min);
            return {from.address, from.mode != access::read_only, least < 0,
                    least,        highest_count<T>(from.max),     listed_words<T>(),
                    from.gap};
        } else {
            return {};
        }
    }

    static constexpr std::size_t word_count = 1;
    [[nodiscard]] static constexpr std::size_t first_word(std::size_t place) noexcept { return place; }
    static constexpr void put_at(std::size_t) noexcept {}
    [[nodiscard]] constexpr bool takes(register_view values, std::size_t at) const noexcept
    {
        std::uint16_t const word = values[at];
        std::int32_t const raw = is_signed ? std::int32_t{static_cast<std::int16_t>(word)} : std::int32_t{word};
        return raw >= lowest and raw <= highest and not gap.contains(raw) and has_meaning(listed, word);
    }
};

/// The limits of a register of any form. A number, or none.
struct value_limits {
    std::int64_t min;
    std::int64_t max;
    count_range gap;
    bool has_min;
    bool has_max;
};

/// Whether a register of a type takes the words of a request, from the one at `at` on; `IsOpen` where it has no limits.
template <typename T, bool IsOpen>
[[nodiscard]] constexpr bool takes_words(register_view values, std::size_t at,
                                         [[maybe_unused]] value_limits const& limits) noexcept
{
    using form = typename as_form<T>::type;
    using value_type = typename form::value_type;
    std::array<std::uint16_t, form::word_count> words{};
    for (std::size_t i = 0; i < words.size(); ++i) {
        words[i] = values[at + i];
    }
    auto const value = form::from_words(words);
    if (not value) {
        return false;
    }
    if constexpr (register_value<value_type>) {
        std::int32_t const raw = raw_count<value_type>(to_word(*value));
        return raw >= limits.min and raw <= limits.max and not limits.gap.contains(raw) and
               has_meaning(listed_words<value_type>(), to_word(*value));
    } else if constexpr (IsOpen) {
        return form::refusal(*value, bound{}, bound{}, count_range{}) == errc::none;
    } else {
        bound const min = limits.has_min ? bound{limits.min} : bound{};
        bound const max = limits.has_max ? bound{limits.max} : bound{};
        return form::refusal(*value, min, max, limits.gap) == errc::none;
    }
}

/// What holds for any register of words.
struct value_rule {
    std::uint16_t address;
    std::uint16_t word_count;
    std::uint16_t first; ///< where its first word is stored
    bool is_writable;
    bool (*check)(register_view, std::size_t, value_limits const&); ///< null where no client writes it
    value_limits limits;

    template <typename T, register_space Space> [[nodiscard]] static constexpr value_rule of(reg<T, Space> const& from)
    {
        using value_type = typename reg<T, Space>::value_type;
        value_rule rule{from.address,
                        reg<T, Space>::word_count,
                        0,
                        from.mode != access::read_only,
                        nullptr,
                        {from.min.raw(), from.max.raw(), from.gap, from.min.is_number(), from.max.is_number()}};
        if constexpr (register_value<value_type>) {
            rule.limits.min = lowest_count<value_type>(from.min);
            rule.limits.max = highest_count<value_type>(from.max);
        }
        // A form without limits needs no arithmetic for them, and one that nobody writes no check at all.
        bool const is_open = not from.min.is_number() and not from.max.is_number() and from.gap.last < from.gap.first;
        if constexpr (not scaled_form<T>) {
            if (rule.is_writable) {
                rule.check = is_open and not register_value<value_type> ? takes_words<T, true> : takes_words<T, false>;
            }
        }
        return rule;
    }

    [[nodiscard]] constexpr std::size_t first_word(std::size_t) const noexcept { return first; }
    constexpr void put_at(std::size_t word) noexcept { first = static_cast<std::uint16_t>(word); }
    [[nodiscard]] constexpr bool takes(register_view values, std::size_t at) const noexcept
    {
        return check(values, at, limits);
    }
};

/// What holds for a coil or a discrete input.
struct bit_rule {
    std::uint16_t address;
    bool is_writable;

    template <typename T, register_space Space> [[nodiscard]] static constexpr bit_rule of(reg<T, Space> const& from)
    {
        return {from.address, from.mode != access::read_only};
    }

    static constexpr std::size_t word_count = 1;
    [[nodiscard]] static constexpr std::size_t first_word(std::size_t place) noexcept { return place; }
    static constexpr void put_at(std::size_t) noexcept {}
};

/// The registers of one kind among those of a bank: their rules, rising by address, and their words as delivered.
template <register_space Space, auto const&... Registers> struct bank_space {
private:
    static constexpr std::size_t all = sizeof...(Registers);
    static constexpr std::array<bool, all> are_of_kind{(Registers.space == Space)...};
    static constexpr bool is_plain =
        Space == register_space::holding and are_all<(Registers.is_plain or Registers.space != Space)...>;
    using rule =
        std::conditional_t<is_space_of_bits(Space), bit_rule, std::conditional_t<is_plain, word_rule, value_rule>>;

public:
    static constexpr std::size_t size = sum_of<(Registers.space == Space ? 1U : 0U)...>();
    static constexpr std::size_t word_count = sum_of<(Registers.space == Space ? Registers.word_count : 0U)...>();

    // What a loop reads often is captured, as a copy: see `key_index`. And without a capture GCC makes a conversion to a
    // pointer, for which it calls the lambda once more.

private:
    /// The places of its registers in the bank's list, rising by address.
    static constexpr auto order = [addresses = std::array<std::uint16_t, all>{Registers.address...},
                                   are_of_it = are_of_kind] {
        std::array<std::uint32_t, size> keys{};
        for (std::uint32_t i = 0, at = 0; i < are_of_it.size(); ++i) {
            if (are_of_it[i]) {
                keys[at++] = std::uint32_t{addresses[i]} << 16U | i;
            }
        }
        sort_addresses(keys);
        std::array<std::uint16_t, size> places{};
        for (std::size_t i = 0; i < places.size(); ++i) {
            places[i] = static_cast<std::uint16_t>(keys[i] & 0xFFFFU);
        }
        return places;
    }();

public:
    static constexpr auto rules = [listed = std::array<rule, all>{rule::of(Registers)...}, places = order] {
        std::array<rule, size> rising{};
        std::size_t word_place = 0;
        for (std::size_t i = 0; i < rising.size(); ++i) {
            rising[i] = listed[places[i]];
            rising[i].put_at(word_place);
            word_place += rising[i].word_count;
        }
        return rising;
    }();

    static constexpr auto delivered = [places = order, rising = rules, are_of_it = are_of_kind] {
        std::array<std::uint16_t, all> starts{};
        for (std::size_t i = 0; i < rising.size(); ++i) {
            starts[places[i]] = static_cast<std::uint16_t>(rising[i].first_word(i));
        }
        std::array<std::uint16_t, word_count> all_words{};
        std::size_t at = 0;
        auto const put = [&](auto const& of) {
            if (are_of_it[at]) {
                std::size_t word_place = starts[at];
                for (std::uint16_t const each : factory_words(of)) {
                    all_words[word_place++] = each;
                }
            }
            return ++at;
        };
        [[maybe_unused]] std::array<std::size_t, all> const done{put(Registers)...};
        return all_words;
    }();

    /// The place of the first register at an address or above it: `size` where there is none. A short list is gone
    /// through, which is smaller.
    [[nodiscard]] static constexpr std::size_t place_from(std::uint32_t address) noexcept
    {
        std::size_t low = 0;
        if constexpr (size <= 8) {
            while (low < size and rules[low].address < address) {
                ++low;
            }
            return low;
        }
        for (std::size_t end = size; low < end;) {
            std::size_t const middle = (low + end) / 2;
            if (rules[middle].address < address) {
                low = middle + 1;
            } else {
                end = middle;
            }
        }
        return low;
    }

    /// Whether registers, from this place on, fill these addresses, none of them cut, and all writable where that is
    /// asked.
    [[nodiscard]] static constexpr bool fills(std::size_t place, std::uint16_t start, std::size_t count,
                                              bool is_to_write) noexcept
    {
        for (std::size_t i = 0; i < count; ++place) {
            if (place == size or rules[place].address != start + i or rules[place].word_count > count - i or
                (is_to_write and not rules[place].is_writable)) {
                return false;
            }
            i += rules[place].word_count;
        }
        return true;
    }
};

/// Holding registers or input registers. A register of several words is read and written whole or not at all: half of it
/// is exception 02.
template <typename Space> class typed_words {
    static constexpr auto& rules = Space::rules;

public:
    [[nodiscard]] constexpr errc check_read(std::uint16_t start, std::size_t count) const noexcept
    {
        return Space::fills(Space::place_from(start), start, count, false) ? errc::none : errc::illegal_data_address;
    }

    [[nodiscard]] constexpr errc check_write(std::uint16_t start, register_view values) const noexcept
    {
        std::size_t place = Space::place_from(start);
        if (not Space::fills(place, start, values.size(), true)) {
            return errc::illegal_data_address;
        }
        for (std::size_t i = 0; i < values.size(); ++place) {
            if (not rules[place].takes(values, i)) {
                return errc::illegal_data_value;
            }
            i += rules[place].word_count;
        }
        return errc::none;
    }

    constexpr errc read(std::uint16_t start, std::size_t count, byte_writer& out) noexcept
    {
        if (std::byte* const to = out.take(2 * count); to != nullptr and count > 0) {
            std::size_t const place = Space::place_from(start);
            std::size_t const first = rules[place].first_word(place);
            for (std::size_t i = 0; i < count; ++i) {
                put_u16(to + 2 * i, words_[first + i]);
            }
        }
        return errc::none;
    }

    constexpr errc write(std::uint16_t start, register_view values) noexcept
    {
        std::size_t place = Space::place_from(start);
        for (std::size_t i = 0; i < values.size(); ++place) {
            is_written_[place] = true;
            for (std::size_t word = 0; word < rules[place].word_count; ++word, ++i) {
                words_[rules[place].first_word(place) + word] = values[i];
            }
        }
        return errc::none;
    }

    /// The value of a register, or a result where its words may be none.
    template <auto const& R> [[nodiscard]] constexpr auto value() const noexcept
    {
        constexpr std::size_t first = first_word<R>();
        if constexpr (R.is_plain) {
            return from_word<value_of<R>>(words_[first]);
        } else if constexpr (is_always_a_value<R>) {
            return *value_in<R>(words_, first, 0);
        } else {
            return value_in<R>(words_, first, 0);
        }
    }

    template <auto const& R> constexpr void set_value(value_of<R> value) noexcept
    {
        constexpr std::size_t first = first_word<R>();
        auto const words = register_form_of<R>::to_words(value);
        for (std::size_t i = 0; i < words.size(); ++i) {
            words_[first + i] = words[i];
        }
    }

    template <auto const& R> constexpr bool& written() noexcept
    {
        constexpr std::size_t place = Space::place_from(R.address);
        return is_written_[place];
    }

private:
    template <auto const& R> static constexpr std::size_t first_word() noexcept
    {
        std::size_t const place = Space::place_from(R.address);
        return rules[place].first_word(place);
    }

    std::array<std::uint16_t, Space::word_count> words_{Space::delivered};
    std::array<bool, Space::size> is_written_{};
};

/// Coils or discrete inputs.
template <typename Space> class typed_bits {
public:
    [[nodiscard]] constexpr errc check_read(std::uint16_t start, std::size_t count) const noexcept
    {
        return Space::fills(Space::place_from(start), start, count, false) ? errc::none : errc::illegal_data_address;
    }

    [[nodiscard]] constexpr errc check_write(std::uint16_t start, bit_view values) const noexcept
    {
        return Space::fills(Space::place_from(start), start, values.size(), true) ? errc::none
                                                                                  : errc::illegal_data_address;
    }

    constexpr errc read(std::uint16_t start, std::size_t count, byte_span out) noexcept
    {
        std::size_t const place = Space::place_from(start);
        for (std::size_t i = 0; i < count; ++i) {
            put_bit(out, i, bits_[place + i]);
        }
        return errc::none;
    }

    constexpr errc write(std::uint16_t start, bit_view values) noexcept
    {
        std::size_t const place = Space::place_from(start);
        for (std::size_t i = 0; i < values.size(); ++i) {
            bits_[place + i] = values[i];
            is_written_[place + i] = true;
        }
        return errc::none;
    }

    template <auto const& R> [[nodiscard]] constexpr bool value() const noexcept { return bits_[place_of<R>()]; }
    template <auto const& R> constexpr void set_value(bool value) noexcept { bits_[place_of<R>()] = value; }
    template <auto const& R> constexpr bool& written() noexcept { return is_written_[place_of<R>()]; }

private:
    template <auto const& R> static constexpr std::size_t place_of() noexcept
    {
        constexpr std::size_t place = Space::place_from(R.address);
        return place;
    }

    static constexpr auto delivered() noexcept
    {
        std::array<bool, Space::size> bits{};
        for (std::size_t i = 0; i < bits.size(); ++i) {
            bits[i] = Space::delivered[i] != 0;
        }
        return bits;
    }

    std::array<bool, Space::size> bits_{delivered()};
    std::array<bool, Space::size> is_written_{};
};

/// Whether one of some registers is of a kind.
template <register_space Space, auto const&... Registers>
inline constexpr bool has_kind = [kinds = std::array<register_space, sizeof...(Registers)>{Registers.space...}] {
    for (register_space const each : kinds) {
        if (each == Space) {
            return true;
        }
    }
    return false;
}();

/// In the place of a kind of which a bank has no register: takes no memory.
template <register_space> struct no_registers {};

/// What a bank has of a kind. A list that nobody needs is not made: of a thousand registers it costs a compiler much.
template <register_space Space, template <typename> typename Typed, auto const&... Registers>
using part_of_bank =
    std::conditional_t<has_kind<Space, Registers...>, Typed<bank_space<Space, Registers...>>, no_registers<Space>>;

} // namespace detail

/// The values of some registers of any kinds, initially their factory values (0 where none is known). Exception 02:
/// reading an address without a register, writing one, writing a read-only register, or reading or writing only part of
/// a register of several words. Exception 03, only if none of the registers written is a case of 02: a value outside its
/// register's limits, one that is no value (a floating point number that is infinite or none), or one that the names of
/// its enumeration do not list (`enumerators`; any value is allowed where they are not given). A signed register's words
/// are compared as signed. Nothing is written in part.
template <auto const&... Registers> class bank {
    using registers = table<Registers...>;
    static_assert(detail::are_all<detail::has_own_steps<Registers>...>,
                  "another register sets this register's steps: name them with restepped");
    static_assert(registers::size == sizeof...(Registers)); // a table refuses registers that overlap

public:
    /// Itself, to be known by: nobody has to find out which registers the bank has.
    /// Internal.
    using typed_bank = bank;

    /// What `register_bank` asks of a bank, of the holding registers.
    [[nodiscard]] constexpr errc check_read(std::uint16_t start, std::size_t count) const noexcept
    {
        return holding_.check_read(start, count);
    }
    [[nodiscard]] constexpr errc check_write(std::uint16_t start, register_view values) const noexcept
    {
        return holding_.check_write(start, values);
    }
    constexpr errc read(std::uint16_t start, std::size_t count, byte_writer& out) noexcept
    {
        return holding_.read(start, count, out);
    }
    constexpr errc write(std::uint16_t start, register_view values) noexcept { return holding_.write(start, values); }

    /// What a server of function 04 asks for.
    [[nodiscard]] constexpr auto& input_registers() noexcept
        requires(detail::has_kind<register_space::input, Registers...>)
    {
        return inputs_;
    }
    /// What a server of functions 01, 05 and 15 asks for.
    [[nodiscard]] constexpr auto& coils() noexcept requires(detail::has_kind<register_space::coil, Registers...>)
    {
        return coils_;
    }
    /// What a server of function 02 asks for.
    [[nodiscard]] constexpr auto& discrete_inputs() noexcept
        requires(detail::has_kind<register_space::discrete_input, Registers...>)
    {
        return discrete_inputs_;
    }

    /// Whether a register is one of this bank's.
    template <auto const& R> static constexpr bool contains = registers::template contains<R>;

    /// The value of a register; of one whose words may be no value (a floating point number, `known` enumerators) a
    /// result.
    template <auto const& R> [[nodiscard]] constexpr auto get() const noexcept
    {
        static_assert(registers::template contains<R>, "this bank has no such register");
        return part<R.space>(*this).template value<R>();
    }

    /// Sets a register from the device's own side, also where a client may only read it.
    template <auto const& R> constexpr void set(value_of<R> value) noexcept
    {
        static_assert(registers::template contains<R>, "this bank has no such register");
        part<R.space>(*this).template set_value<R>(value);
    }

    /// Whether a client has written a register since the last call.
    template <auto const& R> [[nodiscard]] constexpr bool take_written() noexcept
    {
        static_assert(registers::template contains<R>, "this bank has no such register");
        bool& is_written = part<R.space>(*this).template written<R>();
        bool const was = is_written;
        is_written = false;
        return was;
    }

private:
    template <register_space Space, typename Self> static constexpr auto& part(Self& self) noexcept
    {
        if constexpr (Space == register_space::holding) {
            return self.holding_;
        } else if constexpr (Space == register_space::input) {
            return self.inputs_;
        } else if constexpr (Space == register_space::coil) {
            return self.coils_;
        } else {
            return self.discrete_inputs_;
        }
    }

    detail::typed_words<detail::bank_space<register_space::holding, Registers...>> holding_{};
    [[no_unique_address]] detail::part_of_bank<register_space::input, detail::typed_words, Registers...> inputs_{};
    [[no_unique_address]] detail::part_of_bank<register_space::coil, detail::typed_bits, Registers...> coils_{};
    [[no_unique_address]] detail::part_of_bank<register_space::discrete_input, detail::typed_bits, Registers...>
        discrete_inputs_{};
};

/// A bank of all registers of a device.
template <typename Device>
using bank_of = typename detail::all_registers<typename Device::registers>::template with<bank>;

} // namespace RTUWIRE_BUILD
} // namespace rtuwire
