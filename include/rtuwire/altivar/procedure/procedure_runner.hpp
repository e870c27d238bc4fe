// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// Runs a procedure as a conversation with one unit: single reads and writes, pauses, and a time limit. One runner for all:
// a further procedure costs a program its own steps, and nothing of this.
// Internal: may change with any version.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>

#include <rtuwire/altivar/procedure/procedure.hpp>
#include <rtuwire/ask/conversation.hpp>
#include <rtuwire/core/time.hpp>
#include <rtuwire/core/version.hpp>
#include <rtuwire/wire/function.hpp>
#include <rtuwire/wire/registers.hpp>

namespace rtuwire {
inline namespace RTUWIRE_BUILD {
namespace altivar {

class procedure_conversation;

/// What a stop has besides: whether it reads what its words mean before it begins, where that was or was not known before;
/// whether its word keeps the power of a motor; its end where it asks for more after its limit.
struct stop_kind {
    bool (*looks_first)(procedure const&, bool was_known) noexcept;
    bool (*keeps_power)(procedure const&) noexcept;
    action (*give_up)(procedure&) noexcept;
};

/// In what a procedure differs from others, for the runner of all: `procedure` says what each of these is. A program without
/// a stop has none of the code of one.
struct procedure_kind {
    procedure& (*procedure_of)(procedure_conversation&) noexcept;
    action (*step)(procedure&, event) noexcept;
    duration (*drive_timeout)(procedure const&) noexcept;
    stop_kind const* stop; ///< null: it is none
    duration grace;
    bool is_order;
    bool follows_order;
    bool gives_way_to_order;
};

/// The conversation of any procedure, which `procedure_runner` holds behind it. It ends at its limit, counted from the first
/// `advance`; or later by the procedure's grace, or at the end of the one request that is then under way or still has to be
/// sent to leave the drive safe. A stop does not end before its control word has left.
class procedure_conversation : public detail::commander {
public:
    /// For clients: all procedures are visited alike.
    using visited_as = procedure_conversation;

    /// Each action says whether its request may be repeated.
    static constexpr conversation_properties properties{.urgency = detail::urgency::stop_of_unit,
                                                        .freshness = freshness::when_free};
    static constexpr function_set asks{function_code::read_holding_registers, function_code::write_single_register};
    /// A read of two registers at most.
    static constexpr frame_sizes longest_frames{.request = 8, .response = 9};

    static constexpr bool keeps_meaning = true;

    /// Processes the time: starts the clock, ends pauses, and ends the conversation at its limit.
    constexpr void advance(instant now) noexcept
    {
        instant const at = stage_ == stage::made ? now : detail::within_reach(now_, now);
        now_ = now;
        tell_known();
        if (stage_ == stage::made) {
            stage_ = stage::waiting;
            late_at_ = now + limit_;
            if (is_stop()) {
                note_stop();
            } else if (kind_->is_order) {
                note_order_to_run();
            } else {
                note_order();
            }
            begin();
        }
        detail::keep_over(late_at_, now, at);
        if (stage_ != stage::waiting) {
            return;
        }
        if (is_looking()) {
            bool const is_over = (look_.is_limited() and reached(at, pause_end_)) or
                                 (left_ < time_left::none and reached(now, late_at_));
            return is_over ? end_look(0) : void();
        }
        bool const is_overtaken = kind_->follows_order and is_overruled() and not own().takes_back();
        bool const gives_way = kind_->gives_way_to_order and does_stop(action_) and is_unit_ordered();
        if (is_overtaken or gives_way) {
            return yield();
        }
        if (has_to_look()) {
            return begin_look();
        }
        if (has_limit() and reached(now, late_at_)) {
            bool const is_last = left_ == time_left::grace or kind_->grace.microseconds == 0;
            left_ = is_last ? time_left::none : time_left::grace;
            late_at_ = now + kind_->grace;
            if (is_last or not own().takes_back()) { // else it uses its grace for that
                step(event::kind::late);
            }
        } else if (has_length() and reached(at, pause_end_)) {
            what_of(action_) == action_kind::pause ? step(event::kind::pause_over) : fail(errc::bus_jam);
        }
    }

    using commander::unit;

    /// For the client: what the next request does to the motor, and when a unit counts as lost.
    [[nodiscard]] constexpr detail::effect intent() const noexcept
    {
        return is_looking() ? detail::effect::none : effect_now(effect_of(action_));
    }
    [[nodiscard]] constexpr duration drive_timeout() const noexcept { return kind_->drive_timeout(own()); }
    [[nodiscard]] static constexpr std::uint8_t tolerated_misses() noexcept { return 1; }

    constexpr void note_loss() noexcept
    {
        has_lost_ = stage_ == stage::waiting or stage_ == stage::asking;
        heed_loss();
    }

    constexpr std::optional<request_frame> next() noexcept
    {
        if (settled()) {
            return std::nullopt; // whatever befell its unit since
        }
        if (not is_looking() and has_to_look()) {
            begin_look(); // it was heard of only now that what was read counts no more
            return std::nullopt;
        }
        if (is_stop() and was_stopped()) {
            heed_stop();
            if (kind_->stop->keeps_power(own())) {
                fail(errc::overruled);
            }
        }
        if (not has_request()) {
            return std::nullopt;
        }
        stage_ = stage::asking;
        note_command(is_command_to_run());
        if (is_looking()) {
            return request_frame{frame_, repetition::never};
        }
        if (does_stop(action_)) {
            if (own().is_harmful(word_of(action_), look_.allows_word(is_known()))) {
                action_ = to_stop(address_of(action_), 0);
                make_frame();
            }
            if (word_of(action_) != 0) {
                action_ = once(action_); // behind a missing response it may have another meaning
            }
        }
        return request_frame{frame_, repetition_of(action_)};
    }

    /// For the client: how long the response may take. A look of a stop ends when its time is over.
    [[nodiscard]] constexpr duration limited(duration timeout) const noexcept
    {
        duration const rest = pause_end_ - now_;
        return look_.is_limited() ? detail::shorter_of(rest, timeout) : timeout;
    }

    /// For the client: whether it stops its unit by the user's order; and whether such a stop has just found that the unit is
    /// of another family.
    [[nodiscard]] constexpr bool is_stop() const noexcept { return kind_->stop != nullptr; }
    constexpr bool take_other_family() noexcept { return std::exchange(is_other_family_, false); }

    /// Whether there is a request to send.
    [[nodiscard]] constexpr bool has_request() const noexcept
    {
        return is_looking() or what_of(action_) == action_kind::read or what_of(action_) == action_kind::write;
    }

    constexpr void accept(result<response> const& outcome) noexcept
    {
        if (stage_ == stage::made or stage_ == stage::ended) {
            return;
        }
        stage_ = stage::waiting;
        if (is_looking()) {
            end_look(meaning_in(outcome, own().control_word()));
            return heed_loss();
        }
        if (does_stop(action_) and outcome.error() != errc::cancelled) {
            look_.note_word(); // else it never left
        }
        go_on(event_of(outcome));
        if (kind_->follows_order and settled() and is_done()) {
            heed_end_of_order();
        }
        heed_loss();
    }

    /// When `advance` has something to do; nothing while a request is under way.
    [[nodiscard]] constexpr deadline poll_deadline() const noexcept
    {
        if (stage_ != stage::waiting) {
            return {};
        }
        detail::earliest next;
        if (left_ < time_left::none and
            not(has_to_say() and reached(now_, late_at_))) { // else it waits for more than that
            next.add(late_at_);
        }
        if (has_length()) {
            next.add(pause_end_);
        }
        return next;
    }

    /// Whether the procedure has ended.
    [[nodiscard]] constexpr bool settled() const noexcept { return stage_ == stage::ended; }

    /// How it ended; `pending` until it is settled. To be read in the pass in which it settles: from the next visit on it
    /// is `used_already`.
    [[nodiscard]] constexpr altivar::reason reason() const noexcept
    {
        return is_used_already() ? altivar::reason{outcome_kind::used_already}
               : settled()       ? own().reason()
                                 : altivar::reason{};
    }

    /// Whether it ended with success.
    [[nodiscard]] constexpr bool succeeded() const noexcept { return reason().kind == outcome_kind::succeeded; }

protected:
    constexpr procedure_conversation(procedure_kind const& kind, unit_id its_unit, duration its_limit) noexcept
        : commander{its_unit}, kind_{&kind}, limit_{its_limit}, look_{kind.stop != nullptr}
    {}
    /// The procedure goes with it.
    constexpr procedure_conversation(procedure_conversation const&) noexcept = default;
    constexpr procedure_conversation& operator=(procedure_conversation const&) noexcept = default;

    /// Begins anew, as it was made, behind its procedure.
    constexpr void begin_again() noexcept
    {
        detail::commander const former{*this};
        *this = procedure_conversation{*kind_, unit(), limit_};
        if (kind_->follows_order) {
            begin_anew(former);
        } else {
            replace(former);
        }
    }

    /// Of an order to run: whether it was carried out, and still counts.
    [[nodiscard]] constexpr bool has_done_its_order() const noexcept { return is_done() and is_order_in_force(); }

    /// Of a stop: from here on what was read of its words counts for the first one until the unit is lost, however long ago that
    /// was, as it continues what broadcasts have begun.
    constexpr void count_old_readings(bool counts) noexcept { counts_old_ = counts; }

    constexpr void tell_known() noexcept { own().note_known(is_known()); }

private:
    enum class stage : std::uint32_t { made, waiting, asking, ended };

    /// Until its limit: enough. Behind it: the procedure's grace, then none but for one request, which may be given already.
    enum class time_left : std::uint32_t { enough, grace, none, none_one_given };

    constexpr procedure& own() noexcept { return kind_->procedure_of(*this); }
    constexpr procedure const& own() const noexcept { return const_cast<procedure_conversation*>(this)->own(); }

    constexpr void step(event what) noexcept { take(kind_->step(own(), what)); }
    [[gnu::noinline]] constexpr void step(event::kind what) noexcept { step(event{what}); }
    [[gnu::noinline]] constexpr void fail(errc error) noexcept { step({event::kind::failed, 0, error}); }
    /// The same; or the drive belongs to a stop, or to another order, that came later. An order that a silence alone has
    /// ended has failed: a drive that does not supervise its link runs on.
    constexpr void go_on(event what) noexcept
    {
        if (what.error() != errc::overruled) {
            return step(what);
        }
        bool const may_run_on =
            kind_->follows_order and is_unit_ordered() and not is_overruled() and not is_ordered_by_another();
        may_run_on and end_of_order() == errc::unit_lost ? fail(errc::unit_lost) : yield();
    }
    [[gnu::noinline]] constexpr void yield() noexcept { take(own().yield()); }

    constexpr bool is_done() const noexcept
    {
        outcome_kind const how = own().reason().kind;
        return how == outcome_kind::succeeded or how == outcome_kind::reference_limited;
    }
    constexpr bool is_command_to_run() const noexcept
    {
        constexpr std::uint16_t run = cia402::word_of(cia402::command::enable_operation);
        return effect_of(action_) == detail::effect::enabling and address_of(action_) == own().control_word() and
               (word_of(action_) & run) == run;
    }
    constexpr bool is_looking() const noexcept { return look_.is_under_way(); }

    /// Whether the control word to send stops only a drive in its drive profile, and that has to be read.
    [[gnu::noinline]] constexpr bool has_to_look() const noexcept
    {
        return does_stop(action_) and word_of(action_) != 0 and is_its_word(last_confirmed()) and
               look_.is_due(has_doubt()) and own().tells_meaning();
    }
    /// Whether the drive is known to take the words of all stops as such; whether it was, and may have lost its power since.
    constexpr bool is_known() const noexcept { return is_its_word(last_confirmed()) and not has_doubt(); }
    constexpr bool was_known() const noexcept { return is_its_word(last_confirmed()) and has_doubt(); }
    constexpr bool has_doubt() const noexcept { return is_doubtful() and not counts_old_; }
    constexpr bool is_its_word(std::uint16_t address) const noexcept { return address == own().control_word(); }

    constexpr void begin() noexcept
    {
        if (is_stop() and kind_->stop->looks_first(own(), was_known())) {
            return begin_look();
        }
        step({event::kind::begun, std::uint16_t{is_unit_ordered()}});
    }

    constexpr void begin_look() noexcept
    {
        look_.begin();
        pause_end_ = now_ + longest_look_of_a_stop;
        make_frame(false, own().chcf(), 1);
    }

    /// Begins, or sends the control word: the one meant where it is known to be that, else 0000.
    constexpr void end_look(std::uint16_t meaning) noexcept
    {
        look_.end(is_its_word(meaning));
        note_meaning(meaning);
        if (does_stop(action_)) {
            return make_frame();
        }
        tell_known();
        step(event::kind::begun);
    }

    /// It was done, by what was read before its order came to an end: that has failed. A start withdraws its commands, for a
    /// drive that does not supervise its link runs on.
    constexpr void heed_end_of_order() noexcept
    {
        if (errc const why = end_of_order(); why != errc::none) {
            own().forget_end();
            go_on({event::kind::failed, 0, why});
        }
    }

    /// The unit was lost: the next action, unless it is a word that stops, would wait until the drive has stopped by
    /// itself. So it fails now.
    constexpr void heed_loss() noexcept
    {
        if (not has_lost_ or stage_ == stage::asking) {
            return;
        }
        has_lost_ = false;
        if (is_looking()) {
            return end_look(0);
        }
        if (not settled() and not does_stop(action_)) {
            fail(errc::unit_lost);
        }
    }

    /// Whether a stop's control word was never sent.
    constexpr bool has_to_say() const noexcept { return is_stop() and not look_.has_said(); }

    /// Whether the time limit is ahead, or over and not taken notice of. It ends no stop that has to say its word: only what such
    /// a one reads before.
    constexpr bool has_limit() const noexcept
    {
        bool const reads = what_of(action_) == action_kind::read;
        return left_ < time_left::none and (reads or not has_to_say());
    }

    /// Whether the action is a pause, or a request that may wait only for a limited time. Before its first word a stop looks
    /// for a limited time, later as long as its turn and the response take.
    constexpr bool has_length() const noexcept
    {
        return is_looking() ? not look_.has_said()
                            : what_of(action_) == action_kind::pause or length_of(action_).microseconds != 0;
    }

    constexpr event event_of(result<response> const& outcome) const noexcept
    {
        if (not outcome) {
            return {event::kind::failed, 0, outcome.error()};
        }
        if (what_of(action_) == action_kind::write) {
            return {event::kind::written};
        }
        byte_view const pdu = outcome->pdu();
        constexpr std::size_t first = 2, second = 4;
        bool const are_two = count_of(action_) == 2;
        if (pdu.size() != (are_two ? second : first) + 2) {
            return {event::kind::failed, 0, errc::wrong_length};
        }
        return {event::kind::word_read, detail::u16_at(pdu, first), errc::none,
                are_two ? detail::u16_at(pdu, second) : std::uint16_t{0}};
    }

    constexpr void take(action next) noexcept
    {
        // After the limit one request is allowed, and no pause.
        bool const is_request = what_of(next) == action_kind::read or what_of(next) == action_kind::write;
        bool const is_late = left_ >= time_left::none;
        if (is_late and not has_to_say() and
            (what_of(next) == action_kind::pause or (is_request and left_ == time_left::none_one_given))) {
            next = is_stop() ? kind_->stop->give_up(own()) : own().give_up();
        }
        left_ = is_late and is_request ? time_left::none_one_given : left_;
        procedure& read = own();
        note_power(read.take_power());
        if (read.take_fault()) {
            note_fault();
        }
        note_meaning(read.take_meaning());
        if (is_stop() and what_of(next) == action_kind::end) {
            note_stop_over();
            is_other_family_ = read.reason().kind == outcome_kind::other_family;
        }
        stage_ = what_of(next) == action_kind::end ? stage::ended : stage::waiting;
        action_ = next;
        pause_end_ = now_ + length_of(next);
        if (is_request) {
            make_frame();
        }
        if (has_to_look()) {
            begin_look();
        }
    }

    constexpr void make_frame() noexcept
    {
        bool const is_write = what_of(action_) == action_kind::write;
        make_frame(is_write, address_of(action_), is_write ? word_of(action_) : count_of(action_));
    }

    /// A read of holding registers, or the write of one: both are a function, an address, and a count or a word.
    [[gnu::noinline]] constexpr void make_frame(bool is_write, std::uint16_t address, std::uint16_t value) noexcept
    {
        constexpr std::byte read = detail::to_byte(static_cast<std::uint8_t>(function_code::read_holding_registers));
        constexpr std::byte write = detail::to_byte(static_cast<std::uint8_t>(function_code::write_single_register));
        frame_[0] = detail::to_byte(unit().byte());
        frame_[1] = is_write ? write : read;
        detail::put_u16(&frame_[2], address);
        detail::put_u16(&frame_[4], value);
        detail::append_crc(frame_, frame_.size() - detail::adu_overhead);
    }

    procedure_kind const* kind_;
    action action_{to_pause({})};
    duration limit_;
    instant now_{0};
    instant late_at_{0};
    instant pause_end_{0};
    stage stage_{stage::made};
    time_left left_{time_left::enough};
    alignas(4) std::array<std::byte, 8> frame_{
        detail::filled<8>(std::byte{0xFF})}; ///< any: where all is 0, GCC calls memset
    detail::in_word<bool> has_lost_{false};
    detail::in_word<bool> is_other_family_{false};
    detail::in_word<bool> counts_old_{false};
    stop_look look_;
};

/// Those of a stop.
template <typename Stop>
inline constexpr stop_kind stop_functions{
    [](procedure const& which, bool was_known) noexcept {
        return static_cast<Stop const&>(which).looks_first(was_known);
    },
    [](procedure const& which) noexcept { return static_cast<Stop const&>(which).keeps_power(); },
    [](procedure& which) noexcept { return static_cast<Stop&>(which).give_up(); }};

/// A procedure with its conversation.
template <typename Script> class procedure_runner : public procedure_conversation {
public:
    /// The procedure is made in its place, of these parts.
    constexpr procedure_runner(unit_id its_unit, duration its_limit, auto const&... parts) noexcept
        : procedure_conversation{kind, its_unit, its_limit}, procedure_{parts...}
    {}

    /// Begins anew, as it was made: its limit counts from the next `advance`. One under way is given up first, as if it
    /// had been destroyed. An order to move the motor is given by this call, and a stop that begins before the next visit ends
    /// it; the client that it visited last must not have been destroyed, unless another one is in its place.
    constexpr void again() noexcept
    {
        procedure_ = procedure_.anew();
        this->begin_again();
    }

protected:
    [[nodiscard]] constexpr Script const& told() const noexcept { return procedure_; }

private:
    static constexpr procedure& procedure_of(procedure_conversation& which) noexcept
    {
        return static_cast<procedure_runner&>(which).procedure_;
    }
    static constexpr action step(procedure& which, event what) noexcept
    {
        return static_cast<Script&>(which).step(what);
    }
    static constexpr duration drive_timeout_of(procedure const& which) noexcept
    {
        return static_cast<Script const&>(which).drive_timeout();
    }

    static constexpr stop_kind const* stop_of() noexcept
    {
        if constexpr (Script::is_stop) {
            return &stop_functions<Script>;
        } else {
            return nullptr;
        }
    }

    static constexpr procedure_kind kind{&procedure_of,         &step,
                                         &drive_timeout_of,     stop_of(),
                                         Script::grace,         Script::is_order,
                                         Script::follows_order, Script::gives_way_to_order};

    Script procedure_;
};

} // namespace altivar
} // namespace RTUWIRE_BUILD
} // namespace rtuwire
