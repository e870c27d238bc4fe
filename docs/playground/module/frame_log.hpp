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

    void add(seen_frame frame);

    /// The number of the next frame; the first is 0.
    [[nodiscard]] std::uint32_t end() const noexcept { return first_ + static_cast<std::uint32_t>(frames_.size()); }

    /// The frames from a number on that are still kept: a list in JSON.
    [[nodiscard]] std::string list(std::uint32_t from) const;

    /// All fields of a frame, in JSON.
    [[nodiscard]] std::string explain(std::uint32_t number) const;

private:
    static constexpr std::size_t most = 400;

    tool::register_names const* names_;
    std::vector<seen_frame> frames_{};
    std::uint32_t first_{0};
};

} // namespace playground
