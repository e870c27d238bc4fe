// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// Gives a running drive another speed or direction, and waits until its status confirms it.
#pragma once

#include <cstdint>
#include <type_traits>

#include <rtuwire/altivar/device/reference.hpp>
#include <rtuwire/altivar/procedure/procedure_runner.hpp>
#include <rtuwire/core/version.hpp>

namespace rtuwire::inline RTUWIRE_BUILD::altivar {

/// Decides a change of the reference, word by word.
///
/// | read of       | answer                              | not yet written     | written                             |
/// |---------------|-------------------------------------|---------------------|-------------------------------------|
/// | ETA           | 7, 8                                | read LFT            | read LFT                            |
/// |               | in local control                    | end: local_control  | end: local_control                  |
/// |               | 1 to 4, 6, or no state              | end: aborted        | end: fell_back                      |
/// |               | the same with the STOP key          | end: stop_key       | end: stop_key                       |
/// |               | 5                                   | read CMD            | wait, not reached                   |
/// |               | 5, limited                          | read CMD            | end: reference_limited              |
/// |               | 5, reached in the ordered direction | read CMD            | read RFR; a reference of 0: reached |
/// | RFR           | 0                                   |                     | wait, not reached                   |
/// |               | other                               |                     | reached                             |
/// | CMD           | with the halt bit                   | end: halted         |                                     |
/// |               | other                               | write the reference |                                     |
/// | LFT           | any                                 | end: in_fault       | end: in_fault                       |
/// | the reference | confirmed                           | wait                |                                     |
/// | a wait        | over                                |                     | read ETA                            |
/// | anything      | no response                         | end: silent         | end: silent                         |
/// |               | refused                             | end: refused        | end: refused                        |
/// |               | limit over                          | end: aborted        | end: state_timeout                  |
///
/// "Reached" waits the first time, and ends as `succeeded` the second time in a row. A reference of 0 has no direction.
/// Internal.
class reference_procedure : public procedure {
public:
    static constexpr bool follows_order = true;

    constexpr reference_procedure(drive_layout const& layout, reference_write reference) noexcept
        : procedure{layout}, reference_{reference}
    {}

    constexpr action step(event const& what) noexcept
    {
        switch (what.what) {
        case event::kind::begun: return ask(asked::status, layout().eta);
        case event::kind::pause_over: return ask(asked::status, layout().eta);
        case event::kind::word_read: return on_response(what.word);
        case event::kind::written: is_written_ = true; return to_pause(status_period);
        case event::kind::failed: return end(what.error);
        case event::kind::late: break;
        }
        return end(is_written_ ? outcome_kind::state_timeout : outcome_kind::aborted);
    }

private:
    enum class asked : std::uint8_t { status, fault, control, frequency };

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
        case asked::frequency: break;
        }
        return count_reached(word != 0);
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
            return ask(asked::control, layout().cmd);
        }
        if ((status & reference_limited_bit) != 0) {
            return end(outcome_kind::reference_limited);
        }
        bool const is_reached = (status & reference_reached_bit) != 0;
        bool const turns_back = (status & runs_backwards_bit) != 0;
        if (reference_.is_zero() or not is_reached or turns_back != reference_.is_reverse()) {
            return count_reached(reference_.is_zero() and is_reached);
        }
        return ask(asked::frequency, layout().rfr);
    }

    /// A drive may still show that it has reached the reference before this one, so once is not enough.
    constexpr action count_reached(bool is_reached) noexcept
    {
        constexpr int looks_at_it = 2;
        reached_ = is_reached ? reached_ + 1 : 0;
        return reached_ >= looks_at_it ? end(outcome_kind::succeeded) : to_pause(status_period);
    }

    /// One write of the reference with its sign: the direction bit stays as it is.
    constexpr action write(std::uint16_t control) noexcept
    {
        if ((control & layout().halt) != 0) {
            return end(outcome_kind::halted);
        }
        reference_write const told = reference_.under(control);
        return to_enable(told.address, told.word);
    }

    reference_write reference_;
    int reached_{0};
    asked asked_{asked::status};
    bool is_written_{false};
};

/// Changes the reference of a drive in operation; a negative one is in reverse. Done where two status reads after the
/// write show that it is reached, and the motor turns in that direction; `reference_limited` where the drive limits
/// it, `halted` where the halt bit is set, `state_timeout` where the drive does not reach it in time. A long ramp needs
/// a long limit. A drive that leaves operation ends it as `stop_key` or `fell_back`; one not in operation at the
/// first read as `aborted`, or as `stop_key` if that stopped it.
class change_reference : public procedure_runner<reference_procedure> {
public:
    template <device_type Device>
    constexpr change_reference(station<Device> const& drive, std::type_identity_t<reference<Device>> const& to,
                               duration limit = milliseconds(30'000)) noexcept
        : procedure_runner{drive.unit(), reference_procedure{Device::layout, to.write()}, limit}
    {}
};

} // namespace rtuwire::altivar
