// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// Brings a drive's settings back to those as delivered. Terminals command a drive as delivered, and a later
// Altivar has no unit address then: whoever orders this says that he knows, and nobody confirms it. A run input that
// is closed would start the motor by it, so the drive is looked at first.
#pragma once

#include <cstdint>

#include <rtuwire/altivar/at_rest.hpp>
#include <rtuwire/altivar/drive_talk.hpp>
#include <rtuwire/core/version.hpp>
#include <rtuwire/table/device.hpp>

namespace rtuwire::inline RTUWIRE_BUILD::altivar {

/// Said by whoever orders it: the line's control and the drive's address may be gone afterwards.
struct losing_control_and_address {
    explicit constexpr losing_control_and_address() noexcept = default;
};

/// Decides it, word by word.
class factory_script : public script {
public:
    constexpr factory_script(drive_profile const& profile, terminal_options const& options) noexcept
        : script{profile}, look_{profile, options, {.accepts_fault = true, .ends_three_wire = true}}
    {}

    constexpr wish step(event const& what) noexcept
    {
        if (not has_looked_ and what.what != event::kind::late) {
            return look(what);
        }
        switch (what.what) {
        case event::kind::word_read: return heard(what.word);
        case event::kind::written:
            return is_taking_back_ ? end(ending::executed_unconfirmed)
                                   : to_pause(profile().eeprom_time);
        case event::kind::pause_over: return take_back();
        case event::kind::failed:
            return is_taking_back_ ? end(ending::executed_unconfirmed) : end(what.error);
        case event::kind::begun:
        case event::kind::late: break;
        }
        return end(is_taking_back_ ? ending::executed_unconfirmed : ending::silent,
                   errc::timed_out);
    }

private:
    constexpr wish look(event const& what) noexcept
    {
        wish const next = run_inside(look_, what);
        has_looked_ = look_.reason().how == ending::succeeded;
        return has_looked_ ? to_read(profile().cmi) : next;
    }

    constexpr wish heard(std::uint16_t word) noexcept
    {
        // Orders in what was read are not given again: factory settings, save, recall.
        constexpr std::uint16_t factory_bit = 0x0001;
        control_ = static_cast<std::uint16_t>(word & ~profile().cmi_orders);
        return to_rearrange(profile().cmi, static_cast<std::uint16_t>(control_ | factory_bit));
    }

    /// The order does not stand there for ever, if the drive still hears it.
    constexpr wish take_back() noexcept
    {
        is_taking_back_ = true;
        return to_write(profile().cmi, control_);
    }

    at_rest_script look_;
    std::uint16_t control_{0};
    bool has_looked_{false};
    bool is_taking_back_{false};
};

/// Restores the factory settings of a drive that stands or is in fault, with its run inputs open
/// (`run_input_closed`): also that of three-wire control, because two-wire control comes back. Where the inputs cannot
/// be read, as on an ATV310, the risk has to be taken (`accept_unseen_inputs`), or it ends as `unknown_register`.
/// Nothing is saved: the settings are gone with the power unless `save_to_eeprom` follows, where the drive still hears
/// it. Where all went well it ends as `executed_unconfirmed`; `succeeded` is never said.
class restore_factory_settings : public drive_talk<factory_script> {
public:
    template <device_type Device>
    constexpr restore_factory_settings(station<Device> const& drive, losing_control_and_address,
                                       terminal_options const& options = {},
                                       duration limit = milliseconds(5'000)) noexcept
        : drive_talk{drive.unit(), factory_script{Device::profile, options}, limit}
    {}

    /// Refused: nobody has said it.
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
