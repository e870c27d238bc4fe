// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// The program above a client or a bus: conversations that ask, are cancelled, and come and go while their
// request is under way.
#pragma once

#include <array>
#include <optional>
#include <utility>
#include <vector>

#include "slow_world.hpp"

namespace rtuwire::simulation {

class application final : public program, public witness {
public:
    application(setting const& how, tally& counts) : link_{engine_for(how)}, world_{how, counts, *link_, *this}
    {
        for (unsigned i = 0; i < how.conversations; ++i) {
            seats_.emplace_back().present[0].emplace(*this);
        }
        world_.run_until(100'000);
    }

    journal const& events() { return world_.all().events; }

    /// A time with faults, and one without. Whether nothing was wrong so far.
    bool live(unsigned inquiries)
    {
        left_ = inquiries;
        act_at_ = world_.now() + 1;
        world_.wake();
        moment const limit = world_.now() + 4'000'000'000U;
        while ((left_ > 0 or is_anything_open()) and world_.now() < limit and not world_.has_fault()) {
            world_.step(limit);
        }
        return not world_.has_fault() and recovers();
    }

    /// A bus with dead units, for so long: what they cost the others.
    bool measure_share()
    {
        left_ = ~0U;
        world_.wake();
        moment const cost = (how().response_timeout() + world_.times().characters(40)) * (how().options.retries + 1U);
        moment const from = world_.now() + 12 * how().units * cost;
        run_until(from);
        silent_time_ = 0;
        unanswered_.fill(0);
        moment const until = from + 60 * cost;
        run_until(until);
        moment const share = (until - from) * bus_options{}.silent_share / 100;
        if (silent_time_ > share + share / 10 + 2 * cost) {
            accuse(fault::share);
        }
        for (unsigned i = 0; i < how().units; ++i) {
            if (how().unit[i].is_dead and unanswered_[i] == 0) {
                accuse(fault::starved);
            }
        }
        return not world_.has_fault();
    }

private:
    /// Where a conversation lives; another may live there later, or it in the other place.
    struct seat {
        std::optional<conversation_on_trial> present[2];
        unsigned at{0};
        moment begin_at{0};
        moment away_until{0};
        unsigned failures{0};
        bool has_responded{false};
        bool is_health_known{true}; ///< not where an outcome was dropped

        conversation_on_trial& here() { return *present[at]; }
    };

    setting const& how() const { return world_.how(); }
    void accuse(fault what) { world_.all().accuse(what, world_.now()); }
    void note(char const* what, std::uint32_t inquiry) { world_.all().events.note(world_.now(), what, inquiry); }
    std::uint32_t below(moment limit) { return world_.random_source().below(static_cast<std::uint32_t>(limit)); }
    inquiry& inquiry_of(seat& at) { return world_.all().inquiries[at.here().inquiry]; }

    void run_until(moment end)
    {
        while (world_.now() < end and not world_.has_fault()) {
            world_.step(end);
        }
    }

    bool is_anything_open()
    {
        for (seat& each : seats_) {
            if (each.here().wants) {
                return true;
            }
        }
        return false;
    }

    // --- its part of a pass -----------------------------------------------------------------------

    void converse() override
    {
        moment const now = world_.now();
        for (std::size_t i = 0; i < seats_.size(); ++i) {
            seat& at = seats_[i];
            if (at.away_until > now) {
                continue;
            }
            if (not at.here().wants and left_ > 0 and at.begin_at <= now) {
                --left_;
                note("wants to ask: conversation", static_cast<std::uint32_t>(i));
                begin(i);
            }
            turn_ = i;
            link_->converse(i, at.here(), world_.clock());
        }
    }

    void given(conversation_on_trial& by) override
    {
        inquiry& of = world_.all().inquiries[by.inquiry];
        seat const& at = seats_[turn_];
        of.is_health_known = not how().is_bus or at.is_health_known;
        bool const is_silent = at.failures >= bus_options{}.silent_after or (at.failures != 0 and not at.has_responded);
        of.is_first_try_only = how().is_bus and at.is_health_known and is_silent;
        world_.verdicts().given(by.inquiry, world_.now());
    }

    void accepted(conversation_on_trial& by, result<response> const& outcome) override
    {
        moment const now = world_.now();
        note("outcome for conversation", static_cast<std::uint32_t>(turn_));
        bool const is_own = world_.verdicts().accepts(by.inquiry, by.wants and by.was_given, outcome, now);
        by.wants = by.was_given = false;
        if (not is_own) {
            return;
        }
        bool const has_response = outcome.has_value() or is_exception(outcome.error());
        bool const is_cancelled = outcome.error() == errc::cancelled;
        tally& counts = world_.all().counts();
        ++counts.inquiries;
        ++(has_response ? counts.answered : is_cancelled ? counts.given_up : counts.failed);
        seat& at = seats_[turn_];
        inquiry const& of = world_.all().inquiries[by.inquiry];
        if (how().measures_share and not has_response) {
            silent_time_ += now - of.given;
            ++unanswered_[of.request[0] - 1U];
        }
        note_health(at, of, has_response, is_cancelled);
        last_is_good_ = has_response;
        at.begin_at = now + time_to_think();
        world_.wake();
    }

    /// What a bus should know of a slot's unit; of a broadcast it learns nothing.
    static void note_health(seat& at, inquiry const& of, bool has_response, bool is_cancelled)
    {
        if (of.is_broadcast()) {
            return;
        }
        at.has_responded = at.has_responded or has_response;
        if (has_response) {
            at.failures = 0;
            at.is_health_known = true;
        } else if (is_cancelled) {
            at.is_health_known = false;
        } else {
            ++at.failures;
        }
    }

    /// Half of all requests follow at once.
    moment time_to_think()
    {
        if (how().measures_share) {
            return how().response_timeout() / (how().seed % 2 == 0 ? 4 : 1) * 2;
        }
        if (below(2) == 0) {
            return 0;
        }
        return below(below(2) == 0 ? 20'000 : how().response_timeout());
    }

    // --- requests --------------------------------------------------------------------------------

    void begin(std::size_t index)
    {
        unsigned const all = how().units + how().servers;
        // On a bus each slot is one unit's.
        auto unit = static_cast<std::uint8_t>(1 + (how().is_bus ? index % all : below(all)));
        bool const is_plain = how().measures_share or how().has_constant_latency;
        if (not how().measures_share and not world_.is_calm() and below(25) == 0) {
            unit = 0;
        }
        inquiry& of = world_.all().inquiries.add(++inquiry_number_);
        of.id = inquiry_number_;
        of.begun = world_.now();
        of.may_repeat = is_plain or below(8) != 0;
        of.request = make_request(unit);
        seat& at = seats_[index];
        at.here().begin(of.id, of.request, of.may_repeat);
    }

    /// Few addresses and quantities, as in a real program: what a response repeats tells little.
    frame make_request(std::uint8_t unit)
    {
        unsigned const start = 3'200 + below(2);
        bool const is_long = not how().measures_share and below(16) == 0;
        unsigned const count = 2 + below(is_long ? 100 : 2);
        // With little time a host cannot wait for the silence that ends function 08.
        unsigned const kind = unit == 0 ? 4 + below(4) : below(world_.is_calm() ? 9 : 10);
        frame made;
        if (kind < 4) {
            made = frame{unit, 3}.word(start).word(count);
        } else if (kind < 6) {
            made = frame{unit, 6}.word(start).word(inquiry_number_ & 0xFFFFU);
        } else if (kind < 8) {
            made = frame{unit, 16}.word(start).word(count).byte(2 * count);
            add_words(made, count);
        } else if (kind < 9) {
            made = frame{unit, 23}.word(start).word(count).word(start).word(2).byte(4);
            add_words(made, 2);
        } else {
            made = frame{unit, 8}.word(0).word(inquiry_number_ & 0xFFFFU);
            add_words(made, below(3));
        }
        return made.close();
    }
    void add_words(frame& to, unsigned count) const
    {
        for (unsigned i = 0; i < count; ++i) {
            to.word((inquiry_number_ + 7U * i) & 0xFFFFU);
        }
    }

    // --- what else it does ------------------------------------------------------------------------

    moment next_act() const override
    {
        moment next = act_at_;
        for (seat const& each : seats_) {
            if (each.begin_at > world_.now() and left_ > 0) {
                next = std::min(next, each.begin_at);
            }
        }
        return next;
    }

    /// A request is due; and now and then somebody cancels, leaves, or comes back.
    void act() override
    {
        world_.wake();
        if (act_at_ > world_.now()) {
            return;
        }
        act_at_ = world_.now() + 1 + below(2 * how().response_timeout());
        if (world_.happens(how().noise)) {
            world_.make_noise();
        }
        if (world_.happens(how().cancels)) {
            link_->cancel(world_.clock());
            note("cancel", world_.verdicts().current());
            world_.verdicts().cancelled();
        }
        if (world_.happens(how().misuses)) {
            misuse(below(seats_.size()));
        }
        for (seat& each : seats_) {
            check_end(each);
        }
    }

    void misuse(std::size_t index)
    {
        seat& at = seats_[index];
        bool const is_current = at.here().wants and world_.verdicts().is_current(at.here().inquiry);
        std::size_t const other = below(seats_.size());
        switch (below(5)) {
        case 0: // destroyed; another in the same place
            give_up(at, is_current, "destroyed");
            at.present[at.at].reset();
            at.present[at.at].emplace(*this);
            break;
        case 1: // begun again
            give_up(at, is_current, "begun again");
            if (left_ > 0) {
                --left_;
                begin(index);
            }
            break;
        case 2: // moved to another place
            note("moved", at.here().inquiry);
            at.present[1 - at.at].emplace(std::move(at.here()));
            at.present[at.at].reset();
            at.at = 1 - at.at;
            break;
        case 3: // two change places; on a bus each slot is one unit's
            if (not how().is_bus and other != index) {
                note("changes places", at.here().inquiry);
                std::swap(at.here(), seats_[other].here());
                bool const is_away = at.away_until > world_.now() or seats_[other].away_until > world_.now();
                inquiry& under_way = world_.all().inquiries[world_.verdicts().current()];
                under_way.was_away = under_way.was_away or is_away;
            }
            break;
        default: // nobody serves it for a while
            note("away", at.here().inquiry);
            at.away_until =
                world_.now() + below(below(2) == 0 ? how().response_timeout() / 8 : 3 * how().response_timeout());
            inquiry_of(at).was_away = inquiry_of(at).was_away or is_current;
            break;
        }
    }

    void give_up(seat& at, bool is_current, char const* how_so)
    {
        note(how_so, at.here().inquiry);
        if (not at.here().wants) {
            return;
        }
        ++world_.all().counts().given_up;
        ++world_.all().counts().inquiries;
        at.here().give_up();
        at.is_health_known = false;
        if (is_current) {
            world_.verdicts().given_up();
        }
    }

    /// How long a request may wait for its outcome: for the others' and their debts, on a bus also for
    /// its turn among the silent.
    moment longest_wait() const
    {
        return (how().is_bus ? 20U : 1U) * (how().conversations + 1U) * how().longest_wait();
    }

    void check_end(seat& at)
    {
        moment const since = std::max(inquiry_of(at).begun, at.away_until);
        if (at.here().wants and world_.now() > since + longest_wait() + 10'000'000) {
            accuse(fault::never_ended);
        }
    }

    /// The line is good again: each conversation's next request succeeds within a bound.
    bool recovers()
    {
        world_.calm_down();
        for (std::size_t i = 0; i < seats_.size() and not world_.has_fault(); ++i) {
            seat& at = seats_[i];
            at.away_until = 0;
            world_.await_silence();
            begin(i);
            world_.wake();
            moment const bound = world_.now() + longest_wait() + 1'000'000;
            while (at.here().wants and world_.now() < bound and not world_.has_fault()) {
                world_.step(bound);
            }
            if (not world_.has_fault() and (at.here().wants or not last_is_good_)) {
                accuse(fault::slow_recovery);
            }
        }
        world_.stir_up();
        return not world_.has_fault();
    }

    std::unique_ptr<engine> link_;
    slow_world world_;
    std::vector<seat> seats_{};
    std::array<unsigned, setting::most_units> unanswered_{};
    moment act_at_{never};
    moment silent_time_{0};
    std::uint32_t inquiry_number_{0};
    std::size_t turn_{0};
    unsigned left_{0};
    bool last_is_good_{false};
};

} // namespace rtuwire::simulation
