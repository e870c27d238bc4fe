// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// What a cyclic controller commands, cycle by cycle: words in, words out. It enables a drive only on an order given
// after the last loss, fault or stop; any of these cancels the order. What it has read of its drive, and the stop that was
// ordered, stand in front.
// Internal: may change with any version.
#pragma once

#include <cstdint>
#include <utility>

#include <rtuwire/altivar/device/drive_layout.hpp>
#include <rtuwire/altivar/device/reference.hpp>
#include <rtuwire/altivar/procedure/inspection/reference_limits.hpp>
#include <rtuwire/altivar/procedure/motion/stop.hpp>
#include <rtuwire/altivar/procedure/outcome.hpp>
#include <rtuwire/altivar/procedure/procedure.hpp>
#include <rtuwire/ask/commander.hpp>
#include <rtuwire/cia402/command.hpp>
#include <rtuwire/cia402/next_command.hpp>
#include <rtuwire/cia402/state.hpp>
#include <rtuwire/core/version.hpp>

namespace rtuwire {
inline namespace RTUWIRE_BUILD {
namespace altivar {

/// The drive as it was read last.
class cycle_sight {
public:
    /// Takes a status word, and whether the motor is at rest.
    constexpr void take(std::uint16_t status, bool stands) noexcept
    {
        bool const was_in_fault = cia402::is_in_fault(state_);
        status_ = status;
        state_ = cia402::decode(status);
        has_read_fault_ = has_read_fault_ or (cia402::is_in_fault(state_) and not was_in_fault);
        is_known_ = true;
        has_enabled_ = false;
        looks_at_rest_ = not stands           ? std::uint8_t{0}
                         : looks_at_rest_ < 2 ? static_cast<std::uint8_t>(looks_at_rest_ + 1)
                                              : looks_at_rest_;
        power_seen_ = power_in(state_);
    }

    /// The link was lost; `may_run`: the drive may have been running.
    constexpr void lose(bool may_run) noexcept
    {
        was_lost_running_ = may_run;
        is_known_ = false;
        looks_at_rest_ = 0;
        state_ = cia402::state::unknown;
    }

    /// The drive has to be read before an order.
    constexpr void forget() noexcept { is_known_ = false; }

    /// The command to run was given, or was not.
    constexpr void note_command(bool enables) noexcept { has_enabled_ = has_enabled_ or enables; }

    /// What a read found of the motor's power, and whether it found the drive newly in fault; each reported once.
    constexpr detail::power_seen take_power() noexcept
    {
        return std::exchange(power_seen_, detail::power_seen::nothing);
    }
    constexpr bool take_fault() noexcept { return std::exchange(has_read_fault_, false); }

    [[nodiscard]] constexpr std::uint16_t status() const noexcept { return status_; }
    [[nodiscard]] constexpr cia402::state state() const noexcept { return state_; }
    [[nodiscard]] constexpr bool is_in_fault() const noexcept { return cia402::is_in_fault(state_); }
    [[nodiscard]] constexpr bool is_remote() const noexcept { return (status_ & remote_bit) != 0; }
    [[nodiscard]] constexpr bool shows_stop_key() const noexcept { return (status_ & stop_key_bit) != 0; }
    [[nodiscard]] constexpr bool is_known() const noexcept { return is_known_; }
    [[nodiscard]] constexpr bool has_enabled() const noexcept { return has_enabled_; }
    [[nodiscard]] constexpr bool was_lost_running() const noexcept { return was_lost_running_; }

    /// Whether the motor stood at the last two reads.
    [[nodiscard]] constexpr bool stands() const noexcept { return looks_at_rest_ >= 2; }

    /// Whether the drive takes an order: known, under remote control, and neither in fault nor in a quick stop.
    [[nodiscard]] constexpr bool is_able() const noexcept
    {
        return is_known_ and state_ != cia402::state::unknown and state_ != cia402::state::quick_stop_active and
               not is_in_fault() and is_remote();
    }

    /// Whether the motor may turn: with power, in a state that nobody knows, or enabled since the last read.
    [[nodiscard]] constexpr bool may_turn() const noexcept
    {
        bool const has_power = state_ == cia402::state::operation_enabled or
                               state_ == cia402::state::quick_stop_active or
                               (state_ == cia402::state::unknown and is_known_);
        return has_power or has_enabled_;
    }

private:
    std::uint16_t status_{0};
    cia402::state state_{cia402::state::unknown};
    std::uint8_t looks_at_rest_{0}; ///< in a row, up to 2
    bool is_known_{false};
    bool was_lost_running_{false}; ///< it may have been running at the last loss
    bool has_enabled_{false};      ///< the command to run was given since the state was read
    detail::power_seen power_seen_{detail::power_seen::nothing};
    bool has_read_fault_{false};
};

/// The stop of one drive.
class cycle_stop {
public:
    /// Orders a stop. Another one does not replace a freewheel; DC injection is the ramp here.
    constexpr void order(stop_by how) noexcept
    {
        bool const coasts = is_under_way_ and how_ == stop_by::freewheel;
        how_ = coasts ? how_ : how;
        is_under_way_ = true;
    }

    /// An order to run ends a halt.
    constexpr void end() noexcept { is_under_way_ = false; }

    /// Takes what was read. A stop has ended where the drive is in a state in which no single word can start it.
    constexpr void note(cycle_sight const& seen) noexcept
    {
        bool const is_low = seen.state() == cia402::state::switch_on_disabled or
                            seen.state() == cia402::state::not_ready_to_switch_on or
                            seen.state() == cia402::state::fault;
        // A halt stays in force in operation; the next order ends it.
        bool const is_over = is_under_way_ and (is_low or (is_halting(seen) and seen.stands()));
        has_ended_ = has_ended_ or is_over;
        is_under_way_ = is_under_way_ and not is_low;
    }

    /// Whether a stop has ended; reported once.
    constexpr bool take_end() noexcept { return std::exchange(has_ended_, false); }

    /// Whether a halt was ordered, and is under way.
    [[nodiscard]] constexpr bool is_halting(cycle_sight const& seen) const noexcept
    {
        return is_under_way_ and how_ == stop_by::halt and seen.state() == cia402::state::operation_enabled;
    }

    /// Whether an order may follow: there is no stop, or a halt whose motor stands.
    [[nodiscard]] constexpr bool is_over(cycle_sight const& seen) const noexcept
    {
        return not is_under_way_ or (is_halting(seen) and seen.stands());
    }

    /// The control word of a drive that must not run, whether a stop was ordered or not.
    [[nodiscard]] constexpr std::uint16_t word(cycle_sight const& seen) const noexcept
    {
        switch (seen.state()) {
        case cia402::state::operation_enabled:
        case cia402::state::quick_stop_active: return word_with_power(seen);
        case cia402::state::unknown:
            // An unknown state, or one that can no longer be read, may be "operation enabled".
            return seen.is_known() or seen.was_lost_running() or is_under_way_ ? word_with_power(seen)
                                                                               : std::uint16_t{0};
        case cia402::state::not_ready_to_switch_on:
        case cia402::state::switch_on_disabled:
        case cia402::state::ready_to_switch_on:
        case cia402::state::switched_on:
        case cia402::state::fault_reaction_active:
        case cia402::state::fault: break;
        }
        // Without power, but perhaps one word away from it: to a state where no single word can start the motor.
        return seen.has_enabled() ? word_with_power(seen) : std::uint16_t{0};
    }

private:
    /// The stop command in operation or in a quick stop. A quick stop, also one by another client, goes on until the
    /// motor is at rest; only a freewheel ends it.
    constexpr std::uint16_t word_with_power(cycle_sight const& seen) const noexcept
    {
        if (is_halting(seen)) {
            return cia402::word_of(cia402::command::enable_operation) | detail::halt_bit;
        }
        bool const stands = seen.stands() and not seen.has_enabled();
        if (stands or (is_under_way_ and how_ == stop_by::freewheel)) {
            return cia402::word_of(cia402::command::disable_voltage);
        }
        bool const is_quick =
            seen.state() == cia402::state::quick_stop_active or (is_under_way_ and how_ == stop_by::quick_stop);
        return cia402::word_of(is_quick ? cia402::command::quick_stop : cia402::command::switch_on);
    }

    stop_by how_{stop_by::ramp};
    bool is_under_way_{false};
    bool has_ended_{false};
};

/// The words of a fault reset: the reset bit is low, high, low.
class reset_edge {
public:
    /// Begins one; false where the drive is not in fault, or a reset is under way.
    constexpr bool order(cia402::state at) noexcept
    {
        bool const is_taken = at == cia402::state::fault and step_ == 0;
        step_ = is_taken ? std::uint8_t{1} : step_;
        return is_taken;
    }
    constexpr void end() noexcept { step_ = 0; }

    [[nodiscard]] constexpr bool is_under_way() const noexcept { return step_ != 0; }
    [[nodiscard]] constexpr std::uint16_t word() noexcept
    {
        std::uint16_t const word = step_ == 2 ? detail::fault_reset_bit : std::uint16_t{0};
        step_ = step_ == 3 ? std::uint8_t{0} : static_cast<std::uint8_t>(step_ + 1);
        return word;
    }

private:
    std::uint8_t step_{0};
};

/// Decides the control word of one drive for each cycle. Not a safety function.
class cyclic_control {
public:
    /// Orders operation; a negative reference is in reverse. Refused, with nothing changed, where the drive is not
    /// known to be reachable, free of faults and under remote control, in a quick stop, and while a stop that was
    /// ordered here has not ended.
    constexpr bool run(std::uint16_t reference) noexcept
    {
        if (not is_able()) {
            return false;
        }
        reference_ = reference;
        reason_ = {};
        stop_.end();
        if (not is_ordered_) {
            is_ordered_ = true;
            was_told_to_run_ = false;
            highest_ = detail::enable_rank(state());
            had_stop_key_ = sight_.shows_stop_key();
        }
        return true;
    }

    /// Whether the drive's limits allow a reference; the reason tells which does not. A motor that was ordered to run is
    /// never kept at a faster reference, and one that turns is not held to the lowest.
    constexpr bool allows(reference_write what, reference_limits const& limits) noexcept
    {
        bool const is_slower = is_ordered_ and what.is_within(reference_);
        outcome_kind const found = limits.judge(what, not is_ordered_ and not is_running());
        if (is_slower or found == outcome_kind::succeeded) {
            return true;
        }
        reason_ = {found, errc::none, state()};
        reason_.limit = limits.named_by(found);
        return false;
    }

    /// Withdraws the order: the motor stops by `how`. Another stop does not replace a freewheel; DC injection is the
    /// ramp here.
    constexpr void stop(stop_by how) noexcept
    {
        stop_.order(how);
        is_ordered_ = false;
        has_switched_on_ = false;
        reset_.end();
    }

    /// Orders one fault reset; false where the drive is not in fault, or a reset is under way.
    constexpr bool reset_fault() noexcept { return reset_.order(state()); }

    /// Takes a status word, and whether the motor is at rest.
    constexpr void note_status(std::uint16_t status, bool stands) noexcept
    {
        sight_.take(status, stands);
        stop_.note(sight_);
        if (sight_.is_in_fault()) {
            return drop(outcome_kind::in_fault);
        }
        reset_.end();
        if (not sight_.is_remote()) {
            return drop(outcome_kind::local_control);
        }
        int const rank = detail::enable_rank(state());
        bool const shows_stop_key = sight_.shows_stop_key();
        if (is_ordered_ and shows_stop_key and not had_stop_key_) {
            return drop(outcome_kind::stop_key);
        }
        if (is_ordered_ and rank < highest_) {
            return drop(outcome_kind::fell_back);
        }
        if (is_ordered_ and is_running() and highest_ < rank and not was_told_to_run_) {
            return note_overwritten(); // no word from here explains it
        }
        had_stop_key_ = had_stop_key_ and shows_stop_key;
        highest_ = rank;
    }

    constexpr void note_fault(std::uint16_t code) noexcept { reason_.fault = code; }

    /// No response, or one too late: the state of the drive is unknown.
    constexpr void note_loss(errc error) noexcept
    {
        bool const could_run = may_run();
        drop(outcome_kind::silent, error);
        reset_.end();
        sight_.lose(could_run);
    }

    /// The drive must not be commanded, or its words are not where they are expected.
    constexpr void note_finding(outcome_kind found) noexcept
    {
        drop(found);
        reason_.kind = found;
        sight_.forget();
        reset_.end();
    }

    /// A stop by another conversation cancelled the order.
    constexpr void note_overruled() noexcept
    {
        drop(outcome_kind::overruled);
        reset_.end();
    }

    /// The control word or the reference in the drive is not the one written last.
    constexpr void note_overwritten() noexcept
    {
        drop(outcome_kind::overwritten);
        reason_.kind = outcome_kind::overwritten;
    }

    /// Another conversation stopped the drive, or read it in fault: its state is unknown until it is read.
    constexpr void note_stopped() noexcept { sight_.forget(); }

    /// The last command may not have arrived: enabling begins again from the state of the drive.
    constexpr void note_miss() noexcept { has_switched_on_ = false; }

    /// Whether another conversation's order to run counts for this drive: without power it is only read.
    constexpr void give_way(bool gives_way) noexcept { gives_way_ = gives_way; }
    [[nodiscard]] constexpr bool gives_way() const noexcept { return gives_way_ and not moves(); }

    /// Enabling takes too long.
    constexpr void note_late() noexcept { drop(outcome_kind::state_timeout); }

    /// The control word for this cycle; call once in each cycle.
    [[nodiscard]] constexpr std::uint16_t next_command() noexcept
    {
        return reset_.is_under_way() ? reset_.word() : is_ordered_ ? next_step() : stop_.word(sight_);
    }

    /// The word that stops the drive, whatever is ordered; it coasts where the word may mean something else.
    [[nodiscard]] constexpr std::uint16_t word_to_stop(bool is_confirmed, drive_layout const& layout) const noexcept
    {
        bool const is_doubtful = not is_confirmed and may_have_io_profile(layout);
        return is_doubtful ? std::uint16_t{0} : stop_.word(sight_);
    }

    /// The reference of the order in force; 0 without one, so that no other client's order runs at an old one.
    [[nodiscard]] constexpr std::uint16_t reference() const noexcept
    {
        return is_ordered_ ? reference_ : std::uint16_t{0};
    }

    [[nodiscard]] constexpr bool is_able() const noexcept { return sight_.is_able() and stop_.is_over(sight_); }
    [[nodiscard]] constexpr bool is_ordered() const noexcept { return is_ordered_; }

    /// Whether the next command may move the motor: an order to run, or a fault reset.
    [[nodiscard]] constexpr bool moves() const noexcept { return is_ordered_ or reset_.is_under_way(); }

    /// Whether the next command is part of a fault reset.
    [[nodiscard]] constexpr bool is_resetting() const noexcept { return reset_.is_under_way(); }

    /// Whether the next command is the one that enables a drive that does not run.
    [[nodiscard]] constexpr bool is_about_to_enable() const noexcept
    {
        return is_ordered_ and state() == cia402::state::switched_on and has_switched_on_;
    }

    /// Whether the next command, while enabling, is `word` again.
    [[nodiscard]] constexpr bool would_repeat(std::uint16_t word) const noexcept
    {
        bool const is_low =
            state() == cia402::state::switch_on_disabled or state() == cia402::state::ready_to_switch_on;
        return is_ordered_ and is_low and word == cia402::word_of(detail::next_command_to_enable(state()));
    }

    /// Whether the drive has power, or may have, and no order to run.
    [[nodiscard]] constexpr bool must_stop() const noexcept { return not moves() and sight_.may_turn(); }

    /// Whether the drive may be running as far as is known: ordered, or with power.
    [[nodiscard]] constexpr bool may_run() const noexcept { return is_ordered_ or must_stop(); }

    /// Whether a halt was ordered, and is under way.
    [[nodiscard]] constexpr bool is_halting() const noexcept { return stop_.is_halting(sight_); }

    /// What a read found of the motor's power, whether it found the drive newly in fault, and whether a stop that was ordered
    /// here has ended; each reported once.
    constexpr detail::power_seen take_power() noexcept { return sight_.take_power(); }
    constexpr bool take_fault() noexcept { return sight_.take_fault(); }
    constexpr bool take_end_of_stop() noexcept { return stop_.take_end(); }
    /// Whether the command to run was given since the last status, which showed a motor without it.
    [[nodiscard]] constexpr bool has_enabled() const noexcept { return sight_.has_enabled() and not is_running(); }
    [[nodiscard]] constexpr bool is_running() const noexcept { return state() == cia402::state::operation_enabled; }
    [[nodiscard]] constexpr cia402::state state() const noexcept { return sight_.state(); }
    [[nodiscard]] constexpr std::uint16_t status() const noexcept { return sight_.status(); }

    /// Why the last order was dropped, or which limit refused the last one (`above_hsp`, `below_lsp`); before the first
    /// order, what first kept the drive from taking one, or `pending`.
    [[nodiscard]] constexpr altivar::reason reason() const noexcept { return reason_; }

private:
    constexpr void drop(outcome_kind kind, errc error = errc::none) noexcept
    {
        if (is_ordered_ or reason_.kind == outcome_kind::pending) {
            reason_ = {kind, error, state(), 0};
        }
        is_ordered_ = false;
        has_switched_on_ = false;
    }

    /// A drive found in "switched on" gets "switch on" again: the command to run follows only one sent from here.
    constexpr std::uint16_t next_step() noexcept
    {
        cia402::command next =
            is_running() ? cia402::command::enable_operation : detail::next_command_to_enable(state());
        if (state() == cia402::state::switched_on and not has_switched_on_) {
            next = cia402::command::switch_on;
        }
        sight_.note_command(next == cia402::command::enable_operation);
        was_told_to_run_ = was_told_to_run_ or next == cia402::command::enable_operation;
        has_switched_on_ = has_switched_on_ or next == cia402::command::switch_on;
        return next == cia402::command::none ? std::uint16_t{0} : cia402::word_of(next);
    }

    altivar::reason reason_{};
    std::uint16_t reference_{0};
    int highest_{0};
    cycle_sight sight_{};
    cycle_stop stop_{};
    reset_edge reset_{};
    bool has_switched_on_{false}; ///< "switch on" was sent, while enabling
    bool was_told_to_run_{false}; ///< since the order
    bool is_ordered_{false};
    bool gives_way_{false};
    bool had_stop_key_{false}; ///< pressed before the order, and shown until the motor runs
};

} // namespace altivar
} // namespace RTUWIRE_BUILD
} // namespace rtuwire
