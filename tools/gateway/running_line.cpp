// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
#include "running_line.hpp"

#include <algorithm>
#include <atomic>
#include <mutex>
#include <thread>
#include <utility>

#include "../support/platform.hpp"
#include "line/time_text.hpp"
#include "line_board.hpp"
#include "line_rounds.hpp"
#include "opened_line.hpp"
#include "output/plain_text.hpp"

namespace tool::gateway {

class running_line::parts {
public:
    parts(std::shared_ptr<line_plan const> which, bool may_write, stored_writes& stored, std::function<void()> on_news)
        : plan{std::move(which)}, board{*plan, may_write, on_news}, on_news_{std::move(on_news)}, stored_{stored},
          plan_of_clients_{plan}
    {
        without_signals const kept;
        thread_ = std::thread{[this] { run(); }};
    }
    parts(parts const&) = delete;
    parts& operator=(parts const&) = delete;
    ~parts() { finish(); }

    void end() { shall_end_ = true; }
    bool shall_end() const { return shall_end_; }
    bool has_ended() const { return has_ended_; }
    void finish()
    {
        end();
        if (thread_.joinable()) {
            thread_.join();
        }
    }

    void serve(std::shared_ptr<line_plan const> by)
    {
        std::scoped_lock const held{guard_};
        has_new_clients_ = has_new_clients_ or by->said_of_clients != plan_of_clients_->said_of_clients;
        plan_of_clients_ = std::move(by);
    }

    std::shared_ptr<line_plan const> plan;
    line_board board;

private:
    std::shared_ptr<line_plan const> new_clients()
    {
        std::scoped_lock const held{guard_};
        return std::exchange(has_new_clients_, false) ? plan_of_clients_ : nullptr;
    }
    void run()
    {
        opened_line line{*plan, [this](std::string const& text) {
                             board.tell({event_kind::note, unix_now(), {}, plan->name + ": " + plain_text(text)});
                         }};
        line_rounds rounds{*plan, line, board, stored_};
        while (not shall_end_) {
            if (auto const by = new_clients()) {
                line.serve(by->serve);
            }
            rounds.step();
        }
        rounds.end();
        has_ended_ = true;
        on_news_();
    }

    std::function<void()> on_news_;
    stored_writes& stored_;
    std::mutex guard_{};
    std::shared_ptr<line_plan const> plan_of_clients_;
    bool has_new_clients_{false};
    std::atomic<bool> shall_end_{false};
    std::atomic<bool> has_ended_{false};
    std::thread thread_{};
};

running_line::running_line(std::shared_ptr<line_plan const> plan, bool may_write, stored_writes& stored,
                           std::function<void()> on_news)
    : parts_{std::make_unique<parts>(std::move(plan), may_write, stored, std::move(on_news))}
{}

running_line::~running_line() = default;

line_plan const& running_line::plan() const noexcept { return *parts_->plan; }

void running_line::serve(std::shared_ptr<line_plan const> plan) { parts_->serve(std::move(plan)); }

line_state running_line::state() const { return parts_->board.state(); }

device_slot::content running_line::device(std::size_t which) const { return parts_->board.device(which); }

void running_line::submit(setting_request request)
{
    if (parts_->shall_end()) { // nobody takes it any more
        parts_->board.answer(request, setting_result::refused, "the line ends", unix_now());
        return;
    }
    parts_->board.submit(std::move(request), unix_now(), std::chrono::steady_clock::now());
}

std::vector<setting_answer> running_line::take_answers() { return parts_->board.take_answers(); }

std::vector<line_event> running_line::take_events() { return parts_->board.take_events(); }

void running_line::end() { parts_->end(); }

bool running_line::shall_end() const { return parts_->shall_end(); }

bool running_line::has_ended() const { return parts_->has_ended(); }

void running_line::finish() { parts_->finish(); }

namespace {

/// Whether a line of a plan that was read later is the same one.
bool goes_on_as(running_line const& line, line_plan const& plan)
{
    return not line.shall_end() and line.plan().name == plan.name and line.plan().said == plan.said;
}

} // namespace

running_lines::running_lines(bool may_write, stored_writes& stored, std::function<void()> on_news)
    : may_write_{may_write}, stored_{stored}, on_news_{std::move(on_news)}
{}

running_lines::~running_lines() { finish(); }

void running_lines::end()
{
    std::ranges::for_each(lines_, [](auto const& each) { each->end(); });
}

void running_lines::end_all_but(gateway_plan const& plan)
{
    for (auto const& each : lines_) {
        if (std::ranges::none_of(plan.lines, [&each](auto const& one) { return goes_on_as(*each, *one); })) {
            each->end();
        }
    }
}

bool running_lines::are_ending() const
{
    return std::ranges::any_of(lines_, [](auto const& each) { return each->shall_end() and not each->has_ended(); });
}

void running_lines::finish()
{
    end(); // all of them at once, before one is waited for
    std::ranges::for_each(lines_, [](auto const& each) { each->finish(); });
}

void running_lines::apply(gateway_plan const& plan, std::function<void(running_line&)> const& last_look)
{
    std::vector<std::shared_ptr<running_line>> next;
    for (auto const& each : plan.lines) {
        auto const same = std::ranges::find_if(
            lines_, [&each](auto const& one) { return one != nullptr and goes_on_as(*one, *each); });
        next.push_back(same == lines_.end() ? nullptr : std::exchange(*same, nullptr));
    }
    std::erase(lines_, nullptr);
    finish();
    for (auto const& each : lines_) {
        last_look(*each);
    }
    lines_.clear(); // a port is free before its new line opens it
    for (std::size_t i = 0; i < next.size(); ++i) {
        if (next[i] != nullptr) {
            next[i]->serve(plan.lines[i]);
        } else {
            next[i] = std::make_shared<running_line>(plan.lines[i], may_write_, stored_, on_news_);
        }
    }
    lines_ = std::move(next);
}

} // namespace tool::gateway
