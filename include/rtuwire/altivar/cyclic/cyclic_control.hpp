// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// What a cyclic controller commands, cycle by cycle: words in, words out. It enables a drive only on an order given
// after the last loss, fault or stop; any of these cancels the order.
#pragma once

#include <cstdint>

#include <rtuwire/altivar/device/drive_layout.hpp>
#include <rtuwire/altivar/procedure/outcome.hpp>
#include <rtuwire/altivar/procedure/stop.hpp>
#include <rtuwire/cia402/next_command.hpp>
#include <rtuwire/core/version.hpp>

namespace rtuwire::inline RTUWIRE_BUILD::altivar {

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
        is_stopping_ = false;
        if (not is_ordered_) {
            is_ordered_ = true;
            highest_ = cia402::enable_rank(state_);
            had_stop_key_ = (status_ & stop_key_bit) != 0;
            reason_ = {};
        }
        return true;
    }

    /// Withdraws the order: the motor stops by `how`. Another stop does not replace a freewheel; DC injection is the
    /// ramp here.
    constexpr void stop(stop_by how) noexcept
    {
        bool const is_on_its_way = is_stopping_ and how_ == stop_by::freewheel;
        how_ = is_on_its_way ? how_ : how;
        is_ordered_ = false;
        has_switched_on_ = false;
        is_stopping_ = true;
        reset_step_ = 0;
    }

    /// Orders one fault reset; false where the drive is not in fault, or a reset is under way.
    constexpr bool reset_fault() noexcept
    {
        bool const is_taken = state_ == cia402::state::fault and reset_step_ == 0;
        reset_step_ = is_taken ? std::uint8_t{1} : reset_step_;
        return is_taken;
    }

    /// Takes a status word, and whether the motor is at rest.
    constexpr void note_status(std::uint16_t status, bool stands) noexcept
    {
        status_ = status;
        bool const was_in_fault = cia402::is_in_fault(state_);
        state_ = cia402::decode(status);
        has_read_fault_ = has_read_fault_ or (cia402::is_in_fault(state_) and not was_in_fault);
        is_known_ = true;
        has_enabled_ = false;
        looks_at_rest_ = not stands           ? std::uint8_t{0}
                         : looks_at_rest_ < 2 ? static_cast<std::uint8_t>(looks_at_rest_ + 1)
                                              : looks_at_rest_;
        end_stop();
        has_read_rest_ = cia402::is_at_rest(state_);
        if (cia402::is_in_fault(state_)) {
            return drop(outcome_kind::in_fault);
        }
        reset_step_ = 0;
        if ((status & remote_bit) == 0) {
            return drop(outcome_kind::local_control);
        }
        int const rank = cia402::enable_rank(state_);
        bool const is_stop_pressed = (status & stop_key_bit) != 0 and not had_stop_key_;
        if (is_ordered_ and (rank < highest_ or is_stop_pressed)) {
            return drop(outcome_kind::stuck);
        }
        had_stop_key_ = had_stop_key_ and (status & stop_key_bit) != 0;
        highest_ = rank;
    }

    constexpr void note_fault(std::uint16_t code) noexcept { reason_.fault = code; }

    /// No response, or one too late: the state of the drive is unknown.
    constexpr void note_loss(errc error) noexcept
    {
        was_lost_running_ = may_run();
        drop(outcome_kind::silent);
        reason_.error = error;
        is_known_ = false;
        looks_at_rest_ = 0;
        reset_step_ = 0;
        state_ = cia402::state::unknown;
    }

    /// The drive must not be commanded, or its words are not where they are expected.
    constexpr void note_finding(outcome_kind found) noexcept
    {
        drop(found);
        reason_.kind = found;
        is_known_ = false;
        reset_step_ = 0;
    }

    /// A stop by another conversation cancelled the order.
    constexpr void note_overruled() noexcept
    {
        drop(outcome_kind::overruled);
        reset_step_ = 0;
    }

    /// The control word or the reference in the drive is not the one written last.
    constexpr void note_overwritten() noexcept
    {
        drop(outcome_kind::overwritten);
        reason_.kind = outcome_kind::overwritten;
    }

    /// Another conversation stopped the drive: its state is unknown until it is read.
    constexpr void note_stopped() noexcept { is_known_ = false; }

    /// The last command may not have arrived: enabling begins again from the state of the drive.
    constexpr void note_miss() noexcept { has_switched_on_ = false; }

    /// Enabling takes too long.
    constexpr void note_late() noexcept { drop(outcome_kind::stuck); }

    /// The control word for this cycle; call once in each cycle.
    [[nodiscard]] constexpr std::uint16_t next_command() noexcept
    {
        if (reset_step_ != 0) {
            return reset_word();
        }
        return is_ordered_ ? next_step() : go_down();
    }

    /// The word that stops the drive, whatever is ordered; it coasts where the word may mean something else.
    [[nodiscard]] constexpr std::uint16_t word_to_stop(word_meaning known, drive_layout const& layout) const noexcept
    {
        bool const is_doubtful = layout.chcf != 0 and known == word_meaning::unknown;
        return is_doubtful ? std::uint16_t{0} : go_down();
    }

    /// The reference of the order in force; 0 without one, so that no other client's order runs at an old one.
    [[nodiscard]] constexpr std::uint16_t reference() const noexcept
    {
        return is_ordered_ ? reference_ : std::uint16_t{0};
    }

    [[nodiscard]] constexpr bool is_able() const noexcept
    {
        bool const is_free = not is_stopping_ or (is_halting() and looks_at_rest_ >= 2);
        return is_known_ and is_free and state_ != cia402::state::unknown and
               state_ != cia402::state::quick_stop_active and not cia402::is_in_fault(state_) and
               (status_ & remote_bit) != 0;
    }
    [[nodiscard]] constexpr bool is_ordered() const noexcept { return is_ordered_; }

    /// Whether the next command may move the motor: an order to run, or a fault reset.
    [[nodiscard]] constexpr bool moves() const noexcept { return is_ordered_ or reset_step_ != 0; }

    /// Whether the next command is part of a fault reset.
    [[nodiscard]] constexpr bool is_resetting() const noexcept { return reset_step_ != 0; }

    /// Whether the next command is the one that enables a drive that does not run.
    [[nodiscard]] constexpr bool is_about_to_enable() const noexcept
    {
        return is_ordered_ and state_ == cia402::state::switched_on and has_switched_on_;
    }

    /// Whether the next command, while enabling, is `word` again.
    [[nodiscard]] constexpr bool would_repeat(std::uint16_t word) const noexcept
    {
        bool const is_low = state_ == cia402::state::switch_on_disabled or state_ == cia402::state::ready_to_switch_on;
        return is_ordered_ and is_low and word == cia402::word_of(cia402::next_command_to_enable(state_));
    }

    /// Whether the drive has power, or may have, and no order to run.
    [[nodiscard]] constexpr bool must_stop() const noexcept
    {
        bool const may_turn = state_ == cia402::state::operation_enabled or
                              state_ == cia402::state::quick_stop_active or
                              (state_ == cia402::state::unknown and is_known_);
        return not moves() and (may_turn or has_enabled_);
    }

    /// Whether the drive may be running as far as is known: ordered, or with power.
    [[nodiscard]] constexpr bool may_run() const noexcept { return is_ordered_ or must_stop(); }

    /// Whether a halt was ordered, and is under way.
    [[nodiscard]] constexpr bool is_halting() const noexcept
    {
        return is_stopping_ and how_ == stop_by::halt and state_ == cia402::state::operation_enabled;
    }

    /// Whether a read found the drive without power, or newly in fault, and whether a stop that was ordered here has
    /// ended; each reported once.
    constexpr bool take_rest() noexcept { return take(has_read_rest_); }
    constexpr bool take_fault() noexcept { return take(has_read_fault_); }
    constexpr bool take_end_of_stop() noexcept { return take(has_ended_stop_); }
    [[nodiscard]] constexpr bool is_running() const noexcept { return state_ == cia402::state::operation_enabled; }
    [[nodiscard]] constexpr cia402::state state() const noexcept { return state_; }
    [[nodiscard]] constexpr std::uint16_t status() const noexcept { return status_; }

    /// Why the last order was dropped; `pending` where none was.
    [[nodiscard]] constexpr altivar::reason reason() const noexcept { return reason_; }

private:
    constexpr void drop(outcome_kind kind) noexcept
    {
        if (is_ordered_ or reason_.kind == outcome_kind::pending) {
            reason_ = {kind, errc::none, state_, 0};
        }
        is_ordered_ = false;
        has_switched_on_ = false;
    }

    constexpr std::uint16_t go_down() const noexcept
    {
        switch (state_) {
        case cia402::state::operation_enabled:
        case cia402::state::quick_stop_active: return word_of_stop();
        case cia402::state::unknown:
            // An unknown state, or one that can no longer be read, may be "operation enabled".
            return is_known_ or was_lost_running_ or is_stopping_ ? word_of_stop() : std::uint16_t{0};
        case cia402::state::not_ready_to_switch_on:
        case cia402::state::switch_on_disabled:
        case cia402::state::ready_to_switch_on:
        case cia402::state::switched_on:
        case cia402::state::fault_reaction_active:
        case cia402::state::fault: break;
        }
        // Without power, but perhaps one word away from it: to a state where no single word can start the motor.
        return has_enabled_ ? word_of_stop() : std::uint16_t{0};
    }

    /// The stop command in operation or in a quick stop. A quick stop, also one by another client, goes on until the
    /// motor is at rest; only a freewheel ends it.
    constexpr std::uint16_t word_of_stop() const noexcept
    {
        if (is_halting()) {
            return cia402::word_of(cia402::command::enable_operation) | cia402::halt_bit;
        }
        bool const stands = looks_at_rest_ >= 2 and not has_enabled_;
        if (stands or (is_stopping_ and how_ == stop_by::freewheel)) {
            return cia402::word_of(cia402::command::disable_voltage);
        }
        bool const is_quick =
            state_ == cia402::state::quick_stop_active or (is_stopping_ and how_ == stop_by::quick_stop);
        return cia402::word_of(is_quick ? cia402::command::quick_stop : cia402::command::switch_on);
    }

    /// A stop has ended where the drive is in a state in which no single word can start it.
    constexpr void end_stop() noexcept
    {
        bool const is_low = state_ == cia402::state::switch_on_disabled or
                            state_ == cia402::state::not_ready_to_switch_on or state_ == cia402::state::fault;
        // A halt stays in force in operation; the next order ends it.
        bool const is_over = is_stopping_ and (is_low or (is_halting() and looks_at_rest_ >= 2));
        has_ended_stop_ = has_ended_stop_ or is_over;
        is_stopping_ = is_stopping_ and not is_low;
    }

    static constexpr bool take(bool& mark) noexcept
    {
        bool const is_set = mark;
        mark = false;
        return is_set;
    }

    /// The reset bit is low, high, low.
    constexpr std::uint16_t reset_word() noexcept
    {
        std::uint16_t const word = reset_step_ == 2 ? cia402::fault_reset_bit : std::uint16_t{0};
        reset_step_ = reset_step_ == 3 ? std::uint8_t{0} : static_cast<std::uint8_t>(reset_step_ + 1);
        return word;
    }

    /// A drive found in "switched on" gets "switch on" again: the command to run follows only one sent from here.
    constexpr std::uint16_t next_step() noexcept
    {
        cia402::command next = state_ == cia402::state::operation_enabled ? cia402::command::enable_operation
                                                                          : cia402::next_command_to_enable(state_);
        if (state_ == cia402::state::switched_on and not has_switched_on_) {
            next = cia402::command::switch_on;
        }
        has_enabled_ = has_enabled_ or next == cia402::command::enable_operation;
        has_switched_on_ = has_switched_on_ or next == cia402::command::switch_on;
        return next == cia402::command::none ? std::uint16_t{0} : cia402::word_of(next);
    }

    altivar::reason reason_{};
    std::uint16_t reference_{0};
    std::uint16_t status_{0};
    cia402::state state_{cia402::state::unknown};
    int highest_{0};
    std::uint8_t reset_step_{0};
    std::uint8_t looks_at_rest_{0}; ///< in a row, up to 2
    stop_by how_{stop_by::ramp};
    bool is_known_{false};
    bool has_switched_on_{false};  ///< "switch on" was sent, while enabling
    bool was_lost_running_{false}; ///< it may have been running at the last loss
    bool has_enabled_{false};      ///< the command to run was given since the state was read
    bool is_ordered_{false};
    bool has_read_rest_{false};
    bool has_read_fault_{false};
    bool has_ended_stop_{false};
    bool is_stopping_{false};  ///< a stop was ordered here, and has not ended
    bool had_stop_key_{false}; ///< pressed before the order, and shown until the motor runs
};

} // namespace rtuwire::altivar
