// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// What a client knows of its request and of its conversations. Apart, so that all of it stands in front of the
// frame: small processors reach near members with short instructions, 300 bytes less on a Cortex-M0+. For the same
// reason the octets come first: those beyond the first 32 of a client cost more.
#pragma once

#include <cstdint>

#include <rtuwire/client/attempts.hpp>
#include <rtuwire/client/echo.hpp>
#include <rtuwire/client/phase.hpp>
#include <rtuwire/client/turns.hpp>
#include <rtuwire/core/time.hpp>
#include <rtuwire/core/version.hpp>
#include <rtuwire/wire/errc.hpp>
#include <rtuwire/wire/frame_length.hpp>

namespace rtuwire::inline RTUWIRE_BUILD {

/// The base of a client behind what cuts its frames; all zero at the start. Members that are classes have no `{}`:
/// GCC would call memset for it, 170 bytes.
class client_state {
protected:
    client_phase phase_{client_phase::idle};
    errc trouble_{errc::none};
    std::uint8_t skip_left_{0};
    bool may_be_stale_{false}; ///< the question must leave at once or not at all
    bool is_woken_{false};     ///< the next pass has something to do at once
    std::uint8_t unit_{0};     ///< that was asked last; 0 for everyone
    bool is_held_back_{false}; ///< somebody has a question to a unit that is asked nothing now
    attempts attempts_;
    std::uint16_t size_{0}; ///< of the request
    echo_check echo_{};
    length_so_far longest_{}; ///< of its answers
    instant deadline_{0};
    turns turns_;
};

} // namespace rtuwire
