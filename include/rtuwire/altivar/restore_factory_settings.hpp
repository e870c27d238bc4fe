// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// Brings a drive's settings back to those as delivered. Terminals command a drive as delivered, and a later
// Altivar has no unit address then: whoever orders this says that he knows, and nobody confirms it.
#pragma once

#include <cstdint>

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
    explicit constexpr factory_script(drive_profile const& profile) noexcept : script{profile} {}

    constexpr wish step(event const& what) noexcept
    {
        switch (what.what) {
        case event::kind::begun: return to_read(profile().eta);
        case event::kind::word_read: return heard(what.word);
        case event::kind::written:
            return is_taking_back_ ? end(ending::executed_unconfirmed)
                                   : to_pause(profile().eeprom_time);
        case event::kind::pause_over: return take_back();
        case event::kind::failed:
            return is_taking_back_ ? end(ending::executed_unconfirmed) : end(what.error);
        case event::kind::late: break;
        }
        return end(is_taking_back_ ? ending::executed_unconfirmed : ending::silent,
                   errc::timed_out);
    }

private:
    constexpr wish heard(std::uint16_t word) noexcept
    {
        // Orders in what was read are not given again: factory settings, save, recall.
        constexpr std::uint16_t factory_bit = 0x0001;
        if (not has_looked_) {
            has_looked_ = true;
            return cia402::has_power(note(word)) ? end(ending::refused_while_running)
                                                 : to_read(profile().cmi);
        }
        control_ = static_cast<std::uint16_t>(word & ~profile().cmi_orders);
        return to_write(profile().cmi, static_cast<std::uint16_t>(control_ | factory_bit));
    }

    /// The order does not stand there for ever, if the drive still hears it.
    constexpr wish take_back() noexcept
    {
        is_taking_back_ = true;
        return to_write(profile().cmi, control_);
    }

    std::uint16_t control_{0};
    bool has_looked_{false};
    bool is_taking_back_{false};
};

/// Restores the factory settings of a stopped drive. Nothing is saved: they are gone with the power unless
/// `save_to_eeprom` follows, where the drive still hears it. Where all went well it ends as
/// `executed_unconfirmed`; `succeeded` is never said.
class restore_factory_settings : public drive_talk<factory_script> {
public:
    template <device_type Device>
    constexpr restore_factory_settings(station<Device> const& drive, losing_control_and_address,
                                       duration limit = milliseconds(5'000)) noexcept
        : drive_talk{drive.unit(), factory_script{Device::profile}, limit}
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
