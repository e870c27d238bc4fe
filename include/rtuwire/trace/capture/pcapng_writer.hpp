// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// Frames as they passed, as the blocks of a pcapng file, which Wireshark opens. Each block is whole when it is given
// away, so that a ring or a UART may drop one for which it has no room. Knows no file and no clock.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include <rtuwire/core/bytes.hpp>
#include <rtuwire/core/literal.hpp>
#include <rtuwire/core/time.hpp>
#include <rtuwire/core/version.hpp>
#include <rtuwire/trace/traced_frame.hpp>

namespace rtuwire {
inline namespace RTUWIRE_BUILD {

/// What a capture puts around each frame; the number is the link type of the file. Modbus RTU has no link type of its
/// own, so Wireshark finds out what a frame is only from something around it. Only `udp` lets Wireshark tell
/// requests from responses, and pair them.
enum class capture_form : std::uint16_t {
    udp = 228,         ///< IPv4 and UDP with addresses that are made up; Wireshark needs `-o mbrtu.udp.port:1502`
    user0 = 147,       ///< the bare frame; Wireshark needs an entry for USER0 in its DLT table: mbrtu
    rtac_serial = 250, ///< the header of an RTAC recorder; Wireshark needs `-d rtacser.data,mbrtu`
    upper_pdu = 252,   ///< an exported PDU for the dissector `mbrtu`; nothing to set
};

namespace detail {

/// Types of blocks and codes of options that are written here.
struct pcapng_code {
    static constexpr std::uint32_t section = 0x0A0D'0D0AU;
    static constexpr std::uint32_t byte_order = 0x1A2B'3C4DU;
    static constexpr std::uint32_t interface_description = 1;
    static constexpr std::uint32_t enhanced_packet = 6;

    static constexpr std::uint16_t comment = 1;
    static constexpr std::uint16_t interface_name = 2;
    static constexpr std::uint16_t packet_flags = 2;
    static constexpr std::uint16_t application = 4;
    static constexpr std::uint16_t bits_per_second = 8;
    static constexpr std::uint16_t time_resolution = 9;
};

/// Blocks one behind the other, in place. What does not fit is not written: who uses it knows that all of it does.
class block_builder {
public:
    constexpr void clear() noexcept { size_ = 0; }

    /// Begins a block; its length is filled in at its end.
    constexpr void begin(std::uint32_t type) noexcept
    {
        start_ = size_;
        u32(type);
        u32(0);
    }

    /// Ends the block with its length.
    constexpr void end() noexcept
    {
        std::uint32_t const length = static_cast<std::uint32_t>(size_ - start_) + 4U;
        u32(length);
        std::size_t const behind = size_;
        size_ = start_ + 4;
        u32(length);
        size_ = behind;
    }

    constexpr void u8(std::uint32_t value) noexcept
    {
        if (size_ < bytes_.size()) {
            bytes_[size_++] = to_byte(value);
        }
    }
    constexpr void u16(std::uint32_t value) noexcept
    {
        u8(value);
        u8(value >> 8U);
    }
    constexpr void u32(std::uint32_t value) noexcept
    {
        u16(value);
        u16(value >> 16U);
    }
    /// In the order of the network, most significant byte first.
    constexpr void network_u16(std::uint32_t value) noexcept
    {
        u8(value >> 8U);
        u8(value);
    }
    constexpr void network_u32(std::uint32_t value) noexcept
    {
        network_u16(value >> 16U);
        network_u16(value);
    }
    constexpr void bytes(byte_view source) noexcept
    {
        for (std::byte const each : source) {
            u8(to_u8(each));
        }
    }
    constexpr void text(literal source) noexcept
    {
        for (char const each : source) {
            u8(static_cast<unsigned char>(each));
        }
    }

    /// Fills up to a multiple of four bytes.
    constexpr void pad() noexcept
    {
        while ((size_ - start_) % 4 != 0) {
            u8(0);
        }
    }

    /// The code and size of an option; its value and `pad` follow.
    constexpr void option(std::uint16_t code, std::size_t size) noexcept
    {
        u16(code);
        u16(static_cast<std::uint32_t>(size));
    }
    constexpr void option(std::uint16_t code, literal value) noexcept
    {
        option(code, value.size());
        text(value);
        pad();
    }
    constexpr void end_of_options() noexcept { u32(0); }

    [[nodiscard]] constexpr byte_view view() const noexcept { return byte_view{bytes_}.first(size_); }

private:
    // A packet of the UDP form takes most: 28 bytes of the block, 284 of the packet, 36 of options and the end.
    std::array<std::byte, 352> bytes_{};
    std::size_t start_{0};
    std::size_t size_{0};
};

// What stands in front of a frame in each form of capture.

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
constexpr void write_udp_header(block_builder& out, made_up_route const& way, std::size_t payload) noexcept
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
constexpr void write_rtac_header(block_builder& out, traced_frame const& frame,
                                 std::uint64_t unix_microseconds) noexcept
{
    out.network_u32(static_cast<std::uint32_t>(unix_microseconds / 1'000'000U));
    out.network_u32(static_cast<std::uint32_t>(unix_microseconds % 1'000'000U));
    out.u8(frame.is_own ? wrapping::rtac_sent : wrapping::rtac_received);
    out.u8(0);
    out.network_u16(0);
}

/// What stands in front of a frame.
constexpr void write_wrapping(block_builder& out, capture_form form, traced_frame const& frame,
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

} // namespace detail

/// What a capture says of its line.
struct capture_options {
    capture_form form{capture_form::udp};
    std::span<char const> interface_name{}; ///< "/dev/ttyUSB0"; 63 characters of it are kept, up to a zero
    std::uint32_t bits_per_second{0};       ///< 0: not known
};

/// When a capture starts: the time by the calendar, and what the clock of the frames showed then. A device without a
/// calendar gives 0, and its frames are of the year 1970.
struct capture_start {
    std::uint64_t unix_microseconds{0};
    instant at;
};

/// The blocks of a pcapng file, one at a time in 352 bytes of its own:
///
///     uart.send(blocks.begin({.bits_per_second = 19'200}, {.at = now}));
///     uart.send(blocks.packet(frame));
///
/// The 32 bits of `instant` become 64: between two calls may lie up to 35 minutes. Where a line is silent for longer,
/// call `advance` in between.
class pcapng_blocks {
public:
    /// A frame's first bytes, which a packet keeps; of a longer one it keeps only the size beside them.
    static constexpr std::size_t most_kept = 256;

    /// The blocks with which a file begins. Where they are sent again, a reader that came late can begin there.
    /// The view is valid until the next call.
    [[nodiscard]] constexpr byte_view begin(capture_options const& options, capture_start start) noexcept
    {
        form_ = options.form;
        time_ = start.unix_microseconds;
        at_ = start.at;
        out_.clear();
        write_section();
        write_interface(options);
        return out_.view();
    }

    /// Says what time it is, where no frame did so for up to 35 minutes.
    constexpr void advance(instant now) noexcept
    {
        std::uint32_t const ahead = (now - at_).microseconds;
        constexpr std::uint64_t turn = std::uint64_t{1} << 32U;
        time_ += reached(now, at_) ? ahead : ahead - turn;
        at_ = now;
    }

    /// The same by the calendar, after any length of time: for a host that may be stopped for an hour.
    constexpr void advance(instant now, std::uint64_t unix_microseconds) noexcept
    {
        time_ = unix_microseconds;
        at_ = now;
    }

    /// The block of a frame; after `begin`. A frame may be up to 35 minutes older than the one before. The view is valid until the
    /// next call.
    [[nodiscard]] constexpr byte_view packet(traced_frame const& frame) noexcept
    {
        advance(frame.at);
        out_.clear();
        write_packet(frame);
        return out_.view();
    }

private:
    constexpr void write_section() noexcept
    {
        out_.begin(detail::pcapng_code::section);
        out_.u32(detail::pcapng_code::byte_order);
        out_.u16(1);
        out_.u16(0);
        out_.u32(0xFFFF'FFFFU); // the length of the section is not known
        out_.u32(0xFFFF'FFFFU);
        out_.option(detail::pcapng_code::application, "rtuwire");
        out_.end_of_options();
        out_.end();
    }

    constexpr void write_interface(capture_options const& options) noexcept
    {
        out_.begin(detail::pcapng_code::interface_description);
        out_.u16(static_cast<std::uint32_t>(form_));
        out_.u16(0);
        out_.u32(0xFFFF);
        write_name(options.interface_name);
        if (form_ == capture_form::udp) {
            out_.option(detail::pcapng_code::comment,
                        "A serial line. IP addresses and ports are made up: 10.0.0.N is unit N, "
                        "10.0.0.0 all units, 10.0.0.254 the client.");
        }
        if (options.bits_per_second != 0) {
            out_.option(detail::pcapng_code::bits_per_second, 8);
            out_.u32(options.bits_per_second);
            out_.u32(0);
        }
        out_.option(detail::pcapng_code::time_resolution, 1);
        out_.u32(6); // microseconds
        out_.end_of_options();
        out_.end();
    }

    constexpr void write_name(std::span<char const> name) noexcept
    {
        std::size_t size = 0;
        while (size < name.size() and size < 63 and name[size] != '\0') {
            ++size;
        }
        if (size == 0) {
            return;
        }
        out_.option(detail::pcapng_code::interface_name, size);
        for (char const each : name.first(size)) {
            out_.u8(static_cast<unsigned char>(each));
        }
        out_.pad();
    }

    constexpr void write_packet(traced_frame const& frame) noexcept
    {
        std::size_t const kept = frame.bytes.size() < most_kept ? frame.bytes.size() : most_kept;
        std::uint32_t const around = detail::wrapping_size(form_);
        out_.begin(detail::pcapng_code::enhanced_packet);
        out_.u32(0);
        out_.u32(static_cast<std::uint32_t>(time_ >> 32U));
        out_.u32(static_cast<std::uint32_t>(time_));
        out_.u32(static_cast<std::uint32_t>(kept) + around);
        out_.u32(static_cast<std::uint32_t>(frame.bytes.size()) + around);
        detail::write_wrapping(out_, form_, frame, time_);
        out_.bytes(frame.bytes.first(kept));
        out_.pad();
        out_.option(detail::pcapng_code::packet_flags, 4);
        out_.u32(frame.is_own ? 2 : 1);
        write_comment(frame);
        out_.end_of_options();
        out_.end();
    }

    /// Only ports tell a role, so that the other forms say it in words.
    constexpr void write_comment(traced_frame const& frame) noexcept
    {
        bool const has_role = form_ != capture_form::udp and frame.role != frame_role::unknown;
        bool const has_verdict = frame.verdict != frame_verdict::good;
        literal const role = has_role ? name(frame.role) : literal{};
        literal const between = has_role and has_verdict ? literal{", "} : literal{};
        literal const verdict = has_verdict ? name(frame.verdict) : literal{};
        if (has_role or has_verdict) {
            out_.option(detail::pcapng_code::comment, role.size() + between.size() + verdict.size());
            out_.text(role);
            out_.text(between);
            out_.text(verdict);
            out_.pad();
        }
    }

    detail::block_builder out_{};
    capture_form form_{}; // zero until it begins, so that a `constinit` object lies in .bss: 400 bytes of flash less
    std::uint64_t time_{0};
    instant at_{0};
};

/// What takes the bytes of a capture, a whole block at a time.
template <typename Out>
concept byte_sink = requires(Out& out, byte_view block)
{
    out(block);
};

/// A `frame_sink` that gives each frame on as a block of a pcapng file:
///
///     pcapng_writer capture{[&](byte_view block) noexcept { file.write(block); }};
///     capture.begin({.interface_name = device, .bits_per_second = 19'200}, {.unix_microseconds = wall, .at = now});
///
/// Before `begin` it drops every frame.
template <byte_sink Out> class pcapng_writer {
public:
    /// Copies the sink; nothing is written yet.
    explicit constexpr pcapng_writer(Out out) noexcept : out_{out} {}

    /// Writes the blocks with which a file begins, and takes frames from now on.
    constexpr void begin(capture_options const& options, capture_start start) noexcept
    {
        has_begun_ = true;
        out_(blocks_.begin(options, start));
    }

    /// As `pcapng_blocks::advance`.
    constexpr void advance(instant now) noexcept { blocks_.advance(now); }
    constexpr void advance(instant now, std::uint64_t unix_microseconds) noexcept
    {
        blocks_.advance(now, unix_microseconds);
    }

    constexpr void take(traced_frame const& frame) noexcept
    {
        if (has_begun_) {
            out_(blocks_.packet(frame));
        }
    }

private:
    Out out_;
    pcapng_blocks blocks_{};
    bool has_begun_{false};
};

} // namespace RTUWIRE_BUILD
} // namespace rtuwire
