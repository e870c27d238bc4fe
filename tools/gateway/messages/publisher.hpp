// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Which message is the next, for a connection that takes one at a time: nothing waits here but the newest of each device. It
// knows no broker and waits for nothing.
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <functional>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "device_slot.hpp"
#include "gateway_file.hpp"
#include "messages/topics.hpp"
#include "running_line.hpp"

namespace tool::gateway {

/// A line as it is looked at.
struct line_feed {
    std::shared_ptr<line_plan const> plan;
    std::function<line_state()> state;
    std::function<device_slot::content(std::size_t)> device;
};

struct outgoing_message {
    std::string topic;
    std::string text;
    bool is_retained{false};
    bool must_arrive{false}; ///< by QoS 1: the broker says whether it takes it

    friend bool operator==(outgoing_message const&, outgoing_message const&) = default;
};

class publisher {
public:
    using clock = std::chrono::steady_clock;
    using time = clock::time_point;

    static constexpr std::chrono::seconds heartbeat_period{1};
    static constexpr std::chrono::seconds longest_heartbeat{3};
    /// How long Home Assistant gets to subscribe to what it was told of, before it is told the values again.
    static constexpr std::chrono::seconds discovery_time{5};

    /// `kept`: the topics that the broker keeps of an earlier process.
    publisher(bool may_write, std::set<std::string> kept) : may_write_{may_write}, kept_{std::move(kept)} {}

    /// From here on. A line whose plan is the same object goes on; what is kept of others is taken back.
    void set_plan(gateway_plan const& plan, std::vector<line_feed> lines, time now);
    [[nodiscard]] gateway_plan const& plan() const { return plan_; }
    [[nodiscard]] topics const& names() const { return names_; }

    void connected();
    void disconnected() { is_connected_ = false; }
    /// Home Assistant began: it is told everything again.
    void discover_again();
    void put_answer(setting_topic const& of_what, std::string text);
    /// Everything is said to be offline, and then nothing more.
    void end();

    /// Nothing where there is none for now. Without values where these would wait on their way.
    [[nodiscard]] std::optional<outgoing_message> next(time now, bool has_values = true);
    /// Whether all was given that a new connection begins with; once it ends, all that it ends with.
    [[nodiscard]] bool is_complete() const;

    /// A message that had to arrive did.
    void arrived(std::string const& topic);
    /// All topics that the broker keeps, or may keep from now on.
    [[nodiscard]] std::set<std::string> kept() const;
    [[nodiscard]] bool has_to_take_back() const { return not stale_.empty(); }

private:
    struct device_look {
        std::optional<bool> availability{}; ///< as it was published
        std::uint64_t published{0};         ///< the `seq` of its values
        bool is_again{false};               ///< all values, at `again_at_`
    };

    struct line_look {
        line_feed feed;
        std::vector<device_look> devices{};
        std::uint64_t heartbeat{0}; ///< the `seq` that was seen last
        time heartbeat_at{};        ///< when it was seen first
        std::optional<bool> availability{};
        std::uint64_t status{0}; ///< the `seq` that was published
        time status_at{};        ///< when the next one is due
    };

    /// A value of a device of a line.
    struct value_index {
        std::size_t line;
        std::size_t device;
        std::size_t value;
    };

    void publish_anew(line_look& line);
    std::optional<outgoing_message> next_discovery(time now);
    std::optional<outgoing_message> next_of_line(line_look& line, time now);
    std::optional<outgoing_message> next_availability(line_look& line, std::size_t which);
    std::optional<outgoing_message> next_values(line_look& line, std::size_t which, time now);

    bool may_write_;
    std::set<std::string> kept_;    ///< that are made by the plan, and of an earlier process before there is one
    std::set<std::string> stale_{}; ///< that are to be taken back
    std::deque<std::string> to_take_back_{};
    gateway_plan plan_{};
    topics names_{"", ""};
    std::vector<line_look> lines_{};
    std::vector<std::pair<std::size_t, std::size_t>> devices_{}; ///< by line
    std::vector<value_index> values_{};
    std::deque<outgoing_message> queue_{};
    std::size_t discovered_{0}; ///< of `values_`
    std::size_t turn_{0};       ///< of `devices_`
    std::optional<time> again_at_{};
    bool is_connected_{false};
    bool has_ended_{false};
};

} // namespace tool::gateway
