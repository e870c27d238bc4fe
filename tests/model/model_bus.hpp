// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A second bus, written from rules 28 to 32 of docs/engine-rules.md. Shares no code with the headers.
#pragma once

#include <limits>

#include "model_client.hpp"

namespace model {

struct share {
    unsigned silent_share;
    unsigned silent_after;
};

struct slot_options {
    retry_policy with;
    microseconds least_idle;
    microseconds longest_gap;
};

/// A conversation that may pause by itself.
struct bus_conversation : conversation {
    bool is_timed{false};
    virtual void advance(microseconds now) = 0;
    virtual std::optional<microseconds> poll_deadline() const = 0;
};

class bus {
public:
    bus(line_times const& times, options const& how, share const& of, std::size_t slots)
        : inner{times, how}, times_{times}, share_{of},
          slots_(slots, slot{{inner.own_retry_policy(), 0, 0}}), last_probed_{slots - 1}
    {
        inner.kept_up = [this](microseconds now) { advance_slots(now); };
    }
    bus(bus const&) = delete;
    bus& operator=(bus const&) = delete;

    void set(std::size_t index, slot_options const& as) { slots_[index].options = as; }

    void advance(microseconds now)
    {
        inner.advance(now);
        is_urgent_ = false;
        advance_slots(now);
    }
    void advance_slots(microseconds now)
    {
        is_put_off_ = is_put_off_ and now < put_off_until_;
        is_idle_ = is_idle(now);
        if (is_idle_) {
            return;
        }
        had_awake_ = false;
        for (slot& each : slots_) {
            each.is_resting = each.is_resting and now < each.not_before;
            if (is_pass_) {
                each.is_present = each.is_present and each.is_here;
                each.is_here = false;
            }
            each.wake = std::nullopt;
        }
        is_pass_ = false;
        urgent_wake_ = std::nullopt;
    }

    /// 42: after a call that may have changed what goes on on the line.
    void happened()
    {
        is_idle_ = false;
        has_left_ = has_left_ and inner.is_visit_vain();
    }

    void converse(std::size_t index, bus_conversation& who, microseconds now)
    {
        if (index >= slots_.size() or (is_idle_ and not who.is_timed)) {
            return;
        }
        had_awake_ = had_awake_ or who.is_timed;
        is_pass_ = true;
        slot& own = slots_[index];
        own.is_here = true;
        own.is_present = not who.settled();
        bool const wants = own.is_present and not is_urgent_ and not is_held_back(index, now);
        if (auto const told = inner.deliver(who, wants, now)) {
            has_left_ = false;
            own.not_before = now + own.options.least_idle;
            own.is_resting = own.options.least_idle > 0;
            note(own, *told, now);
        }
        if (who.is_timed) {
            who.advance(now);
            wake_at(own.wake, who.poll_deadline(), now);
        }
        if (not is_urgent_ and not is_held_back(index, now)) {
            ask(index, who, now);
        }
        happened();
    }

    void run_urgent(bus_conversation& who, microseconds now)
    {
        if (who.is_timed or not who.settled()) {
            is_idle_ = false;
            had_awake_ = true;
        }
        inner.deliver(who, now);
        if (who.is_timed) {
            who.advance(now);
        }
        is_urgent_ = is_urgent_ or not who.settled();
        if (who.is_timed) {
            wake_at(urgent_wake_, who.poll_deadline(), now);
        }
        if (not who.settled() and inner.ask(who, now, slots_[0].options.with) == client::turn::taken) {
            asked_at_ = now;
        }
        happened();
    }

    bool is_silent(std::size_t index) const { return is_silent(slots_[index]); }

    std::optional<microseconds> poll_deadline() const
    {
        auto next = inner.poll_deadline();
        auto const add = [&](microseconds at) { next = next ? std::min(*next, at) : at; };
        for (slot const& each : slots_) {
            add(each.wake.value_or(never));
            add(each.is_resting ? each.not_before : never);
        }
        add(is_put_off_ ? put_off_until_ : never);
        add(urgent_wake_.value_or(never));
        if (*next == never) {
            next = std::nullopt;
        }
        return next;
    }

    /// For who reads a schedule.
    std::string state() const
    {
        std::string out = is_put_off_ ? " put off until " + std::to_string(put_off_until_) : "";
        for (slot const& each : slots_) {
            out += ", " + std::to_string(each.unit) + (each.has_responded ? " +" : " ?") +
                   std::to_string(each.failures) + (each.is_here ? "!" : "") + (each.is_present ? "." : "") +
                   (each.wake ? "@" + std::to_string(*each.wake) : "");
        }
        return out + " last " + std::to_string(last_probed_);
    }

    client inner;

private:
    static constexpr microseconds never = std::numeric_limits<microseconds>::max();

    struct slot {
        slot_options options;
        std::uint8_t unit{0};
        unsigned failures{0};
        bool has_responded{false};
        microseconds not_before{0};
        microseconds last_request{0};
        bool is_resting{false};
        bool is_here{false};
        bool is_present{false};
        std::optional<microseconds> wake{};
    };

    /// 42.
    bool is_idle(microseconds now)
    {
        bool const had_left = has_left_;
        has_left_ = inner.is_visit_vain();
        if (not has_left_ or not had_left or not is_pass_ or had_awake_ or urgent_wake_) {
            return false;
        }
        for (slot const& each : slots_) {
            if (each.wake or (each.is_resting and now >= each.not_before) or (is_silent(each) and not is_put_off_)) {
                return false;
            }
        }
        return true;
    }

    bool is_silent(slot const& of) const
    {
        return of.failures >= (of.has_responded ? std::max(share_.silent_after, 1U) : 1U);
    }
    static void wake_at(std::optional<microseconds>& wake, std::optional<microseconds> at, microseconds now)
    {
        if (at and *at > now and (not wake or *at < *wake)) {
            wake = at;
        }
    }

    void ask(std::size_t index, bus_conversation& who, microseconds now)
    {
        slot& own = slots_[index];
        retry_policy with = own.options.with;
        with.retries = is_silent(own) ? 0 : with.retries;
        client::turn const what = inner.ask(who, now, with);
        if (what == client::turn::not_its) {
            return;
        }
        if (what == client::turn::taken) {
            own.last_request = asked_at_ = now;
            if (own.unit != inner.unit() and inner.unit() != 0) {
                own.unit = inner.unit();
                own.failures = 0;
                own.has_responded = false;
            }
        }
        last_probed_ = is_silent(own) ? index : last_probed_;
    }

    /// A time as the clock shows it, which wraps after 71.6 minutes.
    static microseconds on_clock(microseconds length) { return static_cast<std::uint32_t>(length); }

    /// 28 and 29.
    void note(slot& own, fault error, microseconds now)
    {
        if (error == cancelled or inner.unit() == 0) {
            return;
        }
        if (error < 0x80) {
            own.failures = 0;
            own.has_responded = true;
            return;
        }
        ++own.failures;
        microseconds const cost = on_clock(now - asked_at_);
        microseconds const addend =
            std::min<microseconds>((cost / share_.silent_share + 1) * (100 - share_.silent_share), 600'000'000);
        microseconds const left = is_put_off_ ? on_clock(put_off_until_ - asked_at_) : 0;
        put_off_until_ = now + std::min<microseconds>(left + addend, 1'800'000'000);
        is_put_off_ = true;
    }

    bool is_held_back(std::size_t index, microseconds now)
    {
        slot& own = slots_[index];
        if (own.is_resting) {
            return true;
        }
        if (not is_silent(own)) {
            return false;
        }
        if (is_put_off_) {
            return true;
        }
        if (next_to_probe(index) != index or not fits(index, now)) {
            wake_at(own.wake, now + own.options.with.response_timeout, now);
            return true;
        }
        return false;
    }
    /// 30.
    std::size_t next_to_probe(std::size_t own) const
    {
        std::size_t at = last_probed_;
        do {
            at = (at + 1) % slots_.size();
        } while (at != own and not may_be_probed(slots_[at]));
        return at;
    }
    bool may_be_probed(slot const& each) const
    {
        return is_silent(each) and each.is_present and not each.is_resting and not inner.is_held(each.unit);
    }
    /// 31. However long ago the other was asked, as the clock shows it.
    bool fits(std::size_t index, microseconds now) const
    {
        microseconds const end = now + slots_[index].options.with.response_timeout + times_.characters(512);
        for (std::size_t i = 0; i < slots_.size(); ++i) {
            slot const& each = slots_[i];
            if (i == index or is_silent(each) or each.options.longest_gap == 0 or not each.is_present or
                each.unit == 0) {
                continue;
            }
            if (on_clock(end - each.last_request) > each.options.longest_gap) {
                return false;
            }
        }
        return true;
    }

    line_times times_;
    share share_;
    std::vector<slot> slots_;
    std::size_t last_probed_{0};
    microseconds asked_at_{0};
    bool is_put_off_{false};
    microseconds put_off_until_{0};
    bool is_urgent_{false};
    std::optional<microseconds> urgent_wake_{};
    bool is_pass_{false};
    bool is_idle_{false};
    bool has_left_{false};  ///< at the latest `advance`, and nothing changed since
    bool had_awake_{false}; ///< somebody with a time of its own, or before all slots, visited since then
};

} // namespace model
