// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A fault of a line as a person types it: "late=1%", "lost@250x5", "request-delay=5%:30ms"; and which frames it meets. That
// follows from the seed and the frame's number alone, so that the same again makes the same again, whatever else is typed.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include <rtuwire/sim.hpp>

namespace tool {

enum class frame_way : std::uint8_t { request, answer };

/// In the order in which they are named.
enum class fault_kind : std::uint8_t {
    delay,
    late,
    doubled,
    foreign,
    lost,
    damaged,
    noise,
    echo,
    lumps,
    split,
    cut,
    babble,
};

/// "late", "request-lost".
[[nodiscard]] std::string name_of(fault_kind kind, frame_way way);

struct line_fault {
    fault_kind kind{};
    frame_way way{frame_way::answer};
    std::uint32_t in_a_million{0};
    std::uint32_t first{0}; ///< from this number on; 0: no moment was named
    std::uint32_t count{1}; ///< so many of them
    rtuwire::duration time{};
    std::string typed{};

    /// A babble goes on behind the client's time-out where no time is typed: its deadline fires though bytes keep coming.
    [[nodiscard]] rtuwire::duration time_at(rtuwire::duration time_out) const
    {
        return time.microseconds != 0 ? time : rtuwire::duration{time_out.microseconds + time_out.microseconds / 8};
    }
};

/// What a person typed, one or more faults between commas. Ends the command where a word is none.
[[nodiscard]] std::vector<line_fault> faults_in(std::string_view words);

/// What a fault does, with its own figures: "an answer comes later, by up to 30 ms".
[[nodiscard]] std::string words_of(line_fault const& fault, rtuwire::duration time_out);

/// Whether it meets a frame, counted in its direction from 1 on.
[[nodiscard]] bool meets(line_fault const& fault, std::uint32_t seed, std::uint32_t number);

/// For what it does to the frame, apart from whether it does.
[[nodiscard]] rtuwire::sim::random_source draws_of(line_fault const& fault, std::uint32_t seed, std::uint32_t number);

/// All names with what they do, a line each.
[[nodiscard]] std::string faults_text();

} // namespace tool
