// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
#include "line_rounds.hpp"

#include <algorithm>
#include <exception>
#include <filesystem>
#include <map>
#include <optional>
#include <system_error>
#include <utility>

#include "exit_status.hpp"
#include "output/plain_text.hpp"

namespace tool::gateway {

namespace {

std::chrono::steady_clock::duration period_of(double seconds)
{
    return std::chrono::duration_cast<std::chrono::steady_clock::duration>(std::chrono::duration<double>{seconds});
}

} // namespace

std::vector<device_part> parts_of(line_plan const& plan)
{
    std::vector<device_part> parts;
    for (std::size_t device = 0; device < plan.devices.size(); ++device) {
        std::map<double, std::vector<std::size_t>> by_period;
        std::vector<device_value> const& values = plan.devices[device].values;
        for (std::size_t i = 0; i < values.size(); ++i) {
            by_period[values[i].every].push_back(i);
        }
        for (auto& [every, which] : by_period) {
            parts.push_back({device, every, std::move(which)});
        }
    }
    return parts;
}

line_rounds::line_rounds(line_plan const& plan, asked_line& line, line_board& board, stored_writes& stored)
    : plan_{plan}, line_{line}, board_{board}, stored_{stored}, devices_(plan.devices.size())
{
    for (device_part& each : parts_of(plan)) {
        clock::duration const period = period_of(each.every);
        parts_.push_back({std::move(each), period, line.now()});
    }
    for (std::size_t i = 0; i < devices_.size(); ++i) {
        devices_[i].content = *board.device(i);
        begin_patience(devices_[i]);
    }
    line_.beat_by([this] { show_state(); });
}

void line_rounds::step()
{
    show_state();
    try {
        act();
    } catch (std::exception const& why) {
        lose_port(why.what());
    }
}

void line_rounds::act()
{
    take_settings();
    write_next();      // one, so that many of them starve no reading
    line_.serve_one(); // clients and rounds take turns
    clock::time_point const now = line_.now();
    if (state_.is_up) {
        if (not told_losses_.empty() and now - opened_at_ >= longest_doubt) {
            confirm_port();
        }
        ask_parts(now);
    } else if (port_patience_.is_due(now)) {
        open();
    } else {
        line_.wait(now + longest_wait);
    }
}

void line_rounds::show_state()
{
    exchange_counts const& counts = line_.counts();
    state_.time = line_.unix_time();
    ++state_.seq;
    state_.requests = counts.asked;
    state_.silences = counts.silent;
    state_.refusals = counts.refused;
    state_.errors = counts.damaged;
    state_.clients = line_.clients();
    board_.set_state(state_);
}

void line_rounds::open()
{
    line_.open();
    clock::time_point const now = line_.now();
    opened_at_ = now;
    state_.is_up = true;
    state_.why.clear();
    ++state_.opened;
    was_settled_ = false;
    if (told_losses_.empty()) {
        confirm_port();
    }
    for (part& each : parts_) {
        each.due = now;
    }
}

void line_rounds::confirm_port()
{
    port_patience_.note(true, line_.now());
    told_losses_.clear();
    tell(event_kind::port_opened, {}, "its port is open: " + plan_.choices.port);
}

void line_rounds::lose_port(std::string const& why)
{
    line_.close();
    state_.is_up = false;
    state_.why = why;
    port_patience_.note(false, line_.now());
    if (told_losses_.size() < most_reasons and std::ranges::count(told_losses_, why) == 0) {
        told_losses_.push_back(why);
        tell(event_kind::port_lost, {}, why);
    }
    for (std::size_t i = 0; i < devices_.size(); ++i) {
        begin_patience(devices_[i]);
        devices_[i].wrong_until = {};
        devices_[i].is_looked_at = false;
        if (devices_[i].content.why != why) {
            mark_lost(i, why);
        }
    }
    for (part& each : parts_) {
        each.reading.reset();
    }
    show_state();
}

bool line_rounds::has_live_ones() const { return std::ranges::any_of(devices_, &device::is_identified); }

bool line_rounds::is_settled() const
{
    return std::ranges::all_of(devices_, [](device const& each) {
        return each.is_identified or each.patience.is_silent() or each.wrong_until != clock::time_point{};
    });
}

bool line_rounds::may_ask(device const& which, clock::time_point now) const
{
    bool const is_probe = which.patience.is_silent();
    return now >= which.wrong_until and which.patience.is_due(now) and (not is_probe or now >= probes_from_);
}

void line_rounds::ask_parts(clock::time_point now)
{
    if (part* const first = first_due(now)) {
        ask(*first);
        return;
    }
    clock::time_point next = now + longest_wait;
    for (part const& each : parts_) {
        next = each.due > now ? std::min(next, each.due) : next;
    }
    line_.wait(next);
}

line_rounds::part* line_rounds::first_due(clock::time_point now)
{
    part* first = nullptr;
    for (part& each : parts_) {
        std::size_t const which = each.what.device;
        bool const is_set = std::ranges::any_of(settings_, [&](taken_setting const& setting) {
            return setting.goes_on and setting.what.request.device == which;
        });
        if (each.due > now or is_set or not may_ask(devices_[which], now)) {
            continue;
        }
        if (line_.is_left_alone(which)) {
            silent_at_ = now;
            line_.keep_turn(which);
        } else if (first == nullptr or place_of(each) < place_of(*first)) {
            first = &each;
        }
    }
    return first;
}

void line_rounds::ask(part& one)
{
    std::size_t const which = one.what.device;
    bool const is_turn_of_look = devices_[which].is_looked_at;
    if (may_be_another(which) and not is_of_right_one(one)) {
        return;
    }
    if (is_turn_of_look and not one.reading) { // the next request of it costs as much
        end_turn(which);
        return;
    }
    if (not one.reading) {
        if (line_.is_left_alone(which)) { // since it was identified
            return;
        }
        if (not read(one)) {
            if (not one.reading->found.late.empty()) {
                look_later(which);
                return;
            }
            if (not is_of_right_one(one)) {
                return;
            }
        }
    }
    bool const was_slow = one.reading->found.was_repeated;
    if (take(one)) {
        schedule(one, devices_[which].is_identified);
    }
    if (was_slow) {
        end_turn(which);
    }
}

bool line_rounds::is_of_right_one(part& one)
{
    auto const who = identify(one.what.device);
    if (who == device_finding::kind::silent or who == device_finding::kind::wrong) {
        schedule(one, devices_[one.what.device].is_identified);
    }
    return who == device_finding::kind::right;
}

void line_rounds::look_later(std::size_t which)
{
    devices_[which].is_looked_at = true;
    silent_at_ = line_.now();
    end_turn(which);
}

void line_rounds::end_turn(std::size_t which) { devices_[which].turn = line_.now(); }

/// One that says who it is may have been exchanged where it was missed once, or not heard for a while.
bool line_rounds::may_be_another(std::size_t which) const
{
    device const& one = devices_[which];
    bool const is_doubtful = one.misses > 0 or line_.now() - one.heard >= longest_unheard;
    return one.is_looked_at or not one.is_identified or (is_doubtful and says_who(which));
}

bool line_rounds::says_who(std::size_t which) const
{
    device_plan const& plan = plan_.devices[which];
    return plan.drive != nullptr or (plan.names != nullptr and not plan.names->vendor.empty());
}

/// Counted from where it began, so that no round makes the next one late for good; what was missed is left out. What a look at
/// new devices takes is no fault of the periods.
void line_rounds::schedule(part& one, bool is_live)
{
    clock::time_point const now = line_.now();
    std::uint64_t const silences = line_.counts().silent + line_.clients().value_or(client_counts{}).silences;
    silent_at_ = std::exchange(silences_, silences) != silences ? now : silent_at_;
    settled_from_ = was_settled_ ? settled_from_ : now; // listening before the first request is none, either
    was_settled_ = is_settled();
    auto const missed_since = [&](clock::time_point since) {
        return now < since + one.period ? 0 : (now - since) / one.period;
    };
    auto const left_out = is_live ? missed_since(std::max(one.due, settled_from_)) : 0;
    clock::time_point const due_before = one.due;
    one.due += one.period * (missed_since(one.due) + 1);
    state_.overruns += static_cast<std::uint64_t>(left_out);
    // What silence and repetitions cost, longer periods do not mend.
    bool const was_silent = silent_at_ > due_before;
    if (left_out > 0 and not was_silent and not std::exchange(was_overrun_told_, true)) {
        tell(event_kind::note, {},
             "more is asked than the line carries: rounds are left out, longer periods would help");
    }
    device const& asked = devices_[one.what.device];
    if (asked.misses > 0) { // a lost one is found soon
        bool const is_to_be_repeated = plan_.choices.retries == 0 and asked.misses == 1 and asked.is_identified;
        one.due = std::min(one.due, is_to_be_repeated ? now : now + std::chrono::seconds{1});
    }
}

device_finding::kind line_rounds::identify(std::size_t which)
{
    using enum device_finding::kind;
    device& one = devices_[which];
    clock::time_point const began = line_.now();
    device_finding const found = line_.identify(which, one.patience.is_silent());
    silent_at_ = std::exchange(one.is_looked_at, false) ? line_.now() : silent_at_;
    if (found.what == open) {
        look_later(which);
        return open;
    }
    for (part& each : parts_) {
        if (each.what.device == which and found.what != right) {
            each.reading.reset();
        }
    }
    if (found.what == silent) {
        note_silence(which, found.why, line_.now() - began);
        return silent;
    }
    begin_patience(one);
    if (not told_losses_.empty()) {
        confirm_port();
    }
    if (found.what == wrong) {
        one.wrong_until = line_.now() + wrong_device_pause;
        if (one.content.why != found.why) {
            mark_lost(which, found.why);
            one.was_told = true;
            tell(event_kind::wrong_device, plan_.devices[which].name, found.why);
        }
        return wrong;
    }
    for (part& each : parts_) { // while it was away none of its rounds was left out
        bool const is_met = each.what.device == which and not one.is_identified;
        each.due = is_met ? std::max(each.due, began) : each.due;
    }
    one.is_identified = true;
    one.heard = line_.now();
    if (not found.why.empty() and not std::exchange(one.was_doubt_told, true)) {
        tell(event_kind::note, plan_.devices[which].name, found.why);
    }
    return right;
}

/// It responds, or is to be met: so many rounds it may miss from here on.
void line_rounds::begin_patience(device& one) const
{
    bool const is_forgotten = line_.now() - one.first_lost >= unsteady_time;
    one.losses = is_forgotten ? 0 : one.losses;
    unsigned const least = plan_.choices.retries == 0 ? 2 : 1; // two requests in any case
    one.patience = asked_less{least + std::max(one.losses, 1U) - 1, longest_pause};
    one.misses = 0;
}

void line_rounds::note_silence(std::size_t which, std::string const& why, clock::duration cost)
{
    device& one = devices_[which];
    clock::time_point const now = line_.now();
    ++one.misses;
    one.patience.note(false, now);
    if (not one.patience.is_silent()) {
        return;
    }
    if (std::exchange(one.is_identified, false)) {
        one.first_lost = one.losses++ == 0 ? now : one.first_lost;
    }
    if (one.content.why != why) {
        mark_lost(which, why);
    }
    if (not std::exchange(one.was_told, true)) {
        tell(event_kind::device_silent, plan_.devices[which].name, why);
    }
    probes_from_ = has_live_ones() ? now + std::min<clock::duration>(9 * cost, longest_pause) : now;
}

/// Nothing of it is known any more.
void line_rounds::mark_lost(std::size_t which, std::string const& why)
{
    device& one = devices_[which];
    one.is_identified = false;
    one.is_read_next = false;
    one.content.is_available = false;
    one.content.why = why;
    ++one.content.seq;
    for (slot_value& each : one.content.values) {
        each = {.time = line_.unix_time(), .seq = one.content.seq, .why = why};
    }
    put(which);
}

bool line_rounds::read(part& one)
{
    std::size_t const which = one.what.device;
    clock::time_point const began = line_.now();
    std::uint64_t const time = line_.unix_time();
    part_reading found = line_.read(static_cast<std::size_t>(&one - parts_.data()));
    silent_at_ = found.was_repeated ? line_.now() : silent_at_;
    bool const was_read_in_part = std::exchange(one.is_read_in_part, found.has_responded and found.has_fallen_silent);
    bool const may_be_gone = one.is_read_in_part and not was_read_in_part;
    bool const may_be_exchanged = found.was_repeated and says_who(which);
    bool const is_doubtful = found.has_responded and (may_be_gone or may_be_exchanged);
    one.reading = {std::move(found), time, line_.now() - began};
    return not is_doubtful;
}

bool line_rounds::take(part& one)
{
    std::size_t const which = one.what.device;
    device& asked = devices_[which];
    auto [found, time, cost] = *std::exchange(one.reading, std::nullopt);
    asked.is_read_next = false;
    if (not found.has_responded) {
        note_silence(which, found.why, cost);
        if (not asked.is_identified) {
            return true; // all of it is marked
        }
    } else {
        begin_patience(asked);
        asked.heard = line_.now();
        if (std::exchange(asked.was_told, false)) {
            tell(event_kind::device_back, plan_.devices[which].name, "it responds again");
        }
        asked.late_readings = found.late.empty() ? 0 : asked.late_readings + 1;
        if (asked.late_readings >= late_readings_told and not std::exchange(asked.was_lateness_told, true)) {
            tell(event_kind::note, plan_.devices[which].name, found.late);
        }
        asked.content.is_available = true;
        asked.content.why.clear();
    }
    ++asked.content.seq;
    for (std::size_t i = 0; i < one.what.values.size(); ++i) {
        slot_value& to = asked.content.values[one.what.values[i]];
        if (not found.values[i]) {
            continue;
        }
        to = std::move(*found.values[i]);
        to.time = time;
        to.seq = asked.content.seq;
    }
    put(which, time);
    return found.is_through;
}

void line_rounds::put(std::size_t which) { put(which, line_.unix_time()); }

void line_rounds::put(std::size_t which, std::uint64_t time)
{
    devices_[which].content.time = time;
    board_.put(which, devices_[which].content);
}

std::string line_rounds::why_away(setting_request const& request) const
{
    device const& to = devices_[request.device];
    if (not state_.is_up) {
        return "the line is away: " + state_.why;
    }
    if (not to.is_identified or not to.content.is_available) {
        return "the device is away: " + to.content.why;
    }
    return {};
}

std::string line_rounds::claim(setting_request const& request)
{
    device_plan const& to = plan_.devices[request.device];
    device_value const& value = to.values[request.value];
    if (not value.setting->is_stored) {
        return {};
    }
    // By what it is on the line, whatever it is called: other names are no way around the interval. A device's file has its name
    // only until it is put in again, and others may get it then.
    std::vector<std::string> ports{plan_.choices.port};
    std::error_code is_no_file;
    std::filesystem::path const file = std::filesystem::canonical(plan_.choices.port, is_no_file);
    if (not is_no_file and file != plan_.choices.port) {
        ports.push_back(file.string());
    }
    place const& where = value.which.where;
    std::vector<std::string> registers;
    for (unsigned i = 0; i < ports.size() * where.size(); ++i) {
        registers.push_back(ports[i / where.size()] + ' ' + std::to_string(to.unit.unit.byte()) + ' ' +
                            std::string{name_of(where.space)} + ':' + std::to_string(where.address + i % where.size()));
    }
    return stored_.claim(registers, line_.unix_time(), line_.now());
}

bool line_rounds::is_expired(taken_setting const& setting) const
{
    return setting.what.is_expired(line_.now(), line_.unix_time());
}

void line_rounds::take_settings()
{
    clock::time_point const now = line_.now();
    auto const may_have = [&](std::size_t which) {
        return std::ranges::none_of(settings_,
                                    [&](taken_setting const& each) { return each.what.request.device == which; }) and
               not(devices_[which].is_read_next and std::ranges::any_of(parts_, [&](part const& each) {
                       return each.what.device == which and each.due <= now;
                   }));
    };
    auto const is_to_go = [&](waiting_setting const& each) {
        return may_have(each.request.device) or each.is_expired(now, line_.unix_time());
    };
    while (auto setting = board_.take_setting(is_to_go)) {
        settings_.push_back({*std::move(setting)});
    }
}

std::optional<setting_outcome> line_rounds::ended_waiting(taken_setting const& setting) const
{
    setting_request const& request = setting.what.request;
    if (is_expired(setting)) {
        return setting_outcome{setting_result::expired, setting.goes_on ? why_too_late : "it expired before its turn"};
    }
    if (std::string why = why_away(request); not why.empty()) {
        return setting_outcome{setting_result::failed, std::move(why)};
    }
    if (std::string why = board_.why_replaced(request); not why.empty()) {
        return setting_outcome{setting_result::refused, std::move(why)};
    }
    return std::nullopt;
}

/// Before what is due of others, but where its device had a turn while they waited.
void line_rounds::write_next()
{
    std::erase_if(settings_, [&](taken_setting const& each) {
        auto const ended = ended_waiting(each);
        if (ended) {
            answer(each.what.request, ended->result, ended->why);
        }
        return ended.has_value();
    });
    if (settings_.empty()) {
        return;
    }
    clock::time_point const now = line_.now();
    part const* const due = first_due(now);
    auto next = settings_.end();
    for (auto each = settings_.begin(); each != settings_.end(); ++each) {
        std::size_t const which = each->what.request.device;
        clock::time_point const turn = devices_[which].turn;
        if (line_.is_left_alone(which)) {
            silent_at_ = now;
            line_.keep_turn(which);
        } else if ((due == nullptr or turn <= place_of(*due)) and
                   (next == settings_.end() or turn < devices_[next->what.request.device].turn)) {
            next = each;
        }
    }
    if (next == settings_.end()) {
        return;
    }
    try {
        if (not write(*next)) {
            return;
        }
    } catch (...) {
        settings_.erase(next);
        throw;
    }
    settings_.erase(next);
}

bool line_rounds::write(taken_setting& setting)
{
    setting_request const& request = setting.what.request;
    device& to = devices_[request.device];
    setting_look const last_look = [&]() -> std::optional<setting_outcome> {
        if (std::string const why = board_.why_replaced(request); not why.empty()) { // while it was judged
            return setting_outcome{setting_result::refused, why};
        }
        if (std::string const why = is_expired(setting) ? std::string{} : claim(request); not why.empty()) {
            return setting_outcome{setting_result::refused, why};
        }
        if (is_expired(setting)) { // to note it may take its time, too
            return setting_outcome{setting_result::expired, why_too_late};
        }
        return std::nullopt;
    };
    for (part& each : parts_) { // it would be old behind this, and what was set seem to jump back
        if (each.what.device == request.device) {
            each.reading.reset();
        }
    }
    std::optional<setting_outcome> outcome;
    try {
        outcome = line_.write(setting.what, setting.goes_on, last_look);
    } catch (std::exception const& why) {
        answer(request, setting_result::failed, why.what()); // whatever else: it has its answer, and is not tried again
        throw;
    }
    if (not outcome or setting.goes_on) {
        setting.goes_on = to.is_read_next = true;
        silent_at_ = line_.now();
        end_turn(request.device);
    }
    if (not outcome) {
        return false;
    }
    if (outcome->result != setting_result::done) {
        to.heard = {}; // it may say that it is another
    }
    if (outcome->was_sent) {
        for (part& each : parts_) { // what it holds now is published soon
            bool const has_it =
                each.what.device == request.device and std::ranges::count(each.what.values, request.value) != 0;
            each.due = has_it ? std::min(each.due, line_.now()) : each.due;
        }
    }
    answer(request, outcome->result, outcome->why);
    if (not outcome->port_lost.empty()) {
        throw ended{exit_status::port, outcome->port_lost};
    }
    return true;
}

void line_rounds::answer(setting_request const& request, setting_result result, std::string why)
{
    board_.answer(request, result, std::move(why), line_.unix_time());
}

void line_rounds::end()
{
    constexpr auto why = "the line ended before its turn";
    for (taken_setting const& each : settings_) {
        answer(each.what.request, setting_result::refused, why);
    }
    settings_.clear();
    while (auto const setting = board_.take_setting([](waiting_setting const&) { return true; })) {
        answer(setting->request, setting_result::refused, why);
    }
}

void line_rounds::tell(event_kind what, std::string const& who, std::string const& text)
{
    board_.tell({what, line_.unix_time(), who, plan_.name + ": " + (who.empty() ? "" : who + ": ") + plain_text(text)});
}

} // namespace tool::gateway
