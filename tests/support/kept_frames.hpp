// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A sink for tests: it keeps up to 32 frames, each with its bytes.
#pragma once

#include <array>
#include <cstddef>

#include <rtuwire/trace.hpp>
#include <rtuwire/wire/function.hpp>

namespace rtuwire::test {

using namespace detail;

class kept_frames {
public:
    constexpr void take(traced_frame const& frame) noexcept
    {
        kept& own = all_[count_++];
        own.frame = frame;
        for (std::size_t i = 0; i < frame.bytes.size(); ++i) {
            own.bytes[i] = frame.bytes[i];
        }
    }
    constexpr std::size_t count() const noexcept { return count_; }
    constexpr traced_frame operator[](std::size_t index) const noexcept
    {
        traced_frame frame = all_[index].frame;
        frame.bytes = byte_view{all_[index].bytes.data(), frame.bytes.size()};
        return frame;
    }
    constexpr void clear() noexcept { count_ = 0; }

    /// Whether the frame at a place has these bytes, role, verdict and sender.
    constexpr bool has(std::size_t index, byte_view bytes, frame_role role, frame_verdict verdict,
                       bool is_own = false) const noexcept
    {
        if (index >= count_) {
            return false;
        }
        traced_frame const frame = (*this)[index];
        return same_bytes(frame.bytes, bytes) and frame.role == role and frame.verdict == verdict and
               frame.is_own == is_own;
    }
    constexpr bool has_at(std::size_t index, instant at) const noexcept
    {
        return index < count_ and (*this)[index].at == at;
    }

private:
    struct kept {
        traced_frame frame{.bytes = {}, .at = instant{0}};
        std::array<std::byte, max_adu_size> bytes{};
    };
    std::array<kept, 32> all_{};
    std::size_t count_{0};
};

} // namespace rtuwire::test
