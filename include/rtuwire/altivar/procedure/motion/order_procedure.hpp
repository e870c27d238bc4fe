// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// What every order to run has in common: the check of the drive before it, the STOP key meanwhile, and the withdrawal.
// Internal: may change with any version.
#pragma once

#include <cstdint>

#include <rtuwire/altivar/device/reference.hpp>
#include <rtuwire/altivar/procedure/inspection/supervision.hpp>
#include <rtuwire/altivar/procedure/motion/stop.hpp>
#include <rtuwire/core/version.hpp>

namespace rtuwire {
inline namespace RTUWIRE_BUILD {
namespace altivar {

/// The base of the procedures that order a drive to run. Each is a stop as well, which begins where the order is withdrawn,
/// and holds its check of the drive, behind all else: small processors reach what is near with short instructions.
class order_procedure : public stop_procedure {
public:
    static constexpr bool is_order = true;
    static constexpr bool follows_order = true;

    /// The time to stop a drive that was commanded to run and must not.
    static constexpr duration grace{milliseconds(30'000)};

    using procedure::give_up; // as an order, not as its stop

protected:
    constexpr order_procedure(drive_layout const& layout, reference_write wanted) noexcept
        : stop_procedure{layout, stop_by::freewheel}, reference_{wanted}
    {}

    [[nodiscard]] constexpr reference_write const& wanted() const noexcept { return reference_; }

    /// Continues the check. Where the drive is ready after it, the last word read was a status word. A motor at rest gets no
    /// reference that its limits forbid: that ends the order as soon as they are read.
    constexpr action examine(supervision_procedure& check, event what, bool is_at_rest) noexcept
    {
        action const next = run_inside(check, what);
        reference_limits const& limits = check.report().limits;
        outcome_kind const found = is_at_rest ? limits.judge(reference_, true) : outcome_kind::succeeded;
        bool const goes_on = found == outcome_kind::succeeded or reason().kind != outcome_kind::pending;
        return goes_on ? next : end_beyond(found, limits.named_by(found));
    }
    /// Begins the check again, of a motor at rest, behind a response that was lost.
    constexpr action examine_anew(supervision_procedure& check, errc lost) noexcept
    {
        check.restart(lost);
        return examine(check, {event::kind::begun}, true);
    }
    [[nodiscard]] constexpr bool is_ready(supervision_procedure const& check) const noexcept
    {
        return check.reason().kind == outcome_kind::succeeded and reason().kind == outcome_kind::pending;
    }

    /// Whether the STOP key was pressed since the status read before. A drive that was stopped by the key earlier shows
    /// it until it runs: for the first status read `first_look` says what that means. A second press while the first is
    /// shown cannot be seen here.
    constexpr bool is_key_pressed(std::uint16_t status) noexcept
    {
        bool const is_shown = (status & stop_key_bit) != 0;
        bool const is_new = is_shown and not shows_key_;
        shows_key_ = is_shown;
        return is_new;
    }

    /// Whether this client had ordered the motor to run when this order was given: then the key may have stopped it since.
    constexpr void note_ordered(bool is_ordered) noexcept { was_ordered_ = is_ordered; }

    /// The first status read: what ends the order before the check. The drive may leave such a state during the check, at the
    /// drive or by its mains, and the motor would start by that.
    constexpr outcome_kind first_look(std::uint16_t status, cia402::state at) noexcept
    {
        is_local_ = (status & remote_bit) == 0;
        bool const is_pressed = is_key_pressed(status) and was_ordered_;
        return cia402::is_in_fault(at)                                 ? outcome_kind::in_fault
               : is_pressed and at != cia402::state::operation_enabled ? outcome_kind::stop_key
                                                                       : outcome_kind::pending;
    }
    /// A status read at the end of the check. A drive that was in local control at first still counts as being so; only here,
    /// for the check may have named a better reason.
    [[nodiscard]] constexpr std::uint16_t as_met(std::uint16_t status) const noexcept
    {
        return is_local_ ? static_cast<std::uint16_t>(status & ~remote_bit) : status;
    }

    /// Keeps the drive's LFT; an outcome in fault reports it.
    constexpr void note_code(std::uint16_t code) noexcept { fault_ = code; }

    constexpr action finish(outcome_kind kind, errc error) noexcept
    {
        return kind == outcome_kind::in_fault ? end_in_fault(fault_) : end(kind, error);
    }

    /// Withdraws the commands sent, and ends with this outcome when the drive stands.
    constexpr action take_back(outcome_kind kind, errc error, stop_by mode) noexcept
    {
        note_taking_back();
        kind_ = kind;
        error_ = error;
        note_state(cia402::state::unknown);
        plan(mode);
        return stop_procedure::step({event::kind::begun}); // never ends the procedure
    }
    constexpr action come_to_rest(event what) noexcept
    {
        action const next = stop_procedure::step(what);
        if (what_of(next) != action_kind::end) {
            return next;
        }
        forget_end();
        return finish(kind_, error_);
    }

private:
    reference_write reference_;
    std::uint16_t fault_{0};
    outcome_kind kind_{outcome_kind::pending};
    errc error_{errc::none};
    bool shows_key_{false}; ///< at the last look
    bool was_ordered_{false};
    bool is_local_{false};
};

} // namespace altivar
} // namespace RTUWIRE_BUILD
} // namespace rtuwire
