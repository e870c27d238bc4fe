// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Whether what a client sends, and what it says of the responses, is right. Knows frames and times only;
// of the library it knows the outcome's error and bytes.
#pragma once

#include <array>
#include <vector>

#include <rtuwire/ask/conversation.hpp>

#include "records.hpp"

namespace rtuwire::simulation {

using namespace detail;

/// A response on its way to the client.
struct arrival {
    frame content{};
    frame_origin origin{};
    unsigned heard{0};
    bool is_whole{false};
    bool is_clean{false};   ///< nothing came between the request and it
    bool is_in_time{false}; ///< the client cannot have stopped waiting for it
    moment first_at{0};     ///< when its first character was handed to the client
    moment last_at{0};
};

class judge {
public:
    judge(setting const& how, line_times const& times, records& all) : how_{how}, times_{times}, all_{all} {}

    std::uint32_t current() const { return current_; }
    bool is_current(std::uint32_t inquiry) const { return inquiry == current_; }

    // --- requests ---------------------------------------------------------------------------------

    /// A conversation gave its request to the client.
    void given(std::uint32_t number, moment now)
    {
        current_ = number;
        inquiry& of = all_.inquiries[number];
        ++of.round;
        of.sent = of.pauses = 0;
        of.was_away = of.was_cancelled = of.is_unsure = false;
        of.given = now;
        told_at_ = never;
        forget_responses();
        is_under_way_ = true;
    }

    /// The client hands out a frame. The number of its transmission; 0 where it is not the request
    /// under way.
    std::uint32_t sends(bytes_view bytes, moment now)
    {
        check_line(now);
        inquiry& of = all_.inquiries[current_];
        if (of.id != current_ or not same(of.request.view(), bytes)) {
            all_.events.note(now, "client sends", 0, bytes);
            all_.accuse(fault::alien_bytes, now);
            return 0;
        }
        if (of.sent > 0) {
            check_repetition(of, now);
        }
        ++of.sent;
        if (of.sent > most_transmissions(of) + most_unsure(of)) {
            all_.accuse(fault::too_many, now);
        }
        ++last_;
        all_.transmissions.add(last_) = {last_, of.id, of.round, now, 0};
        told_at_ = never;
        forget_responses();
        is_under_way_ = true;
        return last_;
    }

    /// It leaves until then.
    void leaves(moment end)
    {
        all_.transmissions[last_].end = own_end_ = end;
        was_broadcast_ = all_.inquiries[current_].is_broadcast();
    }

    /// The client is told that it has left.
    void told(moment now)
    {
        told_at_ = now;
        bytes_since_told_ = 0;
        forget_responses();
    }

    // --- responses --------------------------------------------------------------------------------

    /// A character of the line's echo was handed to the client.
    void hears_echo(moment now) { last_heard_ = now; }

    /// The echo is not what was sent: what the client makes of a response then is its own affair.
    void echo_is_spoiled() { all_.inquiries[current_].is_unsure = true; }

    /// A character of somebody else's was.
    void hears(arrival& of, bool is_first, bool is_last, moment now)
    {
        last_heard_ = now;
        if (is_first) {
            of.first_at = now;
            of.is_clean = told_at_ != never and bytes_since_told_ == 0;
        }
        ++bytes_since_told_;
        // A response that only silence ends, and more within that silence: nobody can part them.
        if (due_ != 0 and all_.inquiries[current_].request[1] == 8) {
            due_ = 0;
        }
        if (is_last) {
            of.last_at = now;
            has_arrived(of, now);
        }
    }

    // --- outcomes ---------------------------------------------------------------------------------

    /// A conversation accepts an outcome; whether it is its own.
    bool accepts(std::uint32_t number, bool was_given, result<response> const& outcome, moment now)
    {
        all_.events.note(now, outcome.has_value() ? "accepts a value" : "accepts an error",
                         static_cast<unsigned>(outcome.error()));
        inquiry& of = all_.inquiries[number];
        if (outcome.error() == errc::cancelled and of.id == number and number != current_) {
            all_.events.note(now, "is told that it was dropped", number);
            return false;
        }
        if (not was_given or number != current_ or of.id != number) {
            all_.events.note(now, "its request", number);
            all_.accuse(fault::unasked, now);
            return false;
        }
        bool const has_response = outcome.has_value() or is_exception(outcome.error());
        if (of.is_broadcast()) {
            if (outcome.has_value() and of.sent != 1) {
                all_.accuse(fault::too_few, now);
            }
        } else if (has_response) {
            judge_response(of, outcome, now);
        } else {
            judge_failure(of, outcome.error(), now);
        }
        forget_responses();
        is_under_way_ = false;
        return true;
    }

    /// Nobody waits for the request under way any more.
    void given_up()
    {
        all_.inquiries[current_].was_away = true;
        due_ = 0;
        is_under_way_ = false;
    }
    void cancelled()
    {
        all_.inquiries[current_].was_cancelled = true;
        due_ = 0;
    }

    moment longest_response(inquiry const& of) const
    {
        return how_.response_timeout() + times_.characters(response_size(of.request));
    }

private:
    void forget_responses()
    {
        candidates_.clear();
        due_ = 0;
    }

    void check_line(moment now)
    {
        moment const rest = how_.lets_line_rest() ? times_.t3_5 : 0;
        if (now < own_end_) {
            all_.accuse(fault::overlap, now);
        } else if (own_end_ > 0 and now < own_end_ + rest) {
            all_.accuse(fault::short_silence, now);
        }
        if (last_heard_ > 0 and now < last_heard_ + rest) {
            all_.accuse(fault::short_silence, now);
        }
        if (was_broadcast_ and now < own_end_ + how_.options.turnaround.microseconds) {
            all_.accuse(fault::short_turnaround, now);
        }
    }

    /// A late response of function 06 that comes while its request is sent again is an echo, as far as the client can know.
    void note_look_alike(arrival const& of)
    {
        inquiry& asked = all_.inquiries[current_];
        asked.is_unsure = asked.is_unsure or (is_under_way_ and same(asked.request.view(), of.content.view()));
    }

    unsigned most_transmissions(inquiry const& of) const
    {
        bool const is_once = not of.may_repeat or of.is_first_try_only or of.is_broadcast();
        return 1U + (is_once ? 0U : how_.options.retries) + of.pauses;
    }
    /// Where several responses came in one lump, the client may have taken another one as "busy".
    unsigned most_unsure(inquiry const& of) const
    {
        return of.is_unsure ? retry_policy{}.busy_retries - of.pauses : 0U;
    }

    /// A request goes out again: whether the time was right.
    void check_repetition(inquiry& of, moment now)
    {
        bool const was_busy = take_busy(of, now);
        if (due_ != 0) {
            all_.accuse(fault::refused, now);
        }
        if (not was_busy and not of.is_unsure) {
            check_waited(of, true, now);
        }
    }

    /// Whether the last transmission was answered by "busy"; holds the pause against its time.
    bool take_busy(inquiry& of, moment now)
    {
        if (candidates_.empty()) {
            return false;
        }
        arrival const& first = candidates_.front();
        bool const is_busy = first.content[1] != of.request[1] and
                             (first.content[2] == 6 or (first.content[2] == 5 and of.request[1] <= 4));
        of.is_unsure = of.is_unsure or not first.is_in_time or not first.is_clean;
        if (not is_busy or not of.may_repeat or of.pauses >= retry_policy{}.busy_retries) {
            return false;
        }
        moment const pause = moment{retry_policy{}.busy_pause.microseconds} << of.pauses;
        ++of.pauses;
        due_ = 0;
        if (not of.is_unsure and now < first.last_at + pause) {
            all_.accuse(fault::short_pause, now);
        }
        return true;
    }

    /// Whether a request without any response was given its time, and not much more.
    void check_waited(inquiry const& of, bool is_repetition, moment now)
    {
        if (told_at_ == never or bytes_since_told_ != 0 or of.is_broadcast()) {
            return;
        }
        if (now < told_at_ + longest_response(of)) {
            all_.accuse(fault::early_timeout, now);
        }
        // What only silence ends is waited for until that silence, too.
        moment const silence = of.request[1] != 8 ? 0U : how_.is_host ? 50'000U : times_.t3_5;
        moment const slack = 5'000 + 2 * how_.pass_late_most + times_.t3_5 + silence;
        if (is_repetition and not of.was_away and now > told_at_ + longest_response(of) + slack) {
            all_.accuse(fault::late_timeout, now);
        }
    }

    /// The last character of a response was handed to the client.
    void has_arrived(arrival& of, moment now)
    {
        of.is_whole = of.is_whole and of.heard == of.content.size();
        all_.events.note(now, of.is_whole ? "client hears" : "client hears it spoiled", of.origin.transmission,
                         of.content.view());
        if (told_at_ == never or of.first_at < told_at_) {
            note_look_alike(of);
            return;
        }
        if (not of.is_whole) {
            ++all_.counts().spoiled;
            return;
        }
        inquiry const& asked = all_.inquiries[current_];
        if (not could_response(asked.request, of.content)) {
            return;
        }
        if (std::uint32_t& follows = beyond_up_to(asked); of.origin.chain <= follows) {
            follows = last_; // whatever the client makes of it
        }
        of.is_in_time = now < told_at_ + longest_response(asked);
        candidates_.push_back(of);
        if (of.is_clean and of.is_in_time and of.origin.transmission == last_ and is_under_way_ and
            not asked.is_unsure) {
            due_ = last_;
        }
    }

    static bool is_content(arrival const& of, result<response> const& outcome)
    {
        return outcome.has_value() ? same(outcome->pdu(), of.content.view().subspan(1, of.content.size() - 3))
                                   : static_cast<unsigned>(outcome.error()) == of.content[2];
    }

    bool is_to(arrival const& of, inquiry const& asked)
    {
        transmission const& answered = all_.transmissions[of.origin.transmission];
        return answered.number == of.origin.transmission and answered.inquiry == asked.id and
               answered.round == asked.round;
    }

    std::uint32_t& beyond_up_to(inquiry const& of) { return beyond_up_to_[of.request[0] % beyond_up_to_.size()]; }

    inquiry const& answered_by(arrival const& of)
    {
        return all_.inquiries[all_.transmissions[of.origin.transmission].inquiry];
    }

    /// The response that was taken. A loop that comes late sees the outcome after more has arrived:
    /// where the same bytes came twice, it was the right one then.
    arrival const* taken(inquiry const& of, result<response> const& outcome)
    {
        arrival const* found = nullptr;
        for (arrival const& each : candidates_) {
            bool const is_right_already = how_.pass_late_most > 0 and found != nullptr and is_to(*found, of);
            if (is_content(each, outcome) and not is_right_already) {
                found = &each;
            }
        }
        return found;
    }

    void judge_response(inquiry& of, result<response> const& outcome, moment now)
    {
        if (candidates_.empty()) {
            ++all_.counts().by_chance;
            all_.events.note(now, "nobody sent that", of.id);
            return;
        }
        arrival const* const got = taken(of, outcome);
        if (got == nullptr) {
            all_.accuse(fault::invented, now);
            return;
        }
        if (is_to(*got, of)) {
            all_.counts().late_accepted += got->origin.transmission != last_ ? 1U : 0U;
            return;
        }
        // Whatever took longer than this, no rule of time can tell from a response to the next request;
        // and once one passed, the queue that its unit has then comes one request late.
        std::uint32_t& follows = beyond_up_to(of);
        moment const took = got->last_at - got->origin.could_begin;
        bool const is_beyond = got->origin.is_late_chain or got->origin.chain <= follows or
                               took > longest_response(answered_by(*got)) + how_.late_response();
        all_.events.note(now, is_beyond ? "beyond the rule: took the response to" : "took the response to",
                         got->origin.transmission);
        if (is_beyond and not how_.has_constant_latency) {
            ++all_.counts().beyond_rule;
            follows = last_;
        } else {
            all_.accuse(fault::foreign_response, now);
        }
    }

    void judge_failure(inquiry& of, errc error, moment now)
    {
        if (error == errc::cancelled or of.was_cancelled or of.was_away) {
            return;
        }
        take_busy(of, now);
        if (due_ != 0) {
            all_.accuse(fault::refused, now);
        }
        if (of.is_unsure) {
            return;
        }
        if (error == errc::timed_out) {
            check_waited(of, false, now);
        }
        bool const is_exhausted = error == errc::timed_out or error == errc::crc_mismatch;
        if (is_exhausted and of.is_health_known and of.sent != most_transmissions(of)) {
            all_.accuse(of.sent < most_transmissions(of) ? fault::too_few : fault::too_many, now);
        }
    }

    setting const& how_;
    line_times const& times_;
    records& all_;
    std::vector<arrival> candidates_{};           ///< what could be the response, since the client was told
    std::array<std::uint32_t, 8> beyond_up_to_{}; ///< by unit: transmissions up to this
    std::uint32_t current_{0};                    ///< the request under way
    std::uint32_t last_{0};                       ///< the last transmission
    std::uint32_t due_{0};                        ///< the transmission whose response has to be accepted
    moment told_at_{never};                       ///< when the client was told that its request has left
    moment own_end_{0};
    moment last_heard_{0};
    unsigned bytes_since_told_{0};
    bool was_broadcast_{false};
    bool is_under_way_{false};
};

} // namespace rtuwire::simulation
