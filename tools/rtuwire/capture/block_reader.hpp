// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// What the blocks of a pcapng file and the records of a pcap file hold: interfaces, whose times count in steps of their
// own, and frames. Knows a block at a time; capture_reader.hpp, which uses it, finds where they begin and end.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

#include <rtuwire/trace.hpp>

#include "capture/captured_frame.hpp"
#include "capture/file_order.hpp"
#include "capture/frame_unwrapper.hpp"

namespace tool {

/// Types of blocks and codes of options that are read here.
struct pcapng_code {
    static constexpr std::uint32_t section = 0x0A0D'0D0AU;
    static constexpr std::uint32_t byte_order = 0x1A2B'3C4DU;
    static constexpr std::uint32_t interface_description = 1;
    static constexpr std::uint32_t old_packet = 2;
    static constexpr std::uint32_t simple_packet = 3;
    static constexpr std::uint32_t enhanced_packet = 6;

    static constexpr std::uint16_t comment = 1;
    static constexpr std::uint16_t packet_flags = 2;
    static constexpr std::uint16_t bits_per_second = 8;
    static constexpr std::uint16_t time_resolution = 9;
    static constexpr std::uint16_t time_offset = 14;
};

/// One interface: what packets of it are, and how its times count.
struct capture_interface {
    std::uint32_t link_type{0};
    std::uint32_t bits_per_second{0};
    std::uint8_t resolution{6}; ///< n: steps of 10^-n s, or of 2^-n s where the highest bit is 1
    std::uint64_t offset{0};    ///< seconds, in two's complement

    /// Whether a second is counted in steps that 64 bits can hold.
    [[nodiscard]] constexpr bool has_good_resolution() const noexcept
    {
        return (resolution & 0x80U) != 0 ? (resolution & 0x7FU) < 64 : resolution < 20;
    }

    /// A time in microseconds; rounded towards zero, and modulo 2^64.
    [[nodiscard]] constexpr std::uint64_t microseconds_of(std::uint64_t steps) const noexcept
    {
        return offset * 1'000'000U + ((resolution & 0x80U) != 0 ? of_binary(steps) : of_decimal(steps));
    }

private:
    [[nodiscard]] constexpr std::uint64_t of_decimal(std::uint64_t steps) const noexcept
    {
        for (unsigned i = resolution; i < 6; ++i) {
            steps *= 10;
        }
        for (unsigned i = 6; i < resolution; ++i) {
            steps /= 10;
        }
        return steps;
    }

    /// Seconds, and of the rest as many bits as leave room for 10^6.
    [[nodiscard]] constexpr std::uint64_t of_binary(std::uint64_t steps) const noexcept
    {
        constexpr unsigned most = 44;
        unsigned const bits = resolution & 0x7FU;
        std::uint64_t const whole = steps >> bits;
        std::uint64_t const rest = steps - (whole << bits);
        unsigned const cut = bits > most ? bits - most : 0U;
        return whole * 1'000'000U + ((rest >> cut) * 1'000'000U >> (bits - cut));
    }
};

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
    [[nodiscard]] constexpr capture_errc read(std::uint32_t type, rtuwire::byte_view body) noexcept
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
        return find(packet, 0, {.bytes = {}, .at = rtuwire::instant{0}}, unix_microseconds);
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

    [[nodiscard]] constexpr capture_errc read_section(rtuwire::byte_view body) noexcept
    {
        interface_count_ = 0;
        return order.u16(body, 4) == 1 ? capture_errc::none : capture_errc::unsupported_version;
    }

    [[nodiscard]] constexpr capture_errc read_interface(rtuwire::byte_view body) noexcept
    {
        if (interface_count_ == most_interfaces) {
            return capture_errc::too_many_interfaces;
        }
        capture_interface added{.link_type = order.u16(body, 0)};
        auto const take = [&](std::uint16_t code, rtuwire::byte_view value) { return take_option(added, code, value); };
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
                                             rtuwire::byte_view value) const noexcept
    {
        if (code == pcapng_code::time_resolution and value.size() == 1) {
            added.resolution = std::to_integer<std::uint8_t>(value[0]);
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
    [[nodiscard]] constexpr capture_errc read_simple_packet(rtuwire::byte_view body) noexcept
    {
        if (interface_count_ == 0) {
            return capture_errc::no_such_interface;
        }
        std::uint32_t const full = order.u32(body, 0);
        std::uint32_t const kept = snap_length_ != 0 and snap_length_ < full ? snap_length_ : full;
        if (kept > body.size() - 4) {
            return capture_errc::wrong_block_length;
        }
        return find({body.subspan(4, kept), full}, 0, {.bytes = {}, .at = rtuwire::instant{0}}, 0);
    }

    [[nodiscard]] constexpr capture_errc read_packet(rtuwire::byte_view body, std::uint32_t number) noexcept
    {
        if (number >= interface_count_) {
            return capture_errc::no_such_interface;
        }
        rtuwire::byte_view const behind = body.subspan(packet_head_size);
        std::uint32_t const kept = order.u32(body, 12);
        if (kept > behind.size()) {
            return capture_errc::wrong_block_length;
        }
        rtuwire::traced_frame frame{.bytes = {}, .at = rtuwire::instant{0}};
        if (not take_options(behind.subspan(padded(kept)), frame)) {
            return capture_errc::wrong_option;
        }
        std::uint64_t const steps = std::uint64_t{order.u32(body, 4)} << 32U | order.u32(body, 8);
        std::uint64_t const time = interfaces_[number].microseconds_of(steps);
        return find({behind.first(kept), order.u32(body, 16)}, number, frame, time);
    }

    [[nodiscard]] constexpr bool take_options(rtuwire::byte_view options, rtuwire::traced_frame& frame) const noexcept
    {
        return for_each_option(order, options, [&](std::uint16_t code, rtuwire::byte_view value) {
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
    [[nodiscard]] constexpr capture_errc find(packet_view packet, std::uint32_t number, rtuwire::traced_frame frame,
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
        frame.at = rtuwire::instant{static_cast<std::uint32_t>(time)};
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

} // namespace tool
