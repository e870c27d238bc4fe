// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// How a capture file wraps frames. Modbus RTU has no link type of its own, so Wireshark finds out what a frame is only
// from something around it.
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

} // namespace rtuwire
