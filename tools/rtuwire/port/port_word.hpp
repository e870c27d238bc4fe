// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// What a person types for a port: `/dev/ttyUSB0`, `tcp://host:4001`, `mbap://host`, `sim:atv320:7,atv12:3`, or the name of a
// capture file. Only looks at the word, and at the file of that name; opens nothing.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "words/words.hpp"

namespace tool {

/// A serial device. Whether there is one is seen when it is opened.
struct serial_device {
    std::string path;

    friend bool operator==(serial_device const&, serial_device const&) = default;
};

/// A serial device server, or another program that speaks RTU over TCP.
struct tcp_address {
    std::string host; ///< a name or a number; one of IPv6 without its brackets
    std::uint16_t port{0};

    friend bool operator==(tcp_address const&, tcp_address const&) = default;
};

/// A server of Modbus TCP: a device, or a gateway to the units of a line.
struct mbap_address {
    static constexpr std::uint16_t usual_port = 502;

    std::string host; ///< as of a `tcp_address`
    std::uint16_t port{usual_port};

    friend bool operator==(mbap_address const&, mbap_address const&) = default;
};

/// A simulated drive, or a device of a register file.
struct simulated_drive_choice {
    std::string drive; ///< the name of one of `altivar::all_drives`, or "meter.toml"
    std::uint8_t unit{1};

    friend bool operator==(simulated_drive_choice const&, simulated_drive_choice const&) = default;
};

/// A line of simulated drives: at least one, each at an address of its own.
struct simulated_drives_choice {
    std::vector<simulated_drive_choice> drives;

    friend bool operator==(simulated_drives_choice const&, simulated_drives_choice const&) = default;
};

/// A file of frames that have passed: pcapng or pcap.
struct capture_file {
    std::string path;

    friend bool operator==(capture_file const&, capture_file const&) = default;
};

using port_description = std::variant<serial_device, tcp_address, mbap_address, simulated_drives_choice, capture_file>;

/// The port that was meant; or why the word is refused.
struct port_choice {
    port_description port;
    std::optional<refusal> refused{};
};

[[nodiscard]] port_choice read_port_word(std::string_view word);

/// The same of an address of this machine to listen at, tcp or mbap, by its number; `localhost` is 127.0.0.1. It names its port,
/// of which 0 is any that is free.
[[nodiscard]] port_choice read_listen_word(std::string_view word);

} // namespace tool
