// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// Typed access to the registers of a station. What the device cannot do does not compile. Each call makes a
// conversation of one request, which a client runs; all that depends on the register is folded into the request's
// bytes.
#pragma once

#include <cstddef>
#include <cstdint>

#include <rtuwire/ask/conversation.hpp>
#include <rtuwire/ask/single_request.hpp>
#include <rtuwire/ask/words_read.hpp>
#include <rtuwire/core/result.hpp>
#include <rtuwire/core/version.hpp>
#include <rtuwire/table/device.hpp>
#include <rtuwire/table/form/form_setting.hpp>
#include <rtuwire/table/setting.hpp>
#include <rtuwire/table/table.hpp>
#include <rtuwire/wire/bits.hpp>
#include <rtuwire/wire/errc.hpp>
#include <rtuwire/wire/function.hpp>
#include <rtuwire/wire/registers.hpp>

namespace rtuwire {
inline namespace RTUWIRE_BUILD {

namespace detail {

/// Rejects at compile time, with a message in English, what a device cannot answer.
template <auto const& R, device_type Device> consteval bool is_readable() noexcept
{
    static_assert(has_register<Device, R>, "this device has no such register");
    static_assert(has_scale<Device, R>, "this device lacks the register that holds the scale");
    static_assert(R.space != register_space::holding or implements<Device>(function_code::read_holding_registers),
                  "this device does not implement function 03");
    static_assert(R.space != register_space::input or implements<Device>(function_code::read_input_registers),
                  "this device does not implement function 04");
    static_assert(R.space != register_space::coil or implements<Device>(function_code::read_coils),
                  "this device does not implement function 01");
    static_assert(R.space != register_space::discrete_input or implements<Device>(function_code::read_discrete_inputs),
                  "this device does not implement function 02");
    return true;
}

/// Whether a device answers one request for a register with all its words and its scale.
template <auto const& R, device_type Device> [[nodiscard]] consteval bool is_readable_at_once() noexcept
{
    constexpr key_range range = range_of<R>();
    static_assert(range.is_of_one_space(), "a scale is a register of the same kind");
    return (is_space_of_bits(R.space) or read_count<R> <= Device::limits.read) and
           is_readable_across<Device>(static_cast<std::uint16_t>(range.first & 0xFFFFU),
                                      static_cast<std::uint16_t>(range.last & 0xFFFFU), R.space);
}

} // namespace detail

/// Reads the value of one register of this device, by the function of its kind. All its words, and its scale where
/// another register holds it, are read by one request. The limits of its row are for writing: any word that was read is given.
template <auto const& R, device_type Device> [[nodiscard]] constexpr auto read(station<Device> const& of) noexcept
{
    static_assert(detail::is_readable<R, Device>());
    static_assert(detail::has_readable_steps<R>,
                  "another register sets this register's steps: name them with read_with_step");
    if constexpr (R.is_plain) {
        return detail::register_read<value_of<R>>{of.unit(), R.address};
    } else {
        static_assert(detail::is_readable_at_once<R, Device>(),
                      "this register with all its words and its scale does not fit one request of this device");
        return detail::value_read<R>{of.unit()};
    }
}

/// Reads a register whose steps another register sets; `Step` is what the caller knows them to be.
template <typename Step, auto const& R, device_type Device>
[[nodiscard]] constexpr auto read_with_step(station<Device> const& of) noexcept
{
    static_assert(detail::has_register<Device, R>, "this device has no such register");
    return read<restepped<Step, R>>(of);
}

namespace detail {

/// A write of so many words by function 16.
template <std::size_t Count> using block_write = sized_request<9 + 2 * Count, 5>;

/// The words of settings, one after the other, as they stand on the wire.
template <auto const&... Registers> [[nodiscard]] constexpr auto block_of(setting<Registers> const&... values) noexcept
{
    if constexpr ((register_value<value_of<Registers>> and ...)) {
        return register_block<sizeof...(Registers)>{values.word()...};
    } else {
        register_block<(std::size_t{Registers.word_count} + ...)> block;
        std::size_t at = 0;
        auto const put = [&](auto const& several) {
            for (std::uint16_t const each : several) {
                block.set(at++, each);
            }
        };
        (put(setting_words<Registers>(values)), ...);
        return block;
    }
}

/// Why one of several values does not fit; `none` where all do.
template <typename... Settings> [[nodiscard]] constexpr errc first_error(result<Settings> const&... values) noexcept
{
    errc why = errc::none;
    ((why = why == errc::none ? values.error() : why), ...);
    return why;
}

/// Rejects at compile time, with a message in English, what cannot be written on a device.
template <auto const& R, device_type Device> consteval bool is_writable() noexcept
{
    static_assert(has_register<Device, R>, "this device has no such register");
    static_assert(R.space == register_space::holding or R.space == register_space::coil,
                  "an input register or discrete input is read-only: no function writes it");
    static_assert(R.mode != access::read_only, "this register is read-only");
    static_assert(R.space != register_space::holding or R.word_count <= Device::limits.write,
                  "this register has more words than this device takes in one write");
    return true;
}

/// The request that writes one register: function 06, or 16 with all its words; a coil by 05.
template <auto const& R, device_type Device>
[[nodiscard]] constexpr auto write_of(station<Device> const& to, setting<R> value) noexcept
{
    if constexpr (R.space == register_space::coil) {
        static_assert(implements<Device>(function_code::write_single_coil),
                      "this device does not implement function 05");
        return single_request{to.unit(), write_single_coil{R.address, value.value()}};
    } else if constexpr (R.word_count > 1) {
        static_assert(implements<Device>(function_code::write_multiple_registers),
                      "this device does not implement function 16");
        return block_write<R.word_count>{to.unit(), write_multiple_registers{R.address, block_of<R>(value)}};
    } else {
        static_assert(implements<Device>(function_code::write_single_register),
                      "this device does not implement function 06");
        return single_request{to.unit(), write_single_register{R.address, value.word()}};
    }
}

} // namespace detail

/// Writes one setting, by function 06; one of several words by 16, whole; a coil by 05.
template <auto const& R, device_type Device>
[[nodiscard]] constexpr auto write(station<Device> const& to, setting<R> value) noexcept
{
    static_assert(detail::is_writable<R, Device>());
    static_assert(detail::has_own_steps<R>,
                  "another register sets this register's steps: name them with write_with_step");
    return detail::write_of(to, value);
}

/// Writes a value known only at run time: `write<R>(drive, checked(n * 0.1_s))`. One that the register does not take is
/// not sent, and the outcome says why.
template <auto const& R, device_type Device>
[[nodiscard]] constexpr auto write(station<Device> const& to, result<setting<R>> value) noexcept
{
    using request = decltype(write<R>(to, *value));
    return value ? write<R>(to, *value) : request{value.error()};
}

/// Writes a register whose steps another register sets, as INR does those of an ATV320's ramps; `Step` is what the caller
/// knows them to be. Nothing compares it with what the unit has: with another one the unit takes the count, the outcome is a
/// success, and the value is ten or a hundred times too large or too small. Read that register first: docs/registers.md.
template <typename Step, auto const& R, device_type Device>
[[nodiscard]] constexpr auto write_with_step(station<Device> const& to, setting<restepped<Step, R>> value) noexcept
{
    static_assert(detail::is_writable<R, Device>());
    return detail::write_of(to, value);
}

/// The same, of a value known only at run time.
template <typename Step, auto const& R, device_type Device>
[[nodiscard]] constexpr auto write_with_step(station<Device> const& to,
                                             result<setting<restepped<Step, R>>> value) noexcept
{
    using request = decltype(write_with_step<Step, R>(to, *value));
    return value ? write_with_step<Step, R>(to, *value) : request{value.error()};
}

/// Registers that follow one another without a gap, all of one kind.
template <auto const& First, auto const&... Rest> struct contiguous {
    static constexpr std::size_t count = (std::size_t{First.word_count} + ... + Rest.word_count);
    static constexpr std::uint16_t start = First.address;
    static constexpr register_space space = First.space;

    static constexpr bool are_contiguous() noexcept
    {
        std::uint32_t next = std::uint32_t{First.address} + First.word_count;
        [[maybe_unused]] auto const follows = [&next](std::uint16_t its_address, std::uint16_t its_words) {
            bool const does = its_address == next;
            next += its_words;
            return does;
        };
        return ((Rest.space == First.space and follows(Rest.address, Rest.word_count)) and ...);
    }

    template <typename Device>
    static constexpr bool are_of = detail::has_register<Device, First> and (detail::has_register<Device, Rest> and ...);
};

/// Writes several settings whose registers follow one another, by function 16; coils by 15.
template <auto const&... Registers, device_type Device>
[[nodiscard]] constexpr auto write_all(station<Device> const& to, setting<Registers>... values) noexcept
{
    using registers = contiguous<Registers...>;
    static_assert((detail::is_writable<Registers, Device>() and ...));
    static_assert((detail::has_own_steps<Registers> and ...),
                  "another register sets this register's steps: name them with restepped");
    static_assert(registers::are_contiguous(), "one request writes registers that follow one another");
    if constexpr (registers::space == register_space::coil) {
        static_assert(detail::implements<Device>(function_code::write_multiple_coils),
                      "this device does not implement function 15");
        static_assert(registers::count <= max_bit_write_quantity, "one request writes 1968 coils at most");
        bit_block<registers::count> const bits{values.value()...};
        return detail::sized_request<9 + detail::bytes_of_bits(registers::count), 5>{
            to.unit(), write_multiple_coils{registers::start, bits}};
    } else {
        static_assert(detail::implements<Device>(function_code::write_multiple_registers),
                      "this device does not implement function 16");
        static_assert(registers::count <= Device::limits.write, "this device takes fewer registers in one write");
        return detail::block_write<registers::count>{
            to.unit(), write_multiple_registers{registers::start, detail::block_of<Registers...>(values...)}};
    }
}

/// The same, of values of which some are known only at run time: each is `checked(...)`. Where one does not fit, nothing
/// is sent.
template <auto const&... Registers, device_type Device>
[[nodiscard]] constexpr auto write_all(station<Device> const& to, result<setting<Registers>>... values) noexcept
{
    using request = decltype(write_all<Registers...>(to, *values...));
    errc const why = detail::first_error(values...);
    return why == errc::none ? write_all<Registers...>(to, *values...) : request{why};
}

/// Writes some registers and then reads others, in one request, by function 23. The response's words
/// are in the order of `Read`.
template <typename Read, auto const&... Written, device_type Device>
[[nodiscard]] constexpr auto exchange(station<Device> const& with, setting<Written>... values) noexcept
{
    static_assert(detail::implements<Device>(function_code::read_write_multiple_registers),
                  "this device does not implement function 23");
    static_assert(Read::template are_of<Device>, "this device has no such register");
    static_assert((detail::is_writable<Written, Device>() and ...));
    static_assert((detail::has_own_steps<Written> and ...),
                  "another register sets this register's steps: name them with restepped");
    static_assert(Read::are_contiguous() and contiguous<Written...>::are_contiguous(),
                  "one request exchanges registers that follow one another");
    static_assert(Read::space == register_space::holding and contiguous<Written...>::space == register_space::holding,
                  "function 23 reads and writes holding registers");
    constexpr std::size_t count = contiguous<Written...>::count;
    static_assert(Read::count <= Device::limits.exchange_read and count <= Device::limits.exchange_write,
                  "this device takes fewer registers in one exchange");
    return detail::sized_request<13 + 2 * count, 2 + 2 * Read::count>{
        with.unit(), read_write_multiple_registers{Read::start, Read::count, contiguous<Written...>::start,
                                                   detail::block_of<Written...>(values...)}};
}

/// The same, of values of which some are known only at run time: each is `checked(...)`. Where one does not fit, nothing
/// is sent.
template <typename Read, auto const&... Written, device_type Device>
[[nodiscard]] constexpr auto exchange(station<Device> const& with, result<setting<Written>>... values) noexcept
{
    using request = decltype(exchange<Read, Written...>(with, *values...));
    errc const why = detail::first_error(values...);
    return why == errc::none ? exchange<Read, Written...>(with, *values...) : request{why};
}

} // namespace RTUWIRE_BUILD
} // namespace rtuwire
