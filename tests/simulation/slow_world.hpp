// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A client or a bus and the ends of its line, in virtual time: what happens next, and who hears of it. The
// program above it is in application.hpp.
#pragma once

#include <algorithm>
#include <array>
#include <deque>
#include <vector>

#include "conversation_on_trial.hpp"
#include "judge.hpp"
#include "server_end.hpp"
#include "slow_unit.hpp"

namespace rtuwire::simulation {

/// The program that a client or a bus is part of.
class program {
public:
    /// In each pass: its conversations take turns.
    virtual void converse() = 0;
    /// When it wants to act apart from that.
    virtual moment next_act() const = 0;
    virtual void act() = 0;

protected:
    ~program() = default;
};

class slow_world {
public:
    slow_world(setting const& how, tally& counts, engine& link, program& above)
        : how_{how}, times_{how.bits_per_second, bits_per_character(how.format)}, all_{how, counts}, judge_{how_,
                                                                                                            times_,
                                                                                                            all_},
          line_{times_, how.seed * 3U + 1U}, random_{how.seed * 5U + 2U}, link_{link}, program_{above}
    {
        for (unsigned i = 0; i < how_.units; ++i) {
            units_.emplace_back(static_cast<std::uint8_t>(i + 1), how_.unit[i]);
        }
        for (unsigned i = 0; i < how_.servers; ++i) {
            auto const unit = static_cast<std::uint8_t>(how_.units + i + 1);
            bool const is_host = how_.server_is_host[i];
            servers_.emplace_back(unit, timing_of(how_, is_host), times_, is_host ? 50'000U : times_.t3_5 + 1,
                                  how_.is_late_in_lumps, all_);
        }
        link_.advance(clock());
        for (server_end& each : servers_) {
            each.start(clock());
        }
    }

    instant clock() const { return instant{static_cast<std::uint32_t>(now_) + how_.clock_start}; }
    moment from_clock(instant at) const
    {
        auto const ahead = static_cast<std::int32_t>(at.microseconds - clock().microseconds);
        return ahead <= 0 ? now_ : now_ + static_cast<moment>(ahead);
    }
    bool happens(std::uint32_t rate) { return not is_calm_ and random_.happens(rate); }
    bool has_fault() const { return all_.has_fault(); }

    void run_until(moment end)
    {
        while (now_ < end) {
            step(end);
        }
    }

    /// To what happens next, `most` at the latest.
    void step(moment most)
    {
        now_ = std::max(now_, next(most));
        line_.advance(
            now_, [&](passing const& by, character const& value, moment begin) { hear(by, value, begin); },
            [&](passing const& ended) { frame_ended(ended); });
        if (adapter_at_ <= now_) {
            release();
        }
        for (std::size_t i = 0; i < units_.size(); ++i) {
            unit_acts(i);
        }
        for (std::size_t i = 0; i < servers_.size(); ++i) {
            server_acts(i);
        }
        if (sent_at_ <= now_) {
            sent_at_ = never;
            link_.sent(clock());
            judge_.told(now_);
            all_.events.note(now_, "client is told that it has left");
            wake();
        }
        if (act_at_ <= now_) {
            program_.act();
        }
        deadline const due = link_.poll_deadline();
        if (due and from_clock(*due) <= now_) {
            wake();
        }
        if (pass_at_ <= now_) {
            pass_at_ = never;
            pass();
        }
    }

    /// The loop comes round, now or a little later.
    void wake()
    {
        if (pass_at_ == never) {
            auto const most = static_cast<std::uint32_t>(how_.pass_late_most);
            pass_at_ = now_ + random_.below(most);
        }
    }

    /// A burst from a transmitter that is no unit's.
    void make_noise()
    {
        passing noise;
        noise.sender = noise_sender;
        noise.damage = 1;
        for (unsigned i = 0, size = 1 + random_.below(8); i < size; ++i) {
            noise.content.byte(random_.below(256));
        }
        line_.transmit(noise, now_);
    }

    /// Nothing goes wrong any more, once all that was on its way is over.
    void calm_down()
    {
        is_calm_ = true;
        await_silence();
        for (slow_unit& each : units_) {
            each.be_fast();
        }
    }

    /// Returns once nobody has had anything to say, or to catch up with, for twice the time after which a host
    /// ends a frame: a server that hears a response of function 08, which has no length, or the rest of a request
    /// after its loop was busy, begins a frame with it that only this silence ends.
    void await_silence()
    {
        constexpr moment parting = 100'000;
        moment silent_from = now_;
        while (now_ < silent_from + parting and not has_fault()) {
            step(silent_from + parting);
            silent_from = is_anybody_busy() ? now_ : std::max(silent_from, line_.last_end());
        }
    }

    /// Everything may go wrong again.
    void stir_up()
    {
        is_calm_ = false;
        for (std::size_t i = 0; i < units_.size(); ++i) {
            units_[i] = slow_unit{units_[i].unit(), how_.unit[i]};
        }
    }

    moment now() const { return now_; }
    setting const& how() const { return how_; }
    line_times const& times() const { return times_; }
    records& all() { return all_; }
    judge& verdicts() { return judge_; }
    detail::random_source& random_source() { return random_; }
    bool is_calm() const { return is_calm_; }

private:
    bool is_anybody_busy() const
    {
        bool is_busy = line_.next() != never;
        for (slow_unit const& each : units_) {
            is_busy = is_busy or not each.is_idle();
        }
        for (server_end const& each : servers_) {
            is_busy = is_busy or each.is_busy(now_);
        }
        return is_busy;
    }

    static constexpr unsigned client_sender = 0;
    static constexpr unsigned first_unit = 1;
    static constexpr unsigned first_server = 16;
    static constexpr unsigned noise_sender = 31;

    /// A character that waits in the client's adapter.
    struct waiting_byte {
        character value{};
        std::uint32_t arrival{0}; ///< 0 for the line's echo
        bool is_first{false};
        bool is_last{false};
    };

    moment next(moment most)
    {
        act_at_ = program_.next_act();
        moment found = std::min({most, line_.next(), sent_at_, adapter_at_, pass_at_, act_at_});
        for (slow_unit const& each : units_) {
            found = std::min(found, each.next());
        }
        for (server_end const& each : servers_) {
            found = std::min(found, each.next(now_, [&](instant at) { return from_clock(at); }));
        }
        deadline const own = link_.poll_deadline();
        if (not own or pass_at_ != never) {
            return found;
        }
        moment const due = from_clock(*own);
        spins_ = due <= now_ and found > now_ ? spins_ + 1 : 0;
        if (spins_ > 200) {
            all_.accuse(fault::spin, now_);
            spins_ = 0;
        }
        return std::min(found, std::max(due, now_ + 1));
    }

    void pass()
    {
        link_.advance(clock());
        program_.converse();
        if (byte_view const bytes = link_.poll_transmit(); not bytes.empty()) {
            client_sends(bytes);
        }
    }

    void client_sends(byte_view bytes)
    {
        std::uint32_t const number = judge_.sends(bytes, now_);
        if (number == 0) {
            return;
        }
        frame content;
        content.assign(bytes);
        passing const sent = on_line(client_sender, content, {.transmission = number}, how_.request_lost);
        own_end_ = line_.transmit(sent, now_);
        judge_.leaves(own_end_);
        all_.events.note(now_, sent.is_lost or sent.deaf_listeners == ~1U ? "client sends, lost" : "client sends",
                         number, bytes);
        auto const late = static_cast<std::uint32_t>(how_.sent_late_most);
        sent_at_ = happens(how_.sent_never)  ? never
                   : happens(how_.sent_late) ? own_end_ + random_.below(late)
                                             : own_end_;
    }

    /// What the line does to a frame.
    passing on_line(unsigned sender, frame const& content, frame_origin const& origin, std::uint32_t lost)
    {
        passing made;
        made.sender = sender;
        made.content = content;
        made.origin = origin;
        if (happens(lost)) {
            // Where the line echoes, a sender hears itself all the same.
            bool const is_echoed = sender == client_sender and how_.has_line_echo;
            made.is_lost = not is_echoed;
            made.deaf_listeners = is_echoed ? ~1U : 0U;
        }
        if (happens(how_.damaged)) {
            auto const size = static_cast<std::uint32_t>(content.size());
            made.damaged_at = static_cast<std::uint8_t>(random_.below(size));
            made.damage = static_cast<std::uint8_t>(1U << random_.below(8));
            made.is_reported = not how_.is_host and random_.below(2) == 0;
        }
        if (made.deaf_listeners == 0 and happens(how_.missed_by_one)) {
            made.deaf_listeners = 1U << random_.below(first_server + setting::most_servers);
        }
        return made;
    }

    static bool misses(passing const& by, unsigned listener) { return ((by.deaf_listeners >> listener) & 1U) != 0; }

    // --- who hears --------------------------------------------------------------------------------

    void hear(passing const& by, character const& value, moment begin)
    {
        if (by.sender != client_sender) {
            client_hears(by, value, begin);
        } else if (how_.has_line_echo) {
            if (not by.is_whole()) {
                judge_.echo_is_spoiled();
            }
            hand_over({value, 0, false, false});
        }
        for (std::size_t i = 0; i < servers_.size(); ++i) {
            unsigned const listener = first_server + static_cast<unsigned>(i);
            if (by.sender == listener) {
                continue;
            }
            if (servers_[i].is_sending(begin) or misses(by, listener)) {
                servers_[i].misses();
            } else {
                servers_[i].hears(by, value, by.sender == client_sender, chances(), random_, now_, clock());
            }
        }
    }

    server_end::chances chances() const
    {
        return is_calm_ ? server_end::chances{} : server_end::chances{how_.served_late, how_.server_sent_missed};
    }

    void client_hears(passing const& by, character const& value, moment begin)
    {
        if (by.next == 0) {
            of_sender_[by.sender] = ++arrival_number_;
            arrivals_.add(arrival_number_).content = by.content;
        }
        std::uint32_t const number = of_sender_[by.sender];
        arrival& of = arrivals_[number];
        of.origin = by.origin;
        // A spoiled character may be the right one by chance.
        bool const is_right = not value.is_damaged and static_cast<std::uint8_t>(value.value) == by.content[by.next];
        of.is_whole = (of.is_whole or by.next == 0) and is_right;
        bool const is_transmitting = begin < own_end_ and not how_.has_line_echo;
        if (is_transmitting or misses(by, client_sender)) {
            return; // too few are heard then, so that it does not count as whole
        }
        ++of.heard;
        waiting_byte const one{value, number, by.next == 0, by.next + 1 == by.content.size()};
        if (how_.is_host) {
            keep(one);
        } else {
            hand_over(one);
        }
    }

    void hand_over(waiting_byte const& one)
    {
        if (one.value.is_damaged) {
            link_.receive_error(clock());
        } else {
            link_.receive(byte_view{&one.value.value, 1}, clock());
        }
        was_handed_over(one);
        if (one.is_last or one.arrival == 0) {
            wake();
        }
    }

    void was_handed_over(waiting_byte const& one)
    {
        if (one.arrival == 0) {
            judge_.hears_echo(now_);
        } else {
            judge_.hears(arrivals_[one.arrival], one.is_first, one.is_last, now_);
        }
    }

    // A host's adapter: characters come in lumps, with gaps.

    void keep(waiting_byte const& one)
    {
        constexpr std::size_t largest = 62;
        if (waiting_.empty()) {
            bool const has_gap = how_.gap_most > 0 and random_.below(3) == 0;
            moment const gap = has_gap ? random_.below(static_cast<std::uint32_t>(how_.gap_most)) : 0U;
            adapter_at_ = std::max(now_ + how_.adapter_latency, std::min(last_release_, now_) + gap);
        }
        waiting_.push_back(one);
        if (waiting_.size() == largest) {
            adapter_at_ = now_;
        }
    }

    void release()
    {
        adapter_at_ = never;
        last_release_ = now_;
        std::array<std::byte, 64> lump{};
        std::size_t size = 0;
        for (waiting_byte const& one : waiting_) {
            lump[size++] = one.value.value;
        }
        link_.receive(byte_view{lump}.first(size), clock());
        for (waiting_byte const& one : waiting_) {
            was_handed_over(one);
        }
        waiting_.clear();
        wake();
    }

    // --- the other ends ---------------------------------------------------------------------------

    void frame_ended(passing const& ended)
    {
        if (not ended.is_whole()) {
            all_.counts().spoiled += ended.is_lost ? 0U : 1U;
            return;
        }
        if (ended.sender != client_sender) {
            return;
        }
        for (std::size_t i = 0; i < units_.size(); ++i) {
            slow_unit& unit = units_[i];
            if (ended.content[0] == unit.unit() and not unit.is_sending(ended.start) and
                not misses(ended, first_unit + static_cast<unsigned>(i))) {
                unit.take({ended.origin.transmission, ended.content, now_}, random_);
            }
        }
    }

    void unit_acts(std::size_t index)
    {
        slow_unit& unit = units_[index];
        if (unit.next() > now_) {
            return;
        }
        if (unit.waits_for_silence() and line_.last_end() + times_.t3_5 > now_) {
            unit.wait_until(line_.last_end() + times_.t3_5);
            return;
        }
        slow_unit::job const& job = unit.current();
        frame const said = happens(how_.refuses_busy) ? exception_to(job.request, 5 + random_.below(2))
                           : happens(how_.refuses)    ? exception_to(job.request, 1 + random_.below(4))
                                                      : response_to(job.request, job.transmission);
        passing const sent =
            on_line(first_unit + static_cast<unsigned>(index), said, unit.origin(), how_.response_lost);
        moment const end = line_.transmit(sent, now_);
        all_.events.note(now_, sent.is_lost ? "unit answers, lost" : "unit answers", job.transmission, said.view());
        moment const longest =
            how_.response_timeout() + how_.late_response() + times_.characters(response_size(job.request));
        unit.leave(end, longest, random_);
    }

    void server_acts(std::size_t index)
    {
        server_end& node = servers_[index];
        byte_view const bytes = node.pass(now_, clock());
        if (bytes.empty()) {
            return;
        }
        std::uint32_t const number = node.answers();
        frame content;
        content.assign(bytes);
        passing const sent = on_line(first_server + static_cast<unsigned>(index), content,
                                     {number, all_.transmissions[number].end, number, false}, how_.response_lost);
        all_.events.note(now_, sent.is_lost ? "server answers, lost" : "server answers", number, bytes);
        node.leaves(line_.transmit(sent, now_), chances(), random_);
    }

    setting how_;
    line_times times_;
    records all_;
    judge judge_;
    shared_line line_;
    detail::random_source random_;
    engine& link_;
    program& program_;
    moment now_{0};
    bool is_calm_{false};
    std::vector<slow_unit> units_{};
    std::deque<server_end> servers_{};
    latest<arrival> arrivals_{64};
    std::array<std::uint32_t, 32> of_sender_{};
    std::vector<waiting_byte> waiting_{};
    moment sent_at_{never};
    moment adapter_at_{never};
    moment last_release_{0};
    moment pass_at_{never};
    moment act_at_{never};
    moment own_end_{0};
    std::uint32_t arrival_number_{0};
    unsigned spins_{0};
};

} // namespace rtuwire::simulation
