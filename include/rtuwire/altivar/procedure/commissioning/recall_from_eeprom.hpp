// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// Restores the settings that a drive saved last: what was written since is lost. Only an ATV28 has the order, bit 2
// of CMI; other orders that CMI still holds are not repeated with it.
#pragma once

#include <cstdint>

#include <rtuwire/altivar/procedure/inspection/at_rest.hpp>
#include <rtuwire/altivar/procedure/procedure_runner.hpp>
#include <rtuwire/core/version.hpp>
#include <rtuwire/table/device.hpp>

namespace rtuwire::inline RTUWIRE_BUILD::altivar {

/// The bit of CMI that recalls.
/// Internal.
inline constexpr std::uint16_t recall_bit = 0x0004;

/// Decides a recall, word by word.
///
/// | stage           | word read                  | confirmed      | no response | refused       | limit over  |
/// |-----------------|----------------------------|----------------|-------------|---------------|-------------|
/// | looking         | the check, read CMI        |                | end: silent | as in a check | end: silent |
/// | reading_control | write CMI with bit 2       |                | end: silent | end: refused  | end: silent |
/// | ordering        |                            | wait, read CMI | end: maybe  | end: refused  | end: maybe  |
/// | confirming      | bit 2 is 0: end: succeeded |                | end: maybe  | end: refused  | end: maybe  |
/// |                 | else write CMI without it  |                |             |               |             |
/// | taking_back     |                            | end: not_taken | end: silent | end: refused  | end: silent |
///
/// "Maybe" is `executed_unconfirmed`. CMI is written without the orders that it held.
/// Internal.
class recall_procedure : public procedure {
public:
    constexpr recall_procedure(drive_layout const& layout, terminal_options const& options) noexcept
        : procedure{layout}, look_{layout, options, {.ends_three_wire = true}}
    {}

    constexpr action step(event const& what) noexcept
    {
        if (stage_ == stage::looking and what.what != event::kind::late) {
            return check_rest(what);
        }
        switch (what.what) {
        case event::kind::word_read: return on_response(what.word);
        case event::kind::written:
            return stage_ == stage::taking_back ? end(outcome_kind::not_taken) : to_pause(layout().eeprom_time);
        case event::kind::pause_over: return ask(stage::confirming, layout().cmi);
        case event::kind::failed: return fail(what.error);
        case event::kind::begun:
        case event::kind::late: break;
        }
        return fail(errc::timed_out);
    }

private:
    enum class stage : std::uint8_t {
        looking,
        reading_control,
        ordering,
        confirming, ///< the drive clears the bit once it has accepted the order
        taking_back,
    };

    constexpr action ask(stage next, std::uint16_t address) noexcept
    {
        stage_ = next;
        return to_read(address);
    }

    constexpr action check_rest(event const& what) noexcept
    {
        action const next = run_inside(look_, what);
        return look_.reason().kind == outcome_kind::succeeded ? ask(stage::reading_control, layout().cmi) : next;
    }

    constexpr action on_response(std::uint16_t word) noexcept
    {
        if (stage_ == stage::reading_control) {
            control_ = static_cast<std::uint16_t>(word & ~layout().cmi_orders);
            stage_ = stage::ordering;
            return once(to_rearrange(layout().cmi, static_cast<std::uint16_t>(control_ | recall_bit)));
        }
        if ((word & recall_bit) == 0) {
            return end(outcome_kind::succeeded);
        }
        // An order left in CMI would be executed some day.
        stage_ = stage::taking_back;
        return to_write(layout().cmi, control_);
    }

    /// Once the order was sent, it is unknown whether it was executed, and at which bit rate the drive receives.
    constexpr action fail(errc error) noexcept
    {
        bool const may_be_done = stage_ == stage::ordering or stage_ == stage::confirming;
        return may_be_done and not is_exception(error) ? end(outcome_kind::executed_unconfirmed, error) : end(error);
    }

    at_rest_procedure look_;
    std::uint16_t control_{0};
    stage stage_{stage::looking};
};

/// Recalls the saved settings of a drive at rest with its run inputs open: they may give the command to another source.
/// The drive is silent for up to 2 s. `not_taken` where it did not accept the order, which is then cleared;
/// `executed_unconfirmed` where it no longer answers.
class recall_from_eeprom : public procedure_runner<recall_procedure> {
public:
    template <device_type Device>
    explicit constexpr recall_from_eeprom(station<Device> const& drive, terminal_options const& options = {},
                                          duration limit = milliseconds(8'000)) noexcept
        : procedure_runner{drive.unit(), recall_procedure{Device::layout, options}, limit}
    {
        static_assert((Device::layout.cmi_orders & recall_bit) != 0,
                      "this device cannot recall its saved settings over the line");
    }
};

} // namespace rtuwire::altivar
