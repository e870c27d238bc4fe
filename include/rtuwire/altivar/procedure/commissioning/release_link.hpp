// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// An ATV28 gives the control back to its terminals, or takes it from them, by a control word of its serial link. After
// power-up the terminals have it until the line commands. A released drive obeys a closed run input at once, so it is
// released only where it stands and its run inputs were just read as open.
#pragma once

#include <cstdint>

#include <rtuwire/altivar/device/atv28.hpp>
#include <rtuwire/altivar/procedure/inspection/at_rest.hpp>
#include <rtuwire/altivar/procedure/procedure_runner.hpp>
#include <rtuwire/core/version.hpp>
#include <rtuwire/table/device.hpp>

namespace rtuwire::inline RTUWIRE_BUILD::altivar::atv28 {

/// Control words with bit 15, outside the states of the drive profile.
/// Internal.
inline constexpr std::uint16_t link_activated = 0x8000; ///< bit 1 low: no power to the motor
/// Internal.
inline constexpr std::uint16_t link_released = 0x8100;

/// Decides a release or its opposite, word by word.
///
/// | stage         | word read                       | confirmed      | no response  | refused       | limit over   |
/// |---------------|---------------------------------|----------------|--------------|---------------|--------------|
/// | looking       | the check, write 8100           |                | end: silent  | as in a check | end: aborted |
/// | telling       |                                 | wait, read ETA | end: silent  | end: refused  | end: aborted |
/// | confirming    | 5, 6, 7: write 8000             |                | end: silent  | end: refused  | end: aborted |
/// |               | other: read ETI                 |                |              |               |              |
/// | asking_source | its bit 14 is 0: end: succeeded |                | end: silent  | end: refused  | end: aborted |
/// |               | else end: not_taken             |                |              |               |              |
/// | taking_back   |                                 | end: started   | end: started | end: started  | end: aborted |
///
/// "Started" is `started_by_terminals`. The opposite of a release writes 8000, and bit 14 has to be 1.
/// Internal.
class link_procedure : public procedure {
public:
    constexpr link_procedure(bool is_release, terminal_options const& options) noexcept
        : procedure{device::layout}, look_{device::layout, options}, is_release_{is_release}
    {}

    constexpr action step(event const& what) noexcept
    {
        if (stage_ == stage::looking and what.what != event::kind::late) {
            return check_rest(what);
        }
        switch (what.what) {
        case event::kind::written: return after_write();
        case event::kind::pause_over: return ask(stage::confirming, layout().eta);
        case event::kind::word_read: return on_response(what.word);
        case event::kind::failed:
            return stage_ == stage::taking_back ? end(outcome_kind::started_by_terminals, what.error) : end(what.error);
        case event::kind::begun:
        case event::kind::late: break;
        }
        return end(outcome_kind::aborted, errc::timed_out);
    }

private:
    enum class stage : std::uint8_t { looking, telling, confirming, asking_source, taking_back };

    constexpr action ask(stage next, std::uint16_t address) noexcept
    {
        stage_ = next;
        return to_read(address);
    }

    constexpr action check_rest(event const& what) noexcept
    {
        action const next = run_inside(look_, what);
        if (look_.reason().kind != outcome_kind::succeeded) {
            return next;
        }
        stage_ = stage::telling;
        return to_rearrange(layout().cmd, is_release_ ? link_released : link_activated);
    }

    constexpr action after_write() noexcept
    {
        return stage_ == stage::taking_back ? end(outcome_kind::started_by_terminals) : to_pause(status_period);
    }

    constexpr action on_response(std::uint16_t word) noexcept
    {
        if (stage_ == stage::confirming) {
            if (cia402::has_power(note(word))) {
                // The link may always be activated, and the word for it removes the power.
                stage_ = stage::taking_back;
                return to_stop(layout().cmd, link_activated);
            }
            return ask(stage::asking_source, layout().eti);
        }
        constexpr std::uint16_t source_link = 0x4000;
        bool const is_by_link = (word & source_link) != 0;
        return end(is_by_link != is_release_ ? outcome_kind::succeeded : outcome_kind::not_taken);
    }

    at_rest_procedure look_;
    stage stage_{stage::looking};
    bool is_release_;
};

/// Gives the control of a drive at rest to its terminals or its keypad. Refused while it runs, in a fault, and while a
/// run input is closed; if the motor starts all the same, activating the link again removes its power, and this ends as
/// `started_by_terminals`. `not_taken` where the drive reports that the link still commands.
class release_link : public procedure_runner<link_procedure> {
public:
    explicit constexpr release_link(station<device> const& drive, terminal_options const& options = {},
                                    duration limit = milliseconds(3'000)) noexcept
        : procedure_runner{drive.unit(), link_procedure{true, options}, limit}
    {}
};

/// Takes the control of a drive at rest, which is afterwards in "switch on disabled". Refused while the terminals run
/// it, and by an exception in forced local.
class activate_link : public procedure_runner<link_procedure> {
public:
    explicit constexpr activate_link(station<device> const& drive, duration limit = milliseconds(3'000)) noexcept
        : procedure_runner{drive.unit(), link_procedure{false, terminal_options{.run_inputs = 0}}, limit}
    {}
};

} // namespace rtuwire::altivar::atv28
