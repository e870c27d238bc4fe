// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// One life: a controller, its line and its drives, and time, which jumps from one thing that happens to the next.
#pragma once

#include <optional>
#include <utility>

#include "lives/conversations.hpp"
#include "lives/receiver.hpp"
#include "lives/wire.hpp"

#include <rtuwire/client/bus.hpp>

namespace rtuwire::lives {

using namespace detail;

inline constexpr std::size_t slots = places - most_stops_of_everyone;

using life_bus = bus<slots>;
using life_client = drive_client<slots>;

/// A conversation in its place.
struct slot {
    conversation what{};
    std::size_t unit{0};
    moment began{0};
    bool has_told{false}; ///< its end was looked at
    bool is_away{false};
    bool is_paused{false}; ///< it has ended, and is not visited for a while
    bool asks_again{false};
    bool is_visited{false}; ///< since it was made, or used again
    moment pace{0};         ///< of a poll, from one request to the next
    moment due{0};
    bool is_halt{false};
    asked_motion asked{}; ///< by a change of the reference
};

/// A stop of everyone in its place.
struct slot_of_everyone {
    everyone what{};
    bool is_left_out{false}; ///< a drive that was ordered
    bool has_told{false};    ///< its end was looked at
    bool stays{false};       ///< it is visited behind its end, too
    bool is_last{false};     ///< it is visited behind all others
    bool holds{false};       ///< it was visited, and has not ended
};

template <typename Link> class life {
public:
    static constexpr bool has_slots = std::is_same_v<Link, life_bus>;

    life(life_setting const& how, tally& counts, bool prints)
        : how_{how}, counts_{counts}, chance_{how.seed * 40'503U + 1U}, habits_{how.seed * 2'246'822'519U + 3U},
          link_{make_link()}, receiver_{how_, counts}, said_{prints}
    {
        for (std::size_t i = 0; i < how.drives; ++i) {
            nodes_.push_back(std::make_unique<node>(how_, how_.drive[i], at(), counts));
            note_line(i);
            if (how.drive[i].is_io) {
                counts.note(event::named_otherwise);
            }
        }
        pass(5'000);
    }

    /// Lets time pass.
    void pass(moment length)
    {
        moment const end = now_ + length;
        while (now_ < end and not wrong_) {
            step(end);
        }
    }

    /// The controller's program is not scheduled, and the drives live on; what they respond lies in its receiver.
    void sleep(moment length)
    {
        for (auto const& each : nodes_) {
            each->law.note_falling_asleep();
        }
        is_asleep_ = true;
        pass(length);
        is_asleep_ = false;
        receiver_.note_waking(now_);
        for (auto const& each : nodes_) {
            if (each->law.note_sleep(now_, length)) {
                counts_.note(event::slept_while_a_cycle_ran);
            }
        }
    }

protected:
    instant at() const { return instant{how_.start_count + static_cast<std::uint32_t>(now_)}; }
    node& of(slot const& own) { return *nodes_[own.unit]; }

    void accuse(std::optional<breach> wrong, std::size_t unit)
    {
        if (wrong and not wrong_) {
            wrong_ = wrong;
            said_.now = now_;
            said_.say("BREACH at drive %u: %s", unsigned(how_.drive[unit].address),
                      breach_names[static_cast<std::size_t>(*wrong)]);
        }
    }

    Link make_link() const { return Link{how_.timing(), how_.options}; }

    /// The line is good, or not, as far as the judge knows.
    void note_line(std::size_t unit)
    {
        node& own = *nodes_[unit];
        bool const is_good = how_.late_in_a_million == 0 and how_.in_parts_in_a_million == 0;
        own.law.note_line(own.lost.is_good() and is_good, now_);
    }

    void cycle_power(node& own)
    {
        said_.now = now_;
        said_.say("the drive is switched off and on");
        own.law.note_disturbance(now_, own.drive->state(), false);
        own.law.note_power_cycle(now_);
        own.law.note_own_response();
        own.drive->power_cycle(at());
        own.is_local = false;
        own.response_size = 0;
        own.drive->sent(at());
    }

    /// A frame of another master.
    void say_as_another(byte_view frame)
    {
        begin_as_another();
        occupy(frame);
        said_.frame("=>", frame, "  another master", nullptr);
        link_.receive(frame, at());
        for (auto const& each : nodes_) {
            if (not each->lost.requests) {
                bool const is_meant = frame[0] == std::byte{how_.drive[index_of(*each)].address};
                if (is_meant) {
                    each->law.note_foreign(frame, now_, each->drive->state());
                    each->owes_another = true;
                }
                each->drive->receive(frame, at());
            }
        }
    }

    /// Whether nobody owes a response, so that another master would speak.
    bool is_line_free() const
    {
        for (auto const& each : nodes_) {
            if (each->response_size != 0) {
                return false;
            }
        }
        bool const is_over = now_ > last_asked_ + how_.longest_lateness() + 70'000;
        return receiver_.is_empty() and (is_over or is_answered_);
    }

    bool awaits_response() const { return not is_answered_; }

    life_setting how_;
    tally& counts_;
    detail::random_source chance_;
    detail::random_source habits_; ///< of who visits what has ended
    Link link_;
    receiver receiver_;
    chronicle said_;
    std::vector<std::unique_ptr<node>> nodes_{};
    std::array<slot, slots> slots_{};
    std::array<slot_of_everyone, most_stops_of_everyone> everyone_{};
    std::optional<breach> wrong_{};
    moment now_{0};
    bool is_dead_{false};   ///< the controller
    bool is_asleep_{false}; ///< its program

private:
    std::size_t index_of(node const& which) const { return nodes_[0].get() == &which ? 0U : 1U; }
    moment time_of(std::size_t bytes) const { return bytes * 11'000'000ULL / how_.bits_per_second; }

    /// A frame passes, up to its last byte.
    void occupy(byte_view frame)
    {
        now_ += time_of(frame.size());
        said_.now = now_;
        quiet_since_ = now_;
    }

    /// Everybody keeps the silence before a frame: to who hears none two frames are one that is damaged.
    moment silent_at() const { return quiet_since_ + how_.timing().t3_5().microseconds; }

    /// Another master is the first to speak behind a frame, and it awaits a response.
    void begin_as_another()
    {
        now_ = std::max(now_, silent_at());
        for (auto const& each : nodes_) {
            each->drive->advance(at());
        }
        is_answered_ = false;
        last_asked_ = now_;
    }

    void step(moment end)
    {
        instant const now = at();
        said_.now = now_;
        for (std::size_t i = 0; i < nodes_.size(); ++i) {
            // A unit that stands sleeps by its deadline while nobody asks.
            bool const is_idle = is_asleep_ and how_.is_event_driven and not nodes_[i]->law.has_power() and
                                 nodes_[i]->response_size == 0;
            deadline const due = nodes_[i]->drive->poll_deadline();
            if (not is_idle or (due and reached(now, *due))) {
                nodes_[i]->drive->advance(now);
            }
            accuse(nodes_[i]->law.look(now_), i);
        }
        // Of who could begin at the same moment a drive is the first. The controller's request would collide with what it owes
        // another master, or make that look like the response to it: for that docs/what-stops-my-motor.md wants one master.
        bool is_moved = false;
        for (auto const& each : nodes_) {
            is_moved = response(*each) or is_moved;
        }
        is_moved = is_moved or visit(now);
        stalls_ = is_moved ? 0 : stalls_;
        if (not is_moved) {
            jump(end);
        }
    }

    /// A pass of the controller's program; whether it spoke.
    bool visit(instant now)
    {
        if (not is_awake()) {
            return false;
        }
        hear();
        for (auto const& each : nodes_) {
            each->law.note_visit();
        }
        link_.advance(now);
        converse(now);
        return ask();
    }

    void converse(instant now)
    {
        converse_with_everyone(false, now);
        for (std::size_t i = 0; i < slots; ++i) {
            std::visit([&](auto& what) { converse(i, what, now); }, slots_[i].what);
        }
        converse_with_everyone(true, now);
    }

    /// Whether a stop of everyone is under way, as the client knows.
    bool do_all_stop() const
    {
        return std::any_of(everyone_.begin(), everyone_.end(), [](slot_of_everyone const& each) { return each.holds; });
    }

    void converse_with_everyone(bool are_last, instant now)
    {
        for (slot_of_everyone& each : everyone_) {
            if (each.is_last == are_last) {
                std::visit([&](auto& all) { converse(each, all, now); }, each.what);
            }
            if (each.has_told and not each.stays) {
                each = {};
            }
        }
    }

    static void converse(slot_of_everyone&, std::monostate, instant) {}
    template <typename All> void converse(slot_of_everyone& own, All& all, instant now)
    {
        if constexpr (has_slots) {
            link_.run_urgent(all, now);
        } else {
            link_.converse(all, now);
        }
        own.holds = not all.settled();
        if (own.has_told) {
            hear_the_ended(all.reason(0).kind == a::outcome_kind::used_already and not all.succeeded(), 0);
        } else if (all.settled()) {
            own.has_told = true;
            everyone_is_told(own, all);
        }
    }

    template <typename All> void everyone_is_told(slot_of_everyone const& own, All& all)
    {
        for (std::size_t i = 0; i < nodes_.size(); ++i) {
            if (all.reason(i).kind == a::outcome_kind::succeeded or (all.succeeded() and own.is_left_out)) {
                accuse(nodes_[i]->law.told_to_stand(false), i);
            }
        }
    }

    /// What has ended was visited once more: it says so (L18).
    void hear_the_ended(bool says_so, std::size_t unit)
    {
        counts_.note(event::visited_behind_its_end);
        accuse(says_so ? std::nullopt : std::optional{breach::ended_unsaid}, unit);
    }

    void converse(std::size_t, std::monostate, instant) {}
    template <typename Conversation> void converse(std::size_t place, Conversation& what, instant now)
    {
        slot& own = slots_[place];
        if (own.is_away or own.is_paused) {
            return;
        }
        if constexpr (has_slots) {
            link_.converse(place, what, now);
        } else {
            link_.converse(what, now);
        }
        own.is_visited = true;
        if (own.has_told) {
            hear_the_ended(says_that_it_ended(what), own.unit);
        }
        hear(place, own, what);
    }

    template <typename Conversation> static bool says_that_it_ended(Conversation const& what)
    {
        if constexpr (is_cyclic<Conversation>) {
            return true; // it never ends
        } else if constexpr (std::is_base_of_v<finite_conversation, Conversation>) {
            return what.settled() and what.outcome().error() == errc::used_already;
        } else {
            return what.settled() and what.reason().kind == a::outcome_kind::used_already;
        }
    }

    /// What the user of a conversation is told.
    template <typename Conversation> void hear(std::size_t place, slot& own, Conversation& what)
    {
        judge& law = of(own).law;
        if constexpr (is_cyclic<Conversation>) {
            if (law.has_order_of(place) and not what.control().is_ordered()) {
                said_.say("the cycle in place %zu dropped its order: %d", place,
                          static_cast<int>(what.control().reason().kind));
                law.note_end_of_order(place, now_);
            }
        } else if constexpr (std::is_same_v<Conversation, poll>) {
            hear_poll(own, what);
        } else if constexpr (std::is_same_v<Conversation, freewheel>) {
            hear_freewheel(own, what);
        } else if (what.settled() and not own.has_told) {
            own.has_told = true;
            said_.say("place %zu is told: %d, error %d", place, static_cast<int>(what.reason().kind),
                      static_cast<int>(what.reason().error));
            hear_end(place, own, what);
        } else if constexpr (is_start<Conversation>) {
            if (own.has_told and law.has_order_of(place) and not what.running()) {
                counts_.note(event::start_over_by_itself);
                said_.say("the start in place %zu is over", place);
                end_order(place, law);
            }
        }
    }

    void hear_poll(slot& own, poll& what)
    {
        if (what.settled() and not own.has_told) {
            own.has_told = true;
            if (what.outcome()) {
                of(own).law.note_plain_response(now_);
            }
        }
        if (own.has_told and own.asks_again and now_ >= own.due) {
            own.has_told = false;
            own.due = now_ + own.pace;
            what.again();
        }
    }

    /// From its request on, which left since it began, no order counts that was given before.
    void hear_freewheel(slot& own, freewheel& what)
    {
        if (what.settled() and not own.has_told) {
            own.has_told = true;
            said_.say("the motors are freed: error %d", static_cast<int>(what.outcome().error()));
            for (auto const& each : nodes_) {
                what.outcome() ? each->law.note_freed(now_, own.began) : each->law.note_word_given_up();
            }
        }
    }

    /// The motor may run by it until another order changes that; else nobody's order holds it.
    void end_order(std::size_t place, judge& law)
    {
        law.outlives(place) ? law.note_given_up(place, now_, false, false) : law.note_order_over(place, now_);
    }

    template <typename Conversation> void hear_end(std::size_t place, slot& own, Conversation& what)
    {
        judge& law = of(own).law;
        bool const is_done = what.reason().kind == a::outcome_kind::succeeded;
        if constexpr (is_start<Conversation>) {
            if (not what.running()) {
                // The motor may run by it until another order, or a stop, changes that.
                bool const was_done = is_done or what.reason().kind == a::outcome_kind::reference_limited;
                was_done and law.outlives(place) ? law.note_given_up(place, now_, false, false)
                                                 : law.note_end_of_order(place, now_);
                return;
            }
            accuse(law.told_to_run(own.began), own.unit);
            accuse(own.asked.half_hertz > highest_half_hertz ? std::optional{breach::beyond_limits} : std::nullopt,
                   own.unit);
            accuse(law.told_reference(place, own.asked.signed_half_hertz() * 5, now_), own.unit);
        } else if constexpr (std::is_same_v<Conversation, a::stop>) {
            auto const how = what.reason().kind;
            bool const has_none = how == a::outcome_kind::overruled or how == a::outcome_kind::aborted or
                                  how == a::outcome_kind::no_place;
            accuse(law.told_of_a_stop(own.began, has_none), own.unit);
            if (is_done) {
                accuse(law.told_to_stand(own.is_halt), own.unit);
                look_for_runners(own);
            }
        } else if constexpr (std::is_same_v<Conversation, a::change_reference>) {
            if (is_done and own.asked.half_hertz > highest_half_hertz) {
                accuse(breach::beyond_limits, own.unit);
            }
        }
    }

    /// Behind a stop that is done no start of its unit runs that was told before.
    void look_for_runners(slot const& stopped)
    {
        for (slot& each : slots_) {
            std::visit(
                [&](auto& what) {
                    if constexpr (is_start<std::decay_t<decltype(what)>>) {
                        bool const is_meant = each.unit == stopped.unit and each.has_told and not each.is_away;
                        if (is_meant and each.began < stopped.began and what.running()) {
                            accuse(breach::said_to_run, each.unit);
                        }
                    }
                },
                each.what);
        }
    }

    /// Whether something that has not ended may ask a unit; 0: all of them.
    bool is_asked_for(std::uint8_t address) const
    {
        bool const by_everyone = std::any_of(everyone_.begin(), everyone_.end(), [](slot_of_everyone const& each) {
            return each.what.index() != 0 and not each.has_told;
        });
        return by_everyone or std::any_of(slots_.begin(), slots_.end(), [&](slot const& each) {
                   bool const frees_all = std::holds_alternative<freewheel>(each.what);
                   bool const is_meant = address == 0 ? frees_all : how_.drive[each.unit].address == address;
                   return is_meant and each.what.index() != 0 and not each.has_told and not each.is_away;
               });
    }

    /// The controller's frame, where it has one.
    bool ask()
    {
        byte_view const made = link_.poll_transmit();
        if (made.empty()) {
            return false;
        }
        std::array<std::byte, max_adu_size> copy{};
        byte_writer{copy}.bytes(made);
        byte_view const frame = byte_view{copy}.first(made.size());
        ++counts_.frames;
        occupy(frame);
        link_.sent(at());
        last_asked_ = now_;
        is_answered_ = frame[0] == std::byte{0};
        has_come_ = false;
        is_spoilt_ = true;
        if (not is_asked_for(to_u8(frame[0]))) {
            accuse(breach::spoke_behind_its_end, 0);
        }
        for (std::size_t i = 0; i < nodes_.size(); ++i) {
            node& each = *nodes_[i];
            bool const is_meant = frame[0] == std::byte{0} or frame[0] == std::byte{how_.drive[i].address};
            bool const is_missed = frame[0] == std::byte{0} and std::exchange(each.misses_broadcast, false);
            bool const is_lost = (is_meant ? each.loses(true, chance_) : each.lost.requests) or is_missed;
            auto const word = control_word_in(frame, each.drive->profile());
            if (is_meant and do_all_stop() and word and enables(*word, each.drive->profile())) {
                accuse(breach::enabled_while_all_stop, i);
            }
            if (is_meant) {
                said_.frame("->", frame, is_lost ? "  lost" : "", &each);
                accuse(each.law.note_request(frame, now_, not is_lost), i);
            }
            if (not is_lost) {
                each.drive->receive(frame, at());
            }
            if (is_meant) {
                each.owes_another = each.owes_another and is_lost;
                wait_for(each, frame, is_lost);
            }
        }
        return true;
    }

    /// Another master waits for a word to run; another write ends its waiting for its time to speak.
    void wait_for(node& own, byte_view frame, bool is_lost)
    {
        auto const word = control_word_in(frame, own.drive->profile());
        bool const enables_now = word and enables(*word, own.drive->profile()) and not is_lost;
        if (own.other.at == ambush::stage::waiting and enables_now and own.law.is_of_one_cycle()) {
            own.other = {ambush::stage::cutting, 1 + chance_.below(14), chance_.below(3) == 0};
        } else if (own.other.at == ambush::stage::counting and to_u8(frame[1]) != 3) {
            own.other = {};
        }
    }

    /// A response was heard or not; whether the other master has spoken behind it.
    void count_for(node& own, byte_view frame)
    {
        bool const is_due = own.other.at == ambush::stage::counting and to_u8(frame[1]) == 3 and --own.other.reads == 0;
        if (not is_due) {
            return;
        }
        bool const cuts_power = own.other.cuts_power;
        own.other = {};
        if (not own.law.is_of_one_cycle() or own.lost.requests or
            own.drive->state() != cia402::state::operation_enabled) {
            return;
        }
        counts_.note(event::word_of_another_during_a_check);
        if (cuts_power) {
            own.drive->power_cycle(at());
        }
        std::array<std::byte, 8> buffer{};
        static_cast<void>(encode_into(buffer, *unit_id::checked(how_.drive[index_of(own)].address),
                                      write_single_register{own.drive->profile().cmd, 6}));
        begin_as_another();
        occupy(buffer);
        said_.frame("=>", buffer, cuts_power ? "  another master, behind a power cycle" : "  another master", nullptr);
        link_.receive(buffer, at());
        own.law.note_ambush(now_);
        own.owes_another = true;
        for (auto const& each : nodes_) {
            each->drive->receive(buffer, at());
        }
    }

    /// A drive's answer, where it has one and it is time.
    bool response(node& own)
    {
        if (own.response_size == 0) {
            byte_view const made = own.drive->poll_transmit();
            if (made.empty()) {
                return false;
            }
            byte_writer{own.response}.bytes(made);
            own.response_size = made.size();
            own.status = own.drive->status();
            bool const is_late = not std::exchange(own.owes_another, false) and chance_.happens(how_.late_in_a_million);
            own.leaves_at = now_ + (is_late ? chance_.below(how_.longest_lateness()) : 0);
            if (is_late) {
                counts_.note(event::late_answers);
            }
        }
        if (now_ < std::max(own.leaves_at, silent_at())) {
            return false;
        }
        byte_view const frame = byte_view{own.response}.first(own.response_size);
        occupy(frame);
        own.drive->sent(at());
        bool const is_cut = own.other.at == ambush::stage::cutting;
        bool const is_lost = own.loses(false, chance_) or is_cut;
        own.other.at = is_cut ? ambush::stage::counting : own.other.at;
        said_.frame("  <-", frame, is_lost ? "  lost" : "", &own);
        if (not is_lost) {
            receiver_.take(index_of(own), own.status, frame, now_);
            hear();
        }
        for (auto const& each : nodes_) {
            if (each.get() != &own and not is_lost) {
                each->drive->receive(frame, at());
            }
        }
        own.response_size = 0;
        if (not is_lost and is_answered_ and receiver_.is_empty()) {
            count_for(own, frame);
        }
        own.law.note_own_response();
        if (own.cut_behind != 0 and --own.cut_behind == 0) {
            counts_.note(event::power_cycle_between_frames);
            cycle_power(own);
        }
        if (own.refer_behind != 0 and --own.refer_behind == 0 and receiver_.is_empty()) {
            counts_.note(event::reference_of_another_during_a_start);
            std::array<std::byte, 8> other{};
            static_cast<void>(encode_into(other, *unit_id::checked(how_.drive[index_of(own)].address),
                                          write_single_register{own.drive->frequency_reference(), 0xFE0C})); // -50 Hz
            say_as_another(other);
        }
        return true;
    }

    /// The program looks into its receiver. A response tells for sure what it says where it came whole, and nothing before it
    /// since the last request.
    void hear()
    {
        if (not is_awake() or now_ < receiver_.due()) {
            return;
        }
        auto const given = receiver_.give(now_);
        auto const bytes = receiver::bytes_of(given);
        if (given.size() != 1 or given[0].is_late or bytes.size() != given[0].response.size()) {
            said_.frame("  ..", bytes, "  are in the receiver", nullptr);
        }
        link_.receive(bytes, at());
        for (lump const& each : given) {
            is_spoilt_ = each.begin == 0 ? has_come_ : is_spoilt_;
            has_come_ = true;
            if (each.completes()) {
                judge& law = nodes_[each.unit]->law;
                bool const is_sure = each.begin == 0 and not is_spoilt_ and not each.is_late;
                is_sure ? law.note_response(each.response, now_, each.status)
                        : law.note_doubtful_response(now_, each.status);
                is_answered_ = true;
            }
        }
    }

    bool is_awake() const { return not is_dead_ and not is_asleep_; }

    void jump(moment end)
    {
        bool has_power = false;
        earliest next;
        if (is_awake()) {
            next.add(link_.poll_deadline());
            for (slot& each : slots_) {
                std::visit([&](auto& what) { add_to(next, each, what); }, each.what);
            }
            for (slot_of_everyone& each : everyone_) {
                std::visit([&](auto& all) { add_all_to(next, all); }, each.what);
            }
        }
        moment soon = is_awake() ? std::min(end, receiver_.due()) : end;
        for (slot const& each : slots_) {
            soon = is_awake() and each.has_told and each.due > now_ ? std::min(soon, each.due) : soon;
        }
        for (auto const& each : nodes_) {
            next.add(each->drive->poll_deadline());
            has_power = has_power or each->law.has_power();
            if (each->response_size != 0) {
                soon = std::min(soon, std::max(each->leaves_at, silent_at()));
            }
        }
        unsigned const at_rest = is_asleep_ ? 10'000'000U : 500'000U;
        unsigned const in_motion = is_asleep_ ? 500'000U : 50'000U;
        soon = std::min<moment>(soon, now_ + (has_power ? in_motion : at_rest));
        if (deadline const at_next = next; at_next) {
            bool const is_ahead = not reached(at(), *at_next);
            std::uint32_t const away = is_ahead ? (*at_next - at()).microseconds : 0;
            soon = std::min(soon, now_ + away);
        }
        if (soon <= now_) {
            ++stalls_;
            now_ += std::min<moment>(10ULL << std::min(stalls_, 7U), 1'000);
        } else {
            stalls_ = 0;
            now_ = soon;
        }
    }

    static void add_to(earliest&, slot&, std::monostate) {}
    template <typename Conversation> static void add_to(earliest& next, slot& own, Conversation& what)
    {
        if constexpr (timed_conversation<Conversation>) {
            if (not own.is_away and not own.is_paused) {
                next.add(what.poll_deadline());
            }
        }
    }
    static void add_all_to(earliest&, std::monostate) {}
    template <typename All> static void add_all_to(earliest& next, All& all) { next.add(all.poll_deadline()); }

    moment last_asked_{0};
    moment quiet_since_{0}; ///< the end of the last frame
    unsigned stalls_{0};
    bool is_answered_{true};
    bool has_come_{false};  ///< something to the receiver, since then
    bool is_spoilt_{false}; ///< what comes now: something else came before it
};

} // namespace rtuwire::lives
