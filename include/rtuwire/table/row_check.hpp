// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// What the rows of a device have to be. Rows that do not fit together do not compile, and the compiler names the address.
// Apart from table/row_table.hpp, which makes registers of them: whoever writes rows is sent here, and to no other line of it.
#pragma once

#include <cstddef>
#include <cstdint>

#include <rtuwire/core/version.hpp>
#include <rtuwire/table/enumeration.hpp>
#include <rtuwire/table/register.hpp>
#include <rtuwire/table/row.hpp>

namespace rtuwire {
inline namespace RTUWIRE_BUILD {

namespace detail {

/// No address.
inline constexpr std::uint32_t no_row = 0xFFFF'FFFFU;

/// The address of the first row that is wrong; `no_row` where none is.
template <typename Table, typename IsWrong>
[[nodiscard]] consteval std::uint32_t first_wrong_row(IsWrong const& is_wrong) noexcept
{
    std::uint32_t found = no_row;
    Table::for_each_row([&](auto const& row) { found = found == no_row and is_wrong(row) ? row.address : found; });
    return found;
}

/// The count that a number has as a floating point one.
template <typename Real> [[nodiscard]] constexpr bool is_held_as(std::int64_t count) noexcept
{
    constexpr std::int64_t most = std::int64_t{1} << 62U;
    return count >= -most and count <= most and static_cast<std::int64_t>(static_cast<Real>(count)) == count;
}

/// Whether a number of so many words, more than none, holds a count.
[[nodiscard]] constexpr bool is_held_in(std::uint16_t words, bool is_signed, std::int64_t count) noexcept
{
    if (words > 3) {
        return is_signed or count >= 0;
    }
    std::int64_t const values = std::int64_t{1} << (16U * words);
    return is_signed ? count >= -(values / 2) and count < values / 2 : count >= 0 and count < values;
}

/// Whether what a row holds has a count as one of its values.
template <typename Row> [[nodiscard]] constexpr bool is_held_by(Row const& row, std::int64_t count) noexcept
{
    if constexpr (not Row::is_plain) {
        if (row.type.has_form() and row.type.form().is_bit) {
            return count == 0 or count == 1;
        }
        if (row.type.has_form() and row.type.form().is_real) {
            return row.type.form().word_count == 2 ? is_held_as<float>(count) : is_held_as<double>(count);
        }
        return is_held_in(row.word_count(), row.type->kind == parameter_kind::signed_number, count);
    } else {
        return is_held_in(1, row.type->kind == parameter_kind::signed_number, count);
    }
}

template <typename Row> [[nodiscard]] constexpr bool has_limit_beyond_type(Row const& row) noexcept
{
    return (row.min.is_number() and not is_held_by(row, row.min.raw())) or
           (row.max.is_number() and not is_held_by(row, row.max.raw()));
}

[[nodiscard]] constexpr bool has_reversed_limits(register_row const& row) noexcept
{
    return row.min.is_number() and row.max.is_number() and row.min.raw() > row.max.raw();
}

/// Of a drive's row, only whether what it holds has such a value: a test compares the limits with its list.
template <typename Row> [[nodiscard]] constexpr bool is_delivered_wrong(Row const& row) noexcept
{
    if (not row.factory or not is_held_by(row, *row.factory)) {
        return row.factory.has_value();
    }
    if constexpr (not Row::is_plain) {
        bool const is_listed = row.type->kind != parameter_kind::enumeration or
                               has_meaning(row.choices(), static_cast<std::uint16_t>(*row.factory));
        return not is_listed or (row.min.is_number() and *row.factory < row.min.raw()) or
               (row.max.is_number() and *row.factory > row.max.raw()) or row.gap.contains(*row.factory);
    }
    return false;
}

[[nodiscard]] constexpr bool is_of_another_kind(register_row const& row) noexcept
{
    bool const is_bit = row.type.has_form() and row.type.form().is_bit;
    bool const is_read = row.kind.space == register_space::input or row.kind.space == register_space::discrete_input;
    return is_space_of_bits(row.kind.space) != is_bit or (is_read and row.mode() != access::read_only);
}

/// Whether a word of bits has a name for one that no word has.
template <typename Row> [[nodiscard]] constexpr bool has_bit_beyond_word(Row const& row) noexcept
{
    bool has_one = false;
    if (row.type->kind == parameter_kind::bits) {
        for (choice const& each : row.choices()) {
            has_one = has_one or each.word > 15;
        }
    }
    return has_one;
}

[[nodiscard]] constexpr bool has_one_choice_twice(register_row const& row) noexcept
{
    for (std::size_t i = 1; i < row.choices().size(); ++i) {
        choice const& last = row.choices()[i];
        for (choice const& each : row.choices().first(i)) {
            if (each.word == last.word or (each.mnemonic == last.mnemonic and each.mnemonic.size() != 0)) {
                return true;
            }
        }
    }
    return false;
}

} // namespace detail

/// Never defined for an address: these names are the message, the argument is the row's.
template <std::uint32_t Address> struct two_rows_have_this_address;
template <std::uint32_t Address> struct two_rows_have_the_code_of_this_one;
template <std::uint32_t Address> struct this_row_has_its_limits_reversed;
template <std::uint32_t Address> struct this_row_has_a_limit_that_its_type_does_not_hold;
template <std::uint32_t Address> struct this_row_is_delivered_with_a_value_that_it_does_not_take;
template <std::uint32_t Address> struct this_row_holds_what_its_kind_cannot;
template <std::uint32_t Address> struct this_row_has_one_choice_twice;
template <std::uint32_t Address> struct this_row_has_a_bit_beyond_15;
template <std::uint32_t Address> struct this_row_ends_behind_address_65535;

namespace detail {

/// No address has to be named in a message; of any other the compiler does.
template <template <std::uint32_t> typename Message, std::uint32_t Address>
inline constexpr bool is_no_row = [] {
    if constexpr (Address != no_row) {
        return sizeof(Message<Address>) > 0;
    }
    return true;
}();

/// What the rows of a device have to be; of a drive's, only that none is there twice, and that each is what a word holds.
template <typename Table> [[nodiscard]] consteval bool are_right_rows() noexcept
{
    using row = typename Table::row_type;
    static_assert(is_no_row<two_rows_have_this_address, Table::address_taken()>);
    static_assert(is_no_row<two_rows_have_the_code_of_this_one, Table::code_taken()>);
    static_assert(is_no_row<this_row_has_a_limit_that_its_type_does_not_hold,
                            first_wrong_row<Table>(has_limit_beyond_type<row>)>);
    static_assert(is_no_row<this_row_is_delivered_with_a_value_that_it_does_not_take,
                            first_wrong_row<Table>(is_delivered_wrong<row>)>);
    static_assert(is_no_row<this_row_has_a_bit_beyond_15, first_wrong_row<Table>(has_bit_beyond_word<row>)>);
    if constexpr (not row::is_plain) {
        static_assert(is_no_row<this_row_has_its_limits_reversed, first_wrong_row<Table>(has_reversed_limits)>);
        static_assert(is_no_row<this_row_holds_what_its_kind_cannot, first_wrong_row<Table>(is_of_another_kind)>);
        static_assert(is_no_row<this_row_has_one_choice_twice, first_wrong_row<Table>(has_one_choice_twice)>);
    }
    return true;
}

} // namespace detail

} // namespace RTUWIRE_BUILD
} // namespace rtuwire
