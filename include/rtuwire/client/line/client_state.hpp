// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// What a client knows of its request and of its conversations. A base of its own, so that all of it lies in front of
// the frame: small processors reach near members with short instructions, 300 bytes less on a Cortex-M0+. For the same
// reason the members of one byte come first: beyond the first 32 bytes of a client they cost more.
// Internal: may change with any version.
#pragma once

#include <cstdint>

#include <rtuwire/client/line/line_echo.hpp>
#include <rtuwire/client/line/phase.hpp>
#include <rtuwire/client/line/retry_state.hpp>
#include <rtuwire/client/turns.hpp>
#include <rtuwire/core/time.hpp>
#include <rtuwire/core/version.hpp>
#include <rtuwire/wire/errc.hpp>
#include <rtuwire/wire/frame_length.hpp>

namespace rtuwire::inline RTUWIRE_BUILD {

/// The base of a client that follows its `frame_cutter`; all zero at the start. Members of classes have no `{}`, for which
/// GCC would first make zeros by a call of memset (docs/size-notes.md).
class client_state {
protected:
    client_phase phase_{client_phase::idle};
    errc error_{errc::none};
    std::uint8_t skip_left_{0};
    bool must_send_now_{false}; ///< the request must leave at once or not at all
    bool is_woken_{false};      ///< the next pass has something to do at once
    std::uint8_t unit_{0};      ///< that was asked last; 0 for everyone
    bool is_held_back_{false};  ///< a conversation waits for a unit that gets no request now
    [[no_unique_address]] retry_state retries_;
    std::uint16_t size_{0}; ///< of the request
    line_echo echo_;
    length_hint longest_{}; ///< of its responses
    instant deadline_{0};
    turns turns_;
};

} // namespace rtuwire
