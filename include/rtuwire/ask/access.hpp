// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// Typed access to the registers of a station. What the device cannot do does not compile. Each call makes a
// conversation of one request, which a client runs; all that depends on the register is folded into the request's
// bytes.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

#include <rtuwire/ask/conversation.hpp>
#include <rtuwire/ask/finite_conversation.hpp>
#include <rtuwire/ask/single_request.hpp>
#include <rtuwire/core/result.hpp>
#include <rtuwire/core/version.hpp>
#include <rtuwire/table/device.hpp>
#include <rtuwire/table/setting.hpp>
#include <rtuwire/wire/pdu/read_holding_registers.hpp>
#include <rtuwire/wire/pdu/read_write_multiple_registers.hpp>
#include <rtuwire/wire/pdu/write_multiple_registers.hpp>
#include <rtuwire/wire/pdu/write_single_register.hpp>

namespace rtuwire::inline RTUWIRE_BUILD {

/// Reads one register as a word, whatever the word stands for; the untyped base of `register_read`.
/// Internal.
class word_read : public finite_conversation {
public:
    constexpr word_read(unit_id unit, std::uint16_t address) noexcept
    {
        static_cast<void>(encode_into(frame_, unit, read_holding_registers{address, 1}));
    }

    /// Reads once more; it is then no longer settled.
    constexpr void begin() noexcept { reopen(); }

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
        constexpr std::size_t size_of_one = 4;
        if (not outcome) {
            return settle(outcome.error());
        }
        byte_view const pdu = outcome->pdu();
        if (pdu.size() != size_of_one) {
            return settle(errc::wrong_length);
        }
        word_ = u16_at(pdu, 2);
        settle(errc::none);
    }

    /// The word read, or why there is none; `busy` until it is settled.
    [[nodiscard]] constexpr result<std::uint16_t> word() const noexcept
    {
        return error() == errc::none ? result<std::uint16_t>{word_} : error();
    }

private:
    // Not a result, which GCC copies by memcpy where it optimises for size: 60 bytes of a program that
    // has no other use for it.
    std::uint16_t word_{0};
    std::array<std::byte, 8> frame_{}; ///< behind the word it is aligned, which saves 150 bytes on a Cortex-M0+
};

/// Reads one register of values `T`; `outcome()` then gives the value, or why there is none.
/// Internal.
template <register_value T> class register_read : public word_read {
public:
    using word_read::word_read;

    /// The value read, or why there is none; `busy` until it is settled.
    [[nodiscard]] constexpr result<T> outcome() const noexcept
    {
        return word() ? result<T>{from_word<T>(*word())} : result<T>{word().error()};
    }
};

/// Reads the value of one register of this device.
template <auto const& R, device_type Device> [[nodiscard]] constexpr auto read(station<Device> const& of) noexcept
{
    static_assert(has_register<Device, R>, "this device has no such register");
    static_assert(implements<Device>(function_code::read_holding_registers),
                  "this device does not implement function 03");
    static_assert(has_own_steps<R>, "another register sets this register's steps: name them with read_with_step");
    return register_read<value_of<R>>{of.unit(), R.address};
}

/// Reads a register whose steps another register sets; `Step` is what the caller knows them to be.
template <typename Step, auto const& R, device_type Device>
[[nodiscard]] constexpr auto read_with_step(station<Device> const& of) noexcept
{
    static_assert(has_register<Device, R>, "this device has no such register");
    static_assert(implements<Device>(function_code::read_holding_registers),
                  "this device does not implement function 03");
    return register_read<Step>{of.unit(), R.address};
}

/// Rejects at compile time, with a message in English, what cannot be written on a device.
/// Internal.
template <auto const& R, device_type Device> consteval bool is_writable() noexcept
{
    static_assert(has_register<Device, R>, "this device has no such register");
    static_assert(R.mode != access::read_only, "this register is read-only");
    return true;
}

/// Writes one setting, by function 06.
template <auto const& R, device_type Device>
[[nodiscard]] constexpr auto write(station<Device> const& to, setting<R> value) noexcept
{
    static_assert(is_writable<R, Device>());
    static_assert(has_own_steps<R>, "another register sets this register's steps: name them with write_with_step");
    static_assert(implements<Device>(function_code::write_single_register),
                  "this device does not implement function 06");
    return single_request{to.unit(), write_single_register{R.address, value.word()}};
}

/// Writes a value known only at run time: `write<R>(drive, checked(n * 0.1_s))`. One that the register does not take is
/// not sent, and the outcome says why.
template <auto const& R, device_type Device>
[[nodiscard]] constexpr auto write(station<Device> const& to, result<setting<R>> value) noexcept
{
    return value ? write<R>(to, *value) : single_request<write_single_register>{value.error()};
}

/// Writes a register whose steps another register sets; `Step` is what the caller knows them to be.
template <typename Step, auto const& R, device_type Device>
[[nodiscard]] constexpr auto write_with_step(station<Device> const& to, setting<restepped<Step, R>> value) noexcept
{
    static_assert(is_writable<R, Device>());
    static_assert(implements<Device>(function_code::write_single_register),
                  "this device does not implement function 06");
    return single_request{to.unit(), write_single_register{R.address, value.word()}};
}

/// The same, of a value known only at run time.
template <typename Step, auto const& R, device_type Device>
[[nodiscard]] constexpr auto write_with_step(station<Device> const& to,
                                             result<setting<restepped<Step, R>>> value) noexcept
{
    return value ? write_with_step<Step, R>(to, *value) : single_request<write_single_register>{value.error()};
}

/// Registers that follow one another without a gap.
template <auto const& First, auto const&... Rest> struct contiguous {
    static constexpr std::size_t count = 1 + sizeof...(Rest);
    static constexpr std::uint16_t start = First.address;

    static constexpr bool are_contiguous() noexcept
    {
        std::uint32_t next = First.address;
        return ((Rest.address == ++next) and ...);
    }

    template <typename Device>
    static constexpr bool are_of = has_register<Device, First> and (has_register<Device, Rest> and ...);
};

/// Writes several settings whose registers follow one another, by function 16.
template <auto const&... Registers, device_type Device>
[[nodiscard]] constexpr auto write_all(station<Device> const& to, setting<Registers>... values) noexcept
{
    static_assert((is_writable<Registers, Device>() and ...));
    static_assert((has_own_steps<Registers> and ...),
                  "another register sets this register's steps: name them with restepped");
    static_assert(contiguous<Registers...>::are_contiguous(), "one request writes registers that follow one another");
    static_assert(implements<Device>(function_code::write_multiple_registers),
                  "this device does not implement function 16");
    static_assert(sizeof...(Registers) <= Device::limits.write, "this device takes fewer registers in one write");
    register_block<sizeof...(Registers)> const words{values.word()...};
    return sized_request<9 + 2 * sizeof...(Registers), 5>{
        to.unit(), write_multiple_registers{contiguous<Registers...>::start, words}};
}

/// The same, of values of which some are known only at run time: each is `checked(...)`. Where one does not fit, nothing
/// is sent.
template <auto const&... Registers, device_type Device>
[[nodiscard]] constexpr auto write_all(station<Device> const& to, result<setting<Registers>>... values) noexcept
{
    using request = decltype(write_all<Registers...>(to, *values...));
    errc why = errc::none;
    ((why = why == errc::none ? values.error() : why), ...);
    return why == errc::none ? write_all<Registers...>(to, *values...) : request{why};
}

/// Writes some registers and then reads others, in one request, by function 23. The response's words
/// are in the order of `Read`.
template <typename Read, auto const&... Written, device_type Device>
[[nodiscard]] constexpr auto exchange(station<Device> const& with, setting<Written>... values) noexcept
{
    static_assert(implements<Device>(function_code::read_write_multiple_registers),
                  "this device does not implement function 23");
    static_assert(Read::template are_of<Device>, "this device has no such register");
    static_assert((is_writable<Written, Device>() and ...));
    static_assert((has_own_steps<Written> and ...),
                  "another register sets this register's steps: name them with restepped");
    static_assert(Read::are_contiguous() and contiguous<Written...>::are_contiguous(),
                  "one request exchanges registers that follow one another");
    static_assert(Read::count <= Device::limits.exchange_read and sizeof...(Written) <= Device::limits.exchange_write,
                  "this device takes fewer registers in one exchange");
    register_block<sizeof...(Written)> const words{values.word()...};
    return sized_request<13 + 2 * sizeof...(Written), 2 + 2 * Read::count>{
        with.unit(), read_write_multiple_registers{Read::start, Read::count, contiguous<Written...>::start, words}};
}

} // namespace rtuwire
