// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// Runs a write plan: its requests in order, by function 16. The first failure ends it; what was written before stays
// written, and `written()` gives the number of confirmed requests. Apart from poller.hpp: who only reads compiles no write plan.
#pragma once

#include <array>
#include <cstddef>
#include <optional>

#include <rtuwire/ask/conversation.hpp>
#include <rtuwire/core/version.hpp>
#include <rtuwire/table/device.hpp>
#include <rtuwire/table/write_plan.hpp>
#include <rtuwire/wire/function.hpp>
#include <rtuwire/wire/registers.hpp>

namespace rtuwire {
inline namespace RTUWIRE_BUILD {

namespace detail {

/// The conversation of a write plan with one unit; owns the values and the frame under way.
template <typename Plan> class plan_writer : public finite_conversation {
    using device = typename Plan::device;
    static_assert(implements<device>(function_code::write_multiple_registers),
                  "this device does not implement function 16");

public:
    static constexpr function_set asks{function_code::write_multiple_registers};

    constexpr plan_writer(station<device> const& to, Plan const& values) noexcept : plan_{values}, unit_{to.unit()}
    {
        begin();
    }

    /// Writes all of it once more, from the first request on. A plan with a value that does not fit stays settled, and
    /// says so once more.
    constexpr void again() noexcept
    {
        reopen();
        written_ = 0;
        begin();
        if (settled()) {
            tell_again();
        }
    }

    constexpr std::optional<request_frame> next() const& noexcept
    {
        if (settled()) {
            return std::nullopt;
        }
        return request_frame{byte_view{frame_}.first(frame_size_)};
    }
    std::optional<request_frame> next() const&& = delete;

    constexpr void accept(result<response> const& outcome) noexcept
    {
        if (not outcome) {
            settle(outcome.error());
        } else if (++written_ == Plan::request_count) {
            settle(errc::none);
        } else {
            prepare();
        }
    }

    /// How many of the plan's requests the unit has confirmed.
    [[nodiscard]] constexpr std::size_t written() const noexcept { return written_; }

private:
    constexpr void begin() noexcept
    {
        if constexpr (requires { plan_.error(); }) {
            if (plan_.error() != errc::none) {
                return settle(plan_.error());
            }
        }
        prepare();
    }

    constexpr void prepare() noexcept
    {
        register_block<Plan::register_count> words;
        auto const values = plan_.words(written_);
        for (std::size_t i = 0; i < values.size(); ++i) {
            words.set(i, values[i]);
        }
        register_view const used{words.view().bytes().first(2 * values.size())};
        auto const frame = encode_into(frame_, unit_, write_multiple_registers{Plan::requests()[written_].start, used});
        if (frame) {
            frame_size_ = frame->size();
        } else {
            settle(frame.error());
        }
    }

    Plan plan_;
    std::array<std::byte, 9 + 2 * Plan::register_count> frame_{};
    std::size_t frame_size_{0};
    std::size_t written_{0};
    unit_id unit_;
};

} // namespace detail

} // namespace RTUWIRE_BUILD
} // namespace rtuwire
