// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// One register of a device, as the table in its manual has it. A descriptor is a constant that is passed by
// reference as a template argument, so nothing of it reaches the target. Knows no device and no I/O.
#pragma once

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <type_traits>

#include <rtuwire/core/literal.hpp>
#include <rtuwire/core/units.hpp>
#include <rtuwire/core/version.hpp>
#include <rtuwire/table/enumeration.hpp>

namespace rtuwire {
inline namespace RTUWIRE_BUILD {

/// Who may write a register, and when.
enum class access : std::uint8_t {
    read_only,
    read_write,
    configuration, ///< written only while the motor is stopped
};

/// How reliable the source of a descriptor is.
enum class provenance : std::uint8_t {
    documented, ///< printed in the device's manual or the manufacturer's parameter file
    inferred,   ///< from the file of a sister device, confirmed there
    doubtful,   ///< the source is damaged or contradicts itself
};

/// A limit of a register in raw counts: a number, or a share of what another register holds now.
class bound {
public:
    /// No limit but that of 16 bits.
    constexpr bound() noexcept = default;

    /// A number; more than 32 bits of it only for a register that is as wide.
    constexpr bound(std::int64_t raw) noexcept : raw_{raw}, numerator_{0} {}

    /// The raw count of the register called `code`, times a fraction: "INV" times 1/2.
    constexpr bound(literal code, std::uint16_t numerator = 1, std::uint16_t denominator = 1,
                    literal factor = {}) noexcept
        : code_{code}, factor_{factor}, numerator_{numerator}, denominator_{denominator}
    {}

    /// What the register called `code` holds.
    template <std::size_t Size> constexpr bound(char const (&code)[Size]) noexcept : bound{literal{code}} {}

    [[nodiscard]] constexpr bool is_open() const noexcept { return numerator_ == 1 and code_.size() == 0; }
    [[nodiscard]] constexpr bool is_number() const noexcept { return numerator_ == 0; }

    /// The number, where it is one.
    [[nodiscard]] constexpr std::int64_t raw() const noexcept { return raw_; }

    /// The mnemonic of the register it depends on; empty for a number.
    [[nodiscard]] constexpr literal code() const noexcept { return code_; }

    /// The mnemonic of a second register that is multiplied in; empty where there is none.
    [[nodiscard]] constexpr literal factor() const noexcept { return factor_; }
    [[nodiscard]] constexpr std::uint16_t numerator() const noexcept { return numerator_; }
    [[nodiscard]] constexpr std::uint16_t denominator() const noexcept { return denominator_; }

    /// The limit in raw counts, when the other register holds `other` (and the second `multiplier`); rounded
    /// towards zero, and limited to the range of 32 bits.
    [[nodiscard]] constexpr std::int32_t with(std::int32_t other, std::int32_t multiplier = 1) const noexcept
    {
        if (is_number()) {
            return static_cast<std::int32_t>(raw_);
        }
        // A product beyond 47 bits is beyond 32 bits also after the fraction, whose parts have 16.
        constexpr std::int64_t most = std::int64_t{1} << 47U;
        std::int64_t const product = within(std::int64_t{other} * multiplier, -most, most);
        using raw_limits = std::numeric_limits<std::int32_t>;
        return static_cast<std::int32_t>(
            within(product * numerator_ / denominator_, (raw_limits::min)(), (raw_limits::max)()));
    }

private:
    static constexpr std::int64_t within(std::int64_t number, std::int64_t least, std::int64_t most) noexcept
    {
        return number < least ? least : number > most ? most : number;
    }

    literal code_{};
    literal factor_{};
    std::int64_t raw_{0};
    std::uint16_t numerator_{1};
    std::uint16_t denominator_{1};
};

namespace detail {

/// The smallest or largest value of a register named by another register.
[[nodiscard]] constexpr bound share_of(literal code, std::uint16_t numerator, std::uint16_t denominator) noexcept
{
    return bound{code, numerator, denominator};
}

/// A limit that is the product of two registers' raw counts, divided: by 10 where one of them counts
/// tenths and the product whole units.
[[nodiscard]] constexpr bound product_of(literal code, literal factor, std::uint16_t denominator) noexcept
{
    return bound{code, 1, denominator, factor};
}

/// Raw counts from `first` to `last`, both included; none while `last` is below `first`.
struct count_range {
    std::int32_t first{0};
    std::int32_t last{-1};

    [[nodiscard]] constexpr bool contains(std::int32_t raw) const noexcept { return raw >= first and raw <= last; }
};

/// What a row leaves out. Named constants, because a compiler copies them in half the time in which it makes them anew.
inline constexpr bound open_bound{};
inline constexpr literal no_text{};
inline constexpr std::optional<std::int32_t> unknown_count{};
inline constexpr count_range no_gap{};

} // namespace detail

/// The four kinds of a unit's data. Each has addresses of its own, and functions that read and write it.
enum class register_space : std::uint8_t {
    holding,        ///< function 03 reads, 06 and 16 write
    input,          ///< function 04 reads
    coil,           ///< function 01 reads, 05 and 15 write
    discrete_input, ///< function 02 reads
};

namespace detail {

[[nodiscard]] constexpr bool is_space_of_bits(register_space space) noexcept
{
    return space == register_space::coil or space == register_space::discrete_input;
}

} // namespace detail

/// How one or more words stand for a value, where one word is not simply its count: `float32<volts>`. Such a form has
/// - `value_type`, and `word_count`, the number of registers it takes;
/// - `from_words`, which makes a value of an array of so many words, or says why they are none;
/// - `to_words`, which makes the words of a value;
/// - `is_total`, true where any words are a value.
/// A quantity is asked for nothing, so that a table does not make the compiler look into every unit.
template <typename T>
concept register_form = not detail::is_quantity_type<T> and std::is_class_v<T> and requires
{
    typename T::value_type;
    T::word_count;
};

namespace detail {

/// What the registers of a type or form hold, and how many there are.
template <typename T> struct held_by {
    using type = T;
    static constexpr std::uint16_t words = 1;
    static constexpr bool is_form = false;
    static constexpr bool is_bit = false;
};
template <> struct held_by<bool> : held_by<void> {
    using type = bool;
    static constexpr bool is_bit = true;
};
template <register_form T> struct held_by<T> {
    using type = typename T::value_type;
    static constexpr std::uint16_t words = T::word_count;
    static constexpr bool is_form = true;
    static constexpr bool is_bit = false;
};

/// Who may write a register where its row does not say it.
template <register_space Space>
inline constexpr access usual_access =
    Space == register_space::holding or Space == register_space::coil ? access::read_write : access::read_only;

} // namespace detail

/// One register whose values are of type `T`: a quantity, an enumeration, a bit field, or a form of several words. A
/// coil or a discrete input has the type bool.
template <typename T, register_space Space = register_space::holding> struct reg {
    using held = detail::held_by<T>;
    static_assert(held::is_bit == (Space == register_space::coil or Space == register_space::discrete_input),
                  "a coil and a discrete input hold a bool, and a register something else");

    using value_type = typename held::type;
    using form = T;
    static constexpr register_space space = Space;
    static constexpr std::uint16_t word_count = held::words; ///< how many addresses it takes, from `address` on
    /// A holding register of one word, which is a value whatever it is: what a drive has.
    static constexpr bool is_plain = Space == register_space::holding and not held::is_form;

    /// The same register counted in other steps.
    template <typename Step> using in_steps = reg<Step, Space>;

    literal code;          ///< the manufacturer's mnemonic, in upper case
    std::uint16_t address; ///< as it stands on the wire
    access mode = detail::usual_access<Space>;
    bound min = detail::open_bound;                              ///< in raw counts
    bound max = detail::open_bound;                              ///< in raw counts
    std::optional<std::int32_t> factory = detail::unknown_count; ///< the value as delivered, in raw counts, where known
    literal name = detail::no_text;                              ///< for display
    provenance source{provenance::documented};
    literal steps_set_by = detail::no_text;   ///< the register that sets the size of a step, where one does
    detail::count_range gap = detail::no_gap; ///< inside the limits, but never to be written
    void const* counted_as{nullptr};          ///< the register that this one counts in other steps
    bool is_restepped{false}; ///< whether `counted_as` names one: GCC with -fsanitize=undefined does not ask it
};

/// A register that only function 04 reads; a bit that function 01 reads and 05 writes; one that only 02 reads.
template <typename T> using input_reg = reg<T, register_space::input>;
using coil = reg<bool, register_space::coil>;
using discrete_input = reg<bool, register_space::discrete_input>;

/// A bit field: one word of named bits.
template <typename T>
concept bit_field = requires(T value)
{
    {
        value.bits
        } -> std::convertible_to<std::uint16_t>;
    typename T::is_bit_field;
};

/// An enumeration as wide as a register.
template <typename T>
concept register_enumeration = std::is_enum_v<T> and std::same_as<std::underlying_type_t<T>, std::uint16_t>;

namespace detail {

/// A quantity that one register can hold.
template <typename T>
concept register_quantity = requires(T value)
{
    typename T::dimension;
    typename T::scale;
    {
        value.count()
        } -> std::same_as<typename T::rep>;
    requires sizeof(typename T::rep) == 2;
};

/// What a register can hold.
template <typename T>
concept register_value = bit_field<T> or register_enumeration<T> or register_quantity<T>;

/// A value as the word that stands on the wire.
template <register_value T> [[nodiscard]] constexpr std::uint16_t to_word(T value) noexcept
{
    if constexpr (register_quantity<T>) {
        return static_cast<std::uint16_t>(value.count());
    } else if constexpr (bit_field<T>) {
        return value.bits;
    } else {
        return static_cast<std::uint16_t>(value);
    }
}

/// The value of a word from the wire; every word has one.
template <register_value T> [[nodiscard]] constexpr T from_word(std::uint16_t word) noexcept
{
    if constexpr (register_quantity<T>) {
        return T{static_cast<typename T::rep>(word)};
    } else if constexpr (bit_field<T>) {
        return T{word};
    } else {
        return static_cast<T>(word);
    }
}

/// The raw count of a word: negative only in a register of signed numbers.
template <register_value T> [[nodiscard]] constexpr std::int32_t raw_count(std::uint16_t word) noexcept
{
    if constexpr (register_quantity<T>) {
        return from_word<T>(word).count();
    } else {
        return word;
    }
}

/// Whether two references name one register. Not by address: GCC with -fsanitize=undefined does not compare
/// the addresses of two objects in a constant expression.
template <auto const& Left, auto const& Right> inline constexpr bool is_same_register = false;
template <auto const& R> inline constexpr bool is_same_register<R, R> = true;

/// The words that mean something in a register: those that its enumeration lists; without a list, any.
template <register_value T> [[nodiscard]] constexpr std::span<std::uint16_t const> listed_words() noexcept
{
    if constexpr (register_enumeration<T>) {
        return listed_values<T>;
    } else {
        return {};
    }
}

} // namespace detail

/// The type of a register's values.
template <auto const& R> using value_of = typename std::remove_cvref_t<decltype(R)>::value_type;

namespace detail {

/// The register that holds the decimal scale of a form's values.
template <typename T>
concept scaled_form = register_form<T> and requires
{
    T::scale_register;
};

/// Whether a register's values are in steps of another size, which a second register of the same request tells.
template <auto const& R>
inline constexpr bool has_scale_register = scaled_form<typename std::remove_cvref_t<decltype(R)>::form>;

/// Whether a register can be read without a step that the program names.
template <auto const& R> inline constexpr bool has_readable_steps = R.steps_set_by.size() == 0;

/// Whether a register's steps are always the same size.
template <auto const& R> inline constexpr bool has_own_steps = has_readable_steps<R> and not has_scale_register<R>;

} // namespace detail

} // namespace RTUWIRE_BUILD
} // namespace rtuwire
