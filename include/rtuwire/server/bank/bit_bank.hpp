// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// Coils or discrete inputs of a server. A bank that offers them has a function `coils()` or `discrete_inputs()` that
// returns such a bank of bits; for functions 01, 02, 05 and 15.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include <rtuwire/core/result.hpp>
#include <rtuwire/core/version.hpp>
#include <rtuwire/wire/bit_view.hpp>
#include <rtuwire/wire/errc.hpp>
#include <rtuwire/wire/limits.hpp>

namespace rtuwire::inline RTUWIRE_BUILD {

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
        return contains(address) and bit_at(bytes_, offset(address));
    }

    /// Switches the bit at an address; `illegal_data_address` where the bank has none.
    constexpr result<void> set(std::uint16_t address, bool value) noexcept
    {
        if (not contains(address)) {
            return errc::illegal_data_address;
        }
        put_bit(bytes_, offset(address), value);
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
        copy_bits(out, 0, bytes_, offset(start), count);
        return errc::none;
    }

    /// Stores bits that `check_write` allows.
    constexpr errc write(std::uint16_t start, bit_view values) noexcept
    {
        copy_bits(bytes_, offset(start), values.bytes(), 0, values.size());
        return errc::none;
    }

private:
    constexpr std::uint32_t offset(std::uint16_t address) const noexcept { return std::uint32_t{address} - first_; }

    constexpr bool holds(std::uint16_t start, std::size_t count) const noexcept
    {
        return start >= first_ and is_address_range(start, count) and count + offset(start) <= Count;
    }

    std::uint16_t first_{0};
    std::array<std::byte, bytes_of_bits(Count)> bytes_{};
};

} // namespace rtuwire
