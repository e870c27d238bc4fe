// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// Rows as the registers of a device, for typed access: `read<parameter<"LFF">>(drive)`, by the mnemonic alone. A register
// that has an object of its own, `atv320::acc`, is named by that.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <type_traits>
#include <utility>

#include <rtuwire/altivar/parameters/parameter_map.hpp>
#include <rtuwire/altivar/parameters/row_demands.hpp>
#include <rtuwire/altivar/parameters/units.hpp>
#include <rtuwire/core/literal.hpp>
#include <rtuwire/core/version.hpp>
#include <rtuwire/table/enumeration.hpp>
#include <rtuwire/table/register.hpp>
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

/// A register that is a row of a drive.
template <typename Device, typename T> struct row_register : reg<T> {
    template <typename Step> using in_steps = row_register<Device, Step>;
};
template <typename Device, typename T> inline constexpr bool is_row_of = false;
template <typename Device, typename T> inline constexpr bool is_row_of<Device, row_register<Device, T>> = true;

} // namespace detail

namespace altivar {

/// A text as a template argument: `parameter<"LFF">`.
template <std::size_t Size> struct mnemonic {
    char letters[Size]{};

    consteval mnemonic(char const (&text)[Size]) noexcept
    {
        for (std::size_t i = 0; i < Size; ++i) {
            letters[i] = text[i];
        }
    }
};

/// The types of amounts that the rows of a drive may have: a drive of one's own lists its own.
template <typename... Ts> struct amount_types {
    /// The place of the type of which a row says the same.
    [[nodiscard]] static consteval std::size_t place_of(parameter_type const& type) noexcept
    {
        std::size_t place = 0;
        for (parameter_type const& each : {in<Ts>...}) {
            if (each.kind == type.kind and each.unit == type.unit and each.step_numerator == type.step_numerator and
                each.step_denominator == type.step_denominator) {
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

/// Those of this library.
using usual_amounts =
    amount_types<hertz, decihertz, signed_decihertz, hectohertz, decahertz, rpm, signed_rpm, deciamperes,
                 signed_deciamperes, microamperes, signed_microamperes, tenth_milliamperes, volts, decivolts,
                 millivolts, signed_millivolts, percent, signed_percent, tenth_percent, signed_tenth_percent,
                 hundredth_percent, seconds, deciseconds, centiseconds, signed_centiseconds, units::milliseconds,
                 tenth_milliseconds, minutes, hours, centihours, celsius, whole_celsius, centi_per_second, count16,
                 signed_count16, count16_tenths, count16_hundredths, decinewton_metres, milliohms,
                 hundredth_millihenries, centimetres, centimetres_per_second, tenth_millivolts_per_rpm>;

/// The types of amounts of a drive.
/// Internal.
template <typename Device> struct amounts_of {
    using type = usual_amounts;
};
template <typename Device>
    requires requires { typename Device::amounts; }
struct amounts_of<Device> {
    using type = typename Device::amounts;
};

/// The registers of a drive with all its parameters: those of `Driving`, a table of objects, and all rows of some maps.
/// `Device` is the drive, whose rows another one, of other scanner words, may share.
template <typename Device, typename Driving, auto const&... Maps> class row_table {
public:
    static constexpr std::size_t size = (Maps.size() + ...);

    /// The rows, by their groups.
    static constexpr std::array<parameter_map const*, sizeof...(Maps)> maps{&Maps...};

    /// Whether there is a register at an address.
    [[nodiscard]] static constexpr bool has_address(std::uint16_t address,
                                                    register_space space = register_space::holding) noexcept
    {
        return space == register_space::holding and by_address.find(address) != size;
    }

    /// Whether a register is one of this device's, or one of them counted in other steps.
    template <auto const& R>
    static constexpr bool contains = [] {
        if constexpr (detail::is_row_of<Device, std::remove_cvref_t<decltype(R)>>) {
            return true;
        } else {
            return Driving::template contains<R>;
        }
    }();

    /// Whether all of some registers are this device's.
    /// Internal.
    template <auto const&... Asked> [[nodiscard]] static constexpr bool holds_all() noexcept
    {
        return detail::are_all<contains<Asked>...>;
    }

    /// Calls `visit(row)` for each, group by group.
    template <typename Visit> static constexpr void for_each_row(Visit&& visit)
    {
        (Maps.for_each([&](parameter const& each, parameter_group const&) { visit(each); }), ...);
    }

    /// The place of the row of a mnemonic that no object has; `size` where there is none.
    /// Internal.
    [[nodiscard]] static constexpr std::size_t without_object(literal code) noexcept
    {
        std::size_t const place = by_code.find(code);
        return place == size or Driving::has_address(rows[place]->address) ? size : place;
    }

    /// The address of a row that does not say of itself what `Drive` says of its register; 0: there is none.
    /// Internal.
    template <typename Drive = Device> [[nodiscard]] static constexpr std::uint16_t address_without_role() noexcept
    {
        for (row_demand const& each : row_demands<Drive>) {
            std::size_t const place = each.address == 0 ? size : by_address.find(each.address);
            if (place != size and not each.is_met_by(role_of(*rows[place]))) {
                return each.address;
            }
        }
        return 0;
    }

    /// Internal.
    [[nodiscard]] static constexpr parameter const& row_at(std::size_t place) noexcept
    {
        return *rows[place == size ? 0 : place];
    }

private:
    template <typename T, T parameter::*Member>
    static constexpr std::array<T, size> each = [] {
        std::array<T, size> all{};
        std::size_t next = 0;
        for_each_row([&](parameter const& row) { all[next++] = row.*Member; });
        return all;
    }();
    static constexpr std::array<parameter const*, size> rows = [] {
        std::array<parameter const*, size> all{};
        std::size_t next = 0;
        for_each_row([&](parameter const& row) { all[next++] = &row; });
        return all;
    }();
    static constexpr detail::key_index<std::uint16_t, size> by_address{each<std::uint16_t, &parameter::address>};
    static constexpr detail::key_index<literal, size> by_code{each<literal, &parameter::code>};
};

/// What a row holds, as a type: an amount, bits by number, or an enumeration of its own.
/// Internal.
template <typename Called> struct row_value {
    enum class type : std::uint16_t {};
    friend consteval std::span<choice const> choices_beside(type) { return Called::row.choices(); }
};

/// The register of a row.
/// Internal.
template <typename Device, char... Letters> struct row_named {
private:
    using table = typename Device::registers;
    static constexpr char letters[]{Letters..., '\0'};
    static constexpr std::size_t place = table::without_object(letters);
    static constexpr bool is_known = place != table::size;
    static_assert(is_known, "this drive has no parameter of this mnemonic, or one that has a name of its own, as "
                            "atv320::acc: name it by that");

public:
    static constexpr parameter row = table::row_at(place);

private:
    [[nodiscard]] static constexpr auto typed() noexcept
    {
        constexpr parameter_kind kind = row.type->kind;
        if constexpr (kind == parameter_kind::bits) {
            return of<flags<detail::bit_number>>();
        } else if constexpr (kind == parameter_kind::enumeration) {
            return of<typename row_value<row_named>::type>();
        } else {
            using amounts = typename amounts_of<Device>::type;
            constexpr std::size_t type = amounts::place_of(*row.type.operator->());
            static_assert(type < amounts::size, "the types of amounts of this drive lack that of this row");
            return of<typename amounts::template at<type>>();
        }
    }
    template <typename T> [[nodiscard]] static constexpr auto of() noexcept
    {
        return detail::row_register<Device, T>{reg<T>{.code = row.code,
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

/// The register of a row, by its mnemonic: each drive has a shorter name for its own.
template <typename Device, mnemonic Code>
inline constexpr auto const& parameter_called = []<std::size_t... At>(std::index_sequence<At...>) -> auto const&
{
    return row_named<Device, Code.letters[At]...>::it;
}
(std::make_index_sequence<sizeof(Code.letters) - 1>{});

/// A value by its name, where an enumeration is wanted: `named<"YES">`, the mnemonic or the meaning.
/// Internal.
template <mnemonic Name> struct named_choice {
    /// The value of an enumeration that has this name.
    template <register_enumeration Enum> [[nodiscard]] static consteval Enum value() noexcept
    {
        constexpr std::size_t count = enumerators<Enum>.size();
        constexpr std::size_t place = [] {
            std::size_t found = count;
            for (std::size_t i = 0; i < count; ++i) {
                found = enumerators<Enum>[i].name == literal{Name.letters} ? i : found;
            }
            for (std::size_t i = 0; found == count and i < count; ++i) {
                found = detail::listed_name(meanings<Enum>, enumerators<Enum>[i].value) == literal{Name.letters}
                            ? i
                            : found;
            }
            return found;
        }();
        constexpr bool is_known = place < count;
        static_assert(is_known, "this register has no value of this name");
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
template <mnemonic Name> inline constexpr named_choice<Name> named{};

} // namespace altivar
} // namespace RTUWIRE_BUILD
} // namespace rtuwire
