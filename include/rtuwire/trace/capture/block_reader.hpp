// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// What the blocks of a pcapng file and the records of a pcap file hold: interfaces, and frames.
// Internal: may change with any version.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

#include <rtuwire/core/bytes.hpp>
#include <rtuwire/core/time.hpp>
#include <rtuwire/core/version.hpp>
#include <rtuwire/trace/capture/block_builder.hpp>
#include <rtuwire/trace/capture/capture_error.hpp>
#include <rtuwire/trace/capture/capture_time.hpp>
#include <rtuwire/trace/capture/captured_frame.hpp>
#include <rtuwire/trace/capture/file_order.hpp>
#include <rtuwire/trace/capture/frame_unwrapper.hpp>
#include <rtuwire/trace/capture/frame_words.hpp>
#include <rtuwire/trace/traced_frame.hpp>

namespace rtuwire::inline RTUWIRE_BUILD {

/// Whether blocks of a type are looked into.
[[nodiscard]] constexpr bool is_read_block(std::uint32_t type) noexcept
{
    return type == pcapng_code::section or type == pcapng_code::interface_description or
           type == pcapng_code::old_packet or type == pcapng_code::simple_packet or
           type == pcapng_code::enhanced_packet;
}

/// Reads whole blocks, one at a time, and remembers the interfaces of the section.
class block_reader {
public:
    static constexpr std::size_t most_interfaces = 16;

    file_order order{};

    /// A pcap file has one interface, and no block for it.
    constexpr void set_only_interface(std::uint32_t link_type) noexcept
    {
        interfaces_[0] = {.link_type = link_type};
        interface_count_ = 1;
    }

    /// Reads what stands between the two lengths of a block. `found` is where a frame comes.
    [[nodiscard]] constexpr capture_errc read(std::uint32_t type, byte_view body) noexcept
    {
        found_.reset();
        if (body.size() < fixed_size(type)) {
            return capture_errc::wrong_block_length;
        }
        switch (type) {
        case pcapng_code::section: return read_section(body);
        case pcapng_code::interface_description: return read_interface(body);
        case pcapng_code::simple_packet: return read_simple_packet(body);
        case pcapng_code::old_packet: return read_packet(body, order.u16(body, 0));
        default: return read_packet(body, order.u32(body, 0));
        }
    }

    /// Reads the packet of a pcap record.
    [[nodiscard]] constexpr capture_errc read_record(packet_view packet, std::uint64_t unix_microseconds) noexcept
    {
        found_.reset();
        return find(packet, 0, {.bytes = {}, .at = instant{0}}, unix_microseconds);
    }

    /// The frame of what was read last.
    [[nodiscard]] constexpr std::optional<captured_frame> const& found() const noexcept { return found_; }

    /// How many packets carried no frame.
    [[nodiscard]] constexpr std::uint32_t skipped() const noexcept { return skipped_; }

private:
    /// The size of what each block of a type has.
    [[nodiscard]] static constexpr std::size_t fixed_size(std::uint32_t type) noexcept
    {
        switch (type) {
        case pcapng_code::section: return 16;
        case pcapng_code::interface_description: return 8;
        case pcapng_code::simple_packet: return 4;
        default: return packet_head_size;
        }
    }

    [[nodiscard]] constexpr capture_errc read_section(byte_view body) noexcept
    {
        interface_count_ = 0;
        return order.u16(body, 4) == 1 ? capture_errc::none : capture_errc::unsupported_version;
    }

    [[nodiscard]] constexpr capture_errc read_interface(byte_view body) noexcept
    {
        if (interface_count_ == most_interfaces) {
            return capture_errc::too_many_interfaces;
        }
        capture_interface added{.link_type = order.u16(body, 0)};
        auto const take = [&](std::uint16_t code, byte_view value) { return take_option(added, code, value); };
        if (not for_each_option(order, body.subspan(8), take)) {
            return capture_errc::wrong_option;
        }
        if (not added.has_good_resolution()) {
            return capture_errc::wrong_resolution;
        }
        snap_length_ = interface_count_ == 0 ? order.u32(body, 4) : snap_length_;
        interfaces_[interface_count_++] = added;
        return capture_errc::none;
    }

    /// Takes an option of an interface; false where it has a wrong size.
    [[nodiscard]] constexpr bool take_option(capture_interface& added, std::uint16_t code,
                                             byte_view value) const noexcept
    {
        if (code == pcapng_code::time_resolution and value.size() == 1) {
            added.resolution = to_u8(value[0]);
            return true;
        }
        if (code != pcapng_code::bits_per_second and code != pcapng_code::time_offset) {
            return code != pcapng_code::time_resolution;
        }
        if (value.size() != 8) {
            return false;
        }
        std::uint64_t const number = order.u64(value, 0);
        if (code == pcapng_code::time_offset) {
            added.offset = number;
        } else {
            added.bits_per_second = number > 0xFFFF'FFFFU ? 0 : static_cast<std::uint32_t>(number);
        }
        return true;
    }

    /// A packet without a time, of the first interface.
    [[nodiscard]] constexpr capture_errc read_simple_packet(byte_view body) noexcept
    {
        if (interface_count_ == 0) {
            return capture_errc::no_such_interface;
        }
        std::uint32_t const full = order.u32(body, 0);
        std::uint32_t const kept = snap_length_ != 0 and snap_length_ < full ? snap_length_ : full;
        if (kept > body.size() - 4) {
            return capture_errc::wrong_block_length;
        }
        return find({body.subspan(4, kept), full}, 0, {.bytes = {}, .at = instant{0}}, 0);
    }

    [[nodiscard]] constexpr capture_errc read_packet(byte_view body, std::uint32_t number) noexcept
    {
        if (number >= interface_count_) {
            return capture_errc::no_such_interface;
        }
        byte_view const behind = body.subspan(packet_head_size);
        std::uint32_t const kept = order.u32(body, 12);
        if (kept > behind.size()) {
            return capture_errc::wrong_block_length;
        }
        traced_frame frame{.bytes = {}, .at = instant{0}};
        if (not take_options(behind.subspan(padded(kept)), frame)) {
            return capture_errc::wrong_option;
        }
        std::uint64_t const steps = std::uint64_t{order.u32(body, 4)} << 32U | order.u32(body, 8);
        std::uint64_t const time = interfaces_[number].microseconds_of(steps);
        return find({behind.first(kept), order.u32(body, 16)}, number, frame, time);
    }

    [[nodiscard]] constexpr bool take_options(byte_view options, traced_frame& frame) const noexcept
    {
        return for_each_option(order, options, [&](std::uint16_t code, byte_view value) {
            if (code == pcapng_code::comment) {
                apply_comment(value, frame);
            }
            if (code == pcapng_code::packet_flags and value.size() == 4) {
                frame.is_own = (order.u32(value, 0) & 3U) == 2;
            }
            return code != pcapng_code::packet_flags or value.size() == 4;
        });
    }

    /// Finds the frame in a packet.
    [[nodiscard]] constexpr capture_errc find(packet_view packet, std::uint32_t number, traced_frame frame,
                                              std::uint64_t time) noexcept
    {
        capture_interface const& line = interfaces_[number];
        if (packet.full_size < packet.bytes.size()) {
            return capture_errc::wrong_packet;
        }
        packet_content const content = unwrap(line.link_type, packet, frame);
        if (content != packet_content::frame) {
            skipped_ += content == packet_content::other ? 1U : 0U;
            return content == packet_content::other ? capture_errc::none : capture_errc::wrong_packet;
        }
        frame.bytes = packet.bytes;
        frame.at = instant{static_cast<std::uint32_t>(time)};
        found_.emplace(captured_frame{.frame = frame,
                                      .unix_microseconds = time,
                                      .full_size = packet.full_size,
                                      .bits_per_second = line.bits_per_second,
                                      .line = static_cast<std::uint16_t>(number)});
        return capture_errc::none;
    }

    static constexpr std::size_t packet_head_size = 20;

    std::array<capture_interface, most_interfaces> interfaces_{};
    std::size_t interface_count_{0};
    std::uint32_t snap_length_{0};
    std::uint32_t skipped_{0};
    std::optional<captured_frame> found_{};
};

} // namespace rtuwire
