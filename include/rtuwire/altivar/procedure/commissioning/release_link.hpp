// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// An ATV28 gives the control back to its terminals, or takes it from them, by a control word of its serial link. After
// power-up the terminals have it until the line commands. A released drive obeys a closed run input at once, so it is
// released only where it stands and its run inputs were just read as open.
#pragma once

#include <cstdint>

#include <rtuwire/altivar/device/atv28.hpp>
#include <rtuwire/altivar/procedure/commissioning/last_look.hpp>
#include <rtuwire/altivar/procedure/inspection/at_rest.hpp>
#include <rtuwire/altivar/procedure/procedure_runner.hpp>
#include <rtuwire/core/version.hpp>
#include <rtuwire/table/device.hpp>

namespace rtuwire {
inline namespace RTUWIRE_BUILD {
namespace altivar::atv28 {

/// Control words with bit 15, outside the states of the drive profile.
/// Internal.
inline constexpr std::uint16_t link_activated = 0x8000; ///< bit 1 low: no power to the motor
/// Internal.
inline constexpr std::uint16_t link_released = 0x8100;

/// Decides a release or its opposite, word by word. "Closing" is a `last_look` that writes 8000 to a motor that runs,
/// and then ends so.
///
/// | stage         | word read                       | confirmed | no response     | refused          | limit over       |
/// |---------------|---------------------------------|-----------|-----------------|------------------|------------------|
/// | looking       | the check, write 8100           |           | end: silent     | as in a check    | end: aborted     |
/// | telling       |                                 | wait      | closing: silent | closing: refused | closing: aborted |
/// | confirming    | a `last_look`; then read ETI    |           | closing: silent | closing: refused | closing: aborted |
/// | asking_source | its bit 14 is 0: end: succeeded |           | closing: silent | closing: refused | closing: aborted |
/// |               | else end: not_taken             |           |                 |                  |                  |
///
/// A wait ends with confirming. The opposite of a release writes 8000, and bit 14 has to be 1.
/// Internal.
class link_procedure : public procedure {
public:
    /// The time to look once more at a drive whose terminals may have started its motor.
    static constexpr duration grace{milliseconds(3'000)};
    static constexpr bool gives_way_to_order = true;

    constexpr link_procedure(bool is_release, terminal_options const& options) noexcept
        : link_procedure{is_release, at_rest_procedure{device::layout, options}}
    {}

    [[nodiscard]] constexpr link_procedure anew() const noexcept { return {is_release_, look_.anew()}; }

    constexpr action step(event what) noexcept
    {
        if (stage_ == stage::looking) {
            return check_rest(what);
        }
        bool const is_late = what.what() == event::kind::late and not last_.is_cutting();
        if (stage_ == stage::closing or (stage_ == stage::confirming and not is_late)) {
            return see(what);
        }
        switch (what.what()) {
        case event::kind::written: return to_pause(status_period);
        case event::kind::pause_over: return look_last(stage::confirming, {outcome_kind::succeeded});
        case event::kind::word_read: return judge_source(what.word());
        case event::kind::failed: return look_last(stage::closing, {kind_for(what.error()), what.error()});
        case event::kind::begun:
        case event::kind::late: break;
        }
        return look_last(stage::closing, {outcome_kind::aborted});
    }

private:
    enum class stage : std::uint8_t { looking, telling, confirming, asking_source, closing };

    constexpr link_procedure(bool is_release, at_rest_procedure const& look) noexcept
        : procedure{device::layout}, look_{look}, last_{device::layout, link_activated}, is_release_{is_release}
    {}

    constexpr action check_rest(event what) noexcept
    {
        action const next = run_inside(look_, what);
        if (look_.reason().kind != outcome_kind::succeeded) {
            return next;
        }
        stage_ = stage::telling;
        return to_rearrange(layout().cmd, is_release_ ? link_released : link_activated);
    }

    /// The link may always be activated, and the word for it removes the power.
    constexpr action look_last(stage next, altivar::reason const& so) noexcept
    {
        stage_ = next;
        if (next == stage::closing) {
            note_taking_back();
        }
        last_ = last_look{layout(), link_activated};
        return last_.begin(so, reason().state);
    }

    constexpr action see(event what) noexcept
    {
        action const next = run_inside(last_, what);
        if (last_.reason().kind != outcome_kind::succeeded) {
            return next;
        }
        stage_ = stage::asking_source;
        return to_read(layout().eti);
    }

    constexpr action judge_source(std::uint16_t word) noexcept
    {
        constexpr std::uint16_t source_link = 0x4000;
        bool const is_by_link = (word & source_link) != 0;
        return end(is_by_link != is_release_ ? outcome_kind::succeeded : outcome_kind::not_taken);
    }

    at_rest_procedure look_;
    last_look last_;
    stage stage_{stage::looking};
    bool is_release_;
};

/// Gives the control of a drive at rest to its terminals or its keypad. Refused while it runs, in a fault, and while a
/// run input is closed. If the motor starts all the same, activating the link again removes its power, and this ends as
/// `started_by_terminals`; it looks for that at every end after the release, up to 3 s after its limit, and where that
/// look fails, it activates the link, too. `not_taken` where the drive reports that the link still commands.
class release_link : public procedure_runner<link_procedure> {
public:
    /// Releases this drive, within `limit`, but for the last look.
    explicit constexpr release_link(station<device> const& drive, terminal_options const& options = {},
                                    duration limit = milliseconds(3'000)) noexcept
        : procedure_runner{drive.unit(), limit, true, options}
    {}
};

/// Takes the control of a drive at rest, which is afterwards in "switch on disabled". Refused while the terminals run
/// it, and by an exception in forced local.
class activate_link : public procedure_runner<link_procedure> {
public:
    /// Takes this drive, within `limit`.
    explicit constexpr activate_link(station<device> const& drive, duration limit = milliseconds(3'000)) noexcept
        : procedure_runner{drive.unit(), limit, false, terminal_options{.run_inputs = 0}}
    {}
};

} // namespace altivar::atv28
} // namespace RTUWIRE_BUILD
} // namespace rtuwire
