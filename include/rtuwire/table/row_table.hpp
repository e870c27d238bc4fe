// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// Rows as the registers of a device, for typed access: `read<parameter<"LFF">>(drive)`, by the mnemonic alone. A register
// that has an object of its own, `atv320::acc`, is named by that. table/row_check.hpp says which rows do not compile.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <type_traits>
#include <utility>

#include <rtuwire/core/literal.hpp>
#include <rtuwire/core/version.hpp>
#include <rtuwire/table/enumeration.hpp>
#include <rtuwire/table/register.hpp>
#include <rtuwire/table/row.hpp>
#include <rtuwire/table/row_check.hpp>
#include <rtuwire/table/setting.hpp>
#include <rtuwire/table/table.hpp>

namespace rtuwire {
inline namespace RTUWIRE_BUILD {

namespace detail {

/// Types by their places.
template <std::size_t Place, typename T> struct placed_type {
    using type = T;
};
template <typename Places, typename... Ts> struct placed_types;
template <std::size_t... Places, typename... Ts>
struct placed_types<std::index_sequence<Places...>, Ts...> : placed_type<Places, Ts>... {};
template <std::size_t Place, typename T> placed_type<Place, T> at_place(placed_type<Place, T> const&);

/// The number of a bit in a word whose bits have no type.
enum class bit_number : std::uint8_t {};

/// A register that is a row of a device.
template <typename Device, typename T, register_space Space = register_space::holding>
struct row_register : reg<T, Space> {
    template <typename Step> using in_steps = row_register<Device, Step, Space>;
};
template <typename Device, typename T> inline constexpr bool is_row_of = false;
template <typename Device, typename T, register_space Space>
inline constexpr bool is_row_of<Device, row_register<Device, T, Space>> = true;

/// Whether two columns of rows, of one word or of a form, say the same amount.
template <typename Left, typename Right>
[[nodiscard]] constexpr bool is_same_amount(Left const& left, Right const& right) noexcept
{
    if constexpr (std::is_same_v<Left, Right>) {
        return left.is_same(right);
    }
    return false;
}

} // namespace detail

/// A text as a template argument: `parameter<"LFF">`.
template <std::size_t Size> struct mnemonic {
    char letters[Size]{};

    /// Copies the letters.
    consteval mnemonic(char const (&text)[Size]) noexcept
    {
        for (std::size_t i = 0; i < Size; ++i) {
            letters[i] = text[i];
        }
    }
};

/// The types of amounts that the rows of a device may have: a device of one's own lists its own.
template <typename... Ts> struct amount_types {
    /// The place of the type of which a row says the same.
    template <typename Type> [[nodiscard]] static consteval std::size_t place_of(Type const& type) noexcept
    {
        std::size_t place = 0;
        for (bool const is_it : {detail::is_same_amount(in<Ts>, type)...}) {
            if (is_it) {
                return place;
            }
            ++place;
        }
        return place;
    }

    template <std::size_t Place>
    using at = typename decltype(detail::at_place<Place>(
        detail::placed_types<std::make_index_sequence<sizeof...(Ts)>, Ts...>{}))::type;
    static constexpr std::size_t size = sizeof...(Ts);
};

namespace detail {

/// The types of amounts of a device where it lists none: those of the class of its rows.
template <typename Row> struct usual_amounts_of {
    using type = amount_types<>;
};
template <typename Device> struct amounts_of : usual_amounts_of<typename Device::registers::row_type> {};
template <typename Device>
    requires requires { typename Device::amounts; }
struct amounts_of<Device> {
    using type = typename Device::amounts;
};

/// Calls `visit(row)` for each of a list: of an array, or of a map of groups.
template <typename List, typename Visit> constexpr void for_each_row_of(List const& list, Visit&& visit)
{
    if constexpr (std::is_array_v<List>) {
        for (auto const& each : list) {
            visit(each);
        }
    } else {
        for (auto const& group : list.groups()) {
            for (auto const& each : group.rows) {
                visit(each);
            }
        }
    }
}

/// The class of the rows of a list.
template <typename List> struct row_of_list {
    using type = typename List::row_type;
};
template <typename Row, std::size_t Size> struct row_of_list<Row[Size]> {
    using type = std::remove_const_t<Row>;
};

/// Of some lists; they have one.
template <auto const& First, auto const&...> struct row_of_lists : row_of_list<std::remove_cvref_t<decltype(First)>> {};

/// The addresses of some rows: holding registers of one word.
template <typename Table, bool IsPlain> struct row_addresses {
    static constexpr std::size_t count = Table::size;
    using key = std::uint16_t;

    static constexpr std::array<key, count> keys = [] {
        std::array<key, count> all{};
        std::size_t next = 0;
        Table::for_each_row([&](auto const& row) { all[next++] = row.address; });
        return all;
    }();
};

/// Registers of any kind and width.
template <typename Table> struct row_addresses<Table, false> {
    static constexpr std::uint32_t past_the_end = first_wrong_row<Table>(
        [](register_row const& row) { return std::uint32_t{row.address} + row.word_count() > 0x1'0000; });
    static_assert(is_no_row<this_row_ends_behind_address_65535, past_the_end>);
    static constexpr std::size_t count = [] {
        std::size_t words = 0;
        Table::for_each_row([&](register_row const& row) { words += row.word_count(); });
        return words;
    }();
    using key = std::uint32_t;

    static constexpr std::array<key, count> keys = [] {
        std::array<key, count> all{};
        std::size_t next = 0;
        Table::for_each_row([&](register_row const& row) {
            for (std::uint32_t word = 0; word < row.word_count(); ++word) {
                all[next++] = key_of(row.kind.space, row.address) + word;
            }
        });
        return all;
    }();
};

} // namespace detail

template <typename Device, char... Letters> struct row_named;

namespace detail {
template <typename Table> [[nodiscard]] consteval bool is_checked() noexcept;
} // namespace detail

/// The registers of a device that has rows: those of `Objects`, a table, and the rows of some lists. A list is an array of
/// `register_row`; or, of a drive, a map, whose rows have the registers of the table among them. `Device` is the device,
/// whose rows another one, of other scanner words, may share.
template <typename Device, typename Objects, auto const&... Lists> class row_table {
public:
    using device = Device;
    using objects = Objects;

    /// The class of the rows.
    using row_type = typename detail::row_of_lists<Lists...>::type;

    /// How many rows there are.
    static constexpr std::size_t size = (std::size(Lists) + ...);

    /// Whether there is a register at an address.
    [[nodiscard]] static constexpr bool has_address(std::uint16_t address,
                                                    register_space space = register_space::holding) noexcept
    {
        if constexpr (row_type::is_plain) {
            return space == register_space::holding and by_address.find(address) != size;
        } else {
            return by_address.find(detail::key_of(space, address)) != addresses::count or
                   Objects::has_address(address, space);
        }
    }

    /// Whether a register is one of this device's, or one of them counted in other steps.
    template <auto const& R>
    static constexpr bool contains = [] {
        if constexpr (detail::is_row_of<Device, std::remove_cvref_t<decltype(R)>>) {
            return true;
        } else {
            return detail::is_checked<row_table>() and Objects::template contains<R>;
        }
    }();

    /// Whether all of some registers are this device's.
    /// Internal.
    template <auto const&... Asked> [[nodiscard]] static constexpr bool holds_all() noexcept
    {
        return detail::are_all<contains<Asked>...>;
    }

    /// Calls `visit(list)` for each list: the maps of a drive, whose rows stand in groups.
    template <typename Visit> static constexpr void for_each_list(Visit const& visit) { (visit(Lists), ...); }

    /// Calls `visit(row)` for each, list by list.
    template <typename Visit> static constexpr void for_each_row(Visit&& visit)
    {
        (detail::for_each_row_of(Lists, visit), ...);
    }

    /// The row at an address; null where there is none.
    [[nodiscard]] static constexpr row_type const* row_for(std::uint16_t address) noexcept requires(row_type::is_plain)
    {
        std::size_t const place = by_address.find(address);
        return place == size ? nullptr : rows[place];
    }

    /// The place of the row of a mnemonic that no object has; `size` where there is none.
    /// Internal.
    [[nodiscard]] static constexpr std::size_t without_object(literal code) noexcept
    {
        std::size_t const place = by_code.find(code);
        if constexpr (row_type::is_plain) {
            return place == size or Objects::has_address(rows[place]->address) ? size : place;
        } else {
            return place;
        }
    }

    /// The address of a row that another row has, or an object; `no_row` where there is none.
    /// Internal.
    [[nodiscard]] static constexpr std::uint32_t address_taken() noexcept
    {
        std::size_t const second = by_address.duplicate().second;
        if constexpr (not row_type::is_plain) {
            for (std::uint32_t const key : addresses::keys) {
                if (Objects::has_address(static_cast<std::uint16_t>(key & 0xFFFFU),
                                         static_cast<register_space>(key >> 16U))) {
                    return key & 0xFFFFU;
                }
            }
        }
        return second == 0 ? detail::no_row : addresses::keys[second] & 0xFFFFU;
    }

    /// The address of a row whose mnemonic another one has, or an object beside them.
    /// Internal.
    [[nodiscard]] static constexpr std::uint32_t code_taken() noexcept
    {
        if constexpr (not row_type::is_plain) {
            for (row_type const* const row : rows) {
                bool is_taken = false;
                Objects::for_each([&]<auto const & R>() { is_taken = is_taken or R.code == row->code; });
                if (is_taken) {
                    return row->address;
                }
            }
        }
        std::size_t const second = by_code.duplicate().second;
        return second == 0 ? detail::no_row : rows[second]->address;
    }

    /// Internal.
    [[nodiscard]] static constexpr row_type const& row_at(std::size_t place) noexcept
    {
        return *rows[place == size ? 0 : place];
    }

private:
    using addresses = detail::row_addresses<row_table, row_type::is_plain>;

    static constexpr std::array<row_type const*, size> rows = [] {
        std::array<row_type const*, size> all{};
        std::size_t next = 0;
        for_each_row([&](row_type const& row) { all[next++] = &row; });
        return all;
    }();
    static constexpr std::array<literal, size> codes = [] {
        std::array<literal, size> all{};
        std::size_t next = 0;
        for_each_row([&](row_type const& row) { all[next++] = row.code; });
        return all;
    }();
    static constexpr detail::key_index<typename addresses::key, addresses::count> by_address{addresses::keys};
    static constexpr detail::key_index<literal, size> by_code{codes};
};

namespace detail {

/// What a row holds, as a type: an amount, bits by number, or an enumeration of its own.
template <typename Called> struct row_value {
    enum class type : std::uint16_t {};
    friend consteval std::span<choice const> choices_beside(type) { return Called::row.choices(); }
};

/// The rows of a device are checked where one of them, or an object beside them, is first used; those of a drive, of which
/// there may be a thousand, by `drive_check`.
template <typename Table> [[nodiscard]] consteval bool is_checked() noexcept
{
    if constexpr (Table::row_type::is_plain) {
        return true;
    } else {
        return are_right_rows<Table>();
    }
}

/// The register of a row.
template <typename Device, char... Letters> struct row_named {
private:
    using table = typename Device::registers;
    static constexpr char letters[]{Letters..., '\0'};
    static_assert(is_checked<table>());
    static constexpr std::size_t place = table::without_object(letters);
    static constexpr bool is_known = place != table::size;
    static_assert(is_known, "this device has no row of this mnemonic, or a register that has a name of its own, as "
                            "atv320::acc: name it by that");

public:
    static constexpr auto row = table::row_at(place);

private:
    // The rows of a drive are checked one by one.
    static_assert(is_no_row<this_row_has_a_limit_that_its_type_does_not_hold,
                            (has_limit_beyond_type(row) ? std::uint32_t{row.address} : no_row)>);
    static_assert(is_no_row<this_row_is_delivered_with_a_value_that_it_does_not_take,
                            (is_delivered_wrong(row) ? std::uint32_t{row.address} : no_row)>);

    /// Of an amount that the device lists.
    template <typename Type> [[nodiscard]] static constexpr auto amount(Type const&) noexcept
    {
        using amounts = typename detail::amounts_of<Device>::type;
        constexpr std::size_t type = [] {
            if constexpr (std::is_same_v<Type, form_type>) {
                return amounts::place_of(row.type.form());
            } else {
                return amounts::place_of(*row.type.operator->());
            }
        }();
        static_assert(type < amounts::size, "the types of amounts of this device lack that of this row");
        return of<typename amounts::template at<type>>();
    }
    /// Whether it is more, or less, than one word, as no row of a drive is.
    static constexpr bool is_plain = std::remove_const_t<decltype(row)>::is_plain;
    static constexpr bool has_form = [] {
        if constexpr (is_plain) {
            return false;
        } else {
            return row.type.has_form();
        }
    }();
    [[nodiscard]] static constexpr auto typed() noexcept
    {
        if constexpr (has_form) {
            if constexpr (row.type.form().is_bit) {
                return of<bool>();
            } else {
                return amount(row.type.form());
            }
        } else if constexpr (row.type->kind == parameter_kind::bits) {
            return of<flags<detail::bit_number>>();
        } else if constexpr (row.type->kind == parameter_kind::enumeration) {
            return of<typename row_value<row_named>::type>();
        } else {
            return amount(*row.type.operator->());
        }
    }
    [[nodiscard]] static constexpr register_space space() noexcept
    {
        if constexpr (is_plain) {
            return register_space::holding;
        } else {
            return row.kind.space;
        }
    }
    template <typename T> [[nodiscard]] static constexpr auto of() noexcept
    {
        return detail::row_register<Device, T, space()>{reg<T, space()>{.code = row.code,
                                                                        .address = row.address,
                                                                        .mode = row.mode(),
                                                                        .min = row.min,
                                                                        .max = row.max,
                                                                        .factory = row.factory,
                                                                        .name = row.name,
                                                                        .source = row.source(),
                                                                        .steps_set_by = row.steps_set_by,
                                                                        .gap = row.gap}};
    }

public:
    static constexpr auto it = typed();
};

} // namespace detail

/// The register of a row, by its mnemonic: each device has a shorter name for its own.
template <typename Device, mnemonic Code>
inline constexpr auto const& parameter_called = []<std::size_t... At>(std::index_sequence<At...>) -> auto const&
{
    return detail::row_named<Device, Code.letters[At]...>::it;
}
(std::make_index_sequence<sizeof(Code.letters) - 1>{});

namespace detail {

template <typename Table, std::size_t Place, std::size_t... At>
[[nodiscard]] consteval auto const& register_of_row(std::index_sequence<At...>) noexcept
{
    return row_named<typename Table::device, Table::row_at(Place).code[At]...>::it;
}
/// All registers of a device that has rows.
template <typename Table, typename Places> struct registers_of_rows;
template <typename Table, std::size_t... Places> struct registers_of_rows<Table, std::index_sequence<Places...>> {
    template <template <auto const&...> typename List>
    using with = typename Table::objects::template with<
        List, register_of_row<Table, Places>(std::make_index_sequence<Table::row_at(Places).code.size()>{})...>;
};
template <typename Device, typename Objects, auto const&... Lists>
struct all_registers<row_table<Device, Objects, Lists...>>
    : registers_of_rows<row_table<Device, Objects, Lists...>,
                        std::make_index_sequence<row_table<Device, Objects, Lists...>::size>> {};

/// Where a name stands in a list, and how often.
struct found_name {
    std::size_t place;
    std::size_t times{0};

    constexpr void look_at(std::size_t at, bool is_it) noexcept
    {
        place = is_it ? at : place;
        times += is_it ? 1U : 0U;
    }
};

/// A value by its name.
template <mnemonic Name> struct named_choice {
    /// The value of an enumeration that has this name.
    template <register_enumeration Enum> [[nodiscard]] static consteval Enum value() noexcept
    {
        constexpr found_name found = [] {
            found_name by_mnemonic{enumerators<Enum>.size()};
            found_name by_meaning{enumerators<Enum>.size()};
            for (std::size_t i = 0; i < enumerators<Enum>.size(); ++i) {
                named_value const& each = enumerators<Enum>[i];
                by_mnemonic.look_at(i, each.name == literal{Name.letters});
                by_meaning.look_at(i, listed_name(meanings<Enum>, each.value) == literal{Name.letters});
            }
            return by_mnemonic.times == 0 ? by_meaning : by_mnemonic;
        }();
        constexpr std::size_t place = found.place;
        constexpr bool is_known = place < enumerators<Enum>.size();
        static_assert(literal{Name.letters}.size() != 0, "a value without a name is asked for by its number");
        static_assert(is_known, "this register has no value of this name");
        static_assert(found.times < 2, "this register has two values of this name");
        return static_cast<Enum>(enumerators<Enum>[is_known ? place : 0].value);
    }

    template <register_enumeration Enum> constexpr operator Enum() const noexcept
    {
        constexpr Enum which = value<Enum>();
        return which;
    }

    template <typename Setting>
        requires(detail::is_setting<Setting>)
    constexpr operator Setting() const noexcept
    {
        constexpr Setting which{value<typename Setting::value_type>()};
        return which;
    }

    template <register_enumeration Enum> friend constexpr bool operator==(Enum left, named_choice) noexcept
    {
        constexpr Enum right = value<Enum>();
        return left == right;
    }
};

} // namespace detail

/// A value by its name, where an enumeration is wanted: `named<"YES">`, the mnemonic or the meaning.
template <mnemonic Name> inline constexpr detail::named_choice<Name> named{};

} // namespace RTUWIRE_BUILD
} // namespace rtuwire
