// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// Runs a read plan round after round: its requests in order, their registers into a snapshot. A round with a failure
// leaves the snapshot of the last whole round as it was.
#pragma once

#include <array>
#include <cstddef>
#include <optional>

#include <rtuwire/ask/conversation.hpp>
#include <rtuwire/core/version.hpp>
#include <rtuwire/table/device.hpp>
#include <rtuwire/table/read_plan.hpp>
#include <rtuwire/wire/pdu/read_holding_registers.hpp>

namespace rtuwire::inline RTUWIRE_BUILD {

/// The conversation of a read plan with one unit; owns its frames and the snapshot. Each `begin` is one
/// round.
template <typename Plan> class poller : public asker {
public:
    using snapshot = typename Plan::snapshot;

    explicit constexpr poller(station<typename Plan::device> const& of) noexcept
        : frames_{Plan::frames(of.unit().byte())}
    {}

    /// Starts a round; one under way starts again, and the outcome of its last request is dropped.
    constexpr void begin() noexcept
    {
        forget();
        at_ = 0;
        outcome_ = errc::pending;
    }

    constexpr std::optional<request_frame> next() const& noexcept
    {
        if (settled()) {
            return std::nullopt;
        }
        return request_frame{frames_[at_]};
    }
    std::optional<request_frame> next() const&& = delete;

    constexpr void accept(result<response> const& outcome) noexcept
    {
        if (not outcome) {
            return end(outcome.error());
        }
        auto const response = outcome->to<read_holding_registers>();
        if (not response) {
            return end(response.error());
        }
        if (response->registers.size() != Plan::requests()[at_].count) {
            return end(errc::wrong_length);
        }
        incoming_.store(at_, response->registers);
        if (++at_ < Plan::request_count) {
            return;
        }
        current_ = incoming_;
        outcome_ = result<void>{};
    }

    /// Whether the outcome is there.
    [[nodiscard]] constexpr bool settled() const noexcept { return outcome_.error() != errc::pending; }

    /// How the round ended; `pending` until it is settled.
    [[nodiscard]] constexpr result<void> outcome() const noexcept { return outcome_; }

    /// The values of the last whole round; zeros before it.
    [[nodiscard]] constexpr snapshot const& latest() const& noexcept { return current_; }
    snapshot const& latest() const&& = delete;

private:
    constexpr void end(errc error) noexcept { outcome_ = error; }

    std::array<std::array<std::byte, 8>, Plan::request_count> frames_;
    snapshot incoming_{};
    snapshot current_{};
    std::size_t at_{0};
    result<void> outcome_{errc::pending};
};

} // namespace rtuwire
