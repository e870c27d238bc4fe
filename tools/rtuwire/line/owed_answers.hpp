// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Which answers the units of a line still owe. Modbus RTU numbers no request: an answer later than all times looks like the
// answer to the next question of the same function, as an exception does whatever was asked. A unit answers in the order in
// which it was asked: once it has answered a later request, it owes none of those before. So where it owes answers to a
// function, a request by another function is put in front of the next question, a mark. Where a unit says what nobody asked
// behind an answer that was taken for lost, its order is not relied on any more: there may be a converter that answers as it
// can. It owes each answer until that comes, or for twice as long as its latest took, and is asked nothing for as long first. An hour
// without such an answer, and it is in order again.
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <rtuwire/client.hpp>
#include <rtuwire/trace.hpp>

#include "words/option_words.hpp"

namespace tool {

/// So long after the time-out an answer may come yet: until then a unit is asked nothing for which that could be taken.
inline constexpr std::chrono::milliseconds longest_lateness{1500};

/// Something was heard, and nobody's response: an echo, noise, another bit rate.
[[nodiscard]] constexpr bool is_damage(rtuwire::errc why)
{
    using enum rtuwire::errc;
    return why == line_echo or why == collision or why == crc_mismatch or why == uart_error or why == frame_too_short or
           why == frame_too_long;
}

class owed_answers {
public:
    using clock = std::chrono::steady_clock;
    using frame_bytes = std::vector<std::byte>;

    /// How often a request is sent, and for how long an answer is owed: ten times as long as the client waits, 5 s at least,
    /// from the sending on, or from the last thing that was heard behind it. Where answers have numbers, only the last
    /// sending is.
    void begin(rtuwire::client_options const& options, bool has_numbers);

    /// A frame has passed.
    void note(rtuwire::traced_frame const& frame);
    /// These bytes came while nobody waited: an answer, a part of one, or several.
    void note_unawaited(rtuwire::byte_view bytes);

    /// Whether what answers this request may be the answer to another one. Never for what writes: its answer repeats what was
    /// written, and a word that stops a motor waits for nothing.
    [[nodiscard]] bool hides(rtuwire::byte_view question);

    /// The functions by which an answer of this unit may come yet, and until when, whatever it answered by others since: not all
    /// units are in order. That is until 1.5 s behind the time-out, or 0.5 s later than its latest.
    [[nodiscard]] std::map<std::byte, clock::time_point> functions_owed(std::byte unit) const;

    /// Until then a unit that answered out of order is asked nothing: it may owe anything.
    [[nodiscard]] clock::time_point rests_until(std::byte unit) const;
    /// Whether an answer of this unit came later than anybody waited for it, the last time that one did not come in time.
    [[nodiscard]] bool is_late(std::byte unit) const;

    /// A request that only reads, by another function where there is one that the unit may answer; by the same one for
    /// another number of registers.
    [[nodiscard]] frame_bytes mark_for(rtuwire::byte_view question);
    void note_unanswered(rtuwire::byte_view mark);

    /// How many marks are tried for a question, as a rule.
    [[nodiscard]] unsigned tries() const { return tries_; }

    /// Whether the last response was to a sending of this request, and to no other one before.
    [[nodiscard]] bool has_answered(rtuwire::byte_view request) const;

    /// Whether an answer that was owed has come since the last request left.
    [[nodiscard]] bool has_heard_late() const { return was_late_; }

    /// The last question was not asked, or is asked.
    void note_question(rtuwire::byte_view question, bool is_asked);
    /// What there is to say of the last question where it has no response; empty where the unit owed nothing.
    [[nodiscard]] std::string words_of_silence(option_form form) const;

private:
    static constexpr std::chrono::hours trusted_again{1};
    static constexpr std::chrono::milliseconds longest_gap{100}; ///< between parts of an answer

    struct sending {
        frame_bytes frame;
        clock::time_point at;
    };
    struct unit_record {
        std::vector<sending> owed{};
        std::vector<sending> passed_over{}; ///< what it owed before it answered a later one
        bool is_out_of_order{false};        ///< as far as anybody can tell, for `trusted_again` from `unasked_at` on
        clock::time_point unasked_at{};     ///< it said last what nobody had asked
        clock::time_point rests_until{};    ///< until then whatever it owes has come: nobody knows how much that is
        clock::time_point heard{};
        std::map<std::byte, unsigned> unanswered{}; ///< marks by function, since the unit last answered by that
        std::set<std::byte> answered{};             ///< functions, also by an exception
        std::map<std::byte, frame_bytes> longest{}; ///< by function, the answered request for the most registers
        std::chrono::duration<double> latest{0}; ///< how far behind its request an answer came that nobody waited for
        clock::duration latest_of_all{};         ///< the longest of these, since it was in order
    };

    void note_heard(clock::time_point now);
    void note_heard_bytes(rtuwire::traced_frame const& heard, clock::time_point now);
    std::size_t note_answers_in(rtuwire::byte_view heard, clock::time_point now);
    void note_response(rtuwire::byte_view bytes, rtuwire::frame_verdict verdict, clock::time_point now);
    void note_late(unit_record& of, clock::time_point asked, clock::time_point now) const;
    void note_unasked(unit_record& of, rtuwire::byte_view frame, clock::time_point now) const;
    /// How long behind its request an answer is waited for, where something else is to be asked.
    clock::duration may_come_for(unit_record const& of) const;
    /// How long a unit that answers out of order may owe an answer.
    clock::duration longest_of(unit_record const& of) const;
    void forget_old(unit_record& of, clock::time_point now) const;
    static bool owes_registers(unit_record const& of, std::byte function, unsigned count);
    static frame_bytes part_of_known(unit_record const& of, std::byte function);
    static frame_bytes longer_read(unit_record const& of, rtuwire::byte_view question);
    static bool is_ambiguous(unit_record const& of, std::byte function, std::byte asked);

    std::map<std::byte, unit_record> units_{};
    std::chrono::microseconds timeout_{};
    clock::duration longest_{}; ///< that an answer is owed
    unsigned tries_{1};
    bool has_numbers_{false};
    std::uint16_t nonce_{0};
    frame_bytes unawaited_{}; ///< which may be the begin of an answer
    clock::time_point unawaited_at_{};
    frame_bytes answered_{}; ///< the request to which the last response was
    std::byte asked_unit_{};
    bool was_asked_{true}; ///< the last question
    bool was_late_{false};
};

/// A conversation of which no question is asked before its unit is known to owe no answer that could be taken for this
/// one's. Where that is not to be known, the question ends as one without a response.
template <typename Conversation> class in_step : public Conversation {
    static_assert(
        not requires(Conversation & commander) { commander.intent(); }, "what commands a motor waits for nothing");

public:
    in_step(owed_answers& owed, Conversation its) : in_step{owed, std::move(its), owed.tries()} {}
    /// So many marks are tried for a question.
    in_step(owed_answers& owed, Conversation its, unsigned tries)
        : Conversation{std::move(its)}, owed_{owed}, tries_{tries}
    {}

    std::optional<rtuwire::request_frame> next()
    {
        auto const asked = Conversation::next();
        if (not asked) {
            return asked;
        }
        question_.assign(asked->frame().begin(), asked->frame().end());
        bool const is_hidden = owed_.hides(question_);
        owed_.note_question(question_, not is_hidden);
        if (not is_hidden) {
            mark_.clear();
            return asked;
        }
        mark_ = owed_.mark_for(question_);
        return rtuwire::request_frame{mark_, rtuwire::repetition::never};
    }

    void accept(rtuwire::result<rtuwire::response> const& outcome)
    {
        using rtuwire::errc;
        if (mark_.empty()) {
            tried_ = 0;
            errc const why = outcome.error();
            bool const is_response = why == errc::none or rtuwire::is_exception(why);
            bool const is_mismatch =
                why == errc::wrong_function or why == errc::wrong_length or why == errc::response_mismatch;
            bool const is_anothers =
                (is_response and not owed_.has_answered(question_)) or (is_mismatch and owed_.has_heard_late());
            return Conversation::accept(is_anothers ? rtuwire::result<rtuwire::response>{errc::timed_out} : outcome);
        }
        bool const is_over = outcome.error() == errc::cancelled or
                             rtuwire::category_of(outcome.error()) == rtuwire::error_category::serial_device;
        if (is_over) {
            tried_ = 0;
            return Conversation::accept(outcome.error());
        }
        if (outcome.error() == errc::timed_out) {
            owed_.note_unanswered(mark_);
        }
        heard_ = is_damage(outcome.error()) ? outcome.error() : heard_;
        if (++tried_ >= tries_ and owed_.hides(question_)) {
            tried_ = 0;
            Conversation::accept(std::exchange(heard_, errc::timed_out));
        }
    }

private:
    owed_answers& owed_;
    unsigned tries_;
    owed_answers::frame_bytes question_{};
    owed_answers::frame_bytes mark_{}; ///< what is asked in its place; empty where nothing is
    unsigned tried_{0};
    rtuwire::errc heard_{
        rtuwire::errc::timed_out}; ///< what came in the place of a mark's answer says why there is none
};

} // namespace tool
