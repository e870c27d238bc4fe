// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// What makes a device a drive: where its words are, its references, its scanner, its cycle, and that its table has
// these registers. What a device lacks is said in a sentence each.
#pragma once

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <type_traits>

#include <rtuwire/altivar/device/cycle_registers.hpp>
#include <rtuwire/altivar/device/drive_layout.hpp>
#include <rtuwire/core/version.hpp>
#include <rtuwire/table/device.hpp>

namespace rtuwire {
inline namespace RTUWIRE_BUILD {
namespace detail {

/// What a drive has to say, each part for itself.
template <typename T>
concept has_layout = std::convertible_to<decltype(T::layout), altivar::drive_layout>;
template <typename T>
concept has_speed_reference = register_quantity<value_of<T::speed_reference>>;
template <typename T>
concept has_frequency_reference = register_quantity<value_of<T::frequency_reference>>;
template <typename T>
concept has_scanner_registers = std::convertible_to<decltype(T::scanner), altivar::scanner_registers>;
template <typename T>
concept has_cycle = std::convertible_to<decltype(T::cycle), altivar::cycle_registers>;
template <typename T>
concept has_drive_parts = has_layout<T> and has_speed_reference<T> and has_frequency_reference<T> and
    has_scanner_registers<T> and has_cycle<T>;
template <typename T>
concept has_all_parts = device_type<T> and has_drive_parts<T>;

/// Whether the table of a device has a register at an address; `if_any`: or there is none, which is address 0.
template <typename T> [[nodiscard]] constexpr bool has_at(std::uint16_t address) noexcept
{
    return T::registers::has_address(address);
}
template <typename T> [[nodiscard]] constexpr bool has_if_any(std::uint16_t address) noexcept
{
    return address == 0 or has_at<T>(address);
}

template <typename T> [[nodiscard]] constexpr bool has_every_safeguard() noexcept
{
    altivar::safeguard_layout const& at = T::layout.safeguards;
    return has_if_any<T>(at.sll) and has_if_any<T>(at.tto) and has_if_any<T>(at.chcf) and has_if_any<T>(at.cd1) and
           has_if_any<T>(at.fr1) and has_if_any<T>(at.flo) and has_if_any<T>(at.atr) and has_if_any<T>(at.dotd) and
           has_if_any<T>(at.inputs) and has_if_any<T>(at.tcc);
}

/// Whether it may stop by itself: by the registers that say so, or after a time that is fixed.
template <typename T> [[nodiscard]] constexpr bool has_timeout() noexcept
{
    altivar::safeguard_layout const& at = T::layout.safeguards;
    return (at.sll != 0 and at.tto != 0) or
           (at.fixed_timeout != duration{} and at.fixed_timeout <= T::layout.longest_silence);
}

template <typename T> [[nodiscard]] constexpr bool has_every_scanner_register() noexcept
{
    altivar::scanner_registers const& at = T::scanner;
    bool has_all = true;
    for (std::size_t i = 0; i < at.words; ++i) {
        for (std::uint16_t const first : {at.input_addresses, at.output_addresses, at.input_words, at.output_words}) {
            has_all = has_all and has_at<T>(static_cast<std::uint16_t>(first + i));
        }
    }
    return has_all;
}

template <typename T> [[nodiscard]] constexpr bool takes_its_cycle() noexcept
{
    bool const is_one = T::cycle.by == function_code::read_write_multiple_registers;
    bool const is_known = is_one or T::cycle.by == function_code::write_multiple_registers;
    std::size_t const read = is_one ? T::limits.exchange_read : T::limits.read;
    std::size_t const write = is_one ? T::limits.exchange_write : T::limits.write;
    return is_known and implements<T>(T::cycle.by) and T::cycle.reads.size() <= read and
           T::cycle.writes.size() <= write;
}

/// What a drive fulfils beside its parts. Of a device that lacks one, only that is said.
template <typename T> struct drive_conditions {
    static constexpr bool control_word = true, status_word = true, last_fault = true, extended_words = true,
                          output_frequency = true, references = true, safeguards = true, supervised = true,
                          checked = true, scanner = true, single_functions = true, cycle_reads_the_state = true,
                          cycle_writes_an_order = true, cycle_is_contiguous = true, cycle_fits_the_scanner = true,
                          cycle_fits_its_function = true;
};
template <has_all_parts T> struct drive_conditions<T> {
    static constexpr bool control_word = has_at<T>(T::layout.cmd);
    static constexpr bool status_word = has_at<T>(T::layout.eta);
    static constexpr bool last_fault = has_at<T>(T::layout.lft);
    static constexpr bool extended_words = has_at<T>(T::layout.cmi) and has_at<T>(T::layout.eti);
    static constexpr bool output_frequency = has_at<T>(T::layout.rfr);
    static constexpr bool references = has_register<T, T::speed_reference> and has_register<T, T::frequency_reference>;
    static constexpr bool safeguards = has_every_safeguard<T>();
    static constexpr bool supervised = has_timeout<T>();
    static constexpr bool checked = T::layout.checked == altivar::drive_layout::checked_of(T::layout);
    static constexpr bool scanner = has_every_scanner_register<T>();
    static constexpr bool single_functions =
        implements<T>(function_code::read_holding_registers) and implements<T>(function_code::write_single_register);
    static constexpr bool cycle_reads_the_state =
        T::cycle.reads.has(T::layout.eta) and T::cycle.reads.has(T::cycle.speed);
    static constexpr bool cycle_writes_an_order =
        T::cycle.writes.has(T::layout.cmd) and
        T::cycle.writes.has(T::speed_reference.address) != T::cycle.writes.has(T::frequency_reference.address);
    static constexpr bool cycle_is_contiguous =
        T::cycle.by_scanner or
        (T::cycle.reads.follow_one_another() and T::cycle.writes.follow_one_another() and T::cycle.writes.size() == 2);
    static constexpr bool cycle_fits_the_scanner =
        not T::cycle.by_scanner or
        (T::cycle.reads.size() <= T::scanner.words and T::cycle.writes.size() <= T::scanner.words);
    static constexpr bool cycle_fits_its_function = takes_its_cycle<T>();

    static constexpr bool all = control_word and status_word and last_fault and extended_words and output_frequency and
                                references and safeguards and checked and scanner and single_functions and
                                cycle_reads_the_state and cycle_writes_an_order and cycle_is_contiguous and
                                cycle_fits_the_scanner and cycle_fits_its_function;
};

/// Whether a device is asked by its own address: a reserved one reaches whatever hangs on the line.
template <typename T>
concept has_address_of_its_own = T::units.last <= 247;

} // namespace detail

namespace altivar {

/// Whether each of its rows says what the drive says of its register: parameters/row_demands.hpp, where it has any.
/// Internal.
template <typename T> inline constexpr bool has_rows_with_roles = true;

/// A device that is a drive. Where one is not, `drive_check` says in words what is missing.
template <typename T>
concept drive_type =
    detail::has_all_parts<T> and detail::drive_conditions<T>::all and detail::has_address_of_its_own<T>;

/// Stops the compiler at a device that is no drive, with a sentence for what it lacks. Whatever drives a motor does so;
/// a file that describes a drive ends best with `static_assert(drive_check<device>::passed)`.
template <typename T> struct drive_check {
    using found = detail::drive_conditions<T>;

    static_assert(detail::has_layout<T>, "a drive says where its words are: `static constexpr drive_layout layout`");
    static_assert(detail::has_speed_reference<T>, "a drive has a register for its speed: `static constexpr auto const& "
                                                  "speed_reference = lfrd`");
    static_assert(detail::has_frequency_reference<T>,
                  "a drive has a register for its frequency: `static constexpr auto const& "
                  "frequency_reference = lfr`");
    static_assert(detail::has_scanner_registers<T>,
                  "a drive says where its scanner is, or that it has none: `static constexpr "
                  "scanner_registers scanner{}`");
    static_assert(detail::has_cycle<T>, "a drive says what its cycle moves: `static constexpr cycle_registers cycle`");
    static_assert(found::control_word, "the control word, layout.cmd, is in no register of the drive's table");
    static_assert(found::status_word, "the status word, layout.eta, is in no register of the drive's table");
    static_assert(found::last_fault, "the last fault, layout.lft, is in no register of the drive's table");
    static_assert(found::extended_words, "an extended word, layout.cmi or layout.eti, is in no register of the drive's "
                                         "table");
    static_assert(found::output_frequency, "the output frequency, layout.rfr, is in no register of the drive's table");
    static_assert(found::references, "a reference of the drive is no register of its table");
    static_assert(found::safeguards, "an address in layout.safeguards is in no register of the drive's table; 0 says "
                                     "that the drive has none");
    static_assert(found::supervised, "a drive stops by itself where its line goes silent: by layout.safeguards.sll and "
                                     ".tto, or by .fixed_timeout, which longest_silence covers");
    static_assert(found::checked, "a layout that was changed has other registers to check: set layout.checked to "
                                  "drive_layout::checked_of(layout)");
    static_assert(found::scanner, "the drive's table lacks registers of its scanner");
    static_assert(found::single_functions, "a drive has functions 03 and 06: its start and its stop use them");
    static_assert(found::cycle_reads_the_state, "a cycle reads the status word, layout.eta, and cycle.speed");
    static_assert(found::cycle_writes_an_order,
                  "a cycle writes the control word, layout.cmd, and one of the references");
    static_assert(found::cycle_is_contiguous,
                  "a cycle without a scanner reads addresses that follow one another, and writes "
                  "two: the control word and a reference");
    static_assert(found::cycle_fits_the_scanner, "a cycle moves more words than the drive's scanner has");
    static_assert(found::cycle_fits_its_function,
                  "a cycle moves its words by function 23 or 16, which the drive has and "
                  "whose limits they keep");
    static_assert(detail::has_address_of_its_own<T>,
                  "a drive is asked at 1 to 247, never at a reserved address: `units`");
    static_assert(has_rows_with_roles<T>, "a row at a register that commands the drive, tells its state or safeguards "
                                          "it lacks the role of that, and would be restored as what it is not: "
                                          "&commands, &setpoint, &link_loss; of LSP and HSP, &speed_limit ...");

    static constexpr bool passed = drive_type<T>;
    static constexpr drive_layout const& layout = T::layout;
};

/// The same for what every order has: where all parts are there, it leaves the price of the whole check to the order.
/// Internal.
struct parts_are_there {
    static constexpr bool passed = true;
};
/// Internal.
template <typename T>
using parts_check = std::conditional_t<detail::has_drive_parts<T>, parts_are_there, drive_check<T>>;

/// What it does in a simulation besides.
/// Internal.
template <typename T>
inline constexpr simulated_behaviour behaviour_of = [] {
    if constexpr (requires { T::behaviour; }) {
        return T::behaviour;
    } else {
        return simulated_behaviour{};
    }
}();

} // namespace altivar
} // namespace RTUWIRE_BUILD
} // namespace rtuwire
