// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A line in a thread of its own, which never waits for anything but its port. What is called here is called from any other
// thread, and returns at once.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "device_slot.hpp"
#include "gateway_file.hpp"
#include "serve/serve_counts.hpp"
#include "setting_request.hpp"
#include "stored_writes.hpp"

namespace tool::gateway {

/// Counted by the line's own loop since it began; `time` stands still where the loop does.
struct line_state {
    std::uint64_t time{0}; ///< microseconds since 1970, of the last look; 0 before the first
    std::uint64_t seq{0};  ///< of that look: rises with each
    std::uint64_t requests{0};
    std::uint64_t silences{0};              ///< of those: nobody responded in time
    std::uint64_t refusals{0};              ///< exceptions
    std::uint64_t errors{0};                ///< all else that was no response: damaged, of another unit
    std::uint64_t opened{0};                ///< so many times its port was opened
    std::uint64_t overruns{0};              ///< rounds that were left out because those before took too long
    std::optional<client_counts> clients{}; ///< where it has some
    bool is_up{false};                      ///< its port is open
    std::string why{};                      ///< it is not
};

enum class event_kind : std::uint8_t {
    port_lost,
    port_opened,
    device_silent,
    device_back,
    wrong_device,
    setting,
    note
};

/// "device_silent".
constexpr std::string_view name_of(event_kind what) noexcept
{
    constexpr std::string_view names[]{"port_lost",    "port_opened", "device_silent", "device_back",
                                       "wrong_device", "setting",     "note"};
    return names[static_cast<std::size_t>(what)];
}

/// A change, for the log.
struct line_event {
    event_kind what;
    std::uint64_t time;
    std::string device{}; ///< its name; empty where it is of the whole line
    std::string text{};   ///< "line1: meter1 does not respond: ...": a sentence for people, with all names
};

class running_line {
public:
    /// Begins at once. `on_news` is called from the line's thread after each change of a slot, an answer and an event; it
    /// must neither block nor throw.
    running_line(std::shared_ptr<line_plan const> plan, bool may_write, stored_writes& stored,
                 std::function<void()> on_news);
    running_line(running_line const&) = delete;
    running_line& operator=(running_line const&) = delete;
    /// Ends behind the request that is under way.
    ~running_line();

    /// What it began with; its clients may be those of a later one.
    [[nodiscard]] line_plan const& plan() const noexcept;
    /// Its clients are what this plan says, soon; nothing else of the line changes. Where it says the same of them, nothing does.
    void serve(std::shared_ptr<line_plan const> plan);
    [[nodiscard]] line_state state() const;
    /// What is known of a device.
    [[nodiscard]] device_slot::content device(std::size_t which) const;

    /// One register has one request that waits, until its frame leaves: a newer one takes its place, and the older is answered
    /// `refused`. What is no setting, expired, too far ahead or not allowed, or comes behind `end`, is answered, too, and never
    /// leaves.
    void submit(setting_request request);

    /// What has come since the last call. Of events the oldest are dropped where nobody takes them.
    [[nodiscard]] std::vector<setting_answer> take_answers();
    [[nodiscard]] std::vector<line_event> take_events();

    /// Begins to end: behind the request that is under way.
    void end();
    [[nodiscard]] bool shall_end() const;
    [[nodiscard]] bool has_ended() const;
    /// Waits for that. Each setting has its answer then, those that waited as well; what is known stays.
    void finish();

private:
    class parts;
    std::unique_ptr<parts> parts_;
};

/// All lines of a gateway.
class running_lines {
public:
    /// `stored` lives longer.
    running_lines(bool may_write, stored_writes& stored, std::function<void()> on_news);
    running_lines(running_lines const&) = delete;
    running_lines& operator=(running_lines const&) = delete;
    ~running_lines();

    /// Lines that did not change go on, also where their clients did; the others end, and those of the plan begin. All that
    /// end do so at once, each behind its request; `last_look` sees each that has ended, with its last answers and events.
    void apply(
        gateway_plan const& plan, std::function<void(running_line&)> const& last_look = [](running_line&) {});
    /// Those begin to end that `apply` would end.
    void end_all_but(gateway_plan const& plan);
    /// All begin to end.
    void end();
    /// Whether one that is to end has not: its request is under way.
    [[nodiscard]] bool are_ending() const;
    /// All end, and stay.
    void finish();

    /// In the order of the plan.
    [[nodiscard]] std::vector<std::shared_ptr<running_line>> const& all() const noexcept { return lines_; }

private:
    bool may_write_;
    stored_writes& stored_;
    std::function<void()> on_news_;
    std::vector<std::shared_ptr<running_line>> lines_{};
};

} // namespace tool::gateway
