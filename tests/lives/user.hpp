// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// What the user of a life does, by chance.
#pragma once

#include "lives/life.hpp"

namespace rtuwire::lives {

template <typename Link> class user : public life<Link> {
    using base = life<Link>;

protected:
    using base::at;
    using base::chance_;
    using base::counts_;
    using base::everyone_;
    using base::habits_;
    using base::how_;
    using base::link_;
    using base::nodes_;
    using base::now_;
    using base::said_;
    using base::slots_;

public:
    using base::base;

    void act()
    {
        std::size_t const place = chance_.below(slots);
        std::size_t const unit = chance_.below(static_cast<std::uint32_t>(how_.drives));
        switch (chance_.below(29)) {
        case 24:
        case 25:
        case 26:
        case 27: return use_again(place);
        case 28: return begin_freewheel(place, unit);
        case 0:
        case 1:
        case 2:
        case 3: return begin_start(place, unit);
        case 4: return begin_direct_start(place, unit);
        case 5:
        case 6:
        case 7: return begin_stop(place, unit, any_way());
        case 8:
        case 9: return begin_cycle(place, unit);
        case 10:
        case 11:
        case 12:
        case 13: return use_a_cycle();
        case 14: return change(place, unit);
        case 15:
        case 16: return reset(place, unit);
        case 17:
        case 18: return begin_poll(place, unit);
        case 19: return save_or_configure(place, unit);
        case 20: stop_all(); return habits_.below(3) == 0 ? stop_all_beside() : void();
        case 21: return cancel(place);
        case 22: return destroy(place);
        default: return stay_away_or_release(place, unit);
        }
    }

protected:
    drive_setting const& set_of(std::size_t unit) const { return how_.drive[unit]; }
    judge& law_of(std::size_t unit) { return nodes_[unit]->law; }

    asked_motion any_reference()
    {
        bool const is_reverse = chance_.below(2) == 0;
        if (chance_.below(12) == 0) {
            counts_.note(event::asked_beyond_limits);
            return {highest_half_hertz + 1 + static_cast<int>(chance_.below(20)), is_reverse};
        }
        return {chance_.below(3) == 0 ? 0 : static_cast<int>(chance_.below(101)), is_reverse};
    }
    /// For a printed life; the sign of 0, too.
    static double hertz(asked_motion asked) { return (asked.is_reverse ? -1 : 1) * (asked.half_hertz / 2.0); }
    a::stop_by any_way() { return static_cast<a::stop_by>(chance_.below(5)); }
    duration any_limit() { return milliseconds(chance_.below(3) == 0 ? 300U + chance_.below(2'000) : 30'000U); }

    /// What was in a place before is gone. What nobody ends any more, nobody has to.
    void give_up(std::size_t place)
    {
        slot& own = slots_[place];
        bool const was_there = own.what.index() != 0;
        if (own.is_away) {
            return counts_.note(event::destroyed);
        }
        bool is_over = own.has_told;
        if (std::holds_alternative<freewheel>(own.what) and not is_over) {
            for (auto const& each : nodes_) {
                each->law.note_word_given_up();
            }
        }
        bool is_commanding = true;
        std::visit(
            [&](auto& what) {
                using type = std::decay_t<decltype(what)>;
                is_commanding = is_start<type> or is_cyclic<type> or std::is_same_v<type, a::stop>;
            },
            own.what);
        law_of(own.unit).note_given_up(place, now_, is_commanding and not is_over, own.is_visited);
        if (was_there) {
            counts_.note(event::destroyed);
        }
    }

    /// Makes a conversation where another one was.
    template <typename Conversation> Conversation& put(std::size_t place, std::size_t unit, Conversation const& made)
    {
        give_up(place);
        slot& own = slots_[place];
        if (own.what.index() != 0) {
            counts_.note(event::made_anew_in_its_place);
        }
        for (std::size_t i = 0; i < slots; ++i) {
            if (i != place and slots_[i].what.index() != 0 and slots_[i].unit == unit) {
                counts_.note(event::two_for_one_unit);
                break;
            }
        }
        if (not std::is_same_v<Conversation, poll>) {
            law_of(unit).note_company(place);
        }
        auto& what = own.what.template emplace<Conversation>(made);
        own.unit = unit;
        own.began = now_;
        own.has_told = false;
        own.is_away = own.is_paused = false;
        own.asks_again = false;
        own.is_visited = false;
        own.pace = own.due = 0;
        said_.now = now_;
        return what;
    }

    static bool looks_at_state(conversation const& what)
    {
        return std::visit(
            [](auto const& it) {
                using type = std::decay_t<decltype(it)>;
                return not std::is_same_v<type, poll>;
            },
            what);
    }

    /// An order to run. Changes of the reference that are under way may come behind it.
    void note_order(std::size_t place, asked_motion asked, bool is_by_cycle, bool goes_on = false)
    {
        std::size_t const unit = slots_[place].unit;
        bool is_alone = std::none_of(everyone_.begin(), everyone_.end(), [](slot_of_everyone const& each) {
            return each.what.index() != 0 and not each.has_told;
        });
        for (std::size_t i = 0; i < slots; ++i) {
            slot const& each = slots_[i];
            bool const is_other = i != place and each.unit == unit and each.what.index() != 0;
            is_alone = is_alone and not(is_other and looks_at_state(each.what));
        }
        law_of(unit).note_order(place, now_, asked.half_hertz * 500, asked.is_reverse, is_by_cycle, is_alone, goes_on);
        for (slot const& each : slots_) {
            if (each.unit == unit and std::holds_alternative<a::change_reference>(each.what)) {
                law_of(unit).note_change(each.asked.half_hertz * 500, each.asked.is_reverse);
            }
        }
    }

    void begin_start(std::size_t place, std::size_t unit)
    {
        asked_motion const asked = any_reference();
        counts_.note(event::started);
        duration const limit = milliseconds(500 + chance_.below(3'000));
        with_device(set_of(unit).called,
                    [&]<typename Device>(Device) { put(place, unit, make_start<Device>(set_of(unit), asked, limit)); });
        said_.say("start in place %zu: drive %u at %.1f Hz", place, set_of(unit).address, hertz(asked));
        slots_[place].asked = asked;
        note_order(place, asked, false);
    }

    void begin_direct_start(std::size_t place, std::size_t unit)
    {
        if (set_of(unit).which != model::atv28) {
            return begin_start(place, unit);
        }
        asked_motion asked = any_reference();
        asked.is_reverse = asked.is_reverse and asked.half_hertz != 0; // it takes no direction but the sign
        counts_.note(event::started_directly);
        put(place, unit,
            a::atv28::direct_start{station_of<a::atv28::device>(set_of(unit)), reference_of<a::atv28::device>(asked),
                                   milliseconds(3'000), risks_of(set_of(unit))});
        said_.say("direct start in place %zu: drive %u at %.1f Hz", place, set_of(unit).address, hertz(asked));
        slots_[place].asked = asked;
        note_order(place, asked, false);
    }

    void count_stop(a::stop_by how)
    {
        switch (how) {
        case a::stop_by::ramp: return counts_.note(event::stopped_by_ramp);
        case a::stop_by::freewheel: return counts_.note(event::stopped_by_freewheel);
        case a::stop_by::quick_stop: return counts_.note(event::stopped_by_quick_stop);
        case a::stop_by::halt: return counts_.note(event::stopped_by_halt);
        case a::stop_by::dc_injection: return counts_.note(event::stopped_by_dc_injection);
        }
    }

    void begin_stop(std::size_t place, std::size_t unit, a::stop_by how)
    {
        count_stop(how); // one that the drive does not have becomes the ramp
        bool const is_halt = how == a::stop_by::halt and nodes_[unit]->drive->profile().halt != 0;
        auto const begin = chance_.below(2) == 0 ? a::stop_begin::at_once : a::stop_begin::look_first;
        with_device(set_of(unit).called, [&]<typename Device>(Device) {
            put(place, unit, a::stop{station_of<Device>(set_of(unit)), how, any_limit(), begin});
        });
        slots_[place].is_halt = is_halt;
        said_.say("stop in place %zu: drive %u, way %d", place, set_of(unit).address, static_cast<int>(how));
        law_of(unit).note_stop(place, now_, is_halt);
        law_of(unit).note_word_due(now_);
    }

    /// One broadcast to all drives that have their control word where this one has it.
    void begin_freewheel(std::size_t place, std::size_t unit)
    {
        counts_.note(event::freed_everyone);
        with_device(set_of(unit).called,
                    [&]<typename Device>(Device) { put(place, unit, a::broadcast_freewheel<Device>()); });
        said_.say("all motors are freed from place %zu", place);
        for (auto const& each : nodes_) {
            each->law.note_word_due(now_);
        }
    }

    /// One that has ended begins anew; what orders is a new order, and a stop stops again.
    void use_again(std::size_t place)
    {
        slot& own = slots_[place];
        if (own.has_told and not own.is_away) {
            std::visit([&](auto& what) { begin_anew(place, own, what); }, own.what);
        }
    }
    template <typename Conversation> void begin_anew(std::size_t place, slot& own, Conversation& what)
    {
        constexpr bool is_used = is_start<Conversation> or std::is_same_v<Conversation, a::stop> or
                                 std::is_same_v<Conversation, a::change_reference> or
                                 std::is_same_v<Conversation, a::reset_fault>;
        if constexpr (is_used) {
            counts_.note(event::used_again);
            said_.now = now_;
            said_.say("place %zu is used again", place);
            what.again();
            if (chance_.below(3) == 0) { // twice in one pass is once
                what.again();
            }
            own.has_told = own.is_visited = own.is_paused = false;
            own.began = now_;
            law_of(own.unit).note_company(place);
        }
        if constexpr (is_start<Conversation>) {
            law_of(own.unit).note_given_up(place, now_, false, false); // the motor may run by the order before
            note_order(place, own.asked, false);
        } else if constexpr (std::is_same_v<Conversation, a::stop>) {
            law_of(own.unit).note_stop(place, now_, own.is_halt);
            law_of(own.unit).note_word_due(now_);
        } else if constexpr (std::is_same_v<Conversation, a::change_reference>) {
            law_of(own.unit).note_change(own.asked.half_hertz * 500, own.asked.is_reverse);
        }
    }

    void begin_cycle(std::size_t place, std::size_t unit)
    {
        counts_.note(event::cycle_begun);
        with_device(set_of(unit).called,
                    [&]<typename Device>(Device) { put(place, unit, make_cycle<Device>(set_of(unit), chance_)); });
        said_.say("cycle in place %zu: drive %u", place, set_of(unit).address);
    }

    /// Something for a cycle that there is; else there is one.
    void use_a_cycle()
    {
        std::size_t const first = chance_.below(slots);
        for (std::size_t i = 0; i < slots; ++i) {
            std::size_t const place = (first + i) % slots;
            bool is_used = false;
            if (slots_[place].is_away) {
                continue;
            }
            std::visit([&](auto& what) { is_used = use(place, what); }, slots_[place].what);
            if (is_used) {
                return;
            }
        }
        begin_cycle(first, chance_.below(static_cast<std::uint32_t>(how_.drives)));
    }

    template <typename Conversation> bool use(std::size_t, Conversation&) { return false; }
    template <typename Device> bool use(std::size_t place, a::cyclic<Device>& loop)
    {
        said_.now = now_;
        switch (chance_.below(8)) {
        case 0:
            counts_.note(event::cycle_reset_a_fault);
            loop.reset_fault();
            break;
        case 1:
        case 2: stop_cycle(place, loop, any_way()); break;
        default: run(place, loop); break;
        }
        return true;
    }

    template <typename Device> void run(std::size_t place, a::cyclic<Device>& loop)
    {
        asked_motion const asked = any_reference();
        bool const was_ordered = loop.control().is_ordered();
        bool const is_taken = run_cycle<Device>(loop, asked);
        said_.say("run in place %zu: %.1f Hz, taken %d", place, hertz(asked), int{is_taken});
        counts_.note(is_taken ? event::cycle_ran : event::cycle_refused_to_run);
        if (is_taken and asked.half_hertz > highest_half_hertz) {
            base::accuse(breach::beyond_limits, slots_[place].unit);
        }
        if (is_taken) {
            note_order(place, asked, true, was_ordered);
        }
    }

    template <typename Device> void stop_cycle(std::size_t place, a::cyclic<Device>& loop, a::stop_by how)
    {
        counts_.note(event::cycle_stopped);
        bool const is_halt = how == a::stop_by::halt and Device::layout.halt != 0;
        said_.say("stop of the cycle in place %zu, way %d", place, static_cast<int>(how));
        loop.stop(how);
        law_of(slots_[place].unit).note_stop(place, now_, is_halt, true);
    }

    void change(std::size_t place, std::size_t unit)
    {
        asked_motion const asked = any_reference();
        counts_.note(event::reference_changed);
        with_device(set_of(unit).called, [&]<typename Device>(Device) {
            put(place, unit,
                a::change_reference{station_of<Device>(set_of(unit)), reference_of<Device>(asked), any_limit()});
        });
        said_.say("change in place %zu: drive %u to %.1f Hz", place, set_of(unit).address, hertz(asked));
        slots_[place].asked = asked;
        law_of(unit).note_change(asked.half_hertz * 500, asked.is_reverse);
    }

    void reset(std::size_t place, std::size_t unit)
    {
        counts_.note(event::fault_reset);
        if (chance_.below(2) == 0) {
            nodes_[unit]->drive->clear_cause();
            counts_.note(event::cause_gone);
        }
        with_device(set_of(unit).called, [&]<typename Device>(Device) {
            put(place, unit, a::reset_fault{station_of<Device>(set_of(unit))});
        });
        said_.say("fault reset in place %zu: drive %u", place, set_of(unit).address);
    }

    void begin_poll(std::size_t place, std::size_t unit)
    {
        counts_.note(event::polled);
        altivar::drive_layout const& profile = nodes_[unit]->drive->profile();
        std::uint16_t const what = chance_.below(2) == 0 ? profile.rfr : profile.lft;
        put(place, unit, poll{*unit_id::checked(set_of(unit).address), read_holding_registers{what, 1}});
        slots_[place].asks_again = chance_.below(3) != 0;
        if (chance_.below(4) == 0) {
            slots_[place].pace = any_pace(unit);
        }
        said_.say("poll in place %zu: drive %u", place, set_of(unit).address);
    }

    /// Up to what keeps the drive's watchdog just fed.
    moment any_pace(std::size_t unit)
    {
        counts_.note(event::polled_rarely);
        moment const most = set_of(unit).time_out_us() * 98 / 100;
        moment const margin = how_.options.response_timeout.microseconds + how_.options.late_response.microseconds;
        return most - chance_.below(static_cast<std::uint32_t>(std::min(most, margin)));
    }

    void save_or_configure(std::size_t place, std::size_t unit)
    {
        said_.now = now_;
        said_.say("save or scanner in place %zu: drive %u", place, set_of(unit).address);
        if (set_of(unit).called == model::atv320 and chance_.below(2) == 0) {
            counts_.note(event::scanner_configured);
            put(place, unit, scanner_of_atv320{station_of<a::atv320::device>(set_of(unit))});
        } else if (set_of(unit).called == model::atv12 and chance_.below(2) == 0) {
            counts_.note(event::scanner_configured);
            put(place, unit, scanner_of_atv12{station_of<a::atv12::device>(set_of(unit))});
        } else {
            counts_.note(event::saved);
            with_device(set_of(unit).called, [&]<typename Device>(Device) {
                put(place, unit, a::save_to_eeprom{station_of<Device>(set_of(unit))});
            });
        }
    }

    void stop_all() { begin_stop_of_all(0, chance_); }

    /// Another part of the program stops everyone beside it.
    void stop_all_beside()
    {
        base::pass(habits_.below(habits_.below(2) == 0 ? 20'000 : 800'000));
        begin_stop_of_all(1, habits_);
        counts_.note(event::stopped_everyone_twice);
    }

    void begin_stop_of_all(std::size_t which, detail::random_source& chance)
    {
        slot_of_everyone& own = everyone_[which];
        std::size_t const place = slots + which;
        own = {};
        own.stays = habits_.below(2) == 0;
        own.is_last = not base::has_slots and habits_.below(4) == 0; // else before all others, as it is to be visited
        counts_.note(event::stopped_everyone);
        a::broadcast_stop_options const options{.freewheel = chance.below(2) == 0,
                                                .cuts_short = chance.below(4) == 0,
                                                .left_out = any_left_out(),
                                                .last_after = milliseconds(which != 0 ? 20U
                                                                           : habits_.below(3) == 0
                                                                               ? 2'000U
                                                                               : 400U)}; // the later one may end first
        // A drive that this controller did not order nobody stops who does not name it.
        bool const is_one_left_out = how_.drives == 2 and law_of(1).is_ordered() and chance.below(2) == 0;
        own.is_left_out = is_one_left_out;
        if (is_one_left_out) {
            counts_.note(event::left_out_of_a_stop_of_everyone);
        }
        with_device(set_of(0).called, [&]<typename First>(First) {
            auto const first = station_of<First>(set_of(0));
            if (how_.drives == 1 or is_one_left_out) {
                own.what.template emplace<a::broadcast_stop<1>>(options, first);
            } else {
                with_device(set_of(1).called, [&]<typename Second>(Second) {
                    own.what.template emplace<a::broadcast_stop<2>>(options, first, station_of<Second>(set_of(1)));
                });
            }
        });
        said_.now = now_;
        said_.say("stop of everyone");
        for (std::size_t i = 0; i < how_.drives; ++i) {
            is_one_left_out and i == 1 ? law_of(i).note_left_out(place, now_) : law_of(i).note_stop(place, now_, false);
        }
    }

    /// Mostly none.
    std::uint16_t any_left_out()
    {
        std::uint32_t const one = habits_.below(8);
        return one < nodes_.size() ? nodes_[one]->drive->profile().cmd : std::uint16_t{0};
    }

    void destroy_everyone()
    {
        for (std::size_t which = 0; which < everyone_.size(); ++which) {
            bool const is_under_way = everyone_[which].what.index() != 0 and not everyone_[which].has_told;
            everyone_[which] = {};
            for (std::size_t i = 0; is_under_way and i < how_.drives; ++i) {
                law_of(i).note_left(slots + which, now_);
            }
        }
    }

    /// Orders the cycle in a place to run.
    void run_in(std::size_t place)
    {
        std::visit(
            [&](auto& what) {
                if constexpr (is_cyclic<std::decay_t<decltype(what)>>) {
                    run(place, what);
                }
            },
            slots_[place].what);
    }
    /// Stops the cycle in a place; whether there is one.
    bool stops_in(std::size_t place)
    {
        return std::visit(
            [&](auto& what) {
                constexpr bool is_one = is_cyclic<std::decay_t<decltype(what)>>;
                if constexpr (is_one) {
                    stop_cycle(place, what, any_way());
                }
                return is_one;
            },
            slots_[place].what);
    }
    void stay_away_or_destroy(std::size_t place) { chance_.below(2) == 0 ? give_up_for_good(place) : destroy(place); }

    /// Orders anew, and gives that up before its word has left.
    void order_and_leave(std::size_t place, std::size_t unit)
    {
        counts_.note(event::ordered_and_left);
        begin_start(place, unit);
        base::pass(1 + chance_.below(20'000));
        give_up_for_good(place);
    }

    void cancel(std::size_t place)
    {
        counts_.note(event::cancelled);
        said_.now = now_;
        bool const is_all = chance_.below(2) == 0;
        said_.say(is_all ? "cancel" : "cancel of place %zu", place);
        if (is_all) {
            link_.cancel(at());
        } else {
            std::visit(
                [&](auto& what) {
                    if constexpr (not std::is_same_v<std::decay_t<decltype(what)>, std::monostate>) {
                        this->link_.cancel(what, this->at());
                    }
                },
                slots_[place].what);
        }
        for (auto const& each : nodes_) {
            each->law.note_cancel();
        }
    }

    void destroy(std::size_t place)
    {
        give_up(place);
        said_.now = now_;
        said_.say("place %zu is empty", place);
        slots_[place].what.template emplace<std::monostate>();
    }

    void stay_away_or_release(std::size_t place, std::size_t unit)
    {
        said_.now = now_;
        if (chance_.below(2) == 0) {
            counts_.note(event::stayed_away);
            said_.say("place %zu stays away", place);
            return give_up_for_good(place);
        }
        counts_.note(event::released);
        release(unit);
    }

    void release(std::size_t unit) { release(unit, chance_.below(4) == 0); }
    void release(std::size_t unit, bool is_all)
    {
        said_.now = now_;
        said_.say(is_all ? "all drives are released" : "drive %u is released", set_of(unit).address);
        if constexpr (base::has_slots) {
            is_all ? link_.release_all() : link_.release(*unit_id::checked(set_of(unit).address));
        } else {
            is_all ? link_.motor_orders().release_all() : link_.motor_orders().release(set_of(unit).address);
        }
    }

    /// Nobody calls for it any more.
    void give_up_for_good(std::size_t place)
    {
        give_up(place);
        slots_[place].is_away = true;
    }
};

} // namespace rtuwire::lives
