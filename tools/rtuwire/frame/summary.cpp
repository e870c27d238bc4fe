// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
#include "frame/summary.hpp"

#include <algorithm>
#include <optional>
#include <vector>

#include <rtuwire/frames.hpp>

#include "frame/function_text.hpp"
#include "frame/hex_text.hpp"

namespace tool {

namespace {

using rtuwire::byte_view;
using rtuwire::function_code;

/// Registers or bits of a request, one behind the other.
struct run {
    register_space space;
    unsigned start;
    std::size_t count;
    std::vector<std::uint16_t> words{}; ///< that are written
};

/// What a request is to write and to read: one of them, or both.
struct request_runs {
    std::optional<run> write{};
    std::optional<run> read{};
};

template <typename View> std::vector<std::uint16_t> words_in(View const& from)
{
    std::vector<std::uint16_t> words;
    for (std::size_t i = 0; i < from.size(); ++i) {
        words.push_back(static_cast<std::uint16_t>(from[i]));
    }
    return words;
}

template <typename Read> std::optional<run> read_by(byte_view pdu, register_space space)
{
    auto const read = Read::decode(pdu);
    return read ? std::optional{run{space, read->start, read->count}} : std::nullopt;
}

template <typename Write> std::optional<run> single_by(byte_view pdu, register_space space)
{
    auto const write = Write::decode(pdu);
    return write ? std::optional{run{space, write->address, 1, {static_cast<std::uint16_t>(write->value)}}}
                 : std::nullopt;
}

template <typename Write> std::optional<run> several_by(byte_view pdu, register_space space)
{
    auto const write = Write::decode(pdu);
    return write ? std::optional{run{space, write->start, write->values.size(), words_in(write->values)}}
                 : std::nullopt;
}

request_runs runs_of(byte_view pdu, function_code code)
{
    using enum function_code;
    using enum register_space;
    request_runs runs;
    if (code == read_coils) {
        runs.read = read_by<rtuwire::read_coils>(pdu, coil);
    } else if (code == read_discrete_inputs) {
        runs.read = read_by<rtuwire::read_discrete_inputs>(pdu, discrete);
    } else if (code == read_holding_registers) {
        runs.read = read_by<rtuwire::read_holding_registers>(pdu, holding);
    } else if (code == read_input_registers) {
        runs.read = read_by<rtuwire::read_input_registers>(pdu, input);
    } else if (code == write_single_coil) {
        runs.write = single_by<rtuwire::write_single_coil>(pdu, coil);
    } else if (code == write_single_register) {
        runs.write = single_by<rtuwire::write_single_register>(pdu, holding);
    } else if (code == write_multiple_coils) {
        runs.write = several_by<rtuwire::write_multiple_coils<>>(pdu, coil);
    } else if (code == write_multiple_registers) {
        runs.write = several_by<rtuwire::write_multiple_registers<>>(pdu, holding);
    } else if (auto const both = rtuwire::read_write_multiple_registers<>::decode(pdu)) {
        runs.write = run{holding, both->write_start, both->values.size(), words_in(both->values)};
        runs.read = run{holding, both->read_start, both->read_count};
    }
    return runs;
}

/// The words of a response to a read; none where they are not as many as were asked for.
std::vector<std::uint16_t> words_of_response(byte_view pdu, run const& asked, function_code code)
{
    std::vector<std::uint16_t> words;
    auto const take = [&words](auto const& response, auto member) {
        words = response ? words_in((*response).*member) : words;
    };
    if (code == function_code::read_coils) {
        take(rtuwire::read_coils_response::decode(pdu), &rtuwire::read_coils_response::coils);
    } else if (code == function_code::read_discrete_inputs) {
        take(rtuwire::read_discrete_inputs_response::decode(pdu), &rtuwire::read_discrete_inputs_response::inputs);
    } else if (code == function_code::read_input_registers) {
        take(rtuwire::read_input_registers_response::decode(pdu), &rtuwire::read_input_registers_response::registers);
    } else if (code == function_code::read_holding_registers) {
        take(rtuwire::read_holding_registers_response::decode(pdu),
             &rtuwire::read_holding_registers_response::registers);
    } else {
        take(rtuwire::read_write_multiple_registers_response::decode(pdu),
             &rtuwire::read_write_multiple_registers_response::registers);
    }
    bool const is_bits = asked.space >= register_space::coil; // in whole bytes
    bool const is_as_many = words.size() == (is_bits ? (asked.count + 7) / 8 * 8 : asked.count);
    words.resize(is_as_many ? asked.count : 0);
    return words;
}

/// Of one without a name its number; of no holding register its space as well.
std::string label_of(register_space space, unsigned address, std::string const& name)
{
    constexpr char const* spaces[] = {"", "input ", "coil ", "discrete "};
    return name.empty() ? spaces[static_cast<std::size_t>(space)] + std::to_string(address) : name;
}

std::string values_of(run const& which, register_names const* names)
{
    constexpr std::size_t most = 8;
    auto const all = values_in(names, which.space, which.start, which.words);
    std::string text;
    for (std::size_t i = 0; i < std::min(all.size(), most); ++i) {
        text += (i == 0 ? "" : ", ") + label_of(which.space, all[i].address, all[i].name) + ' ' + all[i].short_text;
    }
    return all.size() > most ? text + " and " + std::to_string(all.size() - most) + " more" : text;
}

std::string range_of(run const& which, register_names const* names)
{
    std::string const name = names == nullptr ? std::string{} : names->name_at(which.space, which.start);
    char const* const what = which.space >= register_space::coil ? " bits" : " registers";
    return label_of(which.space, which.start, name) +
           (which.count == 1 ? std::string{} : ", " + std::to_string(which.count) + what);
}

std::string of_request(byte_view pdu, function_code code, register_names const* names)
{
    request_runs const runs = runs_of(pdu, code);
    std::string const write = runs.write ? "write " + values_of(*runs.write, names) : std::string{};
    std::string const read = runs.read ? "read " + range_of(*runs.read, names) : std::string{};
    return write.empty() and read.empty() ? function_text(code)
                                          : write + (write.empty() or read.empty() ? "" : "; ") + read;
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

std::string of_response(byte_view pdu, byte_view asked, function_code code, register_names const* names)
{
    if (code == function_code::encapsulated_interface) {
        auto const page = rtuwire::device_identification::decode(pdu);
        return page ? of_identity(*page) : function_text(code);
    }
    auto [write, read] = runs_of(asked.size() < rtuwire::min_adu_size ? byte_view{} : rtuwire::adu{asked}.pdu(), code);
    if (read) {
        read->words = words_of_response(pdu, *read, code);
        return read->words.empty() ? function_text(code) : values_of(*read, names);
    }
    bool const is_single = code == function_code::write_single_register or code == function_code::write_single_coil;
    return write ? "written " + (is_single ? values_of(*write, names) : range_of(*write, names)) : function_text(code);
}

} // namespace

std::string summary_of(rtuwire::heard_frame const& heard, register_names const* names)
{
    byte_view const bytes = heard.frame.bytes;
    if (heard.is_unanswered) {
        return "no response to: " + of_request(rtuwire::adu{heard.request}.pdu(), heard.function(), names);
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
    return heard.frame.role == rtuwire::frame_role::request ? of_request(pdu, heard.function(), names)
                                                            : of_response(pdu, heard.request, heard.function(), names);
}

} // namespace tool
