// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
#include "frame/damage.hpp"

#include <algorithm>
#include <initializer_list>
#include <string_view>
#include <vector>

#include "frame/frame_fit.hpp"
#include "frame/hex_text.hpp"

namespace tool {

namespace {

using rtuwire::byte_view;
using rtuwire::frame_role;

constexpr std::size_t size_of_crc = 2;

bool is_right(byte_view frame) { return rtuwire::check_frame(frame) == rtuwire::errc::none; }

/// Whether unit, function and all fields between them and a check at the end are those of a function. An unknown function has no
/// form that could be right by chance.
bool has_form(byte_view frame, std::size_t check_size)
{
    byte_view const pdu = frame.subspan(1, frame.size() - 1 - check_size);
    return is_known_pdu(pdu);
}

std::string bytes_text(std::size_t count) { return std::to_string(count) + (count == 1 ? " byte" : " bytes"); }

/// What stands in front of these bytes in a response to this request. The byte count of a read is known.
std::vector<std::byte> likely_beginning(byte_view asked)
{
    std::vector<std::byte> first(asked.begin(), asked.begin() + 2);
    auto const code = std::to_integer<unsigned>(asked[1]);
    constexpr std::size_t with_quantity = 8;
    if (code >= 1 and code <= 4 and asked.size() == with_quantity) {
        unsigned const quantity = word_at(asked, 4);
        first.push_back(static_cast<std::byte>(code <= 2 ? (quantity + 7U) / 8U : 2 * quantity));
    }
    return first;
}

std::string lost_beginning(byte_view bytes, byte_view asked)
{
    if (asked.size() < rtuwire::min_adu_size) {
        return {};
    }
    std::vector<std::byte> const first = likely_beginning(asked);
    for (std::size_t missing = 1; missing <= first.size(); ++missing) {
        std::vector<std::byte> whole(first.begin(), first.begin() + static_cast<std::ptrdiff_t>(missing));
        std::string const text = hex_of(whole);
        whole.insert(whole.end(), bytes.begin(), bytes.end());
        if (is_right(whole)) {
            return "its beginning is missing (" + text +
                   " in front gives a right CRC): a driver is released late, or the receiver is switched on late";
        }
    }
    return {};
}

std::string noise_in_front(byte_view bytes, byte_view asked, option_form form)
{
    constexpr std::size_t most = 8;
    for (std::size_t more = 1; more <= most and bytes.size() >= more + rtuwire::min_adu_size; ++more) {
        byte_view const rest = bytes.subspan(more);
        bool const is_asked = asked.size() < 2 or rest[0] == asked[0];
        if (is_asked and is_right(rest) and (not asked.empty() or has_form(rest, size_of_crc))) {
            return bytes_text(more) + " in front (" + hex_of(bytes.first(more)) +
                   ") of a whole frame, as a driver makes that is switched" +
                   advice(": ", option_words(form, line_option::noise, std::to_string(more)), " skips as many");
        }
    }
    return {};
}

/// One 11 or 13 that was taken out, at the one place where a right CRC follows.
std::string lost_to_flow_control(byte_view bytes)
{
    for (std::byte const taken : {std::byte{0x11}, std::byte{0x13}}) {
        for (std::size_t at = 1; at < bytes.size(); ++at) {
            std::vector<std::byte> whole(bytes.begin(), bytes.end());
            whole.insert(whole.begin() + static_cast<std::ptrdiff_t>(at), taken);
            if (is_right(whole) and has_form(whole, size_of_crc)) {
                return "a " + hex_of(byte_view{&taken, 1}) + " is missing between " + hex_of(bytes.subspan(at - 1, 1)) +
                       " and " + hex_of(bytes.subspan(at, 1)) + " (byte " + std::to_string(at) +
                       "; with it the CRC is right): software flow control (XON, XOFF) took it, switch it off";
            }
        }
    }
    return {};
}

std::string held_line(byte_view bytes)
{
    bool const is_held =
        bytes.size() > 1 and std::ranges::all_of(bytes, [](std::byte each) { return each == std::byte{0}; });
    return is_held
               ? "nothing but 00 came: the line is held at one level; A and B exchanged, no bias, or another bit rate"
               : "";
}

std::string other_protocol(byte_view bytes)
{
    if (auto const message = tcp_message_in(bytes)) {
        return "this is Modbus TCP, transaction " + std::to_string(message->transaction) + ", unit " +
               std::to_string(std::to_integer<unsigned>(message->frame[0])) +
               ": RTU frames have no such header, and a CRC; set the unit or its gateway to RTU";
    }
    if (are_ascii_characters(bytes)) {
        return "this is Modbus ASCII: set the unit to RTU";
    }
    return {};
}

} // namespace

std::optional<tcp_message> tcp_message_in(byte_view bytes)
{
    constexpr std::size_t header = 6, shortest = 2;
    if (bytes.size() < header + shortest or word_at(bytes, 2) != 0 or word_at(bytes, 4) != bytes.size() - header or
        is_right(bytes)) {
        return std::nullopt;
    }
    byte_view const frame = bytes.subspan(header);
    if (not has_form(frame, 0)) {
        return std::nullopt;
    }
    return tcp_message{word_at(bytes, 0), frame};
}

bool is_ascii_message(byte_view bytes)
{
    constexpr std::size_t shortest = 3;
    if (bytes.size() < shortest or is_right(bytes)) {
        return false;
    }
    unsigned sum = 0;
    for (std::byte const each : bytes) {
        sum += std::to_integer<unsigned>(each);
    }
    return (sum & 0xFFU) == 0 and has_form(bytes, 1);
}

bool are_ascii_characters(byte_view bytes)
{
    constexpr std::string_view digits = "0123456789ABCDEFabcdef\r\n";
    constexpr std::size_t shortest = 5;
    return bytes.size() >= shortest and bytes[0] == std::byte{':'} and
           std::ranges::all_of(bytes.subspan(1), [&](std::byte each) {
               return digits.find(static_cast<char>(each)) != std::string_view::npos;
           });
}

std::string cause_of_damage(byte_view bytes, byte_view asked, option_form form)
{
    for (std::string const& cause : {held_line(bytes), other_protocol(bytes), lost_beginning(bytes, asked),
                                     noise_in_front(bytes, asked, form), lost_to_flow_control(bytes)}) {
        if (not cause.empty()) {
            return cause;
        }
    }
    return {};
}

} // namespace tool
