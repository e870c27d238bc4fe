// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// What a line's thread and the others tell each other. Nobody waits here for more than a few copies.
#pragma once

#include <chrono>
#include <cstddef>
#include <deque>
#include <functional>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "device_slot.hpp"
#include "gateway_file.hpp"
#include "running_line.hpp"
#include "setting_request.hpp"

namespace tool::gateway {

class line_board {
public:
    using clock = std::chrono::steady_clock;

    static constexpr std::size_t most_events = 256;
    static constexpr std::size_t most_answers = 1'024;

    line_board(line_plan const& plan, bool may_write, std::function<void()> on_news);

    // The line's side.

    void put(std::size_t device, slot_content content);
    void set_state(line_state state);
    void tell(line_event event);
    /// For whoever asked, and for the log.
    void answer(setting_request const& request, setting_result result, std::string why, std::uint64_t unix_time);
    /// The one that waits longest of those that may be taken.
    std::optional<waiting_setting> take_setting(std::function<bool(waiting_setting const&)> const& may_be_taken);
    /// Why one that was taken is not to be written any more: one of the same register waits behind it. Empty where none does.
    std::string why_replaced(setting_request const& request) const;

    // The others' side: see `running_line`.

    [[nodiscard]] device_slot::content device(std::size_t which) const { return slots_[which].newest(); }
    [[nodiscard]] line_state state() const;
    void submit(setting_request request, std::uint64_t unix_time, clock::time_point now);
    std::vector<setting_answer> take_answers();
    std::vector<line_event> take_events();

private:
    bool has(setting_request const& request) const;
    std::string why_never(setting_request const& request) const;

    line_plan const& plan_;
    bool may_write_;
    std::function<void()> on_news_;
    std::deque<device_slot> slots_{};
    mutable std::mutex guard_{};
    line_state state_{};
    std::vector<waiting_setting> settings_{}; ///< one of each register at most
    std::deque<setting_answer> answers_{};
    std::deque<line_event> events_{};
};

} // namespace tool::gateway
