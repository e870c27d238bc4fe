// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
#include "messages/publisher.hpp"

#include <algorithm>
#include <utility>

#include "messages/discovery.hpp"
#include "messages/state_message.hpp"

namespace tool::gateway {

namespace {

constexpr std::size_t most_answers = 256;

std::string availability_text(bool is_available) { return is_available ? "online" : "offline"; }

} // namespace

void publisher::set_plan(gateway_plan const& plan, std::vector<line_feed> lines, time now)
{
    std::set<std::string> const before = kept();
    std::vector<line_look> const old = std::exchange(lines_, {});
    plan_ = plan;
    names_ = topics{plan.site, plan.gateway};
    devices_.clear();
    values_.clear();
    kept_ = {names_.status()};
    for (line_feed& each : lines) {
        auto const same = std::ranges::find(old, each.plan, [](line_look const& one) { return one.feed.plan; });
        line_look look = same != old.end() ? *same : line_look{.feed = {}, .heartbeat_at = now};
        look.feed = std::move(each);
        line_plan const& line = *look.feed.plan;
        look.devices.resize(line.devices.size());
        kept_.insert(names_.availability(line.name));
        for (std::size_t i = 0; i < line.devices.size(); ++i) {
            device_plan const& device = line.devices[i];
            devices_.emplace_back(lines_.size(), i);
            kept_.insert(names_.availability(line.name, device.name));
            for (std::size_t j = 0; j < device.values.size() and not plan.broker.discovery.empty(); ++j) {
                values_.push_back({lines_.size(), i, j});
                kept_.insert(discovery_topic(plan, line, device, device.values[j], may_write_));
            }
        }
        lines_.push_back(std::move(look));
    }
    stale_.clear();
    std::ranges::set_difference(before, kept_, std::inserter(stale_, stale_.end()));
    to_take_back_.assign(stale_.begin(), stale_.end());
    turn_ = 0;
    discovered_ = 0;
    again_at_.reset();
}

void publisher::publish_anew(line_look& line)
{
    line.availability.reset();
    line.status = 0;
    line.status_at = {};
    line.devices.assign(line.devices.size(), {});
}

void publisher::connected()
{
    is_connected_ = true;
    has_ended_ = false;
    queue_.push_front({names_.status(), availability_text(true), true, true});
    to_take_back_.assign(stale_.begin(), stale_.end());
    std::ranges::for_each(lines_, [this](line_look& each) { publish_anew(each); });
    discovered_ = 0;
    again_at_.reset();
}

void publisher::discover_again() { discovered_ = 0; }

void publisher::put_answer(setting_topic const& of_what, std::string text)
{
    if (queue_.size() < most_answers) {
        queue_.push_back({names_.answer(of_what), std::move(text)});
    }
}

void publisher::end()
{
    has_ended_ = true;
    std::string const offline = availability_text(false);
    for (line_look const& each : lines_) {
        line_plan const& line = *each.feed.plan;
        for (device_plan const& device : line.devices) {
            queue_.push_back({names_.availability(line.name, device.name), offline, true});
        }
        queue_.push_back({names_.availability(line.name), offline, true});
    }
    queue_.push_back({names_.status(), offline, true});
}

std::optional<outgoing_message> publisher::next(time now, bool has_values)
{
    if (not is_connected_) {
        return std::nullopt;
    }
    if (not queue_.empty()) {
        outgoing_message first = std::move(queue_.front());
        queue_.pop_front();
        return first;
    }
    if (has_ended_) {
        return std::nullopt;
    }
    if (auto found = next_discovery(now)) {
        return found;
    }
    for (line_look& each : lines_) {
        if (auto found = next_of_line(each, now)) {
            return found;
        }
    }
    for (std::size_t i = 0; i < devices_.size(); ++i) {
        auto const [line, device] = devices_[turn_];
        if (auto found = next_availability(lines_[line], device)) {
            return found;
        }
        if (auto found = has_values ? next_values(lines_[line], device, now) : std::nullopt) {
            return found;
        }
        turn_ = (turn_ + 1) % devices_.size(); // one that had a message is asked again: it may have two
    }
    return std::nullopt;
}

bool publisher::is_complete() const
{
    bool const has_begun = has_ended_ or (discovered_ == values_.size() and to_take_back_.empty());
    return is_connected_ and queue_.empty() and has_begun;
}

std::optional<outgoing_message> publisher::next_discovery(time now)
{
    if (not to_take_back_.empty()) {
        std::string topic = std::move(to_take_back_.front());
        to_take_back_.pop_front();
        return outgoing_message{std::move(topic), {}, true, true};
    }
    if (discovered_ == values_.size()) {
        return std::nullopt;
    }
    bool const is_first = discovered_ == 0; // whether the broker takes them
    auto const [line, device, value] = values_[discovered_++];
    line_plan const& of_line = *lines_[line].feed.plan;
    device_plan const& of_device = of_line.devices[device];
    if (discovered_ == values_.size()) {
        again_at_ = now + discovery_time;
        for (line_look& each : lines_) {
            std::ranges::for_each(each.devices, [](device_look& one) { one.is_again = true; });
        }
    }
    retained_message made = discovery_of(plan_, of_line, of_device, of_device.values[value], may_write_);
    return outgoing_message{std::move(made.topic), std::move(made.text), true, is_first};
}

std::optional<outgoing_message> publisher::next_of_line(line_look& line, time now)
{
    line_state const state = line.feed.state();
    if (state.seq != line.heartbeat) {
        line.heartbeat = state.seq;
        line.heartbeat_at = now;
    }
    std::string const& name = line.feed.plan->name;
    bool const is_alive = line.heartbeat != 0 and now - line.heartbeat_at < longest_heartbeat;
    if (bool const is_available = is_alive and state.is_up; line.availability != is_available) {
        line.availability = is_available;
        return outgoing_message{names_.availability(name), availability_text(is_available), true};
    }
    if (now >= line.status_at and state.seq != line.status) {
        line.status = state.seq;
        // A late one moves no other.
        line.status_at = heartbeat_period + (now - line.status_at < heartbeat_period ? line.status_at : now);
        return outgoing_message{names_.status(name), status_text(state)};
    }
    return std::nullopt;
}

std::optional<outgoing_message> publisher::next_availability(line_look& line, std::size_t which)
{
    line_plan const& of_line = *line.feed.plan;
    bool const is_available = line.feed.device(which)->is_available;
    if (line.devices[which].availability == is_available) {
        return std::nullopt;
    }
    line.devices[which].availability = is_available;
    return outgoing_message{names_.availability(of_line.name, of_line.devices[which].name),
                            availability_text(is_available), true};
}

std::optional<outgoing_message> publisher::next_values(line_look& line, std::size_t which, time now)
{
    line_plan const& of_line = *line.feed.plan;
    device_plan const& plan = of_line.devices[which];
    device_look& device = line.devices[which];
    device_slot::content const content = line.feed.device(which);
    // Again with the next round, or, where that takes long, without one.
    bool const is_again = device.is_again and again_at_ and now >= *again_at_;
    bool const is_late = is_again and content->is_available and now >= *again_at_ + discovery_time;
    if (content->seq <= device.published and not is_late) {
        return std::nullopt;
    }
    std::string text = state_text(plan, *content, is_again ? 0 : device.published);
    device.published = content->seq;
    device.is_again = device.is_again and not is_again;
    return text.empty() ? std::nullopt
                        : std::optional{outgoing_message{names_.state(of_line.name, plan.name), std::move(text)}};
}

void publisher::arrived(std::string const& topic) { stale_.erase(topic); }

std::set<std::string> publisher::kept() const
{
    std::set<std::string> all = kept_;
    all.insert(stale_.begin(), stale_.end());
    return all;
}

} // namespace tool::gateway
