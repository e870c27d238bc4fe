// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// Frames as they passed, as the blocks of a pcapng file, which Wireshark opens. Each block is whole when it is given
// away, so that a ring or a UART may drop one for which it has no room. Knows no file and no clock.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include <rtuwire/core/bytes.hpp>
#include <rtuwire/core/literal.hpp>
#include <rtuwire/core/time.hpp>
#include <rtuwire/core/version.hpp>
#include <rtuwire/trace/capture/block_builder.hpp>
#include <rtuwire/trace/capture/capture_form.hpp>
#include <rtuwire/trace/capture/frame_words.hpp>
#include <rtuwire/trace/capture/frame_wrapper.hpp>
#include <rtuwire/trace/traced_frame.hpp>

namespace rtuwire::inline RTUWIRE_BUILD {

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
        out_.begin(pcapng_code::section);
        out_.u32(pcapng_code::byte_order);
        out_.u16(1);
        out_.u16(0);
        out_.u32(0xFFFF'FFFFU); // the length of the section is not known
        out_.u32(0xFFFF'FFFFU);
        out_.option(pcapng_code::application, "rtuwire");
        out_.end_of_options();
        out_.end();
    }

    constexpr void write_interface(capture_options const& options) noexcept
    {
        out_.begin(pcapng_code::interface_description);
        out_.u16(static_cast<std::uint32_t>(form_));
        out_.u16(0);
        out_.u32(0xFFFF);
        write_name(options.interface_name);
        if (form_ == capture_form::udp) {
            out_.option(pcapng_code::comment, "A serial line. IP addresses and ports are made up: 10.0.0.N is unit N, "
                                              "10.0.0.0 all units, 10.0.0.254 the client.");
        }
        if (options.bits_per_second != 0) {
            out_.option(pcapng_code::bits_per_second, 8);
            out_.u32(options.bits_per_second);
            out_.u32(0);
        }
        out_.option(pcapng_code::time_resolution, 1);
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
        out_.option(pcapng_code::interface_name, size);
        for (char const each : name.first(size)) {
            out_.u8(static_cast<unsigned char>(each));
        }
        out_.pad();
    }

    constexpr void write_packet(traced_frame const& frame) noexcept
    {
        std::size_t const kept = frame.bytes.size() < most_kept ? frame.bytes.size() : most_kept;
        std::uint32_t const around = wrapping_size(form_);
        out_.begin(pcapng_code::enhanced_packet);
        out_.u32(0);
        out_.u32(static_cast<std::uint32_t>(time_ >> 32U));
        out_.u32(static_cast<std::uint32_t>(time_));
        out_.u32(static_cast<std::uint32_t>(kept) + around);
        out_.u32(static_cast<std::uint32_t>(frame.bytes.size()) + around);
        write_wrapping(out_, form_, frame, time_);
        out_.bytes(frame.bytes.first(kept));
        out_.pad();
        out_.option(pcapng_code::packet_flags, 4);
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
            out_.option(pcapng_code::comment, role.size() + between.size() + verdict.size());
            out_.text(role);
            out_.text(between);
            out_.text(verdict);
            out_.pad();
        }
    }

    // A packet of the UDP form takes most: 28 bytes of the block, 284 of the packet, 36 of options and the end.
    block_builder<352> out_{};
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

} // namespace rtuwire
