// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// How a capture file wraps frames, and the addresses that its packets bear. Modbus RTU has no link type of its own, so
// Wireshark finds out what a frame is only from something around it.
#pragma once

#include <cstdint>

#include <rtuwire/core/version.hpp>

namespace rtuwire::inline RTUWIRE_BUILD {

/// What a capture puts around each frame; the number is the link type of the file. Only `udp` lets Wireshark tell
/// requests from responses, and pair them.
enum class capture_form : std::uint16_t {
    udp = 228,         ///< IPv4 and UDP with addresses that are made up; Wireshark needs `-o mbrtu.udp.port:1502`
    user0 = 147,       ///< the bare frame; Wireshark needs an entry for USER0 in its DLT table: mbrtu
    rtac_serial = 250, ///< the header of an RTAC recorder; Wireshark needs `-d rtacser.data,mbrtu`
    upper_pdu = 252,   ///< an exported PDU for the dissector `mbrtu`; nothing to set
};

/// The addresses of the UDP form: 10.0.0.N is unit N, 10.0.0.0 all units. Of a frame whose role is unknown the ports
/// are others, so that it is not taken for a part of an exchange.
/// Internal.
struct made_up_network {
    static constexpr std::uint32_t units = 0x0A00'0000U;
    static constexpr std::uint32_t client = units + 254U;
    static constexpr std::uint16_t unit_port = 1502;
    static constexpr std::uint16_t client_port = 50'000;
    static constexpr std::uint16_t unknown_port = 1503;
};

/// Sizes and constants of the headers.
/// Internal.
struct wrapping {
    static constexpr std::uint32_t ip_size = 20;
    static constexpr std::uint32_t udp_size = 28; ///< with that of IPv4
    static constexpr std::uint32_t rtac_size = 12;
    static constexpr std::uint8_t rtac_sent = 1;
    static constexpr std::uint8_t rtac_received = 2;
    static constexpr std::uint16_t dissector_tag = 12;
};

} // namespace rtuwire
