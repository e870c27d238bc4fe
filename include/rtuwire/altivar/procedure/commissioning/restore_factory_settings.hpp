// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// Restores a drive's factory settings. With these the terminals command the drive, and a later Altivar has no unit
// address: the caller has to state that this is known, and the drive does not confirm the result. A closed run input
// would then start the motor, so the drive is checked first.
#pragma once

#include <cstdint>

#include <rtuwire/altivar/procedure/inspection/at_rest.hpp>
#include <rtuwire/altivar/procedure/procedure_runner.hpp>
#include <rtuwire/core/version.hpp>
#include <rtuwire/table/device.hpp>

namespace rtuwire::inline RTUWIRE_BUILD::altivar {

/// The caller's statement: the line's control and the drive's address may be lost afterwards.
struct losing_control_and_address {
    explicit constexpr losing_control_and_address() noexcept = default;
};

/// Decides the restore, word by word.
///
/// | stage       | word read            | confirmed                  | no response | refused       | limit over  |
/// |-------------|----------------------|----------------------------|-------------|---------------|-------------|
/// | looking     | the check, read CMI  |                            | end: silent | as in a check | end: silent |
/// | reading CMI | write CMI with bit 0 |                            | end: silent | end: refused  | end: silent |
/// | ordering    |                      | wait, write CMI without it | end: silent | end: refused  | end: silent |
/// | taking back |                      | end: maybe                 | end: maybe  | end: maybe    | end: maybe  |
///
/// "Maybe" is `executed_unconfirmed`. CMI is written without the orders that it held.
/// Internal.
class factory_procedure : public procedure {
public:
    constexpr factory_procedure(drive_layout const& layout, terminal_options const& options) noexcept
        : procedure{layout}, look_{layout, options, {.accepts_fault = true, .ends_three_wire = true}}
    {}

    constexpr action step(event const& what) noexcept
    {
        if (not has_looked_ and what.what != event::kind::late) {
            return check_rest(what);
        }
        switch (what.what) {
        case event::kind::word_read: return on_response(what.word);
        case event::kind::written:
            return is_taking_back_ ? end(outcome_kind::executed_unconfirmed) : to_pause(layout().eeprom_time);
        case event::kind::pause_over: return take_back();
        case event::kind::failed: return is_taking_back_ ? end(outcome_kind::executed_unconfirmed) : end(what.error);
        case event::kind::begun:
        case event::kind::late: break;
        }
        return end(is_taking_back_ ? outcome_kind::executed_unconfirmed : outcome_kind::silent, errc::timed_out);
    }

private:
    constexpr action check_rest(event const& what) noexcept
    {
        action const next = run_inside(look_, what);
        has_looked_ = look_.reason().kind == outcome_kind::succeeded;
        return has_looked_ ? to_read(layout().cmi) : next;
    }

    constexpr action on_response(std::uint16_t word) noexcept
    {
        // Orders in the word that was read are not repeated: factory settings, save, recall.
        constexpr std::uint16_t factory_bit = 0x0001;
        control_ = static_cast<std::uint16_t>(word & ~layout().cmi_orders);
        return to_rearrange(layout().cmi, static_cast<std::uint16_t>(control_ | factory_bit));
    }

    /// Clears the order in CMI, if the drive still receives requests.
    constexpr action take_back() noexcept
    {
        is_taking_back_ = true;
        return to_write(layout().cmi, control_);
    }

    at_rest_procedure look_;
    std::uint16_t control_{0};
    bool has_looked_{false};
    bool is_taking_back_{false};
};

/// Restores the factory settings of a drive at rest or in fault, with its run inputs open (else `run_input_closed`):
/// in three-wire control, too, because two-wire control comes back. Where the inputs cannot be read, as on an ATV310,
/// the risk has to be accepted (`accept_unseen_inputs`), or it ends as `unknown_register`. Nothing is saved: the
/// settings are lost with the power unless `save_to_eeprom` follows, if the drive can still be reached. A good end is
/// `executed_unconfirmed`; it never ends as `succeeded`.
class restore_factory_settings : public procedure_runner<factory_procedure> {
public:
    template <device_type Device>
    constexpr restore_factory_settings(station<Device> const& drive, losing_control_and_address,
                                       terminal_options const& options = {},
                                       duration limit = milliseconds(5'000)) noexcept
        : procedure_runner{drive.unit(), factory_procedure{Device::layout, options}, limit}
    {}

    /// Refused: the statement is missing.
    template <device_type Device>
    explicit constexpr restore_factory_settings(station<Device> const& drive) noexcept
        : restore_factory_settings{drive, losing_control_and_address{}}
    {
        static_assert(not device_type<Device>,
                      "factory settings may take the line's control and the drive's address away: "
                      "say losing_control_and_address");
    }
};

} // namespace rtuwire::altivar
