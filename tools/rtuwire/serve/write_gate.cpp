// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
#include "serve/write_gate.hpp"

#include "frame/frame_fit.hpp"
#include "motion/raw_effect.hpp"

namespace tool {

namespace {

using rtuwire::errc;

constexpr std::uint8_t last_unit = 247;
constexpr unsigned first_exception = 0x80;

gate_verdict malformed(std::string const& number, rtuwire::byte_view pdu)
{
    return {errc::illegal_data_value, "malformed",
            number + ": " + words_of_function(pdu) + ": its data is " +
                std::string{rtuwire::name(flaw_of(pdu, rtuwire::frame_role::request))}};
}

/// What is written by all others, nobody knows: diagnostics silence a unit, functions of a maker may run a motor.
bool writes_places(rtuwire::byte_view pdu)
{
    using enum rtuwire::function_code;
    constexpr rtuwire::function_set known{
        write_single_coil, write_single_register, write_multiple_coils,         write_multiple_registers,
        write_file_record, mask_write_register,   read_write_multiple_registers};
    return known.contains(static_cast<rtuwire::function_code>(pdu[0]));
}

bool writes_beyond_last(rtuwire::byte_view pdu)
{
    using enum rtuwire::function_code;
    constexpr rtuwire::function_set several{write_multiple_coils, write_multiple_registers};
    return several.contains(static_cast<rtuwire::function_code>(pdu[0])) and
           word_at(pdu, 1) + word_at(pdu, 3) > 0x1'0000;
}

} // namespace

gate_verdict judge_request(gate_rules const& rules, std::uint8_t unit, rtuwire::byte_view pdu)
{
    auto const code = static_cast<std::uint8_t>(pdu[0]);
    std::string const number = "unit " + std::to_string(unit);
    if (unit > last_unit or (unit != 0 and rules.units and rules.units->count(unit) == 0)) {
        return {errc::gateway_path_unavailable, "unit",
                unit > last_unit
                    ? number + " is the address of no unit of a line: 1 to 247"
                    : number + " is not served: " + option_words(rules.form, line_option::units) + " does not name it"};
    }
    if (unit == 0 and not rules.may_broadcast) {
        return {errc::gateway_path_unavailable, "broadcast",
                "unit 0 would reach all units of the line" +
                    advice(": that takes ", option_words(rules.form, line_option::broadcast))};
    }
    if (code == 0 or code >= first_exception or (rules.functions and rules.functions->count(code) == 0)) {
        return {errc::illegal_function, "function",
                code == 0 or code >= first_exception
                    ? "there is no such function"
                    : number + ": " + words_of_function(pdu) + ", is not served: --functions does not name it"};
    }
    bool const is_flawed = flaw_of(pdu, rtuwire::frame_role::request) != errc::none;
    if (not has_reading_function(pdu) and not rules.may_write) {
        return {errc::illegal_function, "write",
                number + ": " + words_of_function(pdu) + ", may change something, and only reads pass" +
                    advice("; say ", option_words(rules.form, line_option::write))};
    }
    if (not has_reading_function(pdu) and not writes_places(pdu)) {
        return {errc::illegal_function, "write",
                number + ": " + words_of_function(pdu) + ", is none by which registers, coils or files are written"};
    }
    if (is_flawed) {
        return malformed(number, pdu);
    }
    if (writes_beyond_last(pdu)) {
        return {errc::illegal_data_address, "malformed",
                number + ": " + words_of_function(pdu) + ", goes beyond the last address, 65535"};
    }
    if (unit == 0 and only_reads(pdu)) {
        return {errc::gateway_path_unavailable, "broadcast", "unit 0 is all units, of which none answers a read"};
    }
    return {.only_reads = only_reads(pdu)};
}

} // namespace tool
