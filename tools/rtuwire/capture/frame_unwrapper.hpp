// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// The frame in a packet of a capture: behind the headers of each form (docs/trace.md), and what a comment says of it.
// Knows no file: block_reader.hpp, which uses it, knows blocks and no headers of packets.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string_view>

#include <rtuwire/trace.hpp>

#include "capture/file_order.hpp"

namespace tool {

/// Whether bytes are these characters.
[[nodiscard]] constexpr bool spells(rtuwire::byte_view bytes, std::string_view word) noexcept
{
    return std::equal(bytes.begin(), bytes.end(), word.begin(), word.end(),
                      [](std::byte each, char letter) { return std::to_integer<char>(each) == letter; });
}

/// Takes what one word of a comment says; any other word says nothing.
constexpr void apply_word(rtuwire::byte_view word, rtuwire::traced_frame& frame) noexcept
{
    for (rtuwire::frame_role const role : {rtuwire::frame_role::request, rtuwire::frame_role::response}) {
        frame.role = spells(word, name(role)) ? role : frame.role;
    }
    for (auto const verdict :
         {rtuwire::frame_verdict::damaged, rtuwire::frame_verdict::late, rtuwire::frame_verdict::foreign,
          rtuwire::frame_verdict::echo, rtuwire::frame_verdict::stray}) {
        frame.verdict = spells(word, name(verdict)) ? verdict : frame.verdict;
    }
}

/// Takes what a comment says: words, with a comma and a space between.
constexpr void apply_comment(rtuwire::byte_view comment, rtuwire::traced_frame& frame) noexcept
{
    std::size_t start = 0;
    for (std::size_t i = 0; i <= comment.size(); ++i) {
        if (i == comment.size() or comment[i] == std::byte{','}) {
            apply_word(comment.subspan(start, i - start), frame);
            start = i + 2 <= comment.size() ? i + 2 : comment.size();
        }
    }
}

/// What a packet turned out to be.
enum class packet_content : std::uint8_t { frame, other, wrong };

/// A packet, and then the frame in it: `bytes` become fewer, and `full_size` less, by what stood in front.
struct packet_view {
    rtuwire::byte_view bytes;
    std::uint32_t full_size; ///< as it was on the line, at least that of the bytes

    /// Drops a header; false where the packet has none.
    constexpr bool drop(std::size_t size) noexcept
    {
        if (size > bytes.size()) {
            return false;
        }
        bytes = bytes.subspan(size);
        full_size -= static_cast<std::uint32_t>(size);
        return true;
    }

    /// Keeps what a header says is the payload; false where the packet is smaller.
    constexpr bool keep(std::uint32_t size) noexcept
    {
        if (size > full_size) {
            return false;
        }
        full_size = size;
        bytes = bytes.size() > size ? bytes.first(size) : bytes;
        return true;
    }
};

/// The UDP datagram in an IPv4 packet; other where there is none, or only a fragment of one.
[[nodiscard]] constexpr packet_content unwrap_ip(packet_view& packet) noexcept
{
    constexpr std::uint32_t least_head = 20;
    constexpr std::uint8_t udp_protocol = 17;
    if (packet.bytes.size() < least_head) {
        return packet_content::wrong;
    }
    std::uint8_t const first = std::to_integer<std::uint8_t>(packet.bytes[0]);
    std::size_t const head = (first & 0xFU) * 4U;
    if (first >> 4U != 4) {
        return packet_content::other;
    }
    if (head < least_head or not packet.keep(network_order.u16(packet.bytes, 2)) or packet.bytes.size() < head) {
        return packet_content::wrong;
    }
    bool const is_fragment = (network_order.u16(packet.bytes, 6) & 0x3FFFU) != 0;
    if (is_fragment or std::to_integer<std::uint8_t>(packet.bytes[9]) != udp_protocol) {
        return packet_content::other;
    }
    return packet.drop(head) ? packet_content::frame : packet_content::wrong;
}

/// The role of a frame between two ports; other where none is of those that the library writes.
[[nodiscard]] constexpr packet_content apply_ports(std::uint16_t from, std::uint16_t to,
                                                   rtuwire::traced_frame& frame) noexcept
{
    constexpr std::uint16_t unit_port = 1502;
    constexpr std::uint16_t unknown_port = 1503;
    if (from == unknown_port and to == unknown_port) {
        return packet_content::frame;
    }
    if ((from == unit_port) == (to == unit_port)) {
        return packet_content::other;
    }
    frame.role = to == unit_port ? rtuwire::frame_role::request : rtuwire::frame_role::response;
    return packet_content::frame;
}

[[nodiscard]] constexpr packet_content unwrap_udp(packet_view& packet, rtuwire::traced_frame& frame) noexcept
{
    constexpr std::uint32_t head = 8;
    packet_content const content = unwrap_ip(packet);
    if (content != packet_content::frame) {
        return content;
    }
    if (packet.bytes.size() < head) {
        return packet_content::wrong;
    }
    if (apply_ports(network_order.u16(packet.bytes, 0), network_order.u16(packet.bytes, 2), frame) ==
        packet_content::other) {
        return packet_content::other;
    }
    std::uint16_t const size = network_order.u16(packet.bytes, 4);
    bool const is_right = packet.keep(size) and packet.drop(head);
    return is_right ? packet_content::frame : packet_content::wrong;
}

/// Events of the recorder that carry no data are none of ours.
[[nodiscard]] constexpr packet_content unwrap_rtac(packet_view& packet, rtuwire::traced_frame& frame) noexcept
{
    constexpr std::uint32_t head = 12;
    constexpr std::uint8_t sent = 1;
    constexpr std::uint8_t received = 2;
    if (packet.bytes.size() < head) {
        return packet_content::wrong;
    }
    std::uint8_t const event = std::to_integer<std::uint8_t>(packet.bytes[8]);
    frame.is_own = event == sent;
    bool const has_data = event == sent or event == received;
    return packet.drop(head) and has_data ? packet_content::frame : packet_content::other;
}

/// Walks the tags of an exported PDU; a frame where one names the dissector.
[[nodiscard]] constexpr packet_content unwrap_exported(packet_view& packet) noexcept
{
    constexpr std::uint16_t dissector_tag = 12;
    bool is_ours = false;
    while (packet.bytes.size() >= 4) {
        std::uint16_t const tag = network_order.u16(packet.bytes, 0);
        std::size_t const size = network_order.u16(packet.bytes, 2);
        if (not packet.drop(4)) {
            return packet_content::wrong;
        }
        if (tag == 0) {
            return is_ours ? packet_content::frame : packet_content::other;
        }
        if (size > packet.bytes.size()) {
            return packet_content::wrong;
        }
        rtuwire::byte_view const value = packet.bytes.first(size);
        is_ours = is_ours or (tag == dissector_tag and value.size() >= 5 and spells(value.first(5), "mbrtu") and
                              (size == 5 or value[5] == std::byte{0}));
        static_cast<void>(packet.drop(size));
    }
    return packet_content::wrong;
}

/// The frame in a packet of a link type.
[[nodiscard]] constexpr packet_content unwrap(std::uint32_t link_type, packet_view& packet,
                                              rtuwire::traced_frame& frame) noexcept
{
    switch (static_cast<rtuwire::capture_form>(link_type)) {
    case rtuwire::capture_form::udp: return unwrap_udp(packet, frame);
    case rtuwire::capture_form::rtac_serial: return unwrap_rtac(packet, frame);
    case rtuwire::capture_form::upper_pdu: return unwrap_exported(packet);
    case rtuwire::capture_form::user0: return packet_content::frame;
    }
    return packet_content::other;
}

} // namespace tool
