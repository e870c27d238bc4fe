// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// Gives a running drive another speed or direction, and waits until its status confirms it.
#pragma once

#include <cstdint>
#include <type_traits>
#include <utility>

#include <rtuwire/altivar/device/drive_type.hpp>
#include <rtuwire/altivar/device/reference.hpp>
#include <rtuwire/altivar/procedure/inspection/reference_limits.hpp>
#include <rtuwire/altivar/procedure/procedure_runner.hpp>
#include <rtuwire/core/version.hpp>

namespace rtuwire {
inline namespace RTUWIRE_BUILD {
namespace altivar {

/// Decides a change of the reference, word by word.
///
/// | read of       | answer                              | not yet written     | written                             |
/// |---------------|-------------------------------------|---------------------|-------------------------------------|
/// | ETA           | 7, 8                                | read LFT            | read LFT                            |
/// |               | in local control                    | end: local_control  | end: local_control                  |
/// |               | 1 to 4, 6, or no state              | end: aborted        | end: fell_back                      |
/// |               | the same with the STOP key          | end: stop_key       | end: stop_key                       |
/// |               | 5                                   | read CMD            | wait, not reached                   |
/// |               | 5, limited                          | read CMD            | limited                             |
/// |               | 5, reached in the ordered direction | read CMD            | read RFR; a reference of 0: reached |
/// | RFR           | 0                                   |                     | wait, not reached                   |
/// |               | other                               |                     | reached                             |
/// | CMD           | with the halt bit                   | end: halted         |                                     |
/// |               | other                               | write the reference |                                     |
/// |               | other, 0 would be 0.1 Hz            | read LSP            |                                     |
/// |               | other, limits refuse, no 0          | read the reference  |                                     |
/// | LSP           | 0                                   | write 0             |                                     |
/// |               | other, or refused                   | write 0.1 Hz        |                                     |
/// | LFT           | any                                 | end: in_fault       | end: in_fault                       |
/// | the reference | confirmed                           | wait                |                                     |
/// |               | no slower, the same way             | write the reference |                                     |
/// |               | other, or refused                   | read HSP            |                                     |
/// | HSP; in rpm:  | above it                            | end: above_hsp      |                                     |
/// | then FRS, NSP | other                               | write the reference |                                     |
/// |               | refused, or NSP is 0                | end:                |                                     |
/// |               |                                     | unknown_register    |                                     |
/// |               | the same, of a small one in rpm     | write the reference |                                     |
/// |               | the same, for its name: LSP, too    |                     | read the reference                  |
/// | a wait        | over                                |                     | read ETA                            |
/// | anything      | no response                         | end: silent         | end: silent                         |
/// |               | refused                             | end: refused        | end: refused                        |
/// |               | limit over, of LFT                  | end: in_fault, 0    | end: in_fault, 0                    |
/// |               | limit over                          | end: aborted        | end: state_timeout                  |
///
/// "Reached" waits the first time; the second time in a row it reads the reference, and ends as `overwritten` where
/// that is not the one written, else reads ETA once more: as `succeeded` where that shows "reached" again (without
/// RFR), while another one begins anew. "Limited" does so as `reference_limited`, and asks once, before the reference, for HSP,
/// in rpm FRS and NSP, and LSP: which of the two limits it. A reference of 0 has no direction:
/// it keeps that of the motor, where LSP may be above 0 by 0.1 Hz with the sign for it. Before a word below zero and
/// above -20 rpm is written, FRS and NSP are read: it is at least 0.1 Hz.
/// Internal.
class reference_procedure : public procedure {
public:
    static constexpr bool follows_order = true;

    constexpr reference_procedure(drive_layout const& layout, reference_write reference, beyond_limits beyond) noexcept
        : procedure{layout}, reference_{reference}, beyond_{beyond}
    {}

    [[nodiscard]] constexpr reference_procedure anew() const noexcept { return {layout(), reference_, beyond_}; }

    constexpr action step(event what) noexcept
    {
        switch (what.what()) {
        case event::kind::begun: return ask(asked::status, layout().eta);
        case event::kind::pause_over: return ask(asked::status, layout().eta);
        case event::kind::word_read: return on_response(what.word());
        case event::kind::written: is_written_ = true; return to_pause(status_period);
        case event::kind::failed: return is_exception(what.error()) ? go_without(what.error()) : end(what.error());
        case event::kind::late: break;
        }
        return asked_ == asked::fault ? end_in_fault(0)
                                      : end(is_written_ ? outcome_kind::state_timeout : outcome_kind::aborted);
    }

private:
    enum class asked : std::uint8_t {
        status,
        fault,
        control,
        lowest,
        standing, ///< its reference: slowing down is never refused
        highest,
        rated_frequency,
        rated_speed,
        frequency,
        written, ///< its reference, when it is reached: another order may have written one since
    };

    constexpr action ask(asked what, std::uint16_t address) noexcept
    {
        asked_ = what;
        return to_read(address);
    }

    constexpr action on_response(std::uint16_t word) noexcept
    {
        switch (asked_) {
        case asked::status: return judge(word);
        case asked::fault: return end_in_fault(word);
        case asked::control: return write(word);
        case asked::lowest:
            if (is_written_) {
                limits_.lowest = word;
                return confirm(true);
            }
            told_.word = word == 0 ? reference_.word : told_.word;
            return read_scale();
        case asked::standing: return told_.is_within(word) ? read_scale() : read_limits();
        case asked::highest: limits_.highest = word; return go_on_to_speed();
        case asked::rated_frequency: rated_ = word; return ask(asked::rated_speed, speed_address());
        case asked::rated_speed:
            return limits_.note_scale(rated_, word) ? hold_against_limits()
                   : is_written_                    ? confirm(true)
                                                    : go_without_scale(errc::none);
        case asked::written:
            holds_reference_ = word == told_.word;
            return holds_reference_ ? ask(asked::status, layout().eta) : end(outcome_kind::overwritten);
        case asked::frequency: break;
        }
        return count(word != 0 ? outcome_kind::succeeded : outcome_kind::pending);
    }

    constexpr action judge(std::uint16_t status) noexcept
    {
        cia402::state const at = note(status);
        if (cia402::is_in_fault(at)) {
            return ask(asked::fault, layout().lft);
        }
        if ((status & remote_bit) == 0) {
            return end(outcome_kind::local_control);
        }
        if (at != cia402::state::operation_enabled) {
            bool const is_key_shown = (status & stop_key_bit) != 0;
            return end(is_key_shown  ? outcome_kind::stop_key
                       : is_written_ ? outcome_kind::fell_back
                                     : outcome_kind::aborted);
        }
        if (not is_written_) {
            told_.word = reference_.keeping(status).word;
            return ask(asked::control, layout().cmd);
        }
        if ((status & reference_limited_bit) != 0) {
            return count(outcome_kind::reference_limited);
        }
        bool const is_reached = (status & reference_reached_bit) != 0;
        bool const turns_back = (status & runs_backwards_bit) != 0;
        if (reference_.is_zero() or not is_reached or turns_back != reference_.is_reverse()) {
            return count(reference_.is_zero() and is_reached ? outcome_kind::succeeded : outcome_kind::pending);
        }
        return holds_reference_ ? count(outcome_kind::succeeded) : ask(asked::frequency, layout().rfr);
    }

    /// A drive may still show that it has reached the reference before this one, or that it limits that one: so once is
    /// not enough. `pending`: neither is shown. Last comes a status: somebody may have stopped the motor meanwhile.
    constexpr action count(outcome_kind shown) noexcept
    {
        bool const is_again = shown == shown_ and shown != outcome_kind::pending;
        bool const is_last = std::exchange(holds_reference_, false);
        shown_ = shown;
        if (not is_again) {
            return to_pause(status_period);
        }
        if (not is_last) {
            bool const is_unnamed = shown == outcome_kind::reference_limited and not has_limits_;
            return is_unnamed and layout().hsp != 0 ? read_limits() : confirm(has_limits_);
        }
        bool const is_guessed = limits_.is_guessed(told_, reference_);
        if (shown == outcome_kind::reference_limited) {
            note_limit(limits_.kept_for(told_));
        }
        return end(is_guessed ? outcome_kind::reference_limited : shown);
    }

    /// Whether it still holds the reference that is reached, or limited. `has_limits`: both were asked for.
    constexpr action confirm(bool has_limits) noexcept
    {
        has_limits_ = has_limits;
        return ask(asked::written, told_.address);
    }

    /// One write of the reference with its sign: the direction bit stays as it is.
    constexpr action write(std::uint16_t control) noexcept
    {
        if ((control & layout().halt) != 0) {
            return end(outcome_kind::halted);
        }
        told_.word = told_.under(control).word;
        if (reference_.is_zero()) {
            return not told_.is_zero() and layout().lsp != 0 ? ask(asked::lowest, layout().lsp) : read_scale();
        }
        return beyond_ == beyond_limits::refuse and layout().hsp != 0 ? ask(asked::standing, told_.address)
                                                                      : read_scale();
    }

    constexpr action go_without(errc error) noexcept
    {
        bool const is_by_name = asked_ >= asked::lowest and asked_ <= asked::rated_speed;
        if (is_written_ and is_by_name) {
            limits_.highest = reference_limits::unread; // it ends without
            return confirm(true);
        }
        switch (asked_) {
        case asked::lowest: return read_scale();
        case asked::standing: return read_limits();
        case asked::highest: return end(outcome_kind::unknown_register, error);
        case asked::rated_frequency:
        case asked::rated_speed: return go_without_scale(error);
        case asked::status:
        case asked::fault:
        case asked::control:
        case asked::frequency:
        case asked::written: break;
        }
        return end(error);
    }

    constexpr std::uint16_t speed_address() const noexcept { return layout().nsp != 0 ? layout().nsp : layout().sds; }
    constexpr action read_limits() noexcept { return ask(asked::highest, layout().hsp); }
    /// What a hertz is decides how many rpm have a sign in the drive's steps.
    constexpr action read_scale() noexcept
    {
        constexpr std::uint16_t surely_signed = 20; // SDS is 200 at most
        bool const may_lose_sign = told_.is_reverse() and told_.size() < surely_signed;
        return may_lose_sign ? go_on_to_speed() : tell();
    }
    /// Of a reference that no limit refuses it is not needed.
    constexpr action go_without_scale(errc error) noexcept
    {
        bool const is_needed = limits_.highest != reference_limits::unread;
        limits_ = {};
        return is_needed ? end(outcome_kind::unknown_register, error) : tell();
    }
    constexpr action go_on_to_speed() noexcept
    {
        bool const has_speed = told_.is_speed and speed_address() != 0;
        return not has_speed       ? hold_against_limits()
               : layout().frs != 0 ? ask(asked::rated_frequency, layout().frs)
                                   : ask(asked::rated_speed, speed_address());
    }
    constexpr action hold_against_limits() noexcept
    {
        if (is_written_) {
            return ask(asked::lowest, layout().lsp);
        }
        outcome_kind const found = limits_.judge(told_, false);
        return found == outcome_kind::succeeded ? tell() : end_beyond(found, limits_.highest);
    }
    constexpr action tell() noexcept
    {
        asked_ = asked::status;
        told_.word = limits_.signed_for_drive(told_);
        return to_enable(told_.address, told_.word);
    }

    reference_write reference_;
    reference_write told_{reference_.address, reference_.word,
                          reference_.is_speed}; ///< as this drive has to be told it
    reference_limits limits_{};
    outcome_kind shown_{outcome_kind::pending}; ///< at the look before
    std::uint16_t rated_{0};                    ///< FRS
    beyond_limits beyond_;
    asked asked_{asked::status};
    bool is_written_{false};
    bool has_limits_{false};      ///< it was asked for what limits the reference
    bool holds_reference_{false}; ///< the one written: the word read last
};

/// Changes the reference of a drive in operation; a negative one is in reverse, and 0 keeps the direction in which the
/// motor turns. Done where two status reads after the write show that it is reached and that the motor turns in that
/// direction, the drive then still holds it (else `overwritten`), and a third status shows it once more;
/// `reference_limited` where they show that the drive limits it (`reason().limit` is the limit that it keeps to, where it tells); `above_hsp` where it was not written, because it is
/// above HSP and not slower than the one before (`beyond_limits::limit` writes it all the same); `halted` where the
/// halt bit is set, `state_timeout` where the drive does not reach it in time. A long ramp needs a long limit. A drive
/// that leaves operation ends it as `stop_key` or `fell_back`; one not in operation at the first read as `aborted`, or
/// as `stop_key` if that stopped it.
class change_reference : public procedure_runner<reference_procedure> {
public:
    /// Changes the reference of this drive, within `limit`.
    template <device_type Device>
    constexpr change_reference(station<Device> const& drive, std::type_identity_t<reference<Device>> const& to,
                               duration limit = milliseconds(30'000),
                               beyond_limits beyond = beyond_limits::refuse) noexcept
        : procedure_runner{drive.unit(), limit, drive_check<Device>::layout, to.write(), beyond}
    {}
};

} // namespace altivar
} // namespace RTUWIRE_BUILD
} // namespace rtuwire
