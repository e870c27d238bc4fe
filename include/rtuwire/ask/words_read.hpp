// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// Reads one register of any kind and width, with the register of its scale where it has one, by one request. With
// ask/access.hpp these have one code for all registers of a kind and width; ask/poller.hpp takes from here how words are read.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

#include <rtuwire/ask/conversation.hpp>
#include <rtuwire/core/bytes.hpp>
#include <rtuwire/core/crc16.hpp>
#include <rtuwire/core/result.hpp>
#include <rtuwire/core/version.hpp>
#include <rtuwire/table/form/form.hpp>
#include <rtuwire/table/table.hpp>
#include <rtuwire/wire/adu.hpp>
#include <rtuwire/wire/errc.hpp>
#include <rtuwire/wire/function.hpp>
#include <rtuwire/wire/registers.hpp>
#include <rtuwire/wire/unit_id.hpp>
#include <rtuwire/wire/views.hpp>

namespace rtuwire {
inline namespace RTUWIRE_BUILD {

namespace detail {

/// The function that reads a kind of registers.
[[nodiscard]] constexpr function_code function_that_reads(register_space space) noexcept
{
    switch (space) {
    case register_space::holding: break;
    case register_space::input: return function_code::read_input_registers;
    case register_space::coil: return function_code::read_coils;
    case register_space::discrete_input: return function_code::read_discrete_inputs;
    }
    return function_code::read_holding_registers;
}

/// The frame that reads `count` registers of a kind from `start` on. All four requests have one form.
[[nodiscard]] constexpr std::array<std::byte, 8> read_frame(unit_id unit, register_space space, std::uint16_t start,
                                                            std::uint16_t count) noexcept
{
    std::array<std::byte, 8> frame{to_byte(unit.byte()), to_byte(to_u8(function_that_reads(space))),
                                   to_byte(start >> 8U), to_byte(start),
                                   to_byte(count >> 8U), to_byte(count)};
    // Byte by byte, as the receiver does: a program needs no other form for it.
    running_crc16<> crc{};
    for (std::size_t i = 0; i < 6; ++i) {
        crc.add(frame[i]);
    }
    frame[6] = to_byte(crc.value());
    frame[7] = to_byte(std::uint32_t{crc.value()} >> 8U);
    return frame;
}

/// The words of a response of any of the four functions, by index; a bit as the word 1 or 0.
class read_words {
public:
    constexpr read_words(byte_view pdu, register_space space) noexcept : pdu_{pdu}, space_{space} {}

    /// Whether the response is of so many registers.
    [[nodiscard]] constexpr bool holds(std::size_t count) const noexcept
    {
        return pdu_.size() == 2 + (is_space_of_bits(space_) ? bytes_of_bits(count) : 2 * count);
    }

    [[nodiscard]] constexpr std::uint16_t operator[](std::size_t index) const noexcept
    {
        if (is_space_of_bits(space_)) {
            return bit_at(pdu_.subspan(2), index) ? std::uint16_t{1} : std::uint16_t{0};
        }
        return u16_at(pdu_, 2 + 2 * index);
    }

private:
    byte_view pdu_;
    register_space space_;
};

/// Reads `Count` registers of a kind as words; the untyped base of `register_read` and `value_read`.
template <register_space Space, std::size_t Count> class words_read : public finite_conversation {
public:
    static constexpr bool keeps_meaning = true;
    static constexpr function_set asks{function_that_reads(Space)};

    /// Reads `Count` registers from `start` on.
    constexpr words_read(unit_id whom, std::uint16_t start) noexcept : frame_{read_frame(whom, Space, start, Count)} {}

    /// Reads once more; it is then no longer settled.
    constexpr void again() noexcept { reopen(); }

    constexpr std::optional<request_frame> next() const& noexcept
    {
        if (settled()) {
            return std::nullopt;
        }
        return request_frame{frame_};
    }
    std::optional<request_frame> next() const&& = delete;

    constexpr void accept(result<response> const& outcome) noexcept
    {
        if (not outcome) {
            return settle(outcome.error());
        }
        read_words const words{outcome->pdu(), Space};
        if (not words.holds(Count)) { // a client has compared it already; others may give a response, too
            return settle(errc::wrong_length);
        }
        for (std::size_t i = 0; i < Count; ++i) {
            words_[i] = words[i];
        }
        settle(errc::none);
    }

protected:
    [[nodiscard]] constexpr std::array<std::uint16_t, Count> const& words() const noexcept { return words_; }

private:
    std::array<std::uint16_t, Count> words_{};
    std::array<std::byte, 8> frame_;
};

/// Reads one holding register as a word, whatever the word stands for.
using word_read = words_read<register_space::holding, 1>;

/// Reads one register of values `T`; `outcome()` then gives the value, or why there is none.
template <register_value T> class register_read : public word_read {
public:
    using word_read::word_read;

    /// The value read, or why there is none; `busy` until it is settled.
    [[nodiscard]] constexpr result<T> outcome() const noexcept
    {
        return error() == errc::none ? result<T>{from_word<T>(words()[0])} : result<T>{error()};
    }
};

/// How many registers one request reads for a value, with those between it and its scale.
template <auto const& R> inline constexpr std::size_t read_count = range_of<R>().last - range_of<R>().first + 1U;

/// Reads the value of one register; `outcome()` gives it, or why there is none: `value_without_meaning` where the
/// register's words are no value of it.
template <auto const& R> class value_read : public words_read<R.space, read_count<R>> {
    static constexpr auto start = static_cast<std::uint16_t>(range_of<R>().first & 0xFFFFU);

public:
    explicit constexpr value_read(unit_id whom) noexcept : words_read<R.space, read_count<R>>{whom, start} {}

    /// The value read, or why there is none; `busy` until it is settled.
    [[nodiscard]] constexpr result<value_of<R>> outcome() const noexcept
    {
        if (this->error() != errc::none) {
            return this->error();
        }
        return value_in<R>(this->words(), static_cast<std::size_t>(R.address - start), scale_place());
    }

private:
    static constexpr std::size_t scale_place() noexcept
    {
        if constexpr (has_scale_register<R>) {
            return static_cast<std::size_t>(std::remove_cvref_t<decltype(R)>::form::scale_register.address - start);
        } else {
            return 0;
        }
    }
};

} // namespace detail

/// Finds out whether a line gives back what is sent: reads one register of a unit and checks whether the request comes back,
/// while it is sent or before the response. On such a line the echo of a function 06 request looks like the response to it, so
/// this is worth one request before the first write. For a client without `has_line_echo`.
class line_echo_probe : public detail::word_read {
public:
    /// Asks this unit for one register.
    explicit constexpr line_echo_probe(unit_id unit) noexcept : detail::word_read{unit, address} {}

    /// Whether the line echoes; `busy` until it is settled. Errors: those of the client, where the unit did not
    /// respond at all. An exception is a response.
    [[nodiscard]] constexpr result<bool> outcome() const noexcept
    {
        errc const wrong = error();
        if (wrong == errc::line_echo) {
            return true;
        }
        if (wrong == errc::none or is_exception(wrong)) {
            return false;
        }
        return wrong;
    }

private:
    /// Any address: an exception is a response, too.
    static constexpr std::uint16_t address = 0x0300;
};

} // namespace RTUWIRE_BUILD
} // namespace rtuwire
