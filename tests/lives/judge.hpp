// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// The law of motion for one drive of a life. It looks at the drive's motor, at the frames on the line and at what the
// user ordered and was told; of how the library works it knows nothing.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdlib>
#include <optional>
#include <tuple>
#include <utility>

#include "lives/events.hpp"
#include "lives/setting.hpp"
#include "lives/words.hpp"

#include <rtuwire/core/bytes.hpp>

namespace rtuwire::lives {

using namespace detail;

/// Microseconds since a life began.
using moment = std::uint64_t;

inline constexpr std::size_t most_stops_of_everyone = 2;
inline constexpr std::size_t places =
    4 + most_stops_of_everyone; ///< for conversations; the last ones are for stops of everyone

class judge {
public:
    judge(life_setting const& how, drive_setting const& set, far_drive& drive, tally& counts)
        : how_{how}, set_{set}, drive_{drive}, counts_{counts}
    {}

    // What the user does.

    /// An order to run, in mHz, and the direction. `goes_on`: a cycle that runs the motor is told another reference.
    void note_order(std::size_t place, moment now, std::int32_t asked, bool is_reverse, bool is_by_cycle, bool is_alone,
                    bool goes_on)
    {
        if (not has_power_ and not has_order()) {
            most_forward_ = most_reverse_ = 0;
            is_foreign_ = false;
        }
        note_reference(asked, is_reverse);
        order const before = orders_[place].is_there ? orders_[place] : order{};
        bool const has_enabled = goes_on and before.has_enabled;
        orders_[place] = {true, before.has_begun, is_by_cycle, is_by_cycle, is_alone, has_enabled, now};
        kept_halt_at_ = is_by_cycle ? 0 : kept_halt_at_;
        ordered_at_ = now;
    }
    /// The motor turns no slower than LSP.
    void note_reference(std::int32_t asked, bool is_reverse)
    {
        std::int32_t const most = std::max(asked, set_.lsp * 100);
        most_forward_ = is_reverse ? most_forward_ : std::max(most_forward_, most);
        most_reverse_ = is_reverse ? std::min(most_reverse_, -most) : most_reverse_;
    }
    /// A change to 0 has no direction, and may turn the motor in none in which it does not turn already.
    void note_change(std::int32_t asked, bool is_reverse)
    {
        if (asked != 0) {
            note_reference(asked, is_reverse);
        }
    }
    void note_stop(std::size_t place, moment now, bool is_halt, bool is_by_cycle = false)
    {
        if (stops_to_begin_ == 0) {
            before_ = standing();
        }
        stops_to_begin_ |= 1U << place;
        take_orders(now, is_halt ? now : 0);
        kept_halt_at_ = is_by_cycle ? halted_at_ : 0;
    }
    /// The client has all that the user has made.
    void note_visit()
    {
        stops_to_begin_ = 0;
        for_each_order([](order& each) { each.was_there = false; });
    }
    /// A stop of everyone does not name this drive: its broadcasts may be for another family, and nobody follows up.
    void note_left_out(std::size_t place, moment now)
    {
        note_stop(place, now, false);
        last_missed_ = now;
    }
    /// The user was told that an order is over.
    void note_end_of_order(std::size_t place, moment now)
    {
        order const own = std::exchange(orders_[place], {});
        if (own.is_there and not own.has_enabled and detached_.at < own.at) {
            detached_ = {}; // it has replaced that, too
        }
        if (own.is_there and not has_order()) {
            taken_at_ = now;
            if (is_ordered_here_ and not own.has_enabled) { // what it replaced runs the motor: engine rule 40
                leave(now);
            }
        }
    }
    /// The same, and no conversation stops the motor that it ran.
    void note_order_over(std::size_t place, moment now)
    {
        note_end_of_order(place, now);
        if (not has_order()) {
            leave(now);
        }
    }
    /// Another conversation for this drive was made: from here on a look, or a word by function 06, may be its own.
    void note_company(std::size_t place)
    {
        for (std::size_t i = 0; i < places; ++i) {
            orders_[i].is_alone = orders_[i].is_alone and i == place;
        }
    }
    bool has_order_of(std::size_t place) const { return orders_[place].is_there; }
    /// Whether what an order did stands though it does not count any more: another one came behind it, whatever became of
    /// that; or a silence ended it, which stops no drive that does not supervise its link.
    bool outlives(std::size_t place) const { return ordered_at_ > orders_[place].at or not set_.is_supervised(); }

    /// The user gave a conversation up before its end: what it ordered stays ordered, where its word that enables may have
    /// been sent; what it was to stop nobody stops. `is_known`: the client had it before.
    void note_given_up(std::size_t place, moment now, bool was_stopping, bool is_known)
    {
        if (was_stopping) {
            word_due_since_ = 0;
        }
        bool const never_began = take_back_stop(place) and not is_known;
        order const own = std::exchange(orders_[place], {});
        if (own.is_there and (own.has_enabled or not is_known)) {
            detached_ = {true, true, false, true, true, true, std::max(detached_.at, own.at)};
        } else if ((was_stopping and not never_began) or own.is_there) {
            is_known ? leave_or_forget(now) : void(is_orphan_ = has_power_);
        }
    }
    /// A stop of everyone was given up.
    void note_left(std::size_t place, moment now)
    {
        note_word_given_up();
        take_back_stop(place) ? void() : leave_or_forget(now);
    }
    /// One broadcast was to free all motors, and this drive may not have heard it. It counts as a stop that
    /// ended when it was taken (engine rule 41): orders that were given since it began may count, and so does a halt.
    void note_freed(moment now, moment begun)
    {
        std::array<order, places> const given = orders_;
        take_orders(now, halted_at_ >= begun ? halted_at_ : 0);
        note_visit();
        note_word_given_up();
        for (std::size_t i = 0; i < places; ++i) {
            if (given[i].is_there and given[i].at >= begun) {
                orders_[i] = given[i];
                ordered_at_ = std::max(ordered_at_, given[i].at);
            }
        }
        if (has_power_ and
            (is_ordered_here_ or not has_order())) { // an order that ends before its word holds it no more
            leave_or_forget(now);
        }
    }
    void note_word_given_up() { word_due_since_ = 0; }
    /// A conversation that commands nothing was answered.
    void note_plain_response(moment now)
    {
        if (left_.since != 0 and now > left_.since + time_to_be_left and ++left_.answers == most_answers) {
            left_.lost_at = now;
        }
    }
    /// Whether it runs by this controller's order, and nobody's order or stop holds it any more.
    bool is_left() const { return left_.since != 0 and not has_order(); }
    /// What was under way was cancelled: no loss is told by it.
    void note_cancel()
    {
        word_due_since_ = 0;
        unanswered_ = 0;
        asked_function_ = 0;
    }
    void note_restart_of_controller()
    {
        orders_.fill({});
        detached_ = {};
        stops_to_begin_ = 0;
        is_orphan_ = has_power_ or is_ordered_here_;
        is_ordered_here_ = false;
        left_ = {};
        unanswered_ = 0;
        unheeded_ = 0;
        word_due_since_ = 0;
    }
    void note_death(moment now)
    {
        died_at_ = now;
        word_due_since_ = 0;
    }

    /// A stop of its own has begun: its word, or its look, is due.
    void note_word_due(moment now) { word_due_since_ = stop_begun_ = now; }

    /// It has responded, whoever heard that; or it was off.
    void note_own_response() { unheeded_ = 0; }

    /// The controller was not scheduled until now. Where that was longer than the drive's time-out, what its cycles were
    /// ordered is gone; whether there was such an order.
    bool note_sleep(moment now, moment length)
    {
        bool was_ordered = false;
        if (length > set_.lost_after_us()) {
            for (order& each : orders_) {
                was_ordered = was_ordered or (each.is_there and each.is_by_cycle);
                each = each.is_by_cycle ? order{} : each;
            }
        }
        last_missed_ = last_missed_ < taken_at_ ? last_missed_ : now; // what was not sure by then is no surer behind it
        // What takes time from one of these on begins now.
        taken_at_ = stopped_at_ = lost_at_ = now;
        left_.since != 0 ? leave(now) : void();
        unheeded_ = 0;
        word_due_since_ = word_due_since_ != 0 ? now : 0;
        is_asleep_ = false;
        return was_ordered;
    }
    void note_falling_asleep() { is_asleep_ = true; }

    // What happens at the drive.

    /// Something that takes every order away. Who was at rest and shows no trace of it cannot know.
    void note_disturbance(moment now, cia402::state before, bool is_shown)
    {
        // Of several orders at once nobody can tell whose frames are whose.
        bool const is_alone = number_of_orders() < 2;
        for (order& each : orders_) {
            // What comes between another master's 0006 and a status that shows that is not seen before a word.
            bool const knows = ambushed_at_ == 0 and (each.has_begun or (is_shown and each.has_looked));
            each.at = is_alone and knows ? each.at : now;
        }
        if (before != cia402::state::switch_on_disabled or is_shown) {
            disturbed_at_ = now;
        }
    }

    void note_power_cycle(moment now)
    {
        cycled_at_ = now;
        foreign_reference_at_ = 0;               // it is gone
        if (is_enabling_ and unanswered_ != 0) { // and what it has just heard is done without one
            note_reference(0, false);
            note_reference(0, true);
        }
    }

    // What is on the line.

    /// A request of this controller to this drive, or to all.
    std::optional<breach> note_request(byte_view frame, moment now, bool is_heard)
    {
        bool const is_broadcast = frame[0] == std::byte{0};
        word_due_since_ = 0;
        if (not is_broadcast) {
            is_heard and to_u8(frame[1]) == 3 ? note_read(now) : void();
            count_unheeded(now, is_heard);
        }
        if (not is_broadcast) {
            last_missed_ = unanswered_ == 0 ? last_missed_ : now;
            ++unanswered_;
            lost_at_ = unanswered_ == surely_lost() ? now : lost_at_;
        }
        bool const is_other_write = to_u8(frame[1]) == 6 and u16_at(frame, 2) != drive_.profile().cmd and
                                    u16_at(frame, 2) != drive_.frequency_reference() and
                                    u16_at(frame, 2) != drive_.speed_reference();
        asked_function_ = is_other_write ? std::uint8_t{0} : to_u8(frame[1]);
        asked_at_ = now;
        asked_since_ = now - frame.size() * 11'000'000ULL / how_.bits_per_second;
        is_look_ = to_u8(frame[1]) == 3 and u16_at(frame, 2) == drive_.profile().eta;
        auto const word = control_word_in(frame, drive_.profile());
        bool const may = has_order() or is_foreign_;
        bool const is_enabling = word and enables(*word, drive_.profile());
        is_enabling_ = is_enabling;
        is_reference_asked_ = asks_for_reference(frame);
        bool const is_told_otherwise = is_enabling and to_u8(frame[1]) == 6 and holds_reference_of_another();
        if (is_heard) {
            own_reference_at_ = writes_reference(frame) ? now : own_reference_at_;
            // A direct start's last look is at the command, and what others ask may come behind it.
            bool const is_direct = word and (*word & drive_.profile().direct_control) != 0;
            if (is_direct and cycled_at_ != 0 and cycled_at_ >= (is_alone() ? unpolled_at_ : command_read_at_)) {
                note_reference(0, false); // the reference is gone since the last look, and its sign with it
                note_reference(0, true);
            }
            unpolled_at_ = is_poll(frame) ? unpolled_at_ : now;
            command_read_at_ = asks_for(frame, drive_.profile().cmd) ? now : command_read_at_;
            last_heard_ = now;
            was_foreign_ = false;
            if (word and (*word & 0x80U) != 0) {
                note_reset(now);
            }
            if (is_look_) {
                looked_at_ = {now, looked_at_[0], looked_at_[1]};
            }
            note_look_behind_ambush(frame, is_enabling);
            // Direct control has no step between its last look and a motor that turns; the last looks may be another's.
            moment const last_look = is_alone() ? looked_at_[0] : looked_at_[2];
            bool const is_too_late = is_direct and disturbed_at_ >= last_look;
            moment const asked = std::max(latest_order(), ordered_at_);
            was_asked_ = has_order() and (asked >= disturbed_at_ or is_too_late);
            halted_at_ = is_enabling ? 0 : halts_again(word) ? kept_halt_at_ : halted_at_;
            runs_for_another_ = runs_for_another_ and not is_enabling;
            is_fed_by_another_ = is_fed_by_another_ and not is_enabling;
            is_enabling ? note_enabled() : void();
            is_braking_ = word and keeps_power(*word, drive_.profile());
        }
        if (is_enabling and not may) {
            return breach::enabled_without_order;
        }
        return is_told_otherwise ? std::optional{breach::enabled_otherwise} : std::nullopt;
    }
    /// `status` stood in the drive when it made the response.
    void note_response(byte_view frame, moment now, std::uint16_t status)
    {
        unanswered_ = 0;
        note_reference_seen(now);
        bool const is_in_time = now < asked_at_ + how_.options.response_timeout.microseconds;
        note_begin(is_in_time ? asked_function_ : std::uint8_t{0});
        constexpr std::size_t size_of_one_word = 7; // an older request may have had another one
        is_look_ = is_look_ and frame.size() == size_of_one_word;
        // The words of a cycle hold the state, too.
        bool const shows_state = is_look_ or (to_u8(frame[1]) != 16 and frame.size() > size_of_one_word + 1);
        is_key_known_ = shows_state ? (status & altivar::stop_key_bit) != 0 : is_key_known_;
        key_seen_at_ = shows_state and is_key_known_ ? now : key_seen_at_;
        for (order& each : orders_) {
            // A response to who asked in that place before tells the order nothing.
            each.has_looked = each.has_looked or (is_look_ and each.is_alone and asked_since_ >= each.at);
        }
        is_heard_since_good_ = is_heard_since_good_ or is_good_;
    }
    /// A response of which nobody can say whether the controller takes it for one: in parts, or behind other bytes.
    void note_doubtful_response(moment now, std::uint16_t status)
    {
        unanswered_ = 0;
        last_missed_ = now;
        note_reference_seen(now);
        bool const is_shown = (status & altivar::stop_key_bit) != 0;
        is_key_known_ = is_key_known_ or is_shown;
        key_seen_at_ = is_shown ? now : key_seen_at_;
    }
    void note_foreign(byte_view frame, moment now, cia402::state before)
    {
        last_heard_ = now;
        last_foreign_ = now;
        was_foreign_ = true;
        if (to_u8(frame[1]) != 3) {
            was_written_to_ = is_foreign_ = true;
            // What stands there already is nobody else's.
            bool const is_same = to_u8(frame[1]) == 6 and u16_at(frame, 2) == drive_.frequency_reference() and
                                 u16_at(frame, 4) == static_cast<std::uint16_t>(drive_.reference());
            if (writes_reference(frame) and not is_same) {
                foreign_reference_at_ = now;
                foreign_reference_ = u16_at(frame, 4);
            }
            auto const word = control_word_in(frame, drive_.profile());
            bool const stops = word and (*word == 0 or *word == 2);
            if (stops) {
                note_disturbance(now, before, false);
            }
        }
    }
    /// Another master has said 0006 to a drive that was checked; a status that is read behind it shows that.
    void note_ambush(moment now)
    {
        last_heard_ = last_foreign_ = ambushed_at_ = now;
        was_foreign_ = false;
    }
    /// Whether the only order in force is a cycle's, and nobody else looks at the drive.
    bool is_of_one_cycle() const
    {
        bool const is_one = number_of_orders() == 1 and not detached_.is_there and not is_foreign_ and not is_orphan_;
        return is_one and std::all_of(orders_.begin(), orders_.end(), [](order const& each) {
                   return not each.is_there or (each.is_by_cycle and each.is_alone);
               });
    }
    void note_line(bool is_good, moment now)
    {
        is_heard_since_good_ = is_heard_since_good_ and is_good;
        is_good_ = is_good;
        last_missed_ = is_good ? last_missed_ : now;
    }

    // What is seen of the motor.

    /// To be called after each step of the drive.
    std::optional<breach> look(moment now)
    {
        cia402::state const at = drive_.state();
        bool const had_power = has_power_;
        bool const was_running = runs_;
        if (set_.is_io and drive_.frequency() != 0 and not was_written_to_) {
            return breach::moved_without_order;
        }
        if (auto const wrong = judge_line(now)) {
            return wrong;
        }
        has_power_ = cia402::has_power(at);
        runs_ = at == cia402::state::operation_enabled;
        if (cia402::is_in_fault(at) and not was_in_fault_) {
            note_disturbance(now, at, true);
        }
        was_in_fault_ = cia402::is_in_fault(at);
        if (had_power and not has_power_) {
            lose_power(now);
        }
        ran_at_ = runs_ ? now : ran_at_;
        if (runs_ and not was_running) {
            if (auto const wrong = begin_to_run(now)) {
                return wrong;
            }
        }
        return has_power_ ? judge_power(now) : std::nullopt;
    }

    /// What this drive was told last by who ordered it alone, in 0.1 Hz.
    std::optional<breach> told_reference(std::size_t place, int asked, moment now) const
    {
        if (holds_reference_of_another()) {
            return breach::ran_otherwise;
        }
        // What befell it behind its last look nobody can know, nor what it did by itself while its response was on the way.
        bool const gave_up =
            set_.is_supervised() and drive_.reference() == 0 and now >= last_heard_ + set_.time_out_us();
        bool const is_known = number_of_orders() == 1 and orders_[place].is_alone and not is_foreign_ and asked != 0 and
                              (disturbed_at_ == 0 or disturbed_at_ < looked_at_[0]) and
                              unpowered_at_ <= looked_at_[0] and not gave_up;
        return is_known and drive_.reference() != asked ? std::optional{breach::ran_otherwise} : std::nullopt;
    }
    /// A stop has ended: one that was carried out has sent something. `has_none`: another stop is under way, or it has no
    /// place.
    std::optional<breach> told_of_a_stop(moment begun, bool has_none)
    {
        bool const is_missing = word_due_since_ != 0 and begun == stop_begun_;
        word_due_since_ = is_missing ? 0 : word_due_since_;
        return is_missing and not has_none ? std::optional{breach::stopped_late} : std::nullopt;
    }
    bool is_ordered() const { return has_order() and not is_orphan_; }

    /// What a user was told.
    std::optional<breach> told_to_stand(bool by_halt) const
    {
        constexpr std::int32_t resolution = 100; // of what a drive tells
        bool const stands = by_halt ? std::abs(drive_.frequency()) < resolution : not has_power_;
        return stands or is_foreign_ ? std::nullopt : std::optional{breach::stood_not};
    }
    std::optional<breach> told_to_run(moment ordered) const
    {
        bool const ran = ran_at_ >= ordered or runs_;
        return ran or is_foreign_ ? std::nullopt : std::optional{breach::ran_not};
    }
    bool is_foreign() const { return is_foreign_; }
    bool has_power() const { return has_power_; }
    bool is_lost() const { return unanswered_ >= surely_lost(); }
    /// Whether the last response came while the STOP key was shown: one more press looks the same. In company another
    /// conversation may have seen it gone, between two looks of the one that is at work.
    bool is_key_known() const { return is_key_known_ or (not is_alone() and key_seen_at_ >= ordered_at_); }

private:
    struct order {
        bool is_there{false};
        bool has_begun{false}; ///< a write for it was answered; before that nobody can know what happened meanwhile
        bool is_by_cycle{false};
        bool has_looked{false};  ///< its state was read for it
        bool is_alone{false};    ///< else a look may have been somebody else's
        bool has_enabled{false}; ///< the drive heard a word that may be its own
        moment at{0};
        bool was_there{false}; ///< before stops that have not begun
    };

    /// A motor that nobody's order or stop holds. Its unit counts as lost behind some responses to others than those who command.
    struct left_motor {
        moment since{0}; ///< 0: none
        moment lost_at{0};
        unsigned answers{0};
    };
    /// 0.5 s without a visit, and some passes; three responses. One more of each.
    static constexpr moment time_to_be_left = 1'000'000;
    static constexpr unsigned most_answers = 4;

    void leave(moment now) { left_ = {now}; }
    void leave_or_forget(moment now) { is_ordered_here_ ? leave(now) : void(is_orphan_ = has_power_); }

    template <typename Work> void for_each_order(Work work)
    {
        std::for_each(orders_.begin(), orders_.end(), work);
        work(detached_);
    }
    void take_orders(moment now, moment halted_at)
    {
        for_each_order([](order& each) { each.was_there = std::exchange(each.is_there, false) or each.was_there; });
        ordered_at_ = 0;
        taken_at_ = now;
        if (is_orphan_) { // whatever it runs at
            note_reference(std::abs(drive_.frequency()), drive_.frequency() < 0);
        }
        is_orphan_ = false;
        left_ = {};
        halted_at_ = halted_at;
        kept_halt_at_ = 0;
        stopped_at_ = now;
        is_fed_by_another_ = false;
    }
    /// What a stop changes, but the orders.
    std::tuple<moment&, moment&, moment&, moment&, moment&, left_motor&, bool&, bool&> standing()
    {
        return std::tie(ordered_at_, taken_at_, stopped_at_, halted_at_, kept_halt_at_, left_, is_orphan_,
                        is_fed_by_another_);
    }

    /// A stop begins when the client has it (engine rules 36, 37): one that is given up before that has stopped nothing, and
    /// what stood before it stands. Whether it is one.
    bool take_back_stop(std::size_t place)
    {
        unsigned const all = std::exchange(stops_to_begin_, stops_to_begin_ & ~(1U << place));
        if (all != 0 and stops_to_begin_ == 0) {
            for_each_order([](order& each) { each.is_there = std::exchange(each.was_there, false) or each.is_there; });
            standing() = before_;
            ordered_at_ = std::max(ordered_at_, latest_order());
            left_ = has_power_ ? left_ : left_motor{};
            is_orphan_ = is_orphan_ and has_power_;
        }
        return all != stops_to_begin_;
    }
    void note_reference_seen(moment now)
    {
        if (std::exchange(is_reference_asked_, false)) {
            reference_seen_at_ = {now, reference_seen_at_[0]};
        }
    }
    void note_enabled()
    {
        is_ordered_here_ = true;
        left_ = {};
        for (order& each : orders_) {
            each.has_enabled = each.is_there;
        }
    }

    /// A cycle that was asked to halt, and to run no more since, keeps to that behind a start that it has overruled.
    bool halts_again(std::optional<std::uint16_t> word) const
    {
        return kept_halt_at_ != 0 and word and keeps_power(*word, drive_.profile()) and not has_order();
    }

    bool has_order() const
    {
        return detached_.is_there or
               std::any_of(orders_.begin(), orders_.end(), [](order const& each) { return each.is_there; });
    }
    bool is_alone() const
    {
        return std::all_of(orders_.begin(), orders_.end(),
                           [](order const& each) { return not each.is_there or each.is_alone; });
    }
    std::ptrdiff_t number_of_orders() const
    {
        return std::count_if(orders_.begin(), orders_.end(), [](order const& each) { return each.is_there; }) +
               (detached_.is_there ? 1 : 0);
    }
    moment latest_order() const
    {
        moment latest = detached_.is_there ? detached_.at : 0;
        for (order const& each : orders_) {
            latest = each.is_there ? std::max(latest, each.at) : latest;
        }
        return latest;
    }

    bool is_reference(std::uint16_t address) const
    {
        return address == drive_.frequency_reference() or address == drive_.speed_reference();
    }
    /// A start by function 06, a cycle with its control word.
    bool writes_reference(byte_view frame) const
    {
        std::uint8_t const function = to_u8(frame[1]);
        return function == 6 ? is_reference(u16_at(frame, 2)) : function == 16 or function == 23;
    }
    static bool asks_for(byte_view frame, std::uint16_t address)
    {
        unsigned const first = u16_at(frame, 2), end = first + u16_at(frame, 4);
        return to_u8(frame[1]) == 3 and address >= first and address < end;
    }
    bool asks_for_reference(byte_view frame) const
    {
        return asks_for(frame, drive_.frequency_reference()) or asks_for(frame, drive_.speed_reference());
    }
    /// Whether a request is of one of the polls of a life, which belong to no order.
    bool is_poll(byte_view frame) const
    {
        bool const is_of_one = u16_at(frame, 4) == 1; // a look of a stop reads one of these beside ETA
        return is_of_one and (asks_for(frame, drive_.profile().rfr) or asks_for(frame, drive_.profile().lft));
    }
    /// Whether the drive's reference is one of another master that this controller must know of: not one that the drive
    /// refused, and not one that was written behind a start's last look at it. In company the last look may be another
    /// conversation's, and the one before that the start's, and so may the last reference.
    bool holds_reference_of_another() const
    {
        auto const has_crossed = [this](moment look) {
            return (look > own_reference_at_ or not is_alone()) and foreign_reference_at_ >= look;
        };
        bool const did_cross =
            has_crossed(reference_seen_at_[0]) or (not is_alone() and has_crossed(reference_seen_at_[1]));
        bool const is_taken = foreign_reference_ == static_cast<std::uint16_t>(drive_.reference());
        return foreign_reference_at_ > own_reference_at_ and is_taken and not did_cross;
    }

    /// Behind the silence that stops a drive reads may resume (L4); where another master fed it meanwhile they feed it on,
    /// and nothing stops it (docs/what-stops-my-motor.md). A stop since the last request sends its own words.
    void note_read(moment now)
    {
        bool const was_silent =
            now >= last_unheeded_ + set_.time_out_us() + 1'000'000 and stopped_at_ <= last_unheeded_;
        is_fed_by_another_ = is_fed_by_another_ or (was_silent and runs_ and last_foreign_ > last_unheeded_);
    }

    /// Requests in a row, each soon behind the one before.
    void count_unheeded(moment now, bool is_heard)
    {
        constexpr moment soon = 1'000'000;
        bool const is_in_a_row = is_heard and now < last_unheeded_ + soon;
        unheeded_ = is_in_a_row ? unheeded_ : 0;
        unheeded_since_ = unheeded_ == 0 ? now : unheeded_since_;
        unheeded_ += is_heard ? 1 : 0;
        last_unheeded_ = now;
    }

    void note_look_behind_ambush(byte_view frame, bool is_enabling)
    {
        bool const shows_state = is_look_ or to_u8(frame[1]) == 23 or (to_u8(frame[1]) == 3 and u16_at(frame, 4) > 2);
        if (ambushed_at_ != 0 and shows_state and not is_enabling) {
            note_disturbance(std::exchange(ambushed_at_, 0), cia402::state::ready_to_switch_on, false);
        }
        ambushed_at_ = shows_state or is_enabling ? 0 : ambushed_at_;
    }

    /// The user resets a fault by a conversation of its own. What was ordered before and was not told of the fault counts
    /// as ordered again.
    void note_reset(moment now)
    {
        for (order& each : orders_) {
            each.at = now;
        }
    }

    /// A cycle writes by functions 16 and 23, a start by 06.
    void note_begin(std::uint8_t function)
    {
        for (order& each : orders_) {
            bool const is_by_start = function == 6 and (each.is_alone or is_enabling_);
            bool const is_own = each.is_by_cycle ? function == 16 or function == 23 : is_by_start;
            each.has_begun = each.has_begun or (is_own and asked_since_ >= each.at);
        }
    }

    void lose_power(moment now)
    {
        bool const is_by_frame = last_heard_ + 400'000 > now;
        unpowered_at_ = now;
        counts_.note(is_by_frame ? event::motor_stopped_by_order : event::motor_stopped_by_its_timeout);
        is_orphan_ = false;
        is_ordered_here_ = false;
        left_ = {};
        runs_for_another_ = is_fed_by_another_ = false;
        was_counted_ = false;
    }

    std::optional<breach> begin_to_run(moment now)
    {
        counts_.note(event::motor_ran);
        if (is_braking_) { // its user asked for that
            return std::nullopt;
        }
        if (was_foreign_) {
            is_foreign_ = runs_for_another_ = true;
            return std::nullopt;
        }
        if (last_heard_ + 200'000 < now) {
            return breach::moved_by_itself;
        }
        return was_asked_ or is_foreign_ ? std::nullopt : std::optional{breach::moved_without_order};
    }

    /// What has to leave at once, and what has to come back.
    std::optional<breach> judge_line(moment now) const
    {
        constexpr unsigned most_unheeded = 6;
        constexpr moment longest_save = 4'000'000; // an EEPROM that is written twice
        if (is_asleep_ or died_at_ != 0) {
            return std::nullopt;
        }
        if (unheeded_ > most_unheeded and last_unheeded_ > unheeded_since_ + longest_save) {
            return breach::deaf;
        }
        moment const others = 2 * retry_state() + 1'000'000;
        bool const is_late = word_due_since_ != 0 and now > word_due_since_ + others;
        return is_late ? std::optional{breach::stopped_late} : std::nullopt;
    }

    /// Twice as many frames as a loss needs at most: a request and its repetitions, one more where that is tolerated.
    unsigned surely_lost() const { return 2U * (how_.options.retries + 1U); }

    /// One request with its repetitions, the time that late responses are waited for, and a period.
    moment retry_state() const
    {
        moment const once = how_.options.response_timeout.microseconds + how_.options.late_response.microseconds +
                            11'000'000ULL * 80 / how_.bits_per_second;
        return once * (how_.options.retries + 1U) + 300'000;
    }
    moment ramp() const { return std::uint64_t{set_.ramp} * 130'000 + 700'000; }

    std::optional<breach> judge_power(moment now)
    {
        constexpr moment words = 2'000'000; // how long words that stop may go
        std::int32_t const speed = drive_.frequency();
        constexpr std::int32_t tolerance = 100;
        bool const is_too_fast = speed > most_forward_ + tolerance or speed < most_reverse_ - tolerance;
        if (is_too_fast and not is_foreign_ and not is_orphan_) {
            return breach::too_fast;
        }
        if (is_asleep_) {
            return std::nullopt; // what the drive does by itself
        }
        // A quick stop that waits at standstill, and a halt, keep the power.
        bool const stands = speed == 0 and (halted_at_ != 0 or drive_.state() == cia402::state::quick_stop_active);
        moment const by_itself = set_.time_out_us() + ramp();
        bool const is_watched = set_.is_supervised();
        if (died_at_ != 0 and is_watched and now > std::max(died_at_, last_heard_) + by_itself) {
            return breach::power_after_death;
        }
        // What another master alone has started may be read for ever.
        bool const is_ours = not is_orphan_ and not runs_for_another_;
        bool const has_to_trip = is_watched and not is_fed_by_another_;
        if (is_lost() and has_to_trip and died_at_ == 0 and is_ours and not stands) {
            if (not was_counted_) {
                was_counted_ = true;
                counts_.note(event::unit_lost_while_it_ran);
            }
            moment const loss = lost_at_ + retry_state() + words + retry_state();
            moment const stop = stopped_at_ + words + retry_state();
            if (now > std::max({loss, stop, last_foreign_}) + by_itself) {
                return breach::power_after_loss;
            }
        }
        bool const is_excused = is_foreign_ or is_orphan_ or stands or died_at_ != 0;
        if (is_left() and not is_excused) {
            moment const at_last = left_.lost_at + words + 2 * retry_state() + by_itself;
            bool const is_late = left_.lost_at != 0 and now > std::max(at_last, last_foreign_ + by_itself);
            return is_late and has_to_trip ? std::optional{breach::left_to_reads} : std::nullopt;
        }
        if (not has_order() and not is_excused) {
            bool const was_good = is_good_ and is_heard_since_good_ and last_missed_ < taken_at_;
            moment const at_once = taken_at_ + retry_state() + 1'500'000 + ramp();
            moment const at_last = std::max(taken_at_ + words + 3 * retry_state(), last_foreign_) + by_itself;
            if ((was_good and now > at_once) or (has_to_trip and now > at_last)) {
                return breach::power_after_stop;
            }
        }
        return std::nullopt;
    }

    life_setting const& how_;
    drive_setting const& set_;
    far_drive& drive_;
    tally& counts_;
    std::array<order, places> orders_{};
    order detached_{}; ///< of conversations that were given up
    left_motor left_{};
    unsigned stops_to_begin_{0}; ///< a bit for each place with one that the client has not had
    std::tuple<moment, moment, moment, moment, moment, left_motor, bool, bool> before_{}; ///< before these
    moment taken_at_{0};
    moment stopped_at_{0};
    moment halted_at_{0};    ///< asked to halt by the latest stop; 0: not, or enabled since
    moment kept_halt_at_{0}; ///< the same of a cycle, enabled by others since or not
    moment ordered_at_{0};   ///< whatever became of it, since the last stop
    moment disturbed_at_{0};
    moment lost_at_{0}; ///< when it was sent what makes the loss sure, where nothing is answered
    moment asked_at_{0};
    moment asked_since_{0};
    std::array<moment, 3> looked_at_{}; ///< the latest first
    moment last_heard_{0};
    moment key_seen_at_{0};     ///< the latest response while the STOP key was shown
    moment unpolled_at_{0};     ///< it heard another request of this controller than a poll
    moment command_read_at_{0}; ///< ... that reads the control word
    moment last_foreign_{0};
    moment ambushed_at_{0}; ///< until a status shows it
    moment own_reference_at_{0};
    moment foreign_reference_at_{0};
    std::array<moment, 2> reference_seen_at_{}; ///< the latest first
    moment ran_at_{0};
    moment died_at_{0};
    moment last_missed_{0};
    moment word_due_since_{0};
    moment cycled_at_{0};
    moment unpowered_at_{0};
    moment unheeded_since_{0};
    moment last_unheeded_{0};
    moment stop_begun_{0}; ///< of the latest stop of its own
    unsigned unheeded_{0}; ///< requests that it heard since its last response
    unsigned unanswered_{0};
    std::uint16_t foreign_reference_{0};
    std::uint8_t asked_function_{0};
    std::int32_t most_forward_{0};
    std::int32_t most_reverse_{0};
    bool is_good_{true};
    bool is_heard_since_good_{false};
    bool is_orphan_{false};       ///< nobody is left who ordered it, or who was to stop it
    bool is_ordered_here_{false}; ///< it heard a word of this controller that enables, since it stood
    bool is_foreign_{false};      ///< another master wrote to it since it stood, or since the last order
    bool was_foreign_{false};
    bool was_written_to_{false}; ///< by another master, ever
    bool runs_for_another_{false};
    bool is_fed_by_another_{false}; ///< through the silence that was to stop it
    bool is_key_known_{false};
    bool is_enabling_{false}; ///< the last request
    bool is_reference_asked_{false};
    bool was_in_fault_{false};
    bool has_power_{false};
    bool runs_{false};
    bool was_counted_{false};
    bool is_look_{false};
    bool is_braking_{false};
    bool is_asleep_{false}; ///< the controller
    bool was_asked_{false}; ///< what the drive heard last came while an order was in force
};

} // namespace rtuwire::lives
