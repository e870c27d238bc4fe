// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// Keeps the frames that passed until another context takes them: the loop or an interrupt writes, a thread, the loop or
// an interrupt reads. No lock, no heap, and no interrupt is masked.
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <type_traits>

#include <rtuwire/core/bytes.hpp>
#include <rtuwire/core/time.hpp>
#include <rtuwire/core/version.hpp>
#include <rtuwire/rtu/published.hpp>
#include <rtuwire/trace/traced_frame.hpp>
#include <rtuwire/wire/function.hpp>

namespace rtuwire {
inline namespace RTUWIRE_BUILD {

/// A sink of `Bytes` bytes, a power of two; a frame takes 6 more than it has. One context writes: all engines that are
/// traced by one ring run in it. One context reads, by `poll_frame`.
///
/// What does not fit is dropped, and counted in `lost`: what is kept already stays, for only the reader may move it.
/// More than 256 bytes that belong to no frame are kept as several records, each of which may be dropped alone.
///
///     constinit trace_ring<4096> frames;              // some 250 requests and responses of 4 registers
///     client::traced_by<trace_ring<4096>> link{timing};
///     link.trace_to(frames);
///
/// Its processor loads and stores 4 bytes at once: not one of 8 bits.
template <std::size_t Bytes> class trace_ring {
    static_assert(std::has_single_bit(Bytes) and Bytes >= 16 and Bytes <= 0x8000'0000U,
                  "the size of a trace_ring is a power of two, at least 16");

    /// Counts past the size and wraps, so that full and empty differ.
    using index = std::conditional_t<(Bytes <= 0x8000), std::uint16_t, std::uint32_t>;

public:
    /// The most bytes of a record: those of the longest frame.
    static constexpr std::size_t longest = max_adu_size;

    /// Zero-initialised: a `constinit` ring takes no flash.
    constexpr trace_ring() noexcept = default;

    /// Deleted: a client keeps its address.
    trace_ring(trace_ring const&) = delete;
    trace_ring& operator=(trace_ring const&) = delete;

    /// In the writer: keeps a frame. What is traced calls it.
    constexpr void take(traced_frame const& frame) noexcept
    {
        byte_view rest = frame.bytes;
        do {
            std::size_t const size = rest.size() < longest ? rest.size() : longest;
            keep(frame, rest.first(size));
            rest = rest.subspan(size);
        } while (not rest.empty());
    }

    /// In the reader: takes the oldest frame out of the ring; its bytes are copied to `place`, where they stay until the
    /// reader itself writes there.
    [[nodiscard]] constexpr std::optional<traced_frame> poll_frame(std::span<std::byte, longest> place) noexcept
    {
        if (is_empty()) {
            return std::nullopt;
        }
        index at = out_;
        std::uint32_t time = 0;
        for (unsigned i = 0; i < sizeof time; ++i) {
            time = time << 8U | get(at);
        }
        std::uint8_t const what = get(at);
        std::size_t const size = std::size_t{get(at)} + (what >> size_at) * 256U;
        for (std::byte& each : place.first(size)) {
            each = std::byte{get(at)};
        }
        detail::store(out_, at);
        return traced_frame{byte_view{place.data(), size}, instant{time}, static_cast<frame_role>(what & role_mask),
                            static_cast<frame_verdict>(what >> verdict_at & verdict_mask), (what >> own_at & 1U) != 0};
    }

    /// In the reader: whether there is nothing to take.
    [[nodiscard]] constexpr bool is_empty() const noexcept { return detail::load(in_) == out_; }

    /// In either: how many were dropped because the ring was full, since the start. Wraps.
    [[nodiscard]] constexpr std::uint32_t lost() const noexcept { return detail::load(lost_); }

private:
    static constexpr std::size_t head = 6;
    // In one byte: the role, the verdict, whether it is its own, whether it has 256 bytes.
    static constexpr unsigned role_mask = 0x03, verdict_mask = 0x07;
    static constexpr unsigned verdict_at = 2, own_at = 5, size_at = 6;

    constexpr void keep(traced_frame const& frame, byte_view bytes) noexcept
    {
        index at = in_;
        std::size_t const used = static_cast<index>(at - detail::load(out_));
        if (Bytes - used < head + bytes.size()) {
            detail::store(lost_, lost_ + 1U);
            return;
        }
        for (unsigned shift = 32; shift != 0;) {
            shift -= 8;
            put(at, frame.at.microseconds >> shift);
        }
        unsigned const what = static_cast<unsigned>(frame.role) | static_cast<unsigned>(frame.verdict) << verdict_at |
                              (frame.is_own ? 1U << own_at : 0U);
        put(at, what | static_cast<unsigned>(bytes.size() / 256U) << size_at);
        put(at, static_cast<std::uint32_t>(bytes.size()));
        for (std::byte const each : bytes) {
            put(at, detail::to_u8(each));
        }
        detail::store(in_, at);
    }

    constexpr void put(index& at, std::uint32_t value) noexcept
    {
        bytes_[at % Bytes] = detail::to_byte(value);
        ++at;
    }
    constexpr std::uint8_t get(index& at) const noexcept
    {
        std::uint8_t const value = detail::to_u8(bytes_[at % Bytes]);
        ++at;
        return value;
    }

    // Written by the writer.
    index in_{0};
    std::uint32_t lost_{0};
    // Written by the reader.
    index out_{0};
    // Written from `in_` on, read from `out_` to `in_`.
    std::array<std::byte, Bytes> bytes_{};
};

} // namespace RTUWIRE_BUILD
} // namespace rtuwire
