// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// What a client knows of its request and of its conversations. A base of its own, so that all of it lies in front of
// the frame: small processors reach near members with short instructions, 300 bytes less on a Cortex-M0+. For the same
// reason members of one byte that are used often come first: beyond the first 32 bytes of a client they cost more.
// Internal: may change with any version.
#pragma once

#include <cstdint>

#include <rtuwire/client/line/phase.hpp>
#include <rtuwire/client/line/retry_state.hpp>
#include <rtuwire/client/turns.hpp>
#include <rtuwire/core/constant.hpp>
#include <rtuwire/core/time.hpp>
#include <rtuwire/core/version.hpp>
#include <rtuwire/wire/errc.hpp>
#include <rtuwire/wire/frame_length.hpp>

namespace rtuwire::inline RTUWIRE_BUILD {

/// The base of a client that follows its `frame_cutter`; all zero at the start. Members of classes have no `{}`, for which
/// GCC would first make zeros by a call of memset (docs/size-notes.md). No byte is left between the members, nor behind the
/// last one, where `line_end` goes on; all of one byte but one lie in the first 32.
class client_state {
protected:
    client_phase phase_{client_phase::idle};
    errc error_{errc::none};
    bool is_woken_{false}; ///< the next pass has something to do at once
    std::uint8_t unit_{0}; ///< that was asked last; 0 for everyone
    [[no_unique_address]] turns turns_;
    bool must_send_now_{false}; ///< the request must leave at once or not at all
    [[no_unique_address]] retry_state retries_;
    std::uint16_t size_{0}; ///< of the request
    length_hint longest_{}; ///< of its responses; stored, which saves 57 instructions of a read
    instant deadline_{0};
    instant seen_{0}; ///< the latest `advance`
};

/// How many bytes of noise may still be skipped before a response; constant options that allow none take no memory.
template <typename Options> class noise_allowance {
public:
    constexpr void begin(std::uint8_t most) noexcept { left_ = most; }
    [[nodiscard]] constexpr bool is_left() const noexcept { return left_ != 0; }
    constexpr void take() noexcept { --left_; }

private:
    std::uint8_t left_{0};
};
template <typename Options>
    requires(is_constant<Options>and Options::get().max_leading_noise == 0)
class noise_allowance<Options> {
public:
    static constexpr void begin(std::uint8_t) noexcept {}
    [[nodiscard]] static constexpr bool is_left() noexcept { return false; }
    static constexpr void take() noexcept {}
};

} // namespace rtuwire
