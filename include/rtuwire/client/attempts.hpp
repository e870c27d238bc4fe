// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// How often one question was sent, and whether it may be sent once more.
#pragma once

#include <cstdint>

#include <rtuwire/client/options.hpp>
#include <rtuwire/core/time.hpp>
#include <rtuwire/wire/errc.hpp>

namespace rtuwire {

/// The attempts at one question.
class attempts {
public:
    /// A new question; one that may not be repeated gets a single attempt.
    constexpr void begin(patience const& with, bool may_repeat) noexcept
    {
        with_ = with;
        failures_ = 0;
        pauses_ = 0;
        if (not may_repeat) {
            with_.retries = 0;
            with_.busy_retries = 0;
        }
    }

    /// Takes one repetition after silence or damage; false where none is left.
    constexpr bool take_retry() noexcept
    {
        bool const is_left = failures_ < with_.retries;
        failures_ = static_cast<std::uint8_t>(failures_ + (is_left ? 1 : 0));
        return is_left;
    }

    /// Whether the unit asks for time, and may have it.
    [[nodiscard]] constexpr bool may_pause(errc answer) const noexcept
    {
        bool const asks = answer == errc::acknowledge or answer == errc::server_device_busy;
        return asks and pauses_ < with_.busy_retries;
    }

    /// Takes one repetition after a pause; how long it is.
    constexpr duration take_pause() noexcept
    {
        constexpr std::uint8_t most_doublings = 6;
        unsigned const doublings = pauses_ < most_doublings ? pauses_ : most_doublings;
        ++pauses_;
        return with_.busy_pause * (1U << doublings);
    }

    /// Whether an attempt failed without an answer, which may then still come.
    [[nodiscard]] constexpr bool has_failed() const noexcept { return failures_ != 0; }
    [[nodiscard]] constexpr bool is_first() const noexcept { return failures_ + pauses_ == 0; }

    [[nodiscard]] constexpr duration response_timeout() const noexcept
    {
        return with_.response_timeout;
    }

private:
    patience with_{};
    std::uint8_t failures_{0};
    std::uint8_t pauses_{0};
};

} // namespace rtuwire
