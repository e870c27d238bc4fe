// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// What happens to the line and at the drives of a life, by chance, and the life's way from its begin to its end.
#pragma once

#include "lives/user.hpp"

#include <rtuwire/wire/adu.hpp>
#include <rtuwire/wire/registers.hpp>

namespace rtuwire::lives {

template <typename Link> class whole_life : public user<Link> {
    using base = user<Link>;
    using base::at;
    using base::chance_;
    using base::counts_;
    using base::everyone_;
    using base::habits_;
    using base::how_;
    using base::is_dead_;
    using base::link_;
    using base::nodes_;
    using base::now_;
    using base::receiver_;
    using base::said_;
    using base::slots_;
    using base::wrong_;

public:
    using base::base;

    /// Whether the law held.
    bool live()
    {
        base::begin_cycle(0, 0);
        base::pass(200'000);
        if (chance_.below(10) == 0) {
            lie_in_wait(*nodes_[0]);
        }
        for (unsigned i = 0; i < how_.moments and not wrong_; ++i) {
            chance_.below(3) == 0 ? happen() : base::act();
            base::pass(any_time());
        }
        end();
        if (not is_dead_ and habits_.below(3) == 0) {
            visit_on();
        }
        bool const has_wrapped = std::uint64_t{how_.start_count} + now_ > 0xFFFF'FFFFU;
        if (has_wrapped) {
            counts_.note(event::clock_wrap);
        }
        if (wrong_) {
            counts_.note(*wrong_);
        }
        return not wrong_;
    }

private:
    node& any() { return *nodes_[chance_.below(static_cast<std::uint32_t>(nodes_.size()))]; }

    /// Short times hit what is under way, long ones what comes of it.
    moment any_time()
    {
        switch (chance_.below(5)) {
        case 0: return chance_.below(30'000);
        case 1:
        case 2: return chance_.below(300'000);
        case 3: return chance_.below(1'500'000);
        default: return chance_.below(5'000'000);
        }
    }

    void happen()
    {
        node& own = any();
        std::size_t const unit = nodes_[0].get() == &own ? 0U : 1U;
        said_.now = now_;
        switch (chance_.below(29)) {
        case 28: return stop_what_is_used_again();
        case 26:
        case 27: return refer_between_frames(own, unit);
        case 24:
        case 25: return cut_between_frames(own, unit);
        case 0:
        case 1:
        case 2:
        case 3:
        case 4:
        case 5: return lose(own, unit);
        case 6:
        case 7:
        case 8: return restore(own, unit);
        case 9: return trip(own);
        case 10:
            counts_.note(event::cause_gone);
            own.drive->clear_cause();
            return;
        case 11:
        case 12: return press_stop(own);
        case 13:
        case 14: return change_control(own);
        case 15:
        case 16: return switch_drive(own);
        case 17: return switch_controller();
        case 18:
        case 19: return fall_asleep();
        case 20:
        case 21: return lie_in_wait(own);
        default: return let_another_speak(own, unit);
        }
    }

    void lose(node& own, std::size_t unit)
    {
        own.lost = {};
        switch (chance_.below(6)) {
        case 0:
            own.lost.requests = true;
            counts_.note(event::requests_lost);
            break;
        case 1:
            own.lost.answers = true;
            counts_.note(event::answers_lost);
            break;
        case 2:
            own.lost.requests = own.lost.answers = true;
            counts_.note(event::both_directions_lost);
            break;
        case 3:
            own.lost.in_a_million = 20'000 + chance_.below(500'000);
            counts_.note(event::frames_lost_by_chance);
            break;
        case 4:
            own.lost.each_nth = 2 + chance_.below(6);
            counts_.note(event::each_nth_frame_lost);
            break;
        default:
            own.lost.only_nth = 1 + chance_.below(8);
            counts_.note(event::one_frame_lost);
            break;
        }
        said_.say("line of drive %u: requests lost %d, answers lost %d, %u in a million, each %u., the %u.",
                  how_.drive[unit].address, int{own.lost.requests}, int{own.lost.answers}, own.lost.in_a_million,
                  own.lost.each_nth, own.lost.only_nth);
        base::note_line(unit);
    }

    void restore(node& own, std::size_t unit)
    {
        counts_.note(event::line_restored);
        said_.say("line of drive %u is good", how_.drive[unit].address);
        own.lost = {};
        base::note_line(unit);
    }

    void trip(node& own)
    {
        counts_.note(event::fault);
        said_.say("fault");
        own.law.note_disturbance(now_, own.drive->state(), true);
        own.drive->trip(9);
        if (chance_.below(2) == 0) {
            own.drive->clear_cause();
        }
    }

    void press_stop(node& own)
    {
        counts_.note(event::stop_key);
        said_.say("STOP key");
        cia402::state const state = own.drive->state();
        own.drive->press_stop();
        bool const is_shown = (own.drive->status() & altivar::stop_key_bit) != 0;
        own.law.note_disturbance(now_, state, is_shown and not own.law.is_key_known());
    }

    void change_control(node& own)
    {
        cia402::state const state = own.drive->state();
        own.is_local = not own.is_local and chance_.below(2) == 0;
        counts_.note(own.is_local ? event::local_control : event::remote_control);
        said_.say("local control %d", int{own.is_local});
        own.drive->set_local(own.is_local);
        if (own.is_local) {
            own.law.note_disturbance(now_, state, false);
        }
    }

    void switch_drive(node& own)
    {
        counts_.note(event::drive_power_cycle);
        base::cycle_power(own);
    }

    /// Its power goes and comes back between two frames, while somebody starts it.
    void cut_between_frames(node& own, std::size_t unit)
    {
        own.cut_behind = 1 + chance_.below(24);
        std::size_t const place = chance_.below(slots);
        chance_.below(2) == 0 ? base::begin_direct_start(place, unit) : base::begin_start(place, unit);
    }

    /// Another master writes its reference between two frames, while somebody starts the drive.
    void refer_between_frames(node& own, std::size_t unit)
    {
        own.refer_behind = 1 + chance_.below(24);
        std::size_t const place = chance_.below(slots);
        chance_.below(2) == 0 ? base::begin_direct_start(place, unit) : base::begin_start(place, unit);
    }

    void switch_controller()
    {
        counts_.note(event::controller_power_cycle);
        said_.say("the controller is switched off and on");
        for (slot& each : slots_) {
            each.what.template emplace<std::monostate>();
        }
        everyone_.fill({});
        link_ = base::make_link();
        receiver_.clear();
        // A drive may still answer what was asked before.
        duration const longest =
            microseconds(how_.options.response_timeout.microseconds + how_.options.late_response.microseconds);
        for (std::size_t i = 0; i < how_.drives; ++i) {
            link_.hold(*unit_id::checked(how_.drive[i].address), at() + longest);
            nodes_[i]->law.note_restart_of_controller();
        }
    }

    /// Another master waits for the first word to run of a cycle.
    void lie_in_wait(node& own)
    {
        base::pass(400'000);
        own.other = {ambush::stage::waiting};
        base::use_a_cycle();
        base::pass(2'000'000);
    }

    /// For a while, or so long that half the counter of the clock, or all of it, goes by.
    void fall_asleep()
    {
        constexpr std::array<moment, 5> minutes{1, 36, 50, 71, 110};
        bool const is_long = chance_.below(3) == 0;
        moment const length = is_long ? minutes[chance_.below(5)] * 60'000'000 : 200'000 + chance_.below(12'000'000);
        counts_.note(is_long ? event::slept_for_minutes : event::slept_briefly);
        said_.say("the controller sleeps for %.1f s", double(length) / 1e6);
        base::sleep(length);
    }

    /// What is used again is not visited while its drive is stopped.
    void stop_what_is_used_again()
    {
        std::size_t const place = chance_.below(slots);
        slot& own = slots_[place];
        if (not own.has_told or own.is_away) {
            return;
        }
        base::use_again(place);
        own.is_paused = true;
        counts_.note(event::stopped_what_is_used_again);
        base::begin_stop((place + 1) % slots, own.unit, base::any_way());
        base::pass(any_time());
        own.is_paused = false;
    }

    void let_another_speak(node& own, std::size_t unit)
    {
        if (not base::is_line_free()) {
            return;
        }
        constexpr std::array<std::uint16_t, 9> words{0x0000, 0x0002, 0x0006, 0x0007, 0x000F,
                                                     0x080F, 0x010F, 0x0080, 0x0007};
        std::array<std::byte, 8> frame{};
        unit_id const to = *unit_id::checked(how_.drive[unit].address);
        altivar::drive_layout const& profile = own.drive->profile();
        if (chance_.below(3) == 0) {
            counts_.note(event::read_of_another_master);
            static_cast<void>(encode_into(frame, to, read_holding_registers{profile.eta, 1}));
        } else {
            counts_.note(event::word_of_another_master);
            bool const is_reference = chance_.below(4) == 0;
            std::uint16_t const address = is_reference ? own.drive->frequency_reference() : profile.cmd;
            std::uint16_t const word =
                is_reference ? static_cast<std::uint16_t>(chance_.below(400)) : words[chance_.below(9)];
            static_cast<void>(encode_into(frame, to, write_single_register{address, word}));
        }
        base::say_as_another(frame);
    }

    /// For minutes: what has ended is visited on, beside what has not, or for a while it is not.
    void visit_on()
    {
        counts_.note(event::visited_on);
        said_.now = now_;
        said_.say("it goes on for minutes");
        restore_all();
        moment const end = now_ + 240'000'000;
        for (unsigned rounds = 2 + chance_.below(8); rounds != 0 and now_ < end and not wrong_; --rounds) {
            std::size_t const place = chance_.below(slots);
            std::size_t const unit = chance_.below(static_cast<std::uint32_t>(how_.drives));
            switch (chance_.below(10)) {
            case 0: base::begin_start(place, unit); break;
            case 1:
            case 2:
            case 3: base::begin_stop(place, unit, chance_.below(2) == 0 ? a::stop_by::halt : base::any_way()); break;
            case 4: base::begin_poll(place, unit); break;
            case 5:
                base::stop_all();
                base::stop_all_beside();
                break;
            case 6: let_another_speak(*nodes_[unit], unit); break;
            case 7: pause(); break;
            default: base::destroy(place); break;
            }
            base::pass(chance_.below(2) == 0 ? any_time() : chance_.below(60'000'000));
        }
    }

    /// Some of what has ended is not visited until the next pause.
    void pause()
    {
        for (std::size_t place = 0; place < slots; ++place) {
            slot& own = slots_[place];
            bool const holds_motor = nodes_[own.unit]->law.has_order_of(place);
            own.is_paused = own.has_told and not own.asks_again and not holds_motor and chance_.below(2) == 0;
            if (own.is_paused) {
                counts_.note(event::not_visited_for_a_while);
                said_.say("place %zu is not visited for a while", place);
            }
        }
    }

    // The last part.

    void end()
    {
        said_.now = now_;
        said_.say("the last part: %u", static_cast<unsigned>(how_.end));
        switch (how_.end) {
        case last_part::controller_dies: die(); break;
        case last_part::each_is_stopped: stop_each(); break;
        case last_part::everyone_is_stopped:
            restore_all();
            base::stop_all();
            break;
        case last_part::answers_get_lost: lose_all(false); break;
        case last_part::requests_get_lost: lose_all(true); break;
        case last_part::motors_are_left: return leave_motors();
        case last_part::goes_on:
        case last_part::count: break;
        }
        base::pass(how_.end == last_part::goes_on ? 1'000'000 : longest_end());
    }

    /// Until every motor has to be without power: where the line is good its ramp is enough.
    moment longest_end() const
    {
        bool const is_good = how_.end == last_part::each_is_stopped or how_.end == last_part::everyone_is_stopped;
        moment longest = 0;
        for (std::size_t i = 0; i < nodes_.size(); ++i) {
            longest = std::max<moment>(longest, is_good ? 0 : how_.drive[i].time_out_us());
        }
        return longest + (is_good ? 6'000'000 : 9'000'000);
    }

    void die()
    {
        is_dead_ = true;
        for (auto const& each : nodes_) {
            each->law.note_death(now_);
            if (each->law.has_power()) {
                counts_.note(event::controller_died_while_it_ran);
            }
        }
    }

    void restore_all()
    {
        for (std::size_t i = 0; i < nodes_.size(); ++i) {
            restore(*nodes_[i], i);
        }
    }

    void stop_each()
    {
        restore_all();
        for (std::size_t i = 0; i < nodes_.size(); ++i) {
            base::begin_stop(i, i, base::any_way());
        }
    }

    /// The user runs each motor, then gives up what holds it, or does not, and goes on reading.
    void leave_motors()
    {
        restore_all();
        for (std::size_t i = 0; i < how_.drives; ++i) {
            chance_.below(2) == 0 ? base::begin_cycle(2 * i, i) : base::begin_start(2 * i, i);
        }
        base::pass(2'000'000);
        for (std::size_t i = 0; i < how_.drives; ++i) {
            base::run_in(2 * i);
        }
        base::pass(1'000'000 + chance_.below(2'000'000));
        std::uint32_t const drawn = chance_.below(12);
        std::uint32_t const way = drawn < 8 ? drawn : 2 + drawn % 2; // the others are the rarest to hit
        if (way == 0) {
            give_up_everyone();
        } else if (way == 1) {
            free_everyone();
        } else if (way == 2) {
            return stop_others();
        } else if (way == 3) {
            sleep_under_second_starts();
        }
        bool is_watched = false;
        for (std::size_t i = 0; i < how_.drives; ++i) {
            is_watched = give_up(i, way < 4 ? 3 : chance_.below(3)) or is_watched;
        }
        read_on(is_watched);
    }

    /// Everyone is stopped, or all but the last one, while each answers somebody who reads on.
    void stop_others()
    {
        counts_.note(event::others_stopped_beside_a_poll);
        for (std::size_t i = 0; i < how_.drives; ++i) {
            base::begin_poll(2 * i + 1, i);
            slots_[2 * i + 1].asks_again = true;
            if (chance_.below(2) == 0) {
                base::give_up_for_good(2 * i); // who runs it by now
            }
        }
        how_.in_parts_in_a_million = chance_.below(2) == 0 ? 300'000 : how_.in_parts_in_a_million;
        note_lines();
        base::pass(chance_.below(50'000));
        pass_until_it_asks();
        base::stop_all();
        if (chance_.below(2) == 0) {
            base::pass(1);
            base::destroy_everyone();
            base::release(0, true);
        }
        read_on(false);
    }

    /// A request has left, and no pass of the program has come behind it.
    void pass_until_it_asks()
    {
        for (moment const end = now_ + 50'000; now_ < end and not base::awaits_response() and not wrong_;) {
            base::pass(100);
        }
    }

    void note_lines()
    {
        for (std::size_t i = 0; i < nodes_.size(); ++i) {
            base::note_line(i);
        }
    }

    /// A second start of each is under way when the program sleeps, for longer than that may take, or not; and for longer than
    /// the first drive's time-out since that was asked before, or not.
    void sleep_under_second_starts()
    {
        auto const time_out = static_cast<std::uint32_t>(how_.drive[0].time_out_us());
        bool const is_by_time_out = chance_.below(2) == 0;
        base::pass(is_by_time_out ? chance_.below(time_out) : 0);
        for (std::size_t i = 0; i < how_.drives; ++i) {
            base::begin_start(2 * i + 1, i);
        }
        chance_.below(2) == 0 ? base::pass(chance_.below(300'000)) : pass_until_it_asks();
        counts_.note(event::slept_under_a_start);
        base::sleep(1'000'000 + chance_.below(is_by_time_out ? time_out : 6'000'000));
        base::pass(500'000);
    }

    void give_up_everyone()
    {
        counts_.note(event::stop_of_everyone_given_up);
        base::stop_all();
        base::pass(before_it_is_given_up());
        base::destroy_everyone();
        release_soon(0);
    }

    void free_everyone()
    {
        constexpr std::size_t place = 1;
        base::begin_freewheel(place, 0);
        for (std::size_t i = 0; i < nodes_.size(); ++i) {
            node& own = *nodes_[i];
            own.misses_broadcast = chance_.below(2) == 0;
            if (own.misses_broadcast and own.law.has_power()) {
                counts_.note(event::freed_unheard);
                said_.say("drive %u will not hear it", how_.drive[i].address);
            }
        }
        for (unsigned passes = 0; passes < 100 and not slots_[place].has_told; ++passes) {
            base::pass(50'000);
        }
        for (auto const& each : nodes_) {
            each->misses_broadcast = false;
        }
    }

    /// Half of them within 5 ms: most of these have not sent a word.
    moment before_it_is_given_up() { return 1 + chance_.below(chance_.below(2) == 0 ? 200'000 : 5'000); }

    /// Before a stop that was given up counts as that.
    void release_soon(std::size_t unit)
    {
        if (chance_.below(2) == 0) {
            counts_.note(event::released_at_once);
            base::pass(chance_.below(400'000));
            base::release(unit);
        }
    }

    /// In one of three ways, or behind all of them. Whether an order goes on.
    bool give_up(std::size_t unit, std::uint32_t way)
    {
        std::size_t const place = 2 * unit;
        std::size_t const other = place + 1;
        if (way == 0) { // a stop beside it
            counts_.note(event::stop_given_up);
            base::begin_stop(other, unit, base::any_way());
            base::pass(before_it_is_given_up());
            base::stay_away_or_destroy(other);
            release_soon(unit);
        } else if (way == 1 and base::stops_in(place)) {
            counts_.note(event::cycle_given_up);
            base::pass(1 + chance_.below(200'000));
            base::stay_away_or_destroy(place);
        }
        base::begin_poll(other, unit);
        slots_[other].asks_again = true;
        if (way == 2) {
            slots_[other].pace = base::any_pace(unit);
            how_.late_in_a_million = 200'000;
            nodes_[unit]->lost.in_a_million = chance_.below(2) == 0 ? 100'000 : 0;
            base::note_line(unit);
        }
        return way == 2;
    }

    /// Until the motors stand, or have to.
    void read_on(bool is_rare)
    {
        moment longest = 0;
        for (std::size_t i = 0; i < how_.drives; ++i) {
            longest = std::max<moment>(longest, how_.drive[i].time_out_us());
        }
        moment const end = now_ + (is_rare ? 8 : 1) * longest + 16'000'000;
        bool has_power = true;
        bool const orders_anew = chance_.below(2) == 0;
        while (now_ < end and not wrong_ and has_power) {
            base::pass(100'000);
            has_power = false;
            for (std::size_t i = 0; i < how_.drives; ++i) {
                has_power = has_power or nodes_[i]->law.has_power();
                if (orders_anew and nodes_[i]->law.is_left() and nodes_[i]->law.has_power() and
                    chance_.below(30) == 0) {
                    base::order_and_leave(2 * i, i);
                }
            }
        }
    }

    void lose_all(bool are_requests)
    {
        for (std::size_t i = 0; i < nodes_.size(); ++i) {
            nodes_[i]->lost = {};
            nodes_[i]->lost.requests = are_requests;
            nodes_[i]->lost.answers = not are_requests;
            base::note_line(i);
            counts_.note(are_requests ? event::requests_lost : event::answers_lost);
        }
    }
};

} // namespace rtuwire::lives
