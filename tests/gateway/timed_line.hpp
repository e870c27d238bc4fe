// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A line of the gateway in simulated time: what its devices do is set by the test, and what a request costs is counted.
#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "../../tools/gateway/asked_line.hpp"
#include "../../tools/gateway/line_board.hpp"
#include "../../tools/gateway/line_rounds.hpp"
#include "gateway/scratch_folder.hpp"

namespace gateway_test {

using namespace tool;
using namespace tool::gateway;
using namespace std::chrono_literals;
using time_point = asked_line::clock::time_point;

inline constexpr std::uint64_t first_second = 1'800'000'000'000'000; ///< microseconds since 1970, when a line begins

class timed_line final : public asked_line {
public:
    struct unit {
        bool is_there{true};
        bool is_other{false};
        bool is_invalid{false};
        bool is_unsure{false};
        bool is_late{false};
        bool loses_one{false};    ///< response, before it answers the repetition
        bool falls_silent{false}; ///< behind its next response, when it is asked for more
        clock::duration takes{0}; ///< more, for each response
        unsigned looks{1};        ///< so many turns its identification takes
        std::int64_t held{0};
        unsigned reads{0};
        unsigned looked{0};     ///< turns of an identification that is not through
        unsigned identified{0}; ///< turns in all
        unsigned sets{1};       ///< so many turns a setting takes
        unsigned set{0};        ///< turns of the last setting
        unsigned written{0};
        bool owes{false};         ///< an answer that may come yet, from when it is identified on
        unsigned kept{0};         ///< so often its turn was
        std::uint64_t read_at{0}; ///< microseconds since 1970, when its latest values were asked for
    };

    explicit timed_line(line_plan const& plan) : units(plan.devices.size()), parts_{parts_of(plan)} {}

    clock::time_point now() const override { return now_; }
    std::uint64_t unix_time() const override
    {
        auto const passed = std::chrono::duration_cast<std::chrono::microseconds>(now_.time_since_epoch());
        return first_second + static_cast<std::uint64_t>(passed.count());
    }
    void wait(clock::time_point until) override
    {
        if (is_open_) {
            refuse_lost();
        }
        now_ = std::max(now_, until);
    }
    void open() override
    {
        ++opens;
        pass(1ms);
        refuse_lost();
        is_open_ = true;
        has_listened_ = false;
    }
    void close() override
    {
        is_open_ = false;
        for (unit& each : units) {
            each.looked = 0;
        }
    }

    bool is_left_alone(std::size_t device) const override
    {
        return units[device].owes and units[device].identified > 0;
    }
    void keep_turn(std::size_t device) override { ++units[device].kept; }

    device_finding identify(std::size_t device, bool is_known_silent) override
    {
        unit& asked = units[device];
        ++asked.identified;
        if (not request(asked, is_known_silent ? 1 : tries)) {
            asked.looked = 0;
            return {device_finding::kind::silent, "no response in time"};
        }
        if (++asked.looked < asked.looks) {
            return {device_finding::kind::open, {}};
        }
        asked.looked = 0;
        return asked.is_other    ? device_finding{device_finding::kind::wrong, "another device"}
               : asked.is_unsure ? device_finding{device_finding::kind::right, "who knows"}
                                 : device_finding{};
    }

    part_reading read(std::size_t part) override
    {
        unit& asked = units[parts_[part].device];
        ++asked.reads;
        asked.read_at = unix_time();
        part_reading found{.has_responded = request(asked, tries), .was_repeated = asked.loses_one};
        if (found.has_responded and std::exchange(asked.falls_silent, false)) {
            asked.is_there = false;
            found.has_fallen_silent = not request(asked, tries);
        }
        found.late = asked.is_late ? "its answers come too late" : "";
        found.why = found.has_responded ? "" : "no response in time";
        for (std::size_t i = 0; i < parts_[part].values.size(); ++i) {
            found.values.push_back(not found.has_responded ? slot_value{.state = value_state::failed, .why = found.why}
                                   : asked.is_invalid ? slot_value{.state = value_state::invalid, .why = "no value"}
                                                      : slot_value{.state = value_state::valid, .value = asked.held});
        }
        return found;
    }

    std::optional<setting_outcome> write(waiting_setting const& setting, bool goes_on,
                                         setting_look const& last_look) override
    {
        unit& asked = units[setting.request.device];
        asked.set = goes_on ? asked.set + 1 : 1;
        if (asked.set < asked.sets) {
            refuse_lost();
            pass(response + asked.takes);
            return std::nullopt;
        }
        pass(before_write);
        while_judged();
        if (auto const stopped = last_look()) {
            return *stopped;
        }
        refuse_lost();
        ++asked.written;
        if (loses_port_in_write) {
            is_gone = true;
            return setting_outcome{setting_result::failed, "nobody knows", true, "the port is gone"};
        }
        pass(response);
        asked.held = std::stoll(setting.request.text);
        return setting_outcome{setting_result::done, {}, true};
    }

    exchange_counts const& counts() const override { return counts_; }

    void pass(clock::duration time) { now_ += time; }

    std::vector<unit> units;
    clock::duration response{10ms};
    clock::duration timeout{200ms};
    unsigned tries{1}; ///< of one request, where nobody responds
    clock::duration before_write{0ms};
    std::function<void()> while_judged{[] {}}; ///< what comes before it is written
    std::chrono::milliseconds listening{0};    ///< before the first request of a line that was opened
    bool is_gone{false};                       ///< the port
    std::string hangs_up{};                    ///< why it is lost at each request; empty where it is not
    bool loses_port_in_write{false};
    unsigned opens{0};

private:
    void refuse_lost() const
    {
        if (is_gone) {
            throw ended{exit_status::port, "the port is gone"};
        }
    }
    bool request(unit const& asked, unsigned most)
    {
        refuse_lost();
        if (not hangs_up.empty()) {
            pass(response);
            throw ended{exit_status::port, hangs_up};
        }
        ++counts_.asked;
        counts_.silent += asked.is_there ? 0U : 1U;
        pass((asked.is_there ? response + asked.takes : most * timeout) +
             (std::exchange(has_listened_, true) ? 0ms : listening));
        return asked.is_there;
    }

    std::vector<device_part> parts_;
    clock::time_point now_{};
    bool is_open_{false};
    bool has_listened_{true};
    exchange_counts counts_{};
};

/// So many devices with one value each, of a second; the first with another of a minute, and a stored setting.
inline line_plan plan_of(std::size_t devices)
{
    line_plan plan{.name = "line1"};
    for (std::size_t i = 0; i < devices; ++i) {
        device_plan one{.name = "d" + std::to_string(i), .unit = {.unit = rtuwire::unit_id{1}}};
        one.values.push_back({.name = "power", .which = {}, .every = 1.0});
        plan.devices.push_back(std::move(one));
    }
    plan.devices[0].values.push_back({.name = "energy", .which = {}, .every = 60.0});
    plan.devices[0].values.push_back(
        {.name = "level", .which = {}, .every = 1.0, .setting = setting_limits{.is_stored = true}});
    plan.devices[0].values.push_back({.name = "limit", .which = {}, .every = 1.0, .setting = setting_limits{}});
    return plan;
}

/// A line with its rounds.
struct rounds_on_line {
    explicit rounds_on_line(std::size_t devices, bool may_write = true) : rounds_on_line{plan_of(devices), may_write} {}
    explicit rounds_on_line(line_plan of, bool may_write = true)
        : plan{std::move(of)}, line{plan}, board{plan, may_write, [this] { ++news; }},
          stored{folder.path("."), "/etc/one.toml", line.unix_time(), line.now()}, rounds{plan, line, board, stored}
    {}

    /// Its register file has a vendor.
    void have_the_first_say_who_it_is()
    {
        auto const names = std::make_shared<named_places>();
        names->vendor = "Maker";
        plan.devices[0].names = names;
    }

    void run_for(asked_line::clock::duration time)
    {
        for (time_point const end = line.now() + time; line.now() < end;) {
            rounds.step();
        }
    }

    void submit(std::size_t value, std::string text, std::chrono::microseconds valid = 10s, std::string id = "id")
    {
        board.submit(
            {0, value, std::move(text), line.unix_time() + static_cast<std::uint64_t>(valid.count()), std::move(id)},
            line.unix_time(), line.now());
    }

    /// The one answer since the last call.
    setting_answer answer()
    {
        std::vector<setting_answer> const all = board.take_answers();
        return all.size() == 1 ? all[0] : setting_answer{.why = std::to_string(all.size()) + " answers"};
    }

    unsigned count(event_kind what)
    {
        unsigned found = 0;
        for (line_event const& each : board.take_events()) {
            found += each.what == what ? 1U : 0U;
        }
        return found;
    }

    line_plan plan;
    timed_line line;
    unsigned long news{0};
    line_board board;
    scratch_folder folder{};
    stored_writes stored;
    line_rounds rounds;
};

} // namespace gateway_test
