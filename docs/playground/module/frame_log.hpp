// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// The frames that passed, the newest last, and what each of them says.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "frame/register_names.hpp"
#include "json.hpp"

namespace playground {

/// Who put a frame on the line.
enum class sender : std::uint8_t { client, drive, person };

struct seen_frame {
    std::uint64_t begin_us{0}; ///< of its first byte
    std::uint64_t end_us{0};   ///< of its last byte
    sender from{sender::client};
    bool is_damaged{false};
    bool is_unanswered{false}; ///< no frame: a request had no response
    bool is_lost{false};       ///< it did not get through the cable
    bool is_exception{false};
    std::vector<std::byte> bytes{};
    std::vector<std::byte> request{}; ///< of a response
    std::string summary{};
};

class frame_log {
public:
    explicit frame_log(tool::register_names const& names) : names_{&names} {}
    /// Nothing has a name.
    frame_log() = default;

    void add(seen_frame frame);

    /// The number of the next frame; the first is 0.
    [[nodiscard]] std::uint32_t end() const noexcept { return first_ + static_cast<std::uint32_t>(frames_.size()); }

    /// The frames from a number on that are still kept: a list in JSON.
    [[nodiscard]] std::string list(std::uint32_t from) const;

    /// All fields of a frame, in JSON; by other names than those of the log where they are given.
    [[nodiscard]] std::string explain(std::uint32_t number) const { return explain(number, names_); }
    [[nodiscard]] std::string explain(std::uint32_t number, tool::register_names const* names) const;

    /// The unit that a frame names; 0 where there is no such frame.
    [[nodiscard]] std::uint8_t unit_of(std::uint32_t number) const noexcept
    {
        bool const is_kept = number >= first_ and number < end();
        auto const& seen = frames_[is_kept ? number - first_ : 0];
        auto const& bytes = seen.bytes.empty() ? seen.request : seen.bytes;
        return is_kept and not bytes.empty() ? std::to_integer<std::uint8_t>(bytes[0]) : std::uint8_t{0};
    }

private:
    static constexpr std::size_t most = 400;

    tool::register_names const* names_{nullptr};
    std::vector<seen_frame> frames_{};
    std::uint32_t first_{0};
};

} // namespace playground
