// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
#include "frame/summary.hpp"

#include <algorithm>
#include <optional>

#include <rtuwire/frames.hpp>

#include "catalog/value_text.hpp"
#include "frame/function_text.hpp"
#include "frame/hex_text.hpp"

namespace tool {

namespace {

using rtuwire::byte_view;
using rtuwire::function_code;
using rtuwire::register_view;

std::string label_at(unsigned address, drive_catalog const* drive)
{
    register_entry const* const entry = drive == nullptr ? nullptr : drive->at(static_cast<std::uint16_t>(address));
    return entry == nullptr ? std::to_string(address) : std::string{entry->code};
}

std::string value_at(unsigned address, std::uint16_t word, drive_catalog const* drive)
{
    register_entry const* const entry = drive == nullptr ? nullptr : drive->at(static_cast<std::uint16_t>(address));
    return label_at(address, drive) + ' ' + (entry == nullptr ? std::to_string(word) : text_of(*entry, word));
}

std::string values_at(unsigned start, register_view words, drive_catalog const* drive)
{
    constexpr std::size_t most = 8;
    std::string text;
    for (std::size_t i = 0; i < std::min(words.size(), most); ++i) {
        text += (i == 0 ? "" : ", ") + value_at(start + static_cast<unsigned>(i), words[i], drive);
    }
    return words.size() > most ? text + " and " + std::to_string(words.size() - most) + " more" : text;
}

std::string range_at(unsigned start, unsigned count, drive_catalog const* drive)
{
    return label_at(start, drive) + (count == 1 ? std::string{} : ", " + std::to_string(count) + " registers");
}

std::string of_request(byte_view pdu, function_code code, drive_catalog const* drive)
{
    if (auto const read = rtuwire::read_holding_registers::decode(pdu)) {
        return "read " + range_at(read->start, read->count, drive);
    }
    if (auto const read = rtuwire::read_input_registers::decode(pdu)) {
        return "read input " + range_at(read->start, read->count, nullptr);
    }
    if (auto const write = rtuwire::write_single_register::decode(pdu)) {
        return "write " + value_at(write->address, write->value, drive);
    }
    if (auto const write = rtuwire::write_multiple_registers<>::decode(pdu)) {
        return "write " + values_at(write->start, write->values, drive);
    }
    if (auto const both = rtuwire::read_write_multiple_registers<>::decode(pdu)) {
        return "write " + values_at(both->write_start, both->values, drive) + "; read " +
               range_at(both->read_start, both->read_count, drive);
    }
    return function_text(code);
}

std::string printable(byte_view bytes)
{
    std::string text;
    for (std::byte const each : bytes) {
        auto const letter = static_cast<char>(std::to_integer<unsigned char>(each));
        text += letter >= ' ' and letter <= '~' ? letter : '.';
    }
    return text;
}

std::string of_identity(rtuwire::device_identification const& page)
{
    std::string text;
    for (auto at = page.first(); at; at = page.after(*at)) {
        text += (text.empty() ? "" : ", ") + printable(at->value);
    }
    return text;
}

std::string of_response(byte_view pdu, byte_view asked, function_code code, drive_catalog const* drive)
{
    if (code == function_code::encapsulated_interface) {
        auto const page = rtuwire::device_identification::decode(pdu);
        return page ? of_identity(*page) : function_text(code);
    }
    if (asked.size() < rtuwire::min_adu_size) {
        return function_text(code);
    }
    byte_view const request = rtuwire::adu{asked}.pdu();
    if (auto const read = rtuwire::read_holding_registers::decode(request)) {
        auto const words = rtuwire::read_holding_registers_response::decode(pdu);
        return words ? values_at(read->start, words->registers, drive) : function_text(code);
    }
    if (auto const both = rtuwire::read_write_multiple_registers<>::decode(request)) {
        auto const words = rtuwire::read_write_multiple_registers_response::decode(pdu);
        return words ? values_at(both->read_start, words->registers, drive) : function_text(code);
    }
    if (auto const write = rtuwire::write_multiple_registers<>::decode(request)) {
        return "written " + range_at(write->start, static_cast<unsigned>(write->values.size()), drive);
    }
    if (auto const write = rtuwire::write_single_register::decode(request)) {
        return "written " + value_at(write->address, write->value, drive);
    }
    return function_text(code);
}

} // namespace

std::string summary_of(rtuwire::heard_frame const& heard, drive_catalog const* drive)
{
    byte_view const bytes = heard.frame.bytes;
    if (heard.is_unanswered) {
        return "no response to: " + of_request(rtuwire::adu{heard.request}.pdu(), heard.function(), drive);
    }
    bool const is_whole =
        heard.frame.verdict != rtuwire::frame_verdict::damaged and bytes.size() >= rtuwire::min_adu_size;
    if (not is_whole or heard.frame.role == rtuwire::frame_role::unknown) {
        return hex_of(bytes);
    }
    byte_view const pdu = rtuwire::adu{bytes}.pdu();
    if (auto const refused = rtuwire::exception_response::decode(pdu)) {
        return "refused: " + std::string{name(refused->error())};
    }
    return heard.frame.role == rtuwire::frame_role::request ? of_request(pdu, heard.function(), drive)
                                                            : of_response(pdu, heard.request, heard.function(), drive);
}

} // namespace tool
