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
namespace altivar {

/// What a drive has to say, each part for itself.
/// Internal.
template <typename T>
concept has_layout = std::convertible_to<decltype(T::layout), drive_layout>;
/// Internal.
template <typename T>
concept has_speed_reference = detail::register_quantity<value_of<T::speed_reference>>;
/// Internal.
template <typename T>
concept has_frequency_reference = detail::register_quantity<value_of<T::frequency_reference>>;
/// Internal.
template <typename T>
concept has_scanner_registers = std::convertible_to<decltype(T::scanner), scanner_registers>;
/// Internal.
template <typename T>
concept has_cycle = std::convertible_to<decltype(T::cycle), cycle_registers>;
/// Internal.
template <typename T>
concept has_drive_parts = has_layout<T> and has_speed_reference<T> and has_frequency_reference<T> and
    has_scanner_registers<T> and has_cycle<T>;
/// Internal.
template <typename T>
concept has_all_parts = device_type<T> and has_drive_parts<T>;

/// Whether the table of a device has a register at an address; `if_any`: or there is none, which is address 0.
/// Internal.
template <typename T> [[nodiscard]] constexpr bool has_at(std::uint16_t address) noexcept
{
    return T::registers::has_address(address);
}
/// Internal.
template <typename T> [[nodiscard]] constexpr bool has_if_any(std::uint16_t address) noexcept
{
    return address == 0 or has_at<T>(address);
}

/// Registers that its parts name.
/// Internal.
template <typename T>
concept has_control_word = not has_all_parts<T> or has_at<T>(T::layout.cmd);
/// Internal.
template <typename T>
concept has_status_word = not has_all_parts<T> or has_at<T>(T::layout.eta);
/// Internal.
template <typename T>
concept has_last_fault = not has_all_parts<T> or has_at<T>(T::layout.lft);
/// Internal.
template <typename T>
concept has_extended_words = not has_all_parts<T> or (has_at<T>(T::layout.cmi) and has_at<T>(T::layout.eti));
/// Internal.
template <typename T>
concept has_output_frequency = not has_all_parts<T> or has_at<T>(T::layout.rfr);
/// Internal.
template <typename T>
concept has_its_references = not has_all_parts<T> or (detail::has_register<T, T::speed_reference> and
                                                      detail::has_register<T, T::frequency_reference>);

/// Internal.
template <typename T> [[nodiscard]] constexpr bool has_every_safeguard() noexcept
{
    safeguard_layout const& at = T::layout.safeguards;
    return has_if_any<T>(at.sll) and has_if_any<T>(at.tto) and has_if_any<T>(at.chcf) and has_if_any<T>(at.cd1) and
           has_if_any<T>(at.fr1) and has_if_any<T>(at.flo) and has_if_any<T>(at.atr) and has_if_any<T>(at.dotd) and
           has_if_any<T>(at.inputs) and has_if_any<T>(at.tcc);
}
/// Internal.
template <typename T>
concept has_its_safeguards = not has_all_parts<T> or has_every_safeguard<T>();

/// Whether it may stop by itself: by the registers that say so, or after a time that is fixed.
/// Internal.
template <typename T> [[nodiscard]] constexpr bool has_timeout() noexcept
{
    safeguard_layout const& at = T::layout.safeguards;
    return (at.sll != 0 and at.tto != 0) or
           (at.fixed_timeout != duration{} and at.fixed_timeout <= T::layout.longest_silence);
}
/// Internal.
template <typename T>
concept is_supervised = not has_all_parts<T> or has_timeout<T>();

/// Internal.
template <typename T> [[nodiscard]] constexpr bool has_every_scanner_register() noexcept
{
    scanner_registers const& at = T::scanner;
    bool has_all = true;
    for (std::size_t i = 0; i < at.words; ++i) {
        for (std::uint16_t const first : {at.input_addresses, at.output_addresses, at.input_words, at.output_words}) {
            has_all = has_all and has_at<T>(static_cast<std::uint16_t>(first + i));
        }
    }
    return has_all;
}
/// Internal.
template <typename T>
concept has_its_scanner = not has_all_parts<T> or has_every_scanner_register<T>();

/// Functions that orders, stops and checks use.
/// Internal.
template <typename T>
concept has_single_functions = not has_all_parts<T> or (detail::implements<T>(function_code::read_holding_registers) and
                                                        detail::implements<T>(function_code::write_single_register));

/// What its cycle moves.
/// Internal.
template <typename T>
concept cycle_reads_the_state =
    not has_all_parts<T> or (T::cycle.reads.has(T::layout.eta) and T::cycle.reads.has(T::cycle.speed));
/// Internal.
template <typename T>
concept cycle_writes_an_order =
    not has_all_parts<T> or
    (T::cycle.writes.has(T::layout.cmd) and
     T::cycle.writes.has(T::speed_reference.address) != T::cycle.writes.has(T::frequency_reference.address));
/// Internal.
template <typename T>
concept cycle_is_contiguous =
    not has_all_parts<T> or T::cycle.by_scanner or
    (T::cycle.reads.follow_one_another() and T::cycle.writes.follow_one_another() and T::cycle.writes.size() == 2);
/// Internal.
template <typename T>
concept cycle_fits_the_scanner =
    not has_all_parts<T> or not T::cycle.by_scanner or
    (T::cycle.reads.size() <= T::scanner.words and T::cycle.writes.size() <= T::scanner.words);

/// Internal.
template <typename T> [[nodiscard]] constexpr bool takes_its_cycle() noexcept
{
    bool const is_one = T::cycle.by == function_code::read_write_multiple_registers;
    bool const is_known = is_one or T::cycle.by == function_code::write_multiple_registers;
    std::size_t const read = is_one ? T::limits.exchange_read : T::limits.read;
    std::size_t const write = is_one ? T::limits.exchange_write : T::limits.write;
    return is_known and detail::implements<T>(T::cycle.by) and T::cycle.reads.size() <= read and
           T::cycle.writes.size() <= write;
}
/// Internal.
template <typename T>
concept cycle_fits_its_function = not has_all_parts<T> or takes_its_cycle<T>();

/// Whether each of its rows says what the drive says of its register: parameters/row_demands.hpp, where it has any.
/// Internal.
template <typename T> inline constexpr bool has_rows_with_roles = true;

/// Whether a device is asked by its own address: a reserved one reaches whatever hangs on the line.
/// Internal.
template <typename T>
concept has_address_of_its_own = T::units.last <= 247;

/// A device that is a drive. Where one is not, `drive_check` says in words what is missing.
template <typename T>
concept drive_type = has_all_parts<T> and has_control_word<T> and has_status_word<T> and has_last_fault<T> and
    has_extended_words<T> and has_output_frequency<T> and has_its_references<T> and has_its_safeguards<T> and
    has_its_scanner<T> and has_single_functions<T> and cycle_reads_the_state<T> and cycle_writes_an_order<T> and
    cycle_is_contiguous<T> and cycle_fits_the_scanner<T> and cycle_fits_its_function<T> and has_address_of_its_own<T>;

/// Stops the compiler at a device that is no drive, with a sentence for what it lacks. Whatever drives a motor does so;
/// a file that describes a drive ends best with `static_assert(drive_check<device>::passed)`.
template <typename T> struct drive_check {
    static_assert(has_layout<T>, "a drive says where its words are: `static constexpr drive_layout layout`");
    static_assert(has_speed_reference<T>, "a drive has a register for its speed: `static constexpr auto const& "
                                          "speed_reference = lfrd`");
    static_assert(has_frequency_reference<T>, "a drive has a register for its frequency: `static constexpr auto const& "
                                              "frequency_reference = lfr`");
    static_assert(has_scanner_registers<T>, "a drive says where its scanner is, or that it has none: `static constexpr "
                                            "scanner_registers scanner{}`");
    static_assert(has_cycle<T>, "a drive says what its cycle moves: `static constexpr cycle_registers cycle`");
    static_assert(has_control_word<T>, "the control word, layout.cmd, is in no register of the drive's table");
    static_assert(has_status_word<T>, "the status word, layout.eta, is in no register of the drive's table");
    static_assert(has_last_fault<T>, "the last fault, layout.lft, is in no register of the drive's table");
    static_assert(has_extended_words<T>, "an extended word, layout.cmi or layout.eti, is in no register of the drive's "
                                         "table");
    static_assert(has_output_frequency<T>, "the output frequency, layout.rfr, is in no register of the drive's table");
    static_assert(has_its_references<T>, "a reference of the drive is no register of its table");
    static_assert(has_its_safeguards<T>,
                  "an address in layout.safeguards is in no register of the drive's table; 0 says "
                  "that the drive has none");
    static_assert(is_supervised<T>, "a drive stops by itself where its line goes silent: by layout.safeguards.sll and "
                                    ".tto, or by .fixed_timeout, which longest_silence covers");
    static_assert(has_its_scanner<T>, "the drive's table lacks registers of its scanner");
    static_assert(has_single_functions<T>, "a drive has functions 03 and 06: its start and its stop use them");
    static_assert(cycle_reads_the_state<T>, "a cycle reads the status word, layout.eta, and cycle.speed");
    static_assert(cycle_writes_an_order<T>, "a cycle writes the control word, layout.cmd, and one of the references");
    static_assert(cycle_is_contiguous<T>,
                  "a cycle without a scanner reads addresses that follow one another, and writes "
                  "two: the control word and a reference");
    static_assert(cycle_fits_the_scanner<T>, "a cycle moves more words than the drive's scanner has");
    static_assert(cycle_fits_its_function<T>, "a cycle moves its words by function 23 or 16, which the drive has and "
                                              "whose limits they keep");
    static_assert(has_address_of_its_own<T>, "a drive is asked at 1 to 247, never at a reserved address: `units`");
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
template <typename T> using parts_check = std::conditional_t<has_drive_parts<T>, parts_are_there, drive_check<T>>;

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
