// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// Finds the frame in a packet of a capture.
// Internal: may change with any version.
#pragma once

#include <cstddef>
#include <cstdint>

#include <rtuwire/core/bytes.hpp>
#include <rtuwire/core/version.hpp>
#include <rtuwire/trace/capture/capture_form.hpp>
#include <rtuwire/trace/capture/file_order.hpp>
#include <rtuwire/trace/capture/frame_words.hpp>
#include <rtuwire/trace/traced_frame.hpp>

namespace rtuwire::inline RTUWIRE_BUILD {

/// What a packet turned out to be.
enum class packet_content : std::uint8_t { frame, other, wrong };

/// A packet, and then the frame in it: `bytes` become fewer, and `full_size` less, by what stood in front.
struct packet_view {
    byte_view bytes;
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
    constexpr std::uint8_t udp_protocol = 17;
    if (packet.bytes.size() < wrapping::ip_size) {
        return packet_content::wrong;
    }
    std::uint8_t const first = to_u8(packet.bytes[0]);
    std::size_t const head = (first & 0xFU) * 4U;
    if (first >> 4U != 4) {
        return packet_content::other;
    }
    if (head < wrapping::ip_size or not packet.keep(u16_at(packet.bytes, 2)) or packet.bytes.size() < head) {
        return packet_content::wrong;
    }
    bool const is_fragment = (u16_at(packet.bytes, 6) & 0x3FFFU) != 0;
    if (is_fragment or to_u8(packet.bytes[9]) != udp_protocol) {
        return packet_content::other;
    }
    return packet.drop(head) ? packet_content::frame : packet_content::wrong;
}

/// The role of a frame between two ports; other where none is of the form that is written here.
[[nodiscard]] constexpr packet_content apply_ports(std::uint16_t from, std::uint16_t to, traced_frame& frame) noexcept
{
    using network = made_up_network;
    if (from == network::unknown_port and to == network::unknown_port) {
        return packet_content::frame;
    }
    if ((from == network::unit_port) == (to == network::unit_port)) {
        return packet_content::other;
    }
    frame.role = to == network::unit_port ? frame_role::request : frame_role::response;
    return packet_content::frame;
}

[[nodiscard]] constexpr packet_content unwrap_udp(packet_view& packet, traced_frame& frame) noexcept
{
    constexpr std::uint32_t head = wrapping::udp_size - wrapping::ip_size;
    packet_content const content = unwrap_ip(packet);
    if (content != packet_content::frame) {
        return content;
    }
    if (packet.bytes.size() < head) {
        return packet_content::wrong;
    }
    if (apply_ports(u16_at(packet.bytes, 0), u16_at(packet.bytes, 2), frame) == packet_content::other) {
        return packet_content::other;
    }
    std::uint16_t const size = u16_at(packet.bytes, 4);
    bool const is_right = packet.keep(size) and packet.drop(head);
    return is_right ? packet_content::frame : packet_content::wrong;
}

/// Events of the recorder that carry no data are none of ours.
[[nodiscard]] constexpr packet_content unwrap_rtac(packet_view& packet, traced_frame& frame) noexcept
{
    if (packet.bytes.size() < wrapping::rtac_size) {
        return packet_content::wrong;
    }
    std::uint8_t const event = to_u8(packet.bytes[8]);
    frame.is_own = event == wrapping::rtac_sent;
    bool const has_data = event == wrapping::rtac_sent or event == wrapping::rtac_received;
    return packet.drop(wrapping::rtac_size) and has_data ? packet_content::frame : packet_content::other;
}

/// Walks the tags of an exported PDU; a frame where one names the dissector.
[[nodiscard]] constexpr packet_content unwrap_exported(packet_view& packet) noexcept
{
    bool is_ours = false;
    while (packet.bytes.size() >= 4) {
        std::uint16_t const tag = u16_at(packet.bytes, 0);
        std::size_t const size = u16_at(packet.bytes, 2);
        if (not packet.drop(4)) {
            return packet_content::wrong;
        }
        if (tag == 0) {
            return is_ours ? packet_content::frame : packet_content::other;
        }
        if (size > packet.bytes.size()) {
            return packet_content::wrong;
        }
        byte_view const value = packet.bytes.first(size);
        is_ours = is_ours or (tag == wrapping::dissector_tag and value.size() >= 5 and
                              spells(value.first(5), "mbrtu") and (size == 5 or value[5] == std::byte{0}));
        static_cast<void>(packet.drop(size));
    }
    return packet_content::wrong;
}

/// The frame in a packet of a link type.
[[nodiscard]] constexpr packet_content unwrap(std::uint32_t link_type, packet_view& packet,
                                              traced_frame& frame) noexcept
{
    switch (static_cast<capture_form>(link_type)) {
    case capture_form::udp: return unwrap_udp(packet, frame);
    case capture_form::rtac_serial: return unwrap_rtac(packet, frame);
    case capture_form::upper_pdu: return unwrap_exported(packet);
    case capture_form::user0: return packet_content::frame;
    }
    return packet_content::other;
}

} // namespace rtuwire
