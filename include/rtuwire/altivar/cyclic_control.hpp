// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// What a cyclic controller commands, cycle by cycle: words in, words out. It enables a drive only on an
// order given after the last loss, fault or stop; any of these takes the order away.
#pragma once

#include <cstdint>

#include <rtuwire/altivar/profile.hpp>
#include <rtuwire/altivar/reason.hpp>
#include <rtuwire/altivar/script.hpp>
#include <rtuwire/cia402/way.hpp>
#include <rtuwire/core/version.hpp>

namespace rtuwire::inline RTUWIRE_BUILD::altivar {

/// The law of one drive in a cycle. Not a safety function.
class cyclic_control {
public:
    /// Orders operation. Refused, and nothing is changed, where the drive is not known to be reachable,
    /// free of faults and under remote control.
    constexpr bool run(std::uint16_t reference, bool is_reverse) noexcept
    {
        if (not is_able()) {
            return false;
        }
        reference_ = reference;
        extra_bits_ = is_reverse ? reverse_bit : std::uint16_t{0};
        if (not is_ordered_) {
            is_ordered_ = true;
            highest_ = cia402::height_of(state_);
            had_stop_key_ = (status_ & stop_key_bit) != 0;
            reason_ = {};
        }
        return true;
    }

    /// Takes the order back: the motor stops on its ramp.
    constexpr void stop() noexcept { is_ordered_ = false; }

    /// Orders one fault reset; nothing where the drive is in no fault.
    constexpr void reset_fault() noexcept
    {
        if (state_ == cia402::state::fault) {
            reset_step_ = 1;
        }
    }

    /// A status word has come.
    constexpr void note_status(std::uint16_t status) noexcept
    {
        status_ = status;
        state_ = cia402::decode(status);
        is_known_ = true;
        if (cia402::is_in_fault(state_)) {
            return drop(ending::in_fault);
        }
        reset_step_ = 0;
        if ((status & remote_bit) == 0) {
            return drop(ending::local_control);
        }
        int const height = cia402::height_of(state_);
        bool const is_stop_pressed = (status & stop_key_bit) != 0 and not had_stop_key_;
        if (is_ordered_ and (height < highest_ or is_stop_pressed)) {
            return drop(ending::stuck);
        }
        had_stop_key_ = had_stop_key_ and (status & stop_key_bit) != 0;
        highest_ = height;
    }

    constexpr void note_fault(std::uint16_t code) noexcept { reason_.fault = code; }

    /// Nothing came, or too late: nothing is known of the drive.
    constexpr void note_loss(errc error) noexcept
    {
        drop(ending::silent);
        reason_.error = error;
        is_known_ = false;
        reset_step_ = 0;
        state_ = cia402::state::unknown;
    }

    /// The drive's words are not where they are expected: nothing may be written there.
    constexpr void note_misconfigured() noexcept
    {
        drop(ending::misconfigured);
        reason_.how = ending::misconfigured;
        is_known_ = false;
        reset_step_ = 0;
    }

    /// The way up takes too long.
    constexpr void note_late() noexcept { drop(ending::stuck); }

    /// The control word for this cycle, once for each cycle.
    [[nodiscard]] constexpr std::uint16_t next_command() noexcept
    {
        if (reset_step_ != 0) {
            return reset_word();
        }
        return is_ordered_ ? climb() : go_down();
    }

    /// The reference of the last order.
    [[nodiscard]] constexpr std::uint16_t reference() const noexcept { return reference_; }

    [[nodiscard]] constexpr bool is_able() const noexcept
    {
        return is_known_ and state_ != cia402::state::unknown and
               not cia402::is_in_fault(state_) and (status_ & remote_bit) != 0;
    }
    [[nodiscard]] constexpr bool is_ordered() const noexcept { return is_ordered_; }
    [[nodiscard]] constexpr bool is_running() const noexcept
    {
        return state_ == cia402::state::operation_enabled;
    }
    [[nodiscard]] constexpr cia402::state state() const noexcept { return state_; }
    [[nodiscard]] constexpr std::uint16_t status() const noexcept { return status_; }

    /// Why the last order was dropped; `pending` where none was.
    [[nodiscard]] constexpr altivar::reason reason() const noexcept { return reason_; }

private:
    constexpr void drop(ending how) noexcept
    {
        if (is_ordered_ or reason_.how == ending::pending) {
            reason_ = {how, errc::none, state_, 0};
        }
        is_ordered_ = false;
    }

    constexpr std::uint16_t go_down() const noexcept
    {
        switch (cia402::toward_stopped(state_)) {
        case cia402::command::switch_on: return cia402::word_of(cia402::command::switch_on);
        case cia402::command::shutdown: return cia402::word_of(cia402::command::shutdown);
        case cia402::command::none:
        case cia402::command::enable_operation:
        case cia402::command::disable_voltage:
        case cia402::command::quick_stop:
        case cia402::command::fault_reset: break;
        }
        // A state that nobody knows may be operation: the ramp rather than none.
        bool const may_turn = state_ == cia402::state::unknown and is_known_;
        return may_turn ? cia402::word_of(cia402::command::switch_on) : std::uint16_t{0};
    }

    /// Low, high, low.
    constexpr std::uint16_t reset_word() noexcept
    {
        std::uint16_t const word = reset_step_ == 2 ? cia402::fault_reset_bit : std::uint16_t{0};
        reset_step_ =
            reset_step_ == 3 ? std::uint8_t{0} : static_cast<std::uint8_t>(reset_step_ + 1);
        return word;
    }

    constexpr std::uint16_t climb() const noexcept
    {
        cia402::command const next = state_ == cia402::state::operation_enabled
                                         ? cia402::command::enable_operation
                                         : cia402::toward_running(state_);
        if (next == cia402::command::none) {
            return 0;
        }
        return static_cast<std::uint16_t>(cia402::word_of(next) | extra_bits_);
    }

    altivar::reason reason_{};
    std::uint16_t reference_{0};
    std::uint16_t extra_bits_{0};
    std::uint16_t status_{0};
    cia402::state state_{cia402::state::unknown};
    int highest_{0};
    std::uint8_t reset_step_{0};
    bool is_known_{false};
    bool is_ordered_{false};
    bool had_stop_key_{false}; ///< pressed before the order, and shown until the motor runs
};

} // namespace rtuwire::inline RTUWIRE_BUILD::altivar
