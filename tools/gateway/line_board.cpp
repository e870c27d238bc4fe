// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
#include "line_board.hpp"

#include <algorithm>
#include <memory>
#include <utility>

namespace tool::gateway {

namespace {

template <typename Entry> void add_bounded(std::deque<Entry>& to, Entry entry, std::size_t most)
{
    if (to.size() == most) {
        to.pop_front();
    }
    to.push_back(std::move(entry));
}

template <typename Entry> std::vector<Entry> taken(std::deque<Entry>& from)
{
    std::vector<Entry> all{std::make_move_iterator(from.begin()), std::make_move_iterator(from.end())};
    from.clear();
    return all;
}

} // namespace

line_board::line_board(line_plan const& plan, bool may_write, std::function<void()> on_news)
    : plan_{plan}, may_write_{may_write}, on_news_{std::move(on_news)}
{
    for (device_plan const& each : plan.devices) {
        slots_.emplace_back(each.values.size());
    }
}

void line_board::put(std::size_t device, slot_content content)
{
    slots_[device].put(std::make_shared<slot_content const>(std::move(content)));
    on_news_();
}

void line_board::set_state(line_state state)
{
    std::scoped_lock const held{guard_};
    state_ = std::move(state);
}

void line_board::tell(line_event event)
{
    {
        std::scoped_lock const held{guard_};
        add_bounded(events_, std::move(event), most_events);
    }
    on_news_();
}

void line_board::answer(setting_answer answer)
{
    {
        std::scoped_lock const held{guard_};
        add_bounded(answers_, std::move(answer), most_answers);
    }
    on_news_();
}

std::optional<waiting_setting> line_board::take_setting()
{
    std::scoped_lock const held{guard_};
    if (settings_.empty()) {
        return std::nullopt;
    }
    waiting_setting first = std::move(settings_.front());
    settings_.erase(settings_.begin());
    return first;
}

line_state line_board::state() const
{
    std::scoped_lock const held{guard_};
    return state_;
}

std::string line_board::why_never(setting_request const& request) const
{
    bool const is_there =
        request.device < plan_.devices.size() and request.value < plan_.devices[request.device].values.size();
    if (not is_there or not plan_.devices[request.device].values[request.value].setting) {
        return "it is none of the settings that the file names";
    }
    return may_write_ ? "" : "this gateway only reads: it runs without --write";
}

void line_board::submit(setting_request request, std::uint64_t unix_time, clock::time_point now)
{
    setting_answer refused{request.device,          request.value,      request.id,
                           setting_result::refused, why_never(request), unix_time};
    if (refused.why.empty() and request.expires <= unix_time) {
        refused.result = setting_result::expired;
        refused.why = "it expired before it came";
    } else if (refused.why.empty() and request.expires - unix_time > longest_expiry) {
        refused.why = "it expires more than 60 s ahead";
    }
    if (not refused.why.empty()) {
        answer(std::move(refused));
        return;
    }
    std::optional<setting_answer> replaced;
    {
        std::scoped_lock const held{guard_};
        auto const before = std::ranges::find_if(settings_, [&request](waiting_setting const& each) {
            return each.request.device == request.device and each.request.value == request.value;
        });
        if (before != settings_.end()) {
            replaced = setting_answer{before->request.device,  before->request.value,        before->request.id,
                                      setting_result::refused, "a newer one took its place", unix_time};
            settings_.erase(before);
        }
        auto const left = std::chrono::microseconds{request.expires - unix_time};
        settings_.push_back({std::move(request), now + left});
    }
    if (replaced) {
        answer(std::move(*replaced));
    }
}

std::vector<setting_answer> line_board::take_answers()
{
    std::scoped_lock const held{guard_};
    return taken(answers_);
}

std::vector<line_event> line_board::take_events()
{
    std::scoped_lock const held{guard_};
    return taken(events_);
}

} // namespace tool::gateway
