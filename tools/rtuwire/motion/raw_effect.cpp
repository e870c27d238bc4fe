// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
#include "motion/raw_effect.hpp"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <span>

#include "exit_status.hpp"
#include "frame/frame_fit.hpp"
#include "frame/function_text.hpp"
#include "frame/hex_text.hpp"
#include "motion/checked_values.hpp"
#include "motion/moving_registers.hpp"
#include "motion/unsafe_write.hpp"
#include "words/place_value.hpp"

namespace tool {

namespace {

using rtuwire::byte_view;
using rtuwire::errc;
using rtuwire::function_code;

function_code code_of(byte_view pdu) { return static_cast<function_code>(pdu[0]); }

std::string hex_word_of(std::uint16_t word) { return hex_words({&word, 1}); }

constexpr rtuwire::function_set register_writes{function_code::write_single_register,
                                                function_code::write_multiple_registers,
                                                function_code::read_write_multiple_registers};
constexpr rtuwire::function_set coil_writes{function_code::write_single_coil, function_code::write_multiple_coils};
constexpr rtuwire::function_set place_writes{
    function_code::write_single_coil,        function_code::write_multiple_coils,
    function_code::mask_write_register,      function_code::write_single_register,
    function_code::write_multiple_registers, function_code::read_write_multiple_registers};

/// The first register that is written, and where its value stands.
struct written_registers {
    std::uint16_t first;
    std::size_t count;
    std::size_t at;
};

written_registers registers_written(byte_view pdu)
{
    if (code_of(pdu) == function_code::write_multiple_registers) {
        return {word_at(pdu, 1), word_at(pdu, 3), 6};
    }
    return code_of(pdu) == function_code::read_write_multiple_registers
               ? written_registers{word_at(pdu, 5), word_at(pdu, 7), 10}
               : written_registers{word_at(pdu, 1), 1, 3};
}

/// The bits that a mask changes. A bit that its AND mask keeps and its OR mask has stays by the specification, and is set by
/// units that take OR as it is.
std::uint16_t changed_bits(byte_view pdu) { return static_cast<std::uint16_t>(~word_at(pdu, 3) | word_at(pdu, 5)); }

/// The bits that a mask changes, each run of them as one number.
std::vector<std::string> bits_written(byte_view pdu)
{
    constexpr unsigned bits = 16;
    std::uint16_t const changed = changed_bits(pdu);
    std::uint16_t const set = word_at(pdu, 5);
    std::string const address = std::to_string(word_at(pdu, 1));
    std::vector<std::string> words;
    for (unsigned first = 0; first < bits; ++first) {
        unsigned last = first;
        while (last < bits and (changed >> last & 1U) != 0) {
            ++last;
        }
        if (last == first) {
            continue;
        }
        unsigned const value = set >> first & ((1U << (last - first)) - 1U);
        words.push_back(last - first == bits ? address + '=' + hex_word_of(set)
                        : last - first == 1  ? address + '.' + std::to_string(first) + (value != 0 ? "=on" : "=off")
                                             : address + '.' + std::to_string(first) + '-' + std::to_string(last - 1) +
                                                  '=' + std::to_string(value));
        first = last;
    }
    return words;
}

/// The values of a request that is as the specification has it, as `write` takes them.
std::vector<std::string> values_written(byte_view pdu)
{
    std::vector<std::string> words;
    auto const coil = [&words](unsigned address, bool is_on) {
        words.push_back("coil:" + std::to_string(address) + (is_on ? "=on" : "=off"));
    };
    if (code_of(pdu) == function_code::write_single_coil) {
        coil(word_at(pdu, 1), pdu[3] != std::byte{0});
    } else if (code_of(pdu) == function_code::write_multiple_coils) {
        for (unsigned i = 0; i < word_at(pdu, 3); ++i) {
            coil(word_at(pdu, 1) + i, (std::to_integer<unsigned>(pdu[6 + i / 8]) >> (i % 8U) & 1U) != 0);
        }
    } else if (code_of(pdu) == function_code::mask_write_register) {
        return bits_written(pdu);
    } else if (register_writes.contains(code_of(pdu))) {
        written_registers const it = registers_written(pdu);
        for (std::size_t i = 0; i < it.count; ++i) {
            words.push_back(hex_word_of(static_cast<std::uint16_t>(it.first + i)) + '=' +
                            hex_word_of(word_at(pdu, it.at + 2 * i)));
        }
    }
    return words;
}

/// The registers, coils or records that a request writes, which is as the specification has it.
std::vector<unsigned> addresses_written(byte_view pdu)
{
    std::vector<unsigned> all;
    auto const add = [&all](unsigned first, unsigned count) {
        for (unsigned i = 0; i < count; ++i) {
            all.push_back(first + i);
        }
    };
    switch (std::to_integer<unsigned>(pdu[0])) {
    case 15:
    case 16: add(word_at(pdu, 1), word_at(pdu, 3)); break;
    case 21:
        for (std::size_t at = 2; at + 7 <= pdu.size(); at += 7 + 2U * word_at(pdu, at + 5)) {
            add(word_at(pdu, at + 3), word_at(pdu, at + 5));
        }
        break;
    default: add(word_at(pdu, 1), 1); break;
    }
    return all;
}

/// Ends the command where a register is of a drive that may be on the line.
void refuse_register_of(drive_catalog const& drive, std::uint16_t address)
{
    register_entry const* const entry = drive.at(address);
    if (commands_a_motor(address, drive) or entry != nullptr) {
        refuse_for_safety("register " + std::to_string(address) + " is " +
                          (entry != nullptr ? std::string{entry->code} : std::string{"a command"}) + " of an " +
                          std::string{drive.name} +
                          ", which may be on the line; the command write sends it to one unit, and checks it");
    }
}

/// What any object of a unit is written by, its command as well: CANopen's general reference.
bool reaches_objects(byte_view pdu)
{
    return code_of(pdu) == function_code::encapsulated_interface and pdu.size() > 1 and pdu[1] == std::byte{13};
}

/// One of a function that has no specification is.
bool is_as_specified(byte_view pdu) { return flaw_of(pdu, rtuwire::frame_role::request) == rtuwire::errc::none; }

/// Whether a PDU is as long as one of its function that writes registers or coils, by its own bytes; their values are not
/// looked at.
bool has_length_of_write(byte_view pdu)
{
    auto const counted = [pdu](std::size_t at) {
        return at < pdu.size() and pdu.size() == at + 1 + std::to_integer<std::size_t>(pdu[at]);
    };
    switch (std::to_integer<unsigned>(pdu[0])) {
    case 15:
    case 16: return counted(5);
    case 22: return pdu.size() == 7;
    case 23: return counted(9);
    default: return pdu.size() == 5;
    }
}

/// Whether a unit that takes it for a request of its own may do more than read.
bool may_change_something(byte_view pdu, functions_within which)
{
    constexpr unsigned first_exception = 0x80;
    bool const is_function = pdu[0] != std::byte{0} and std::to_integer<unsigned>(pdu[0]) < first_exception;
    bool const is_looked_for =
        is_function and (which == functions_within::any or rtuwire::all_functions.contains(code_of(pdu)));
    return is_looked_for and (place_writes.contains(code_of(pdu)) ? has_length_of_write(pdu)
                                                                  : is_as_specified(pdu) and not only_reads(pdu));
}

/// Whether a unit says back what it was sent, and does nothing else.
bool is_loopback(byte_view pdu)
{
    return code_of(pdu) == function_code::diagnostics and pdu.size() > 2 and word_at(pdu, 1) == 0;
}

/// The first frame with a right CRC in these bytes, from a byte on, whose PDU fits; empty where there is none.
template <typename Fits> byte_view frame_in(byte_view bytes, std::size_t from, Fits fits)
{
    for (std::size_t at = from; at < bytes.size(); ++at) {
        rtuwire::running_crc16<> crc;
        for (std::size_t end = at; end < bytes.size();) {
            crc.add(bytes[end++]);
            byte_view const one = bytes.subspan(at, end - at);
            if (one.size() >= rtuwire::min_adu_size and crc.value() == 0 and fits(one.subspan(1, one.size() - 3))) {
                return one;
            }
        }
    }
    return {};
}

/// The values that a request writes, checked as `write` checks them.
std::vector<value_to_write> checked_places(byte_view pdu, open_line& line, named_unit const& unit,
                                           write_rules const& rules, choices const& chosen)
{
    if (code_of(pdu) == function_code::mask_write_register) {
        bool const is_drive = rules.drive != nullptr;
        refuse_command({.where = {word_at(pdu, 1)}}, rules, chosen);
        if (is_drive or rules.command) {
            refuse_for_safety("unit " + std::to_string(unit.unit.byte()) +
                              (is_drive ? " is an " + std::string{rules.drive->name} : " may be a drive") + ": what " +
                              words_of_function(pdu) +
                              ", makes of its register is not known before, as that of the command write is");
        }
    }
    return checked_values(values_written(pdu), line, unit, rules, chosen);
}

/// Whether a request writes 0000 to the command of a drive, and nothing else: its motor coasts, in each profile. Of an ATV28, which
/// does not say what it is, nobody knows that it is one.
bool takes_power_away(byte_view pdu, drive_catalog const& drive)
{
    constexpr std::uint16_t of_atv28 = 400;
    constexpr rtuwire::function_set plain{function_code::write_single_register,
                                          function_code::write_multiple_registers};
    if (drive.layout.cmd == of_atv28 or not plain.contains(code_of(pdu)) or not is_as_specified(pdu)) {
        return false;
    }
    written_registers const it = registers_written(pdu);
    return it.first == drive.layout.cmd and it.count == 1 and word_at(pdu, it.at) == 0;
}

/// Ends the command where a register runs a motor of some drive, or tells it who does.
void refuse_what_runs_drives(byte_view pdu)
{
    if (not place_writes.contains(code_of(pdu)) or coil_writes.contains(code_of(pdu))) {
        return;
    }
    bool const has_several = register_writes.contains(code_of(pdu));
    written_registers const it = has_several ? registers_written(pdu) : written_registers{word_at(pdu, 1), 1, 0};
    for (std::size_t i = 0; i < it.count; ++i) {
        auto const address = static_cast<std::uint16_t>(it.first + i);
        if (runs_a_drive(address)) {
            refuse_for_safety("register " + std::to_string(address) +
                              " runs a drive, or says who does, and this unit does not say that it is none");
        }
    }
}

} // namespace

bool is_word_that_stops(byte_view pdu)
{
    return std::ranges::any_of(all_catalogs(),
                               [pdu](drive_catalog const* each) { return takes_power_away(pdu, *each); });
}

bool has_reading_function(byte_view pdu)
{
    using enum function_code;
    constexpr rtuwire::function_set reading{read_coils,           read_discrete_inputs,  read_holding_registers,
                                            read_input_registers, read_exception_status, get_comm_event_counter,
                                            get_comm_event_log,   report_server_id,      read_file_record,
                                            read_fifo_queue};
    bool const identifies = code_of(pdu) == encapsulated_interface and pdu.size() > 1 and pdu[1] == std::byte{14};
    return reading.contains(code_of(pdu)) or is_loopback(pdu) or identifies;
}

bool only_reads(byte_view pdu) { return has_reading_function(pdu) and is_as_specified(pdu); }

byte_view changing_frame_in(byte_view bytes, functions_within which, std::size_t from)
{
    return frame_in(bytes, from, [which](byte_view pdu) { return may_change_something(pdu, which); });
}

void refuse_frame_within(byte_view frame, functions_within which)
{
    byte_view const one = is_loopback(frame.subspan(1, frame.size() - 3))
                              ? frame_in(frame, 1, [](byte_view) { return true; })
                              : changing_frame_in(frame, which, 1);
    if (not one.empty()) {
        refuse_for_safety("its bytes, " + hex_of(frame) + ", hold a whole frame, " + hex_of(one) +
                          ": a unit that ends a frame by its length takes that for a request of its own");
    }
}

std::string words_of_function(byte_view pdu)
{
    std::string const number = "function " + function_number(code_of(pdu));
    return number + (rtuwire::all_functions.contains(code_of(pdu)) ? ", " + function_text(code_of(pdu))
                                                                   : ", which is not public");
}

void refuse_unreadable(byte_view pdu)
{
    if (place_writes.contains(code_of(pdu)) and not is_as_specified(pdu)) {
        refuse_word(words_of_function(pdu) + ": its data is " +
                    std::string{rtuwire::name(flaw_of(pdu, rtuwire::frame_role::request))} +
                    ", so nobody knows what a unit writes by it; `decode` shows a frame field by field");
    }
    if (code_of(pdu) == function_code::mask_write_register and changed_bits(pdu) == 0) {
        refuse_word(words_of_function(pdu) +
                    ": its masks change no bit, and it is a write of the register all the same");
    }
}

std::vector<value_to_write> checked_request(byte_view pdu, open_line& line, named_unit const& unit,
                                            write_rules const& rules, choices const& chosen)
{
    std::string const number = "unit " + std::to_string(unit.unit.byte());
    std::string const what = words_of_function(pdu);
    bool const is_drive = rules.drive != nullptr;
    std::vector<value_to_write> values = checked_places(pdu, line, unit, rules, chosen);
    if (reaches_objects(pdu) and (is_drive or rules.command)) {
        refuse_for_safety(number + (is_drive ? " is a drive: " : " may be a drive: ") + what +
                          " of type 13, reaches its command as well");
    }
    if (not chosen.allowed.may_run and not is_as_specified(pdu)) {
        refuse_for_safety(what +
                          ": its data is not as the specification has it, so nobody knows what a unit makes of it" +
                          chosen.allowed.by_run("send"));
    }
    if (not chosen.allowed.may_run and not rules.says_it_is_none) {
        refuse_for_safety(number +
                          (is_drive ? " is an " + std::string{rules.drive->name}
                                    : " does not say by function 43 (0x2B) what it is, and may be a drive") +
                          ": a motor may turn after " + what + chosen.allowed.by_run("send"));
    }
    return values;
}

std::vector<value_to_write> refuse_for_client(byte_view pdu, open_line& line, named_unit const& unit,
                                              write_rules const& rules, choices const& chosen)
{
    refuse_unreadable(pdu);
    if (rules.drive != nullptr and takes_power_away(pdu, *rules.drive)) {
        std::uint16_t const cmd = rules.drive->layout.cmd;
        return {{.where = {cmd}, .entry = rules.drive->at(cmd), .words = {0}, .text = hex_word_of(0)}};
    }
    bool const is_known = rules.drive != nullptr or rules.says_it_is_none;
    if (not is_known) {
        refuse_what_runs_drives(pdu);
    }
    bool const writes_places = place_writes.contains(code_of(pdu));
    std::vector<value_to_write> values = writes_places ? checked_places(pdu, line, unit, rules, chosen)
                                                       : checked_request(pdu, line, unit, rules, chosen);
    if (rules.drive == nullptr) {
        refuse_frame_within(frame_of(std::byte{unit.unit.byte()}, pdu),
                            writes_places ? functions_within::public_ones : functions_within::any);
    } else if (std::optional<ended> const why = why_not_now(values, line, unit.unit, *rules.drive, chosen.allowed)) {
        throw ended{*why};
    }
    return values;
}

void refuse_broadcast(byte_view pdu, choices const& chosen)
{
    constexpr rtuwire::function_set files{function_code::write_file_record};
    std::string const what = words_of_function(pdu);
    if (not place_writes.contains(code_of(pdu)) and not files.contains(code_of(pdu))) {
        refuse_word(what + ", is nothing for all units (-u 0): nobody answers a broadcast, so only what writes is sent "
                           "by one");
    }
    if (code_of(pdu) == function_code::read_write_multiple_registers) {
        refuse_word(what + ", is nothing for all units (-u 0): it reads as well, and nobody answers a broadcast");
    }
    if (not chosen.allowed.may_run) {
        refuse_for_safety("a broadcast reaches whoever is on the line, drives as well; to send it, say --allow-run "
                          "besides");
    }
    if (not is_as_specified(pdu)) {
        refuse_for_safety(what +
                          ": its data is not as the specification has it, so nobody knows what units make of it");
    }
    bool const is_coil = coil_writes.contains(code_of(pdu));
    for (unsigned const address : addresses_written(pdu)) {
        if (is_target_of_profile(address)) {
            refuse_for_safety("address " + std::to_string(address) +
                              " commands the motor of a drive of CiA 402, which may be on the line");
        }
        for (drive_catalog const* const each : is_coil ? std::span<drive_catalog const* const>{} : all_catalogs()) {
            refuse_register_of(*each, static_cast<std::uint16_t>(address));
        }
    }
}

} // namespace tool
