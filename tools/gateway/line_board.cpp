// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
#include "line_board.hpp"

#include <algorithm>
#include <memory>
#include <string_view>
#include <utility>

#include "output/plain_text.hpp"

namespace tool::gateway {

namespace {

template <typename Entry> void add_bounded(std::deque<Entry>& to, Entry entry, std::size_t most)
{
    if (to.size() == most) {
        to.pop_front();
    }
    to.push_back(std::move(entry));
}

constexpr std::string_view replaced = "a newer one took its place";

auto is_of_register(setting_request const& one)
{
    return [device = one.device, value = one.value](waiting_setting const& each) {
        return each.request.device == device and each.request.value == value;
    };
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

void line_board::answer(setting_request const& request, setting_result result, std::string why, std::uint64_t unix_time)
{
    std::string device;
    std::string text = plan_.name + ": ";
    if (has(request)) {
        device_plan const& of = plan_.devices[request.device];
        device = of.name;
        text += device + ": " + of.values[request.value].name + '=' + plain_text(request.text) + ": ";
    }
    text += std::string{name_of(result)} + (why.empty() ? "" : ": ") + plain_text(why);
    tell({event_kind::setting, unix_time, std::move(device), std::move(text)});
    {
        std::scoped_lock const held{guard_};
        add_bounded(answers_, {request.device, request.value, request.id, result, std::move(why), unix_time},
                    most_answers);
    }
    on_news_();
}

std::optional<waiting_setting> line_board::take_setting(std::function<bool(waiting_setting const&)> const& may_be_taken)
{
    std::scoped_lock const held{guard_};
    auto const first = std::ranges::find_if(settings_, may_be_taken);
    if (first == settings_.end()) {
        return std::nullopt;
    }
    waiting_setting taken = std::move(*first);
    settings_.erase(first);
    return taken;
}

line_state line_board::state() const
{
    std::scoped_lock const held{guard_};
    return state_;
}

bool line_board::has(setting_request const& request) const
{
    return request.device < plan_.devices.size() and request.value < plan_.devices[request.device].values.size();
}

std::string line_board::why_never(setting_request const& request) const
{
    if (not has(request) or not plan_.devices[request.device].values[request.value].setting) {
        return "it is none of the settings that the file names";
    }
    return may_write_ ? "" : "this gateway only reads: it runs without --write";
}

std::string line_board::why_replaced(setting_request const& request) const
{
    std::scoped_lock const held{guard_};
    return std::ranges::any_of(settings_, is_of_register(request)) ? std::string{replaced} : std::string{};
}

void line_board::submit(setting_request request, std::uint64_t unix_time, clock::time_point now)
{
    setting_result result = setting_result::refused;
    std::string why = why_never(request);
    if (why.empty() and request.expires <= unix_time) {
        result = setting_result::expired;
        why = "it expired before it came";
    } else if (why.empty() and request.expires - unix_time > longest_expiry) {
        why = "it expires more than 60 s ahead";
    }
    if (not why.empty()) {
        answer(request, result, std::move(why), unix_time);
        return;
    }
    std::optional<setting_request> older;
    {
        std::scoped_lock const held{guard_};
        if (auto const before = std::ranges::find_if(settings_, is_of_register(request)); before != settings_.end()) {
            older = std::move(before->request);
            settings_.erase(before);
        }
        auto const left = std::chrono::microseconds{request.expires - unix_time};
        settings_.push_back({std::move(request), now + left});
    }
    if (older) {
        answer(*older, setting_result::refused, std::string{replaced}, unix_time);
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
