// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// What a server serves: what a bank of registers is, and the plain ones, of words and of bits. A bank that offers coils or
// discrete inputs has a function `coils()` or `discrete_inputs()` that returns a bank of bits; for functions 01, 02, 05
// and 15.
#pragma once

#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>

#include <rtuwire/core/bytes.hpp>
#include <rtuwire/core/result.hpp>
#include <rtuwire/core/version.hpp>
#include <rtuwire/wire/errc.hpp>
#include <rtuwire/wire/function.hpp>
#include <rtuwire/wire/views.hpp>

namespace rtuwire {
inline namespace RTUWIRE_BUILD {

/// Registers that can be checked before they are accessed. `check_read` and `check_write` change nothing and return
/// none, `illegal_data_address` or `illegal_data_value`; `read` appends `count` words and `write` stores all values,
/// after the check of the same range returned none. Their error is `server_device_failure` or any other exception. A
/// request may name a range that runs past address 65535: the checks refuse it with `illegal_data_address` and do not
/// wrap to 0.
template <typename T>
concept register_bank = requires(T& bank, T const& constant, std::uint16_t start, std::size_t count,
                                 register_view values, byte_writer& out)
{
    {
        constant.check_read(start, count)
        } -> std::same_as<errc>;
    {
        constant.check_write(start, values)
        } -> std::same_as<errc>;
    {
        bank.read(start, count, out)
        } -> std::same_as<errc>;
    {
        bank.write(start, values)
        } -> std::same_as<errc>;
};

/// `Count` plain words from address `first` on, up to 65535, all readable and writable. A range that is not
/// wholly inside is `illegal_data_address`.
template <std::size_t Count> class word_bank {
    static_assert(Count > 0 and Count <= 0x1'0000, "a bank holds 1 to 65536 registers");

public:
    /// Words from address 0, all zero.
    constexpr word_bank() noexcept = default;

    /// Words from address `first`, all zero. Those past address 65535 are never reached.
    explicit constexpr word_bank(std::uint16_t its_first) noexcept : first_{its_first} {}

    /// Whether a register exists.
    [[nodiscard]] constexpr bool contains(std::uint16_t address) const noexcept { return holds(address, 1); }

    /// The word at an address that the bank contains; 0 elsewhere.
    [[nodiscard]] constexpr std::uint16_t get(std::uint16_t address) const noexcept
    {
        return contains(address) ? words_[offset(address)] : std::uint16_t{0};
    }

    /// Replaces the word at an address; `illegal_data_address` where the bank has none.
    constexpr result<void> set(std::uint16_t address, std::uint16_t value) noexcept
    {
        if (not contains(address)) {
            return errc::illegal_data_address;
        }
        words_[offset(address)] = value;
        return {};
    }

    /// Whether all of these registers exist; `count` may be any number.
    [[nodiscard]] constexpr errc check_read(std::uint16_t start, std::size_t count) const noexcept
    {
        return holds(start, count) ? errc::none : errc::illegal_data_address;
    }

    /// The same for registers to be written; every value is allowed.
    [[nodiscard]] constexpr errc check_write(std::uint16_t start, register_view values) const noexcept
    {
        return check_read(start, values.size());
    }

    /// Appends words that `check_read` allows; where `out` has no room, appends none and returns
    /// `server_device_failure`.
    constexpr errc read(std::uint16_t start, std::size_t count, byte_writer& out) noexcept
    {
        std::byte* at = out.take(2 * count);
        if (at == nullptr) {
            return errc::server_device_failure;
        }
        std::uint16_t const* word = words_.data() + offset(start);
        for (; count > 0; --count) {
            detail::put_u16(at, *word++);
            at += 2;
        }
        return errc::none;
    }

    /// Stores words that `check_write` allows.
    constexpr errc write(std::uint16_t start, register_view values) noexcept
    {
        for (std::size_t i = 0; i < values.size(); ++i) {
            words_[offset(start) + i] = values[i];
        }
        return errc::none;
    }

private:
    constexpr std::uint32_t offset(std::uint16_t address) const noexcept { return std::uint32_t{address} - first_; }

    constexpr bool holds(std::uint16_t start, std::size_t count) const noexcept
    {
        return start >= first_ and detail::is_address_range(start, count) and count + offset(start) <= Count;
    }

    std::uint16_t first_{0};
    std::array<std::uint16_t, Count> words_{};
};

/// `Count` bits from address `first` on, up to 65535, all writable where a function writes them. A range that is not
/// wholly inside is `illegal_data_address`.
template <std::size_t Count> class bit_bank {
    static_assert(Count > 0 and Count <= 0x1'0000, "a bank holds 1 to 65536 bits");

public:
    /// Bits from address 0, all off.
    constexpr bit_bank() noexcept = default;

    /// Bits from address `first`, all off. Those past address 65535 are never reached.
    explicit constexpr bit_bank(std::uint16_t first) noexcept : first_{first} {}

    /// Whether a bit exists.
    [[nodiscard]] constexpr bool contains(std::uint16_t address) const noexcept { return holds(address, 1); }

    /// The bit at an address that the bank contains; false elsewhere.
    [[nodiscard]] constexpr bool get(std::uint16_t address) const noexcept
    {
        return contains(address) and detail::bit_at(bytes_, offset(address));
    }

    /// Switches the bit at an address; `illegal_data_address` where the bank has none.
    constexpr result<void> set(std::uint16_t address, bool value) noexcept
    {
        if (not contains(address)) {
            return errc::illegal_data_address;
        }
        detail::put_bit(bytes_, offset(address), value);
        return {};
    }

    /// Whether all of these bits exist; `count` may be any number.
    [[nodiscard]] constexpr errc check_read(std::uint16_t start, std::size_t count) const noexcept
    {
        return holds(start, count) ? errc::none : errc::illegal_data_address;
    }

    /// The same for bits to be written.
    [[nodiscard]] constexpr errc check_write(std::uint16_t start, bit_view values) const noexcept
    {
        return check_read(start, values.size());
    }

    /// Puts bits that `check_read` allows, and no others, into `out`, which has room for them and is 0.
    constexpr errc read(std::uint16_t start, std::size_t count, byte_span out) noexcept
    {
        detail::copy_bits(out, 0, bytes_, offset(start), count);
        return errc::none;
    }

    /// Stores bits that `check_write` allows.
    constexpr errc write(std::uint16_t start, bit_view values) noexcept
    {
        detail::copy_bits(bytes_, offset(start), values.bytes(), 0, values.size());
        return errc::none;
    }

private:
    constexpr std::uint32_t offset(std::uint16_t address) const noexcept { return std::uint32_t{address} - first_; }

    constexpr bool holds(std::uint16_t start, std::size_t count) const noexcept
    {
        return start >= first_ and detail::is_address_range(start, count) and count + offset(start) <= Count;
    }

    std::uint16_t first_{0};
    std::array<std::byte, detail::bytes_of_bits(Count)> bytes_{};
};

} // namespace RTUWIRE_BUILD
} // namespace rtuwire
