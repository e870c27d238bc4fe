// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// Writes what stands in front of a frame in each form of capture.
// Internal: may change with any version.
#pragma once

#include <cstddef>
#include <cstdint>

#include <rtuwire/core/bytes.hpp>
#include <rtuwire/core/version.hpp>
#include <rtuwire/trace/capture/block_builder.hpp>
#include <rtuwire/trace/capture/capture_form.hpp>
#include <rtuwire/trace/traced_frame.hpp>

namespace rtuwire::inline RTUWIRE_BUILD {

/// The addresses of the UDP form: 10.0.0.N is unit N, 10.0.0.0 all units. Of a frame whose role is unknown the ports
/// are others, so that it is not taken for a part of an exchange.
struct made_up_network {
    static constexpr std::uint32_t units = 0x0A00'0000U;
    static constexpr std::uint32_t client = units + 254U;
    static constexpr std::uint16_t unit_port = 1502;
    static constexpr std::uint16_t client_port = 50'000;
    static constexpr std::uint16_t unknown_port = 1503;
};

/// Sizes and constants of the headers.
struct wrapping {
    static constexpr std::uint32_t ip_size = 20;
    static constexpr std::uint32_t udp_size = 28; ///< with that of IPv4
    static constexpr std::uint32_t rtac_size = 12;
    static constexpr std::uint8_t rtac_sent = 1;
    static constexpr std::uint8_t rtac_received = 2;
    static constexpr std::uint16_t dissector_tag = 12;
};

/// The dissector's name with its zeros, as an exported PDU has it.
inline constexpr literal dissector_name{"mbrtu\0\0\0"};

/// How many bytes stand in front of a frame.
[[nodiscard]] constexpr std::uint32_t wrapping_size(capture_form form) noexcept
{
    switch (form) {
    case capture_form::udp: return wrapping::udp_size;
    case capture_form::rtac_serial: return wrapping::rtac_size;
    case capture_form::upper_pdu: return 4U + static_cast<std::uint32_t>(dissector_name.size()) + 4U;
    case capture_form::user0: break;
    }
    return 0;
}

/// Where a packet of the UDP form comes from and goes to.
struct made_up_route {
    std::uint32_t source;
    std::uint32_t destination;
    std::uint16_t source_port;
    std::uint16_t destination_port;
};

/// A request goes to the unit whose address is the frame's first byte, a response comes from it. What has no role goes
/// the way of its sender: from the client where it is the one who traces.
[[nodiscard]] constexpr made_up_route route_of(traced_frame const& frame) noexcept
{
    using network = made_up_network;
    std::uint32_t const unit = network::units + (frame.bytes.empty() ? 0U : to_u8(frame.bytes[0]));
    switch (frame.role) {
    case frame_role::request: return {network::client, unit, network::client_port, network::unit_port};
    case frame_role::response: return {unit, network::client, network::unit_port, network::client_port};
    case frame_role::unknown: break;
    }
    return frame.is_own ? made_up_route{network::client, unit, network::unknown_port, network::unknown_port}
                        : made_up_route{unit, network::client, network::unknown_port, network::unknown_port};
}

/// The checksum of an IPv4 header of which these are all words that are not zero: few enough to carry only once.
[[nodiscard]] constexpr std::uint32_t ip_checksum(std::uint32_t fixed, std::uint32_t size,
                                                  made_up_route const& way) noexcept
{
    std::uint32_t sum = fixed + size + (way.source >> 16U) + (way.source & 0xFFFFU) + (way.destination >> 16U) +
                        (way.destination & 0xFFFFU);
    sum = (sum >> 16U) + (sum & 0xFFFFU);
    return ~sum & 0xFFFFU;
}

/// The headers of IPv4 and UDP. A UDP checksum of 0 says that there is none.
template <typename Builder>
constexpr void write_udp_header(Builder& out, made_up_route const& way, std::size_t payload) noexcept
{
    constexpr std::uint32_t version_and_size = 0x4500;
    constexpr std::uint32_t life_and_protocol = 0x4011;
    std::uint32_t const size = static_cast<std::uint32_t>(payload) + wrapping::udp_size;
    out.network_u16(version_and_size);
    out.network_u16(size);
    out.network_u32(0);
    out.network_u16(life_and_protocol);
    out.network_u16(ip_checksum(version_and_size + life_and_protocol, size & 0xFFFFU, way));
    out.network_u32(way.source);
    out.network_u32(way.destination);
    out.network_u16(way.source_port);
    out.network_u16(way.destination_port);
    out.network_u16(size - wrapping::ip_size);
    out.network_u16(0);
}

/// The header of an RTAC recorder: time, event, control lines, footer.
template <typename Builder>
constexpr void write_rtac_header(Builder& out, traced_frame const& frame, std::uint64_t unix_microseconds) noexcept
{
    out.network_u32(static_cast<std::uint32_t>(unix_microseconds / 1'000'000U));
    out.network_u32(static_cast<std::uint32_t>(unix_microseconds % 1'000'000U));
    out.u8(frame.is_own ? wrapping::rtac_sent : wrapping::rtac_received);
    out.u8(0);
    out.network_u16(0);
}

/// What stands in front of a frame.
template <typename Builder>
constexpr void write_wrapping(Builder& out, capture_form form, traced_frame const& frame,
                              std::uint64_t unix_microseconds) noexcept
{
    switch (form) {
    case capture_form::udp: return write_udp_header(out, route_of(frame), frame.bytes.size());
    case capture_form::rtac_serial: return write_rtac_header(out, frame, unix_microseconds);
    case capture_form::upper_pdu:
        out.network_u16(wrapping::dissector_tag);
        out.network_u16(static_cast<std::uint32_t>(dissector_name.size()));
        out.text(dissector_name);
        return out.network_u32(0);
    case capture_form::user0: break;
    }
}

} // namespace rtuwire
