// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A second client, written from docs/engine-rules.md. Shares no code with the headers. The numbers in the comments
// are those of the rules.
#pragma once

#include <functional>
#include <string>

#include "model_conversation.hpp"
#include "model_counts.hpp"
#include "model_debts.hpp"
#include "model_response.hpp"

namespace model {

struct options {
    microseconds response_timeout;
    microseconds turnaround;
    microseconds late_response;
    unsigned retries;
    bool has_line_echo;
    unsigned max_leading_noise;
    std::size_t front;   ///< what a request takes of the memory
    std::size_t longest; ///< frame, less what a request takes beyond `front`
    std::size_t places;  ///< for units that owe something
    std::size_t rows;    ///< for units that are counted
};

struct retry_policy {
    microseconds response_timeout;
    unsigned retries;
    unsigned busy_retries;
    microseconds busy_pause;
    microseconds pause;
};

class client {
public:
    enum class phase { idle, waiting, ready, handed_out, transmitting, awaiting, pausing, turnaround, settled };

    client(line_times const& times, options const& how) : counted{how.rows}, line_{times}, how_{how}, debts_{how.places}
    {}

    void receive(bytes const& chunk, microseconds now)
    {
        if (chunk.empty()) {
            return;
        }
        bool const is_start = line_.is_quiet;
        end_by_silence(chunk.size(), now);
        bool const is_held = debts_.covers(chunk[0]); // 26: what these bytes end may hold a unit from here on
        hear(now);
        std::size_t const back = take_echo(chunk, now);
        std::size_t strays = 0;
        for (std::size_t i = back; i < chunk.size(); ++i) {
            strays += take(chunk[i], now) ? 0U : 1U;
        }
        bytes const rest{chunk.end() - static_cast<std::ptrdiff_t>(strays), chunk.end()};
        bool const begins = is_start and strays == chunk.size();
        if (strays > 0 and (begins ? is_held : rest.size() >= 4 and is_whole(rest))) { // 19
            debts_.come_late(rest[0], now, how_.late_response);
        }
        note_strays(strays, begins, chunk[0], is_held);
    }

    void receive_error(microseconds now)
    {
        bool const is_start = line_.is_quiet;
        end_by_silence(1, now);
        hear(now);
        if (phase_ == phase::awaiting) {
            if (line_.at == receiver::state::between and skips_left_ > 0) {
                --skips_left_;
                counted.note(a_noise, unit());
                return;
            }
            line_.damage();
            return;
        }
        static_cast<void>(is_start);
    }

    /// 7, 8.
    void sent(microseconds at)
    {
        bool const was_leaving = is_leaving();
        take_end(at);
        if (was_leaving) {
            keep_up(at - line_.times.characters(request_.size()));
        }
    }
    void take_end(microseconds at)
    {
        line_.note_activity(at);
        if (not is_leaving()) {
            return;
        }
        line_.begin();
        if (unit() == 0) {
            phase_ = phase::turnaround;
            until_ = at + how_.turnaround;
            return;
        }
        note_sending(at);
        if (error_ == cancelled or error_ == line_echo) {
            settle(error_, at);
            return;
        }
        phase_ = phase::awaiting;
        until_ = at + response_time();
        sent_at_ = at;
        skips_left_ = how_.max_leading_noise;
    }

    void advance(microseconds now)
    {
        is_woken_ = false;
        if (not line_.is_known) {
            line_.note_activity(now);
        }
        if (now >= line_.last + line_.times.silence) {
            line_.is_quiet = true;
        }
        end_by_silence(0, now);
        microseconds const at = judged(now);
        seen_ = now;
        if (phase_ == phase::handed_out) {
            phase_ = phase::transmitting;
            until_ = now + leaving_time();
        } else if (is_timed() and at >= until_) {
            time_out(now);
        }
        if (debts_.advance(at)) {
            if (is_held_back_) {
                turns_.others_wait = true;
                turns_.void_marks();
            }
            is_held_back_ = false;
        }
    }

    /// Told of what passed where a call began with a pass.
    std::function<void(microseconds)> kept_up{};
    void keep_up(microseconds now)
    {
        if (seen_ and now - *seen_ > 1'048'576) {
            advance(now);
            if (kept_up) {
                kept_up(now);
            }
        }
    }

    void cancel(microseconds now)
    {
        if (is_under_way()) {
            keep_up(now);
        }
        if (is_leaving() or phase_ == phase::turnaround) {
            error_ = cancelled;
        } else if (is_under_way()) {
            settle(cancelled, now);
        }
    }
    void cancel(asker const& whose, microseconds now)
    {
        if (turns_.is_due(whose)) {
            cancel(now);
        }
    }
    void hold(std::uint8_t which, microseconds end) { debts_.hold(which, end); }
    bool is_held(std::uint8_t which) const { return debts_.covers(which); }

    bytes poll_transmit()
    {
        if (phase_ != phase::ready) {
            return {};
        }
        phase_ = phase::handed_out;
        counted.note(was_sent_ ? a_repetition : a_request, unit());
        was_sent_ = true;
        echo_at_ = 0;
        echo_ = echo::open;
        return request_;
    }

    void converse(conversation& who, microseconds now) { converse(who, now, own_retry_policy()); }
    void converse(conversation& who, microseconds now, retry_policy const& with)
    {
        deliver(who, now);
        ask(who, now, with);
    }
    /// The same as a conversation of another kind.
    void converse(conversation& who, microseconds now, retry_policy const& with, int prompt_unit)
    {
        std::swap(who.prompt_unit, prompt_unit);
        converse(who, now, with);
        std::swap(who.prompt_unit, prompt_unit);
    }
    retry_policy own_retry_policy() const { return {how_.response_timeout, how_.retries, 3, 50'000, 0}; }

    /// What a conversation is told when it comes by; none where it is told nothing.
    std::optional<fault> deliver(conversation& who, microseconds now) { return deliver(who, not who.settled(), now); }
    std::optional<fault> deliver(conversation& who, bool wants_turn, microseconds now)
    {
        if (not seen_ and phase_ == phase::waiting and now >= until_) { // 5
            settle(never_advanced, now);
        }
        if (turns_.is_lost(who.whose, phase_ == phase::idle)) {
            who.whose.is_due = false;
            who.accept(cancelled, {});
            come_by(who, wants_turn and not who.settled(), now);
            return cancelled;
        }
        if (phase_ == phase::settled and turns_.is_due(who.whose)) {
            phase_ = phase::idle;
            turns_.given(who.whose);
            fault const told = error_;
            who.accept(told, response_);
            if (who.settled() and line_.is_quiet) { // 24
                wake(now);
            }
            return told;
        }
        come_by(who, wants_turn, now);
        return std::nullopt;
    }

    enum class turn { not_its, asked_nothing, taken };
    turn ask(conversation& who, microseconds now, retry_policy const& with)
    {
        bool const is_last = turns_.is_last(who.whose);
        if (who.settled() and not is_last) {
            return turn::asked_nothing;
        }
        if (phase_ != phase::idle) {
            return turn::not_its;
        }
        bool const is_prompt = who.prompt_unit >= 0;
        if (not may_ask(who, is_prompt, now)) {
            return turn::not_its;
        }
        if (is_prompt and debts_.covers(static_cast<std::uint8_t>(who.prompt_unit))) {
            is_held_back_ = is_held_back_ or not is_last;
            return turn::asked_nothing;
        }
        auto const request = who.next();
        if (not request) {
            return turn::asked_nothing;
        }
        bytes const& frame = request->frame;
        if (not frame.empty() and debts_.covers(frame[0])) {
            is_held_back_ = is_held_back_ or not is_last;
            return turn::asked_nothing;
        }
        if (fault const found = refusal(frame); found != none) {
            who.accept(found, {});
            wake(now);
            return turn::asked_nothing;
        }
        start(*request, now, with);
        turns_.take(who.whose);
        return turn::taken;
    }

    std::optional<microseconds> poll_deadline() const
    {
        std::optional<microseconds> next = debts_.next();
        auto const add = [&](microseconds at) { next = next ? std::min(*next, at) : at; };
        if (line_.is_known) {
            if (not line_.is_quiet and phase_ != phase::awaiting) {
                add(line_.last + line_.times.silence);
            }
            if (line_.at != receiver::state::between and not awaits_rest()) {
                add(line_.last + line_.times.frame_end);
            }
        }
        if (phase_ != phase::idle and phase_ != phase::settled) {
            add(until_);
        }
        return next;
    }
    /// Whether the next pass has something to do at once (24).
    bool is_woken() const { return is_woken_ and (phase_ == phase::waiting or not is_under_way()); }

    /// 42: whether the request has left, and others wait, none of them for a held unit.
    bool is_visit_vain() const
    {
        bool const has_left = phase_ == phase::transmitting or phase_ == phase::awaiting or phase_ == phase::pausing or
                              phase_ == phase::turnaround;
        return has_left and turns_.others_wait and not is_held_back_;
    }

    /// When the request that is no more under way ended, or somebody was sent away since.
    microseconds ended_at() const { return is_under_way() ? 0 : ended_at_; }

    phase now_in() const { return phase_; }
    receiver const& line() const { return line_; }
    bytes const& request() const { return request_; }
    /// For who reads a schedule.
    std::string state() const
    {
        auto const number = [](char const* name, microseconds of) { return std::string{name} + std::to_string(of); };
        auto const held = debts_.next();
        return number(", phase ", static_cast<microseconds>(phase_)) + (line_.is_quiet ? " quiet" : " busy") +
               number(" line ", static_cast<microseconds>(line_.at)) + number(" until ", until_) +
               number(" held until ", held.value_or(-1)) + number(" error ", static_cast<microseconds>(error_)) +
               number(" unanswered ", sendings_.unanswered) + number(" from ", sendings_.first) +
               number(" to ", sendings_.begun) + number(" echo ", static_cast<microseconds>(echo_at_)) +
               (is_woken_ ? " woken" : "") + (turns_.others_wait ? " others" : "") + (is_held_back_ ? " back" : "");
    }
    bool is_asked_by(asker const& who) const { return turns_.is_due(who); }
    bool is_busy() const { return phase_ != phase::idle; }
    bool is_under_way() const { return phase_ != phase::idle and phase_ != phase::settled; }
    std::uint8_t unit() const { return request_.empty() ? 0 : request_[0]; }

    statistics counted;

private:
    /// When an `advance` finds times over: by the clock, or as of 35.8 minutes after the one before it. A time that began after a
    /// long pause, but before the `advance` that ends it, is over at the next one.
    microseconds judged(microseconds now) const
    {
        constexpr microseconds whole_turn = microseconds{1} << 32;
        constexpr microseconds may_go_back = 1 << 16;
        microseconds const pause = (now - seen_.value_or(now)) % whole_turn;
        return pause < whole_turn / 2 or pause >= whole_turn - may_go_back
                   ? now
                   : now - (pause - (whole_turn / 2 - may_go_back));
    }
    /// 21.
    bool is_asker_missing() const
    {
        return phase_ == phase::settled or (phase_ == phase::waiting and line_.is_quiet and not debts_.covers(unit()));
    }
    bool is_leaving() const { return phase_ == phase::handed_out or phase_ == phase::transmitting; }
    bool is_timed() const { return phase_ != phase::idle and phase_ != phase::settled and phase_ != phase::handed_out; }
    microseconds leaving_time() const { return limited_response() + line_.times.characters(request_.size()); }
    microseconds limited_response() const { return limited(with_.response_timeout); }
    microseconds response_time() const
    {
        response_size const size = longest_response(request_);
        return limited(limited_response() + line_.times.characters(size.bytes) +
                       (size.is_final ? 0 : line_.times.frame_end));
    }
    bool expects_echo() const { return how_.has_line_echo or echoes_seen_ == 2; }

    /// The longest response behind a request.
    std::size_t room_beside(bytes const& frame) const
    {
        return how_.longest - (std::max(how_.front, frame.size()) - how_.front);
    }

    /// 4.
    fault refusal(bytes const& frame) const
    {
        if (frame.size() < 4) {
            return frame_too_short;
        }
        if (frame.size() > 256) {
            return frame_too_long;
        }
        if (frame.size() > how_.longest + how_.front) {
            return buffer_too_small;
        }
        return longest_response(frame).bytes > room_beside(frame) ? buffer_too_small : none;
    }

    void start(request_frame const& of, microseconds now, retry_policy const& with)
    {
        is_woken_ = false;
        request_ = of.frame;
        with_ = with;
        retries_left_ = of.may_be_repeated and request_[0] != 0 ? with.retries : 0;
        busy_left_ = of.may_be_repeated and request_[0] != 0 ? with.busy_retries : 0;
        pauses_ = 0;
        pause_ = std::max(with.busy_pause, with.pause);
        was_sent_ = false;
        may_be_repeated_ = of.may_be_repeated;
        error_ = none;
        response_.clear();
        sendings_ = {};
        line_.room = room_beside(request_);
        wait(now);
        leave_if_free(now);
    }
    /// 2.
    void drop_unended() { line_.at = awaits_rest() ? receiver::state::between : line_.at; }
    void wait(microseconds now)
    {
        drop_unended();
        echo_ = echo::over;
        if (phase_ == phase::awaiting and with_.pause > 0) { // 11
            phase_ = phase::pausing;
            until_ = now + with_.pause;
            return;
        }
        phase_ = phase::waiting;
        until_ = now + limited_response() + line_.times.silence;
    }
    /// 21, where no outcome is told.
    void come_by(conversation& who, bool wants_turn, microseconds now)
    {
        if (turns_.is_due(who.whose)) {
            if (phase_ == phase::waiting) {
                turns_.renew(who.whose);
                leave_if_free(now);
            }
            return;
        }
        if (phase_ == phase::idle or not wants_turn) {
            return;
        }
        standing const place = turns_.visit(who.whose);
        if (not is_asker_missing()) {
            return;
        }
        bool drops = place == standing::is_last;
        if (place == standing::is_next) {
            drops = turns_.is_missed;
            turns_.is_missed = true;
        }
        if (drops) {
            if (phase_ == phase::waiting) {
                settle(cancelled, now);
            }
            phase_ = phase::idle;
        }
        wake(now);
    }

    /// 5.
    void leave_if_free(microseconds now)
    {
        if (line_.is_quiet and not debts_.covers(unit())) {
            phase_ = phase::ready;
            until_ = now + leaving_time();
        }
    }

    /// 22 and 23.
    bool may_ask(conversation& who, bool is_prompt, microseconds now)
    {
        if (not turns_.others_wait and (line_.is_quiet or not is_prompt)) {
            return true;
        }
        standing const place = turns_.visit(who.whose);
        bool const asks_in_vain = not seen_ and not is_prompt; // 5
        if (not line_.is_quiet and not asks_in_vain) {
            return false;
        }
        turns_.others_wait = place == standing::waits;
        if (place != standing::is_next and not asks_in_vain) {
            wake(now);
        }
        return place == standing::is_next;
    }
    void wake(microseconds now)
    {
        is_woken_ = true;
        ended_at_ = is_under_way() ? ended_at_ : now;
    }

    void hear(microseconds now)
    {
        line_.note_activity(now);
        if (phase_ != phase::ready) {
            return;
        }
        if (may_be_repeated_) { // 6
            wait(now);
        } else {
            settle(bus_jam, now);
        }
    }
    /// 14 to 16: how many bytes of a chunk are the echo's, or a difference of one.
    std::size_t take_echo(bytes const& chunk, microseconds now)
    {
        if (echo_ != echo::open) {
            return 0;
        }
        bool const expects = expects_echo();
        bool const may_answer = phase_ == phase::awaiting and not expects;
        std::size_t same = 0;
        while (same < chunk.size() and echo_at_ + same < request_.size() and chunk[same] == request_[echo_at_ + same]) {
            ++same;
        }
        std::size_t const before = echo_at_;
        echo_at_ += same;
        if (echo_at_ == request_.size()) {
            bool const is_in_frame = line_.at == receiver::state::inside and line_.frame.size() == before;
            bool const is_all_behind = is_in_frame or (line_.at != receiver::state::inside and before == 0);
            bool const is_mirrored = check_response(request_, request_) != line_echo;
            bool const may_be_it = may_answer and is_all_behind and (is_mirrored or request_.size() == 4);
            if (may_be_it and echoes_seen_ == 0) {
                echo_ = is_mirrored ? echo::over : echo::in_front;
                return 0;
            }
            echo_ = echo::whole;
            line_.at = may_answer ? receiver::state::between : line_.at;
            if (not may_be_it) {
                come_back(not is_mirrored, now);
            }
            return same;
        }
        if (same == chunk.size()) {
            return may_answer ? 0 : same;
        }
        bool const is_all_behind = line_.at == receiver::state::inside ? line_.frame.size() == before : before == 0;
        echo_ = phase_ == phase::awaiting and is_all_behind ? echo::over : echo::suspected;
        if (expects) {
            counted.note(a_collision, unit());
            error_ = error_ == none ? collision : error_;
            echoes_seen_ = std::min(echoes_seen_, 1U);
            return same + 1;
        }
        return may_answer ? 0 : same;
    }
    void come_back(bool is_sure, microseconds now)
    {
        bool const is_news = not how_.has_line_echo and echoes_seen_ == 0 and phase_ != phase::turnaround;
        echoes_seen_ = is_sure ? std::min(echoes_seen_ + 1, 2U) : echoes_seen_;
        if (not is_news) {
            return;
        }
        counted.note(a_mismatch, unit());
        error_ = line_echo;
        if (phase_ == phase::awaiting) {
            settle(line_echo, now);
        }
    }
    /// Whether the byte belongs to something.
    bool take(std::uint8_t byte, microseconds now)
    {
        if (phase_ != phase::awaiting) {
            return false;
        }
        if (line_.at == receiver::state::between and skips_left_ > 0 and byte != unit()) {
            --skips_left_;
            counted.note(a_noise, unit());
            echo_ = echo_ == echo::over ? echo::suspected : echo_;
            return true;
        }
        if (line_.take(byte, false) and echo_ != echo::open) {
            line_.at = receiver::state::between;
            judge(false, now);
        }
        return true;
    }

    bool awaits_rest() const { return phase_ == phase::awaiting and line_.lacks_rest(); }
    void end_by_silence(std::size_t count, microseconds now)
    {
        if (line_.at == receiver::state::between or awaits_rest() or not line_.is_gap(count, now)) {
            return;
        }
        bool const was_inside = line_.at == receiver::state::inside;
        line_.at = receiver::state::between;
        if (was_inside and phase_ == phase::awaiting) {
            judge(true, now);
        }
    }

    /// 3, 9 and 25.
    void judge(bool is_by_silence, microseconds now)
    {
        if (error_ == collision) {
            return;
        }
        if (echo_ == echo::open and not expects_echo()) {
            echo_ = echo::over;
        }
        bytes const& frame = line_.frame;
        bool const has_size = matches_size_hint(frame);
        fault found = line_.verdict();
        if (found == none) {
            found = check_response(request_, frame);
            if (found == none and is_by_silence and not has_size) {
                found = wrong_length;
            }
        }
        counted.note_frame(found, unit(), now - sent_at_);
        if (found != none and found >= 0x80 and echo_ == echo::over) {
            echo_ = echo::suspected;
        }
        if (found == none or found < 0x80) {
            echoes_seen_ = echo_ == echo::over ? 0 : echoes_seen_;
            take_response(found, now);
        } else {
            bool const is_damaged = (found == crc_mismatch or found == uart_error) and frame.size() >= 4 and
                                    frame[0] == request_[0] and (frame[1] & 0x7F) == request_[1] and has_size;
            if (is_damaged and debts_.is_empty()) { // 17
                sendings_.answered();
            }
            if (found == wrong_unit or found == wrong_function or found == response_mismatch or
                found == malformed) { // 19
                debts_.come_late(frame[0], now, how_.late_response);
            }
            refuse(found, is_damaged, now);
        }
    }
    void refuse(fault found, bool is_damaged, microseconds now)
    {
        if (found == line_echo or echo_ == echo::in_front) { // 16
            echoes_seen_ = std::min(echoes_seen_ + 1, 2U);
            settle(line_echo, now);
        } else if (is_damaged) {
            fail(found, now);
        } else if (found != wrong_unit and found != frame_too_short) {
            error_ = found;
        }
    }
    void take_response(fault found, microseconds now)
    {
        sendings_.answered();
        bool const asks = found == 6 or (found == 5 and request_[1] >= 1 and request_[1] <= 4);
        if (asks and busy_left_ > 0) {
            --busy_left_;
            phase_ = phase::pausing;
            until_ = now + pause_;
            if (pauses_ < 6 and 2 * pause_ < longest) {
                pause_ *= 2;
            }
            ++pauses_;
            error_ = none;
            return;
        }
        if (found == none) {
            response_.assign(line_.frame.begin() + 1, line_.frame.end() - 2);
        }
        if (sendings_.unanswered > 0) { // 18
            debts_.hold(unit(),
                        now + limited(with_.pause + static_cast<microseconds>(sendings_.unanswered) *
                                                        limited(sendings_.taken(now) + how_.late_response)),
                        sendings_);
            sendings_ = {};
        }
        settle(found, now);
    }
    void note_sending(microseconds at) { sendings_.left(at, leaving_time(), response_time() + how_.late_response); }

    void time_out(microseconds now)
    {
        if (phase_ == phase::waiting) {
            settle(bus_jam, now);
        } else if (phase_ == phase::ready) {
            settle(transmit_stalled, now);
        } else if (phase_ == phase::transmitting) {
            stall(now);
        } else if (phase_ == phase::awaiting) {
            if (echo_ == echo::in_front) {
                counted.note(a_mismatch, unit());
                echoes_seen_ = std::min(echoes_seen_ + 1, 2U);
                return settle(line_echo, now);
            }
            fault why = error_;
            if (why == none) {
                why = line_.is_at_rest(now) ? timed_out : bus_jam;
                counted.note(why == timed_out ? a_timeout : a_jam, unit());
            }
            fail(why, now);
        } else if (phase_ == phase::pausing) {
            wait(now);
        } else {
            settle(error_, now);
        }
    }
    /// 7.
    void stall(microseconds now)
    {
        if (unit() == 0) {
            phase_ = phase::turnaround;
            until_ = now + how_.turnaround;
            error_ = transmit_stalled;
            return;
        }
        note_sending(now);
        settle(transmit_stalled, now);
    }
    /// 11.
    void fail(fault why, microseconds now)
    {
        if (retries_left_ == 0) {
            settle(why, now);
            return;
        }
        --retries_left_;
        error_ = none;
        wait(now);
    }
    void settle(fault why, microseconds now)
    {
        drop_unended();
        echo_ = echo::over;
        ended_at_ = now;
        if (sendings_.unanswered > 0 and unit() != 0) {
            debts_.hold(unit(), std::max(now, std::min(sendings_.begun, now + sendings_.allowed)), sendings_);
        } else if (with_.pause > 0 and unit() != 0) {
            debts_.hold(unit(), now + with_.pause);
        }
        sendings_ = {};
        error_ = why;
        if (why != none) {
            response_.clear();
        }
        phase_ = phase::settled;
    }

    void note_strays(std::size_t count, bool is_start, std::uint8_t first, bool is_held)
    {
        if (count == 0) {
            return;
        }
        if (is_start) {
            is_late_ = first <= 247 and is_held;
            if (is_late_) {
                counted.note(a_late, first);
            }
        }
        for (std::size_t i = 0; i < count and not is_late_; ++i) {
            counted.note_line(a_noise);
        }
    }

    receiver line_;
    std::optional<microseconds> seen_{}; ///< the latest `advance`
    options how_;
    debts debts_;
    turns turns_{};
    phase phase_{phase::idle};
    microseconds until_{0};
    bytes request_{};
    bytes response_{};
    fault error_{none};
    retry_policy with_{};
    unsigned retries_left_{0};
    unsigned busy_left_{0};
    unsigned pauses_{0};
    microseconds pause_{0}; ///< the next one
    bool may_be_repeated_{true};
    bool was_sent_{false};
    sendings sendings_{};
    microseconds sent_at_{0};
    microseconds ended_at_{0};
    enum class echo { over, open, in_front, suspected, whole } echo_{echo::over};
    std::size_t echo_at_{0};
    unsigned echoes_seen_{0}; ///< 2: two or more
    unsigned skips_left_{0};
    bool is_woken_{false};
    bool is_held_back_{false};
    bool is_late_{false};
};

} // namespace model
