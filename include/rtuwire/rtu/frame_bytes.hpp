// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// Internal: where in its holder's memory a frame cutter keeps the bytes of the frame being received, and at which of
// them the length rule is due.
#pragma once

#include <cstddef>
#include <cstdint>

#include <rtuwire/core/bytes.hpp>
#include <rtuwire/core/version.hpp>
#include <rtuwire/rtu/frame_place.hpp>
#include <rtuwire/rtu/line_silence.hpp>
#include <rtuwire/wire/limits.hpp>

namespace rtuwire::inline RTUWIRE_BUILD::detail {

/// Internal: the base of the frame cutter. `Holder` holds the memory, `bytes_`.
template <typename Holder, direction Way, std::size_t Front> class frame_bytes : public line_silence<Holder, Way> {
public:
    constexpr frame_bytes() noexcept = default;

    /// The memory of the frame, for a response written in its place.
    [[nodiscard]] constexpr byte_span storage() noexcept { return static_cast<Holder&>(*this).bytes_; }
    [[nodiscard]] constexpr byte_view storage() const noexcept { return static_cast<Holder const&>(*this).bytes_; }

    /// Keeps the first `size` bytes of the memory, at most 256, free: later frames are received behind them.
    constexpr void receive_behind(std::size_t size) noexcept requires(Front > 0)
    {
        place_.leave_room_for(size);
        end_ = place_.begin();
    }

    /// The largest frame that there is room for.
    [[nodiscard]] constexpr std::size_t room() const noexcept { return place_.memory - place_.begin(); }

    /// Whether the last frame has the size that its own bytes tell, where they tell one. Silence may have ended
    /// it at another size, where by chance its CRC is right, too.
    [[nodiscard]] constexpr bool matches_size_hint() const noexcept { return rule_at_ == 0 or rule_at_ == end_; }

    /// Whether the last frame had the smallest size, and began with this request's unit and function.
    [[nodiscard]] constexpr bool looks_addressed_to(byte_view request) const noexcept
    {
        std::byte const* const start = storage().data() + place_.begin();
        return size() >= min_adu_size and start[0] == request[0] and (start[1] & std::byte{0x7F}) == request[1];
    }

    /// The bytes of the last frame, or of the one being received.
    [[nodiscard]] constexpr byte_view bytes() const noexcept { return {storage().data() + place_.begin(), size()}; }

    /// What has been received of a frame that has not ended.
    [[nodiscard]] constexpr byte_view begun() const noexcept
    {
        return this->state_ == line_silence<Holder, Way>::state::receiving ? bytes() : byte_view{};
    }

    /// Whether the next byte may turn out to belong to the frame before it.
    [[nodiscard]] constexpr bool has_open_end() const noexcept { return this->is_open_end(); }

    /// Keeps the byte 00 that was taken behind an open end, where there is room.
    constexpr void keep_zero() noexcept
    {
        if (end_ < place_.memory) {
            storage()[end_++] = std::byte{0};
        }
    }

protected:
    /// A frame begins: its first two bytes tell more.
    constexpr void begin_bytes() noexcept
    {
        end_ = place_.begin();
        rule_at_ = static_cast<std::uint16_t>(place_.begin() + 2);
    }

    /// The length rule is due when the frame has `size` bytes; 0 where only silence tells the end.
    constexpr void look_at(std::size_t size) noexcept
    {
        rule_at_ = size == 0 ? std::uint16_t{0} : static_cast<std::uint16_t>(place_.begin() + size);
    }

    /// How many bytes there is room for, up to where the length rule is due.
    constexpr std::size_t bytes_to_look() const noexcept
    {
        bool const is_ahead = rule_at_ > end_ and rule_at_ < place_.memory;
        return (is_ahead ? std::size_t{rule_at_} : place_.memory) - end_;
    }

    constexpr std::size_t size() const noexcept { return std::size_t{end_} - place_.begin(); }

    std::uint16_t end_{0};     ///< behind the last byte
    std::uint16_t rule_at_{0}; ///< where the length rule is due; no byte's position, 0, where it has nothing to say
    [[no_unique_address]] frame_place<Front> place_{};
};

} // namespace rtuwire::detail
