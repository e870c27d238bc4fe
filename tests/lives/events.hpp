// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// What happens in the lives, and what may be wrong with one: both are counted, by name.
#pragma once

#include <array>
#include <cstddef>

namespace rtuwire::lives {

/// What the user does, what becomes of the line, and what happens at the drives.
enum class event : unsigned {
    started,
    started_directly,
    stopped_by_ramp,
    stopped_by_freewheel,
    stopped_by_quick_stop,
    stopped_by_halt,
    stopped_by_dc_injection,
    stopped_everyone,
    stopped_everyone_twice,
    freed_everyone,
    cycle_begun,
    cycle_ran,
    cycle_refused_to_run,
    cycle_stopped,
    cycle_reset_a_fault,
    reference_changed,
    fault_reset,
    polled,
    saved,
    scanner_configured,
    cancelled,
    destroyed,
    made_anew_in_its_place,
    two_for_one_unit,
    stayed_away,
    stop_given_up,
    stop_of_everyone_given_up,
    freed_unheard,
    cycle_given_up,
    start_over_by_itself,
    ordered_and_left,
    polled_rarely,
    released,
    released_at_once,
    used_again,
    visited_behind_its_end,
    visited_on,
    not_visited_for_a_while,
    asked_beyond_limits,
    left_out_of_a_stop_of_everyone,
    named_otherwise,
    requests_lost,
    answers_lost,
    both_directions_lost,
    frames_lost_by_chance,
    each_nth_frame_lost,
    one_frame_lost,
    line_restored,
    late_answers,
    fault,
    cause_gone,
    stop_key,
    local_control,
    remote_control,
    drive_power_cycle,
    controller_power_cycle,
    word_of_another_master,
    read_of_another_master,
    word_of_another_during_a_check,
    reference_of_another_during_a_start,
    power_cycle_between_frames,
    slept_briefly,
    slept_for_minutes,
    slept_while_a_cycle_ran,
    slept_under_a_start,
    others_stopped_beside_a_poll,
    stopped_what_is_used_again,
    clock_wrap,
    run_stop,
    port_reads_failed,
    port_writes_failed,
    program_stopped_in_a_call,
    motor_ran,
    motor_stopped_by_order,
    motor_stopped_by_its_timeout,
    unit_lost_while_it_ran,
    controller_died_while_it_ran,
    count,
};

inline constexpr std::size_t event_count = static_cast<std::size_t>(event::count);

inline constexpr std::array<char const*, event_count> event_names{
    "starts",
    "direct starts",
    "stops by ramp",
    "stops by freewheel",
    "stops by quick stop",
    "stops by halt",
    "stops by DC injection",
    "stops of everyone",
    "stops of everyone beside one that was under way",
    "broadcasts that free every motor",
    "cycles",
    "orders to a cycle",
    "orders that a cycle refused",
    "stops of a cycle",
    "fault resets of a cycle",
    "changes of a reference",
    "fault resets",
    "polls",
    "saves",
    "configurations of the scanner",
    "cancels",
    "conversations destroyed",
    "conversations made anew in the same place",
    "second conversations for one unit",
    "conversations that stayed away",
    "stops that were given up, and polls that went on",
    "stops of everyone that were given up, and polls that went on",
    "broadcasts that free every motor and that a drive which ran did not hear, and polls that went on",
    "cycles that were given up while they stopped, and polls that went on",
    "starts that were over by themselves",
    "orders anew that were given up before their word",
    "polls as rare as the drive's time-out",
    "units released from a stop that was given up",
    "units released right behind a stop that was given up",
    "conversations that had ended and were used again",
    "visits of conversations that had ended",
    "lives that went on for minutes",
    "pauses in the visits of a conversation that had ended",
    "references beyond a drive's limits",
    "stops of everyone that do not name a drive that was ordered",
    "drives in their I/O profile, under any name",
    "losses of the requests",
    "losses of the responses",
    "losses of both directions",
    "lines that lose frames by chance",
    "lines that lose each n-th frame",
    "lines that lose the n-th frame",
    "lines restored",
    "late responses",
    "faults",
    "causes of faults gone",
    "STOP keys",
    "changes to local control",
    "changes to remote control",
    "power cycles of a drive",
    "power cycles of the controller",
    "words of another master",
    "reads of another master",
    "words of another master while a cycle checked its drive",
    "references of another master right behind a response to a start",
    "power cycles right behind a response",
    "sleeps of the controller, for seconds",
    "sleeps of the controller, 1 to 110 minutes",
    "sleeps in which a cycle lost its order",
    "sleeps under a second start",
    "stops of everyone, or of all but one, beside polls that go on",
    "stops of a drive whose start, or other conversation, is used again and not visited",
    "wraps of the clock",
    "stops that a blocking client ran",
    "ports whose reads fail",
    "ports whose writes fail",
    "programs that are stopped in a call of their port",
    "motors that began to run",
    "motors that lost power by a frame",
    "motors that lost power by themselves",
    "units lost while their motor ran",
    "controllers that died while a motor ran",
};

/// What breaks the law.
enum class breach : unsigned {
    moved_without_order,
    enabled_without_order,
    enabled_otherwise,
    moved_by_itself,
    too_fast,
    power_after_stop,
    power_after_loss,
    power_after_death,
    left_to_reads,
    stood_not,
    ran_not,
    said_to_run,
    ran_otherwise,
    beyond_limits,
    stopped_late,
    deaf,
    waited_longer,
    ended_unsaid,
    enabled_while_all_stop,
    spoke_behind_its_end,
    count,
};

inline constexpr std::size_t breach_count = static_cast<std::size_t>(breach::count);

inline constexpr std::array<char const*, breach_count> breach_names{
    "a motor got power without an order since the last stop, fault, STOP key, local control or power cycle",
    "a word that enables left without an order in force",
    "a start sent its word that enables behind another master's reference",
    "a motor got power by no frame",
    "a motor turned faster or in another direction than was asked",
    "power too long after the order was taken away",
    "power too long after a loss",
    "power too long after the controller died",
    "power too long where nobody's order or stop held a motor that was read",
    "a stop that was done, and the motor had power",
    "a start that was done, and the motor never ran",
    "a start that says that the motor runs behind a stop that was done",
    "a start that was done, and the drive has another reference",
    "a reference beyond the drive's limits that was taken",
    "a stop whose word, and its look, were not sent at once",
    "a unit that hears and never responds",
    "a wait of a blocking client that lasted longer than a moment",
    "what had ended did not say so at its next visit",
    "a word that enables left while a stop of everyone was under way",
    "a frame left that nothing asked for which had not ended",
};

/// All that was counted.
struct tally {
    std::array<unsigned long, event_count> events{};
    std::array<unsigned long, breach_count> breaches{};
    unsigned long lives{0};
    unsigned long unsupervised{0}; ///< of these
    unsigned long frames{0};

    void note(event what) { ++events[static_cast<std::size_t>(what)]; }
    void note(breach what) { ++breaches[static_cast<std::size_t>(what)]; }
    unsigned long of(event what) const { return events[static_cast<std::size_t>(what)]; }
    unsigned long broken() const
    {
        unsigned long sum = 0;
        for (unsigned long const each : breaches) {
            sum += each;
        }
        return sum;
    }
};

} // namespace rtuwire::lives
