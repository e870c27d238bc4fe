// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A frame out of a capture, and why a capture cannot be read any further.
#pragma once

#include <cstdint>
#include <string_view>

#include <rtuwire/trace.hpp>

namespace tool {

/// A frame from a capture.
struct captured_frame {
    rtuwire::traced_frame frame;        ///< its `at` are the low 32 bits of the time
    std::uint64_t unix_microseconds{0}; ///< its time
    std::uint32_t full_size{0};         ///< on the line; the file may hold fewer of its bytes
    std::uint32_t bits_per_second{0};   ///< of its line; 0 where the file does not say it
    std::uint16_t line{0};              ///< the number of its line in the file, from 0 on
};

/// What is wrong with a capture.
enum class capture_errc : std::uint8_t {
    none,
    not_a_capture,       ///< the first bytes are neither those of pcapng nor of pcap
    unsupported_version, ///< of the file's format
    wrong_block_length,  ///< not a multiple of four, too short for what is in it, or another at its end
    block_too_long,      ///< a block with frames or interfaces that is longer than the reader's memory
    wrong_option,        ///< an option that is longer than its block, or of the wrong size
    no_such_interface,   ///< a packet of an interface that was not described
    too_many_interfaces, ///< more than the reader keeps
    wrong_resolution,    ///< a time resolution finer than 64 bits can hold
    wrong_packet,        ///< a packet whose headers contradict its size
    cut_short,           ///< the file ends inside a block, or has no bytes
};

/// What is wrong, and in which block.
struct capture_error {
    capture_errc why{capture_errc::none};
    std::uint64_t offset{0}; ///< where the block starts, in bytes from the start of the file

    friend constexpr bool operator==(capture_error const&, capture_error const&) noexcept = default;
};

/// What is wrong, in words.
[[nodiscard]] constexpr std::string_view name(capture_errc why) noexcept
{
    switch (why) {
    case capture_errc::none: break;
    case capture_errc::not_a_capture: return "neither a pcapng nor a pcap file";
    case capture_errc::unsupported_version: return "a version of the format that is not known";
    case capture_errc::wrong_block_length: return "a block with a wrong length";
    case capture_errc::block_too_long: return "a block that is too long";
    case capture_errc::wrong_option: return "an option with a wrong length";
    case capture_errc::no_such_interface: return "a packet of an interface that was not described";
    case capture_errc::too_many_interfaces: return "too many interfaces";
    case capture_errc::wrong_resolution: return "a time resolution that is too fine";
    case capture_errc::wrong_packet: return "a packet whose headers contradict its size";
    case capture_errc::cut_short: return "the end of the file inside a block";
    }
    return "no error";
}

} // namespace tool
