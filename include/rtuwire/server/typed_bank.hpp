// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// A server's registers by type: each has its own address, limits and access, which the bank enforces. For a device of
// your own as well as for a drive.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include <rtuwire/core/bytes.hpp>
#include <rtuwire/core/version.hpp>
#include <rtuwire/table/setting.hpp>
#include <rtuwire/table/table.hpp>
#include <rtuwire/wire/errc.hpp>
#include <rtuwire/wire/register_view.hpp>

namespace rtuwire::inline RTUWIRE_BUILD {

/// The values of some registers, initially their factory values (0 where none is known). Exception 02: reading an
/// address without a register, writing one, or writing a read-only register. Exception 03, only if none of the
/// registers written is a case of 02: a value outside its register's limits, or one that the names of its enumeration
/// do not list (`enumerators`; any value is allowed where they are not given). A signed register's words are compared
/// as signed. Nothing is written in part.
template <auto const&... Registers> class bank {
    using registers = table<Registers...>;
    static_assert((has_own_steps<Registers> and ...),
                  "another register sets this register's steps: name them with restepped");
    static constexpr std::size_t none = sizeof...(Registers);

    struct rule {
        std::uint16_t address;
        bool is_writable;
        bool is_signed;
        std::int32_t lowest;
        std::int32_t highest;
        std::span<std::uint16_t const> listed;
        count_range gap;
    };

    template <auto const& R>
    static constexpr rule rule_of{
        R.address, R.mode != access::read_only, lowest<R>() < 0, lowest<R>(), highest<R>(), listed_words<value_of<R>>(),
        R.gap};
    static constexpr std::array<rule, none> rules{rule_of<Registers>...};

public:
    /// Whether a register is one of this bank's.
    template <auto const& R> static constexpr bool contains = registers::template contains<R>;

    /// The value of a register.
    template <auto const& R> [[nodiscard]] constexpr value_of<R> get() const noexcept
    {
        static_assert(registers::template contains<R>, "this bank has no such register");
        return from_word<value_of<R>>(words_[place_of(R.address)]);
    }

    /// Sets a register from the device's own side, also where a client may only read it.
    template <auto const& R> constexpr void set(value_of<R> value) noexcept
    {
        static_assert(registers::template contains<R>, "this bank has no such register");
        words_[place_of(R.address)] = to_word(value);
    }

    /// Whether a client has written a register since the last call.
    template <auto const& R> [[nodiscard]] constexpr bool take_written() noexcept
    {
        static_assert(registers::template contains<R>, "this bank has no such register");
        bool const was = is_written_[place_of(R.address)];
        is_written_[place_of(R.address)] = false;
        return was;
    }

    [[nodiscard]] constexpr errc check_read(std::uint16_t start, std::size_t count) const noexcept
    {
        for (std::size_t i = 0; i < count; ++i) {
            if (place_after(start, i) == none) {
                return errc::illegal_data_address;
            }
        }
        return errc::none;
    }

    [[nodiscard]] constexpr errc check_write(std::uint16_t start, register_view values) const noexcept
    {
        for (std::size_t i = 0; i < values.size(); ++i) {
            std::size_t const place = place_after(start, i);
            if (place == none or not rules[place].is_writable) {
                return errc::illegal_data_address;
            }
        }
        for (std::size_t i = 0; i < values.size(); ++i) {
            if (not fits(rules[place_after(start, i)], values[i])) {
                return errc::illegal_data_value;
            }
        }
        return errc::none;
    }

    constexpr errc read(std::uint16_t start, std::size_t count, byte_writer& out) noexcept
    {
        for (std::size_t i = 0; i < count; ++i) {
            out.u16(words_[place_after(start, i)]);
        }
        return errc::none;
    }

    constexpr errc write(std::uint16_t start, register_view values) noexcept
    {
        for (std::size_t i = 0; i < values.size(); ++i) {
            std::size_t const place = place_after(start, i);
            words_[place] = values[i];
            is_written_[place] = true;
        }
        return errc::none;
    }

private:
    static constexpr std::size_t place_of(std::uint32_t address) noexcept
    {
        std::size_t place = 0;
        while (place < none and rules[place].address != address) {
            ++place;
        }
        return place;
    }

    static constexpr std::size_t place_after(std::uint16_t start, std::size_t offset) noexcept
    {
        return place_of(std::uint32_t{start} + static_cast<std::uint32_t>(offset));
    }

    static constexpr bool fits(rule const& limits, std::uint16_t word) noexcept
    {
        std::int32_t const raw = limits.is_signed ? std::int32_t{static_cast<std::int16_t>(word)} : std::int32_t{word};
        return raw >= limits.lowest and raw <= limits.highest and not limits.gap.contains(raw) and
               has_meaning(limits.listed, word);
    }

    std::array<std::uint16_t, none> words_{static_cast<std::uint16_t>(Registers.factory.value_or(0))...};
    std::array<bool, none> is_written_{};
};

} // namespace rtuwire
