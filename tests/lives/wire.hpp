// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// The line between a controller and its drives: which frames get lost on it, and which come late.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdio>
#include <memory>
#include <vector>

#include "lives/judge.hpp"

namespace rtuwire::lives {

/// How frames between the controller and one drive get lost.
struct losses {
    bool requests{false};
    bool answers{false};
    std::uint32_t in_a_million{0};
    unsigned each_nth{0}; ///< 0: none
    unsigned only_nth{0}; ///< 0: none

    bool is_good() const
    {
        return not requests and not answers and in_a_million == 0 and each_nth == 0 and only_nth == 0;
    }
};

/// Another master waits for a word to run whose response gets lost, and says its own while the drive is checked behind it.
struct ambush {
    enum class stage { none, waiting, cutting, counting };
    stage at{stage::none};
    unsigned reads{0}; ///< that are answered before its word
    bool cuts_power{false};
};

/// A drive with all that belongs to it on the line.
struct node {
    std::unique_ptr<far_drive> drive;
    judge law;
    losses lost{};
    bool misses_broadcast{false}; ///< the next one
    unsigned passed{0};
    std::array<std::byte, max_adu_size> response{};
    std::size_t response_size{0}; ///< of one that has not left
    std::uint16_t status{0};      ///< when that was made
    moment leaves_at{0};
    bool owes_another{false}; ///< a response, to another master
    bool is_local{false};
    ambush other{};
    unsigned cut_behind{0};   ///< so many responses its power goes and comes back; 0: not
    unsigned refer_behind{0}; ///< so many responses another master writes its reference; 0: not

    node(life_setting const& how, drive_setting const& set, instant now, tally& counts)
        : drive{make_drive(set, how.timing(), now)}, law{how, set, *drive, counts}
    {}

    bool loses(bool is_request, detail::random_source& chance)
    {
        ++passed;
        bool const is_nth = lost.each_nth != 0 and passed % lost.each_nth == 0;
        bool const is_the_one = lost.only_nth != 0 and --lost.only_nth == 0;
        return (is_request ? lost.requests : lost.answers) or is_nth or is_the_one or chance.happens(lost.in_a_million);
    }
};

/// What a life prints, where it is asked to.
struct chronicle {
    bool prints{false};
    moment now{0};

    void frame(char const* way, byte_view bytes, char const* fate, node const* of) const
    {
        if (not prints) {
            return;
        }
        std::printf("%12.3f ms  %s", double(now) / 1e3, way);
        for (std::byte const each : bytes) {
            std::printf(" %02X", to_u8(each));
        }
        std::printf("%s", fate);
        if (of != nullptr) {
            std::printf("  [state %d, %.1f Hz]", static_cast<int>(of->drive->state()), of->drive->frequency() / 1e3);
        }
        std::printf("\n");
    }
    template <typename... Args> void say(char const* format, Args... args) const
    {
        if (prints) {
            std::printf("%12.3f ms  ", double(now) / 1e3);
            if constexpr (sizeof...(args) == 0) {
                std::fputs(format, stdout);
            } else {
                std::printf(format, args...);
            }
            std::printf("\n");
        }
    }
};

} // namespace rtuwire::lives
