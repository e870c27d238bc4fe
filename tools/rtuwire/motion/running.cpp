// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
#include "motion/running.hpp"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <utility>

#include <rtuwire/altivar/atv320.hpp>

#include "../support/emergency_stop.hpp"
#include "catalog/value_text.hpp"
#include "line/line_words.hpp"
#include "words/amount_words.hpp"

namespace tool {

namespace {

using rtuwire::altivar::outcome_kind;
using rtuwire::altivar::stop_by;
using rtuwire::cia402::state;
using std::chrono::milliseconds;
using std::chrono::seconds;

constexpr seconds longest_look{3};      ///< between two passes, before the drive's time-out was read
constexpr seconds longest_row{1};       ///< how old what is shown may be
constexpr milliseconds limit_seen{500}; ///< behind a new reference
constexpr seconds one_press{1};         ///< a key that is held repeats itself, and a hand that is hurried presses twice
constexpr seconds connect_limit{5};     ///< to the first exchange of words
constexpr seconds able_limit{5};        ///< to a drive that takes an order
constexpr seconds unreached_limit{3};   ///< the library sends words that stop for 2 s, and is silent then
constexpr seconds unfollowed_limit{30}; ///< in which the motor gets no slower

std::string words_of_kind(outcome_kind kind) { return std::string{std::string_view{name_of(kind)}}; }

/// What a setting has to be for an order. All drives that have the register have this word.
struct remedy {
    template <auto const& R>
    constexpr remedy(rtuwire::setting<R> value, bool may_turn) noexcept
        : code{R.code}, word{value.word()}, moves{may_turn}
    {}

    std::string_view code;
    std::uint16_t word;
    bool moves; ///< behind it a motor may turn
};

namespace atv320 = rtuwire::altivar::atv320;

constexpr std::array remedies{
    remedy{rtuwire::setting<atv320::sll>{atv320::link_lost_reaction::yes}, false},
    remedy{rtuwire::setting<atv320::cd1>{atv320::command_channel::mdb}, true},
    remedy{rtuwire::setting<atv320::fr1>{atv320::reference_channel::mdb}, true},
    remedy{rtuwire::setting<atv320::chcf>{atv320::channel_mode::sim}, true},
    remedy{rtuwire::setting<atv320::atr>{atv320::no_yes::no}, true},
};

/// With the limit that refused a reference.
std::string words_with_limit(rtuwire::altivar::reason const& why)
{
    return words_of_kind(why.kind) + (why.limit != 0 ? ", " + amount_text(why.limit, {1, 10}, "Hz") : std::string{});
}

} // namespace

running::running(std::unique_ptr<motor> which, asked_motion const& asked, any_port& port, rtuwire::unit_id unit,
                 drive_catalog const& drive, choices const& chosen)
    : motor_{std::move(which)}, port_{port}, unit_{unit}, drive_{drive}, display_{chosen.form, drive},
      must_end_{longest_look}, pause_{longest_row}, line_{chosen.line}, asked_{asked}
{
    if (chosen.last) {
        length_ = std::chrono::duration<double>{*chosen.last};
    }
}

running::~running() { emergency.stop_motor(); }

motion_end running::run()
{
    display_.show(motor_->sight());
    standard_output.finish(milliseconds{300});
    auto early = connect();
    if (not early) {
        early = order();
    }
    if (early) {
        emergency.disarm(); // it has no order
        display_.end(motor_->sight(), early->sentence);
        return *early;
    }
    motion_end end = keep_running();
    std::string const rest = stop(end);
    end.sentence += "; " + rest;
    display_.end(motor_->sight(), end.sentence);
    return end;
}

/// Ends where the port fails. False where something asks for an end; nothing is sent then.
bool running::pass()
{
    must_end_.look();
    if (must_end_) {
        return false;
    }
    go_on();
    return true;
}

/// One pass of the motor, and whether the program was paused since the last one: then nobody looked meanwhile.
bool running::go_on()
{
    if (not motor_->pass()) {
        throw ended{exit_status::port, port_.failure() + "; " + own_stop()};
    }
    bool const was_paused = pause_.is_too_long();
    if (was_paused) {
        motor_->note_pause();
    }
    display_.show(motor_->sight());
    return was_paused;
}

std::optional<motion_end> running::connect()
{
    auto const until = clock::now() + connect_limit;
    while (not motor_->sight().is_linked) {
        outcome_kind const why = motor_->reason().kind;
        bool const is_refused =
            why != outcome_kind::pending and why != outcome_kind::silent and why != outcome_kind::in_fault;
        if (is_refused or clock::now() > until) {
            return refusal_of_check();
        }
        if (not pass()) {
            return not_begun();
        }
    }
    rtuwire::duration const timeout = motor_->supervision().period.timeout;
    must_end_ = reason_to_end{to_chrono(timeout != rtuwire::duration{} ? timeout : drive_.layout.longest_silence) / 3};
    return std::nullopt;
}

motion_end running::refusal_of_check() const
{
    auto const& found = motor_->supervision();
    auto const why = motor_->reason();
    if (why.kind == outcome_kind::silent or why.kind == outcome_kind::pending) {
        return {exit_status::no_answer, "the drive does not answer"};
    }
    std::string sentence = "the motor is not started: " + words_of_kind(why.kind);
    if (why.error != rtuwire::errc::none) {
        sentence += ": " + words_of(why.error);
    }
    if (why.kind == outcome_kind::timeout_too_short) {
        sentence += " (" + std::to_string(found.period.timeout.microseconds / 1'000) +
                    " ms; it has to be three times " + std::to_string(found.period.longest_gap.microseconds / 1'000) +
                    " ms: a shorter --timeout helps)";
    } else if (why.kind == outcome_kind::unknown_register and found.word == 0) { // which stands for "not read", too
        register_entry const* const entry = drive_.at(found.address);
        sentence += " (no known value of " + (entry == nullptr ? "" : std::string{entry->code} + ", ") + "register " +
                    std::to_string(found.address) + ": this drive may have no such register, and --drive " +
                    std::string{drive_.name} + " may be wrong)";
    } else if (why.kind == outcome_kind::local_control) {
        sentence +=
            "; its keypad or its terminals command it, or a setting (FR1, CD1, FLO) has given it to another channel";
    } else if (register_entry const* const entry = found.finding == why.kind ? drive_.at(found.address) : nullptr) {
        sentence += " (" + std::string{entry->code} + " is " + full_text(*entry, found.word) + ")" +
                    remedy_for(why.kind, *entry);
    } else if (why.kind == outcome_kind::misconfigured) {
        sentence += "; --frequency does without it";
    } else if (why.kind == outcome_kind::in_fault) {
        return {exit_status::differs,
                sentence + fault_text() + "; `" + shown_command(line_, "--write reset") + "` resets it"};
    }
    return {why.kind == outcome_kind::refused ? exit_status::differs : exit_status::refused, sentence};
}

/// What to do about a setting that forbids an order; nothing where that depends.
std::string running::remedy_for(outcome_kind finding, register_entry const& entry) const
{
    auto const found = std::find_if(remedies.begin(), remedies.end(),
                                    [&entry](remedy const& each) { return each.code == entry.code; });
    if (finding == outcome_kind::unknown_register or found == remedies.end()) {
        return "";
    }
    return "; `" +
           shown_command(line_, (found->moves ? "--write --allow-run write " : "--write write ") +
                                    std::string{entry.code} + '=' + text_of(entry, found->word)) +
           "` changes that";
}

std::optional<motion_end> running::order()
{
    auto const until = clock::now() + able_limit;
    while (not motor_->sight().is_able) {
        if (clock::now() > until or motor_->sight().fault != 0) {
            return refusal_of_check();
        }
        if (not pass()) {
            return not_begun();
        }
    }
    if (int const failure = standard_output.failure(); failure != 0) {
        return motion_end{exit_status::port,
                          std::string{"standard output: "} + std::strerror(failure) + ": the motor is not started"};
    }
    emergency.arm(port_, unit_, drive_.layout.cmd);
    if (not motor_->run()) {
        return motion_end{exit_status::differs, "the drive takes no order: " + words_with_limit(motor_->reason())};
    }
    typed_.forget(); // whoever typed before had no motor in mind that runs
    return std::nullopt;
}

motion_end running::keep_running()
{
    std::optional<clock::time_point> until;
    for (;;) {
        if (not pass()) {
            return interrupted();
        }
        motor_sight const seen = motor_->sight();
        if (not seen.is_ordered) {
            return order_lost();
        }
        if (auto const line = typed_.next(); line and not line->empty()) {
            change(*line);
        }
        tell_limit(seen);
        bool const runs = seen.state == state::operation_enabled;
        if (runs and length_ and not until) {
            until = clock::now() + std::chrono::duration_cast<clock::duration>(*length_);
        }
        if (until and clock::now() >= *until) {
            return {exit_status::done, "the time is over"};
        }
    }
}

/// What was ordered stays where this is refused.
void running::change(std::string const& typed)
{
    std::string sentence;
    try {
        asked_motion const next = motion_typed(typed, asked_, drive_);
        if (motor_->change(next)) {
            asked_ = next;
            limit_due_ = clock::now() + limit_seen;
            sentence = "goes to " + next.text + words_of_least(next);
        } else {
            sentence = typed + ": " + words_with_limit(motor_->reason()) + ": stays at " + asked_.text;
        }
    } catch (ended const& why) {
        sentence = why.what() + (": stays at " + asked_.text + "; Ctrl-C stops it");
    }
    display_.say(motor_->sight(), sentence);
}

/// Said once of each speed that is typed; the drive needs a moment to show what it makes of it.
void running::tell_limit(motor_sight const& seen)
{
    if (limit_due_ and clock::now() >= *limit_due_ and seen.is_linked) {
        limit_due_.reset();
        if (seen.is_limited) {
            display_.say(seen, asked_.text + " is outside of the drive's limits: it turns at " + limit_text());
        }
    }
}

/// Which limit it is, and how much, by what was read at the start; somebody may have changed it since.
std::string running::limit_text() const
{
    auto const& limits = motor_->supervision().limits;
    std::uint16_t const address = asked_.is_speed ? drive_.speed_reference : drive_.frequency_reference;
    outcome_kind const found = limits.judge({address, static_cast<std::uint16_t>(asked_.count), asked_.is_speed}, true);
    std::string const hertz = amount_text(limits.named_by(found), {1, 10}, "Hz");
    return found == outcome_kind::above_hsp   ? "HSP, " + hertz
           : found == outcome_kind::below_lsp ? "LSP, " + hertz
                                              : "LSP, or at HSP, which was changed meanwhile";
}

motion_end running::interrupted() const
{
    int const failure = standard_output.failure();
    // Ctrl-C and TERM are how this command is meant to end; any other signal is an accident, which a shell is told.
    bool const is_asked_for = is_meant(noted.end);
    exit_status const status = is_asked_for     ? exit_status::done
                               : noted.end != 0 ? static_cast<exit_status>(128 + noted.end)
                               : failure != 0   ? exit_status::port
                                                : exit_status::differs;
    return {status, "ended: " + must_end_.text()};
}

motion_end running::not_begun() const
{
    motion_end const why = interrupted();
    return {why.status, why.sentence + "; the motor is not started"};
}

motion_end running::order_lost() const
{
    auto const why = motor_->reason();
    exit_status const status = why.kind == outcome_kind::silent ? exit_status::no_answer : exit_status::differs;
    return {status,
            why.kind == outcome_kind::silent ? "the link is lost: " + words_of(why.error) : words_of_kind(why.kind)};
}

/// What a drive does that hears nobody.
std::string running::own_stop() const
{
    rtuwire::duration const timeout = motor_->supervision().period.timeout;
    std::string const seconds =
        timeout != rtuwire::duration{} ? " of " + amount_text(timeout.microseconds / 100'000, {1, 10}, "s") : "";
    return "the motor stops when the drive's own time-out" + seconds + " is over; " + way_to_stop(line_);
}

std::string running::fault_text() const
{
    std::uint16_t const fault = motor_->sight().fault;
    register_entry const* const entry = drive_.at(drive_.layout.lft);
    return entry == nullptr or fault == 0 ? std::string{} : ": " + text_of(*entry, fault);
}

bool running::stands() const
{
    motor_sight const seen = motor_->sight();
    bool const has_no_power = seen.state == state::switch_on_disabled or seen.state == state::not_ready_to_switch_on or
                              (seen.state == state::fault and seen.fault != 0);
    return seen.is_linked and has_no_power and seen.has_output and seen.output == 0;
}

/// Ctrl-C again takes the motor's power away, whatever it does. That is no slip of a finger, and is said before: a load may
/// fall.
void running::heed_interrupts()
{
    int const pressed = noted.interrupts;
    auto const now = clock::now();
    if (pressed > 0 and not interrupted_at_) {
        interrupted_at_ = now;
        display_.say(motor_->sight(), "Ctrl-C again takes its power away: it coasts");
    }
    if (interrupted_at_ and now - *interrupted_at_ < one_press) {
        heeded_interrupts_ = pressed;
    }
    if (pressed > heeded_interrupts_ and not std::exchange(is_coasting_, true)) {
        motor_->stop(stop_by::freewheel);
    }
}

/// Until it stands; what became of it. Where it was not seen to stand, that is what the end is about.
std::string running::stop(motion_end& end)
{
    motor_->stop(stop_by::ramp);
    bool const is_local = motor_->reason().kind == outcome_kind::local_control;
    auto const patience = is_local ? unreached_limit : unfollowed_limit;
    auto slowed = clock::now();
    auto heard = slowed;
    int slowest = 65'536;
    while (not stands()) {
        heed_interrupts();
        if (go_on()) {
            heard = slowed = clock::now();
        }
        motor_sight const seen = motor_->sight();
        auto const now = clock::now();
        heard = seen.is_linked ? now : heard;
        int const output = seen.has_output ? std::abs(int{seen.output}) : slowest;
        slowed = output < slowest ? now : slowed;
        slowest = std::min(slowest, output);
        if (now - heard > unreached_limit and not is_local) { // there it answers, and obeys no word
            emergency.disarm();                               // from here on only silence makes the drive stop
            outcome_kind const why = motor_->reason().kind;
            bool const is_silent = why == outcome_kind::silent or why == outcome_kind::pending;
            end.status = is_silent ? exit_status::no_answer : exit_status::differs;
            return (is_silent ? "nobody answered the stop: " : "the motor was not seen to stop: ") + own_stop();
        }
        bool const has_no_power = seen.is_linked and rtuwire::cia402::is_at_rest(seen.state);
        if (now - slowed > patience or (is_coasting_ and has_no_power)) {
            emergency.stop_motor();
            end.status = exit_status::differs;
            return has_no_power ? "the motor has no power; it was not seen to stand"
                                : "THE MOTOR WAS TOLD TO STOP, AND DOES NOT FOLLOW";
        }
    }
    emergency.disarm();
    bool const is_fault = motor_->sight().state == state::fault;
    if (is_fault and end.status == exit_status::done) { // while the program slept, say
        end.status = exit_status::differs;
    }
    return (is_fault ? "fault" + fault_text() + "; " : std::string{}) +
           (is_fault or is_coasting_ ? no_power_text : "the motor stands");
}

} // namespace tool
