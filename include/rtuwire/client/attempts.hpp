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
        retries_ = may_repeat ? with.retries : std::uint8_t{0};
        busy_retries_ = may_repeat ? with.busy_retries : std::uint8_t{0};
        failures_ = 0;
        pauses_ = 0;
        response_timeout_ = with.response_timeout;
        busy_pause_ = with.busy_pause;
    }

    /// Takes one repetition after silence or damage; false where none is left.
    constexpr bool take_retry() noexcept
    {
        bool const is_left = failures_ < retries_;
        failures_ = static_cast<std::uint8_t>(failures_ + (is_left ? 1 : 0));
        return is_left;
    }

    /// Whether the unit asks for time, and may have it.
    [[nodiscard]] constexpr bool may_pause(errc answer) const noexcept
    {
        bool const asks = answer == errc::acknowledge or answer == errc::server_device_busy;
        return asks and pauses_ < busy_retries_;
    }

    /// Takes one repetition after a pause; how long it is.
    constexpr duration take_pause() noexcept
    {
        constexpr std::uint8_t most_doublings = 6;
        unsigned const doublings = pauses_ < most_doublings ? pauses_ : most_doublings;
        ++pauses_;
        return busy_pause_ * (1U << doublings);
    }

    /// Whether an attempt failed without an answer, which may then still come.
    [[nodiscard]] constexpr bool has_failed() const noexcept { return failures_ != 0; }
    [[nodiscard]] constexpr bool is_first() const noexcept { return failures_ + pauses_ == 0; }

    [[nodiscard]] constexpr duration response_timeout() const noexcept { return response_timeout_; }

private:
    std::uint8_t retries_{0};
    std::uint8_t busy_retries_{0};
    std::uint8_t failures_{0};
    std::uint8_t pauses_{0};
    duration response_timeout_{};
    duration busy_pause_{};
};

} // namespace rtuwire
