// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// Runs a read plan round after round: its requests in order, their registers into a snapshot. A round with a failure
// leaves the snapshot of the last whole round as it was. Makes the frames of the plan's blocks: a plan has none.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>

#include <rtuwire/ask/conversation.hpp>
#include <rtuwire/ask/words_read.hpp>
#include <rtuwire/core/version.hpp>
#include <rtuwire/table/device.hpp>
#include <rtuwire/table/read_plan.hpp>
#include <rtuwire/wire/function.hpp>
#include <rtuwire/wire/registers.hpp>

namespace rtuwire {
inline namespace RTUWIRE_BUILD {

namespace detail {

/// The frames that read the blocks of a plan from one unit, in order, with their CRC; a constant where the unit is one.
/// By `encode_into` GCC would make them when the program runs, which is 90 bytes larger.
template <typename Plan> [[nodiscard]] constexpr auto read_frames(unit_id unit) noexcept
{
    constexpr address_block const* blocks = Plan::requests().data();
    std::array<std::array<std::byte, 8>, Plan::request_count> all{};
    for (std::size_t i = 0; i < Plan::request_count; ++i) {
        all[i] = read_frame(unit, Plan::space_of(i), blocks[i].start, blocks[i].count);
    }
    return all;
}

/// The functions that a plan asks.
template <typename Plan, std::size_t... Requests>
[[nodiscard]] consteval function_set functions_of(std::index_sequence<Requests...>) noexcept
{
    return function_set{function_that_reads(Plan::space_of(Requests))...};
}

} // namespace detail

/// The conversation of a read plan with one unit; owns its frames and the snapshot. Each `again` is one
/// round more.
template <typename Plan> class poller : public detail::finite_conversation {
public:
    static constexpr bool keeps_meaning = true;
    static constexpr function_set asks = detail::functions_of<Plan>(std::make_index_sequence<Plan::request_count>{});

    using snapshot = typename Plan::snapshot;

    /// Asks this station for one round of the plan.
    explicit constexpr poller(station<typename Plan::device> const& of) noexcept
        : frames_{detail::read_frames<Plan>(of.unit())}
    {}

    /// Starts one more round; one under way starts again, and the outcome of its last request is dropped.
    constexpr void again() noexcept
    {
        reopen();
        at_ = 0;
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
            return settle(outcome.error());
        }
        std::uint16_t const count = Plan::requests()[at_].count;
        if constexpr (Plan::is_plain) {
            auto const response = outcome->to<read_holding_registers>();
            if (not response) {
                return settle(response.error());
            }
            if (response->registers.size() != count) {
                return settle(errc::wrong_length);
            }
            incoming_.store(at_, response->registers);
        } else {
            detail::read_words const words{outcome->pdu(), Plan::space_of(at_)};
            if (not words.holds(count)) {
                return settle(errc::wrong_length);
            }
            incoming_.store(at_, words);
        }
        if (++at_ < Plan::request_count) {
            return;
        }
        current_ = incoming_;
        settle(errc::none);
    }

    /// The values of the last whole round; zeros before it.
    [[nodiscard]] constexpr snapshot const& latest() const& noexcept { return current_; }
    snapshot const& latest() const&& = delete;

private:
    /// The functions of the kinds that a plan reads, each once.
    static constexpr bool has_function(register_space space) noexcept
    {
        return detail::implements<typename Plan::device>(detail::function_that_reads(space));
    }
    static constexpr bool are_all_implemented() noexcept
    {
        bool are = true;
        for (std::size_t i = 0; i < Plan::request_count; ++i) {
            are = are and has_function(Plan::space_of(i));
        }
        return are;
    }
    static_assert(Plan::is_plain or are_all_implemented(),
                  "this device does not implement the function that reads one of these kinds of registers");

    std::size_t at_{0};
    std::array<std::array<std::byte, 8>, Plan::request_count> frames_; ///< behind the number they are aligned: smaller
    snapshot incoming_{};
    snapshot current_{};
};

} // namespace RTUWIRE_BUILD
} // namespace rtuwire
