// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// One register of a device as a row: what its line in the manual's table says. A device is some arrays of them:
//
//     {"U1",     40,  input,   in<float32<volts>>,   {}, {}, {}, "Voltage, phase 1"},
//     {"TARIFF", 120, rw,      tariff,              {}, {}, 1,  "Tariff"},
//     {"K1",     0,   coil_rw, in<bool>,            {}, {}, {}, "Relay"},
//      mnemonic, address, kind and who may write it, what it holds, least, most, as delivered, name
//
// It holds amounts, `in<...>` their unit and step, or a bit, or one of a list of choices, or the bits of a word. Limits and
// the value as delivered are counts of that step; `{}` is none, or not known. A limit may be another register: "TFR". The
// rows of a drive, with the same columns and one more, are in altivar/parameters/parameter.hpp. What a row cannot hold is
// an object beside them: a text, several values in one word, an amount whose scale another register has.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <type_traits>

#include <rtuwire/core/literal.hpp>
#include <rtuwire/core/version.hpp>
#include <rtuwire/table/enumeration.hpp>
#include <rtuwire/table/form/form.hpp>
#include <rtuwire/table/register.hpp>

namespace rtuwire {
inline namespace RTUWIRE_BUILD {

/// What the word of a parameter is.
enum class parameter_kind : std::uint8_t { number, signed_number, bits, enumeration };

/// What a parameter holds, once for all that hold the same.
struct parameter_type {
    parameter_kind kind;
    literal unit{};                 ///< symbol of what is measured, "Hz"; empty where nothing is
    std::int32_t step_numerator{1}; ///< one count is this fraction of the unit
    std::int32_t step_denominator{1};
    std::span<choice const> choices{}; ///< the values of an enumeration, or the bits of a word by number

    /// Whether two are the same amounts.
    [[nodiscard]] constexpr bool is_same(parameter_type const& other) const noexcept
    {
        return kind == other.kind and unit == other.unit and step_numerator == other.step_numerator and
               step_denominator == other.step_denominator;
    }
};

namespace detail {

/// What the values of an enumeration, or the bits of a word, mean; specialised where the list for driving has no words.
template <typename Enum> inline constexpr auto const& words_of = meanings<Enum>;

/// The values of an enumeration that has a type, or the bits of such a word, as choices.
template <typename Enum>
inline constexpr auto choices_of = [] {
    constexpr bool has_mnemonics = enumerators<Enum>.size() != 0;
    std::array<choice, has_mnemonics ? enumerators<Enum>.size() : words_of<Enum>.size()> all{};
    for (std::size_t i = 0; i < all.size(); ++i) {
        if constexpr (has_mnemonics) {
            named_value const& each = enumerators<Enum>[i];
            all[i] = {each.value, each.name, listed_name(words_of<Enum>, each.value)};
        } else {
            all[i] = {words_of<Enum>[i].value, {}, words_of<Enum>[i].name};
        }
    }
    return all;
}();

template <register_value T> [[nodiscard]] consteval parameter_type type_of() noexcept
{
    if constexpr (bit_field<T>) {
        return {.kind = parameter_kind::bits, .choices = choices_of<typename T::bit_type>};
    } else if constexpr (register_enumeration<T>) {
        return {.kind = parameter_kind::enumeration, .choices = choices_of<T>};
    } else {
        return {.kind = std::is_signed_v<typename T::rep> ? parameter_kind::signed_number : parameter_kind::number,
                .unit = T::dimension::symbol,
                .step_numerator = T::scale::num,
                .step_denominator = T::scale::den};
    }
}

/// A number of several words. One with a scale register is no row.
template <typename T>
concept wide_number = register_form<T> and not scaled_form<T> and requires
{
    typename T::value_type::dimension;
    typename T::count_type;
    T::order;
};

/// Whether such a number has a sign.
template <wide_number T> [[nodiscard]] consteval bool is_signed_number() noexcept
{
    if constexpr (std::is_floating_point_v<typename T::count_type>) {
        return true;
    } else {
        return T::lowest < 0;
    }
}

} // namespace detail

/// What a register of several words holds, or a single bit, once for all that hold the same.
struct form_type {
    parameter_type amount;
    std::uint16_t word_count{1};
    word_order order{word_order::high_first};
    bool is_real{false}; ///< a floating point number
    bool is_bit{false};  ///< a coil or a discrete input

    [[nodiscard]] constexpr bool is_same(form_type const& other) const noexcept
    {
        return amount.is_same(other.amount) and word_count == other.word_count and order == other.order and
               is_real == other.is_real and is_bit == other.is_bit;
    }
};

namespace detail {

template <wide_number T> [[nodiscard]] consteval form_type form_of() noexcept
{
    using amount = typename T::value_type;
    return {.amount = {.kind = is_signed_number<T>() ? parameter_kind::signed_number : parameter_kind::number,
                       .unit = amount::dimension::symbol,
                       .step_numerator = amount::scale::num,
                       .step_denominator = amount::scale::den},
            .word_count = T::word_count,
            .order = T::order,
            .is_real = std::is_floating_point_v<typename T::count_type>};
}

} // namespace detail

/// What a row holds whose values have a type: `in<deciseconds>`; in the rows of no drive also `in<float32<volts>>`,
/// `in<bool>`.
template <typename T> inline constexpr auto in = detail::type_of<T>();
template <detail::wide_number T> inline constexpr form_type in<T> = detail::form_of<T>();
template <> inline constexpr form_type in<bool>{.amount = {.kind = parameter_kind::number}, .is_bit = true};

namespace detail {

/// What rows hold that have a list of their own.
inline constexpr parameter_type one_of_a_list{.kind = parameter_kind::enumeration};
inline constexpr parameter_type bits_of_a_list{.kind = parameter_kind::bits};

} // namespace detail

/// What a row holds: an amount in a unit, one of a list of choices, or bits.
class held_values {
public:
    /// An amount, or bits, of this type, which must outlive it.
    constexpr held_values(parameter_type const& type) noexcept : type_{&type} {}

    /// One of these choices, which must outlive it.
    template <std::size_t Count>
    constexpr held_values(choice const (&list)[Count], parameter_type const& type = detail::one_of_a_list) noexcept
        : type_{&type}, own_{list}
    {}

    [[nodiscard]] constexpr parameter_type const* operator->() const noexcept { return type_; }

    [[nodiscard]] constexpr std::span<choice const> choices() const noexcept
    {
        return own_.empty() ? type_->choices : own_;
    }

private:
    parameter_type const* type_;
    std::span<choice const> own_{}; ///< where the row brings its own
};

/// A word of bits: the rows of the list are its bits, by number.
template <std::size_t Count> [[nodiscard]] constexpr held_values bits(choice const (&list)[Count]) noexcept
{
    return {list, detail::bits_of_a_list};
}

/// Who may write a register, and how reliable the source is: `rw` and the like, once for a drive.
struct row_access {
    access mode;
    provenance source;
};

/// The same, where the source contradicts itself.
[[nodiscard]] constexpr row_access doubtful(row_access of) noexcept { return {of.mode, provenance::doubtful}; }

/// What the row of any device holds: what one of a drive does, or a number of several words, or a bit.
class row_values {
public:
    /// What a row of a drive holds.
    constexpr row_values(held_values word) noexcept : word_{word} {}
    /// An amount, or bits, in one word.
    constexpr row_values(parameter_type const& type) noexcept : word_{type} {}
    /// A number of this form, of one to four words.
    constexpr row_values(form_type const& form) noexcept : word_{form.amount}, form_{&form}, has_form_{true} {}
    /// One of these choices.
    template <std::size_t Count> constexpr row_values(choice const (&list)[Count]) noexcept : word_{list} {}

    [[nodiscard]] constexpr parameter_type const* operator->() const noexcept { return word_.operator->(); }
    [[nodiscard]] constexpr std::span<choice const> choices() const noexcept { return word_.choices(); }

    /// Whether it is more, or less, than one word. A flag: GCC with -fsanitize=undefined compares no address of a constant.
    [[nodiscard]] constexpr bool has_form() const noexcept { return has_form_; }

    /// What it then is.
    [[nodiscard]] constexpr form_type const& form() const noexcept { return *form_; }

private:
    held_values word_;
    form_type const* form_{nullptr};
    bool has_form_{false};
};

/// Of which kind a register is, and who may write it: once for a device.
struct row_kind {
    register_space space;
    access mode;
    provenance source{provenance::documented};
};

/// The kinds, as the words of a column: `using namespace rtuwire::row_words` beside the rows.
namespace row_words {

inline constexpr row_kind rw{register_space::holding, access::read_write};
inline constexpr row_kind ro{register_space::holding, access::read_only};
inline constexpr row_kind input{register_space::input, access::read_only};
inline constexpr row_kind coil_rw{register_space::coil, access::read_write};
inline constexpr row_kind coil_ro{register_space::coil, access::read_only};
inline constexpr row_kind discrete{register_space::discrete_input, access::read_only};

} // namespace row_words

/// One register of a device that is no drive, as its row.
struct register_row {
    literal code; ///< the mnemonic, in upper case
    std::uint16_t address;
    row_kind kind;
    row_values type;
    bound min = detail::open_bound;                              ///< in raw counts, or by another register
    bound max = detail::open_bound;                              ///< in raw counts, or by another register
    std::optional<std::int32_t> factory = detail::unknown_count; ///< in raw counts, where known
    literal name = detail::no_text;                              ///< for display
    literal steps_set_by = detail::no_text;   ///< the register that sets the size of a step; empty where none does
    detail::count_range gap = detail::no_gap; ///< raw counts inside the limits that are never written

    /// Whether all rows of this class are holding registers of one word.
    static constexpr bool is_plain = false;

    [[nodiscard]] constexpr access mode() const noexcept { return kind.mode; }
    [[nodiscard]] constexpr provenance source() const noexcept { return kind.source; }
    [[nodiscard]] constexpr std::uint16_t word_count() const noexcept
    {
        return type.has_form() ? type.form().word_count : std::uint16_t{1};
    }

    /// The values of an enumeration, or the bits of a word by number.
    [[nodiscard]] constexpr std::span<choice const> choices() const noexcept { return type.choices(); }
};

} // namespace RTUWIRE_BUILD
} // namespace rtuwire
