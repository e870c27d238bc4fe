// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// Saves a drive's settings to its EEPROM, and takes the order back: a CMI that keeps the bit set wears
// the memory out. Orders that stand in CMI from before are not given again with it.
#pragma once

#include <cstdint>

#include <rtuwire/altivar/drive_talk.hpp>
#include <rtuwire/core/version.hpp>
#include <rtuwire/table/device.hpp>

namespace rtuwire::inline RTUWIRE_BUILD::altivar {

/// Decides a save, word by word.
class save_script : public script {
public:
    explicit constexpr save_script(drive_profile const& profile) noexcept : script{profile} {}

    constexpr wish step(event const& what) noexcept
    {
        switch (what.what) {
        case event::kind::begun: return to_read(profile().eta);
        case event::kind::word_read: return heard(what.word);
        case event::kind::written: return after_write();
        case event::kind::pause_over:
            return profile().shows_eeprom_access ? to_read(profile().eti) : take_back();
        case event::kind::failed: return withdraw(what.error);
        case event::kind::late: break;
        }
        return withdraw(errc::timed_out);
    }

private:
    enum class stage : std::uint8_t { looking, reading_control, saving, taking_back };

    constexpr wish heard(std::uint16_t word) noexcept
    {
        switch (stage_) {
        case stage::looking:
            if (cia402::has_power(note(word))) {
                return end(ending::refused_while_running);
            }
            stage_ = stage::reading_control;
            return to_read(profile().cmi);
        case stage::reading_control:
            control_ = static_cast<std::uint16_t>(word & ~profile().cmi_orders);
            stage_ = stage::saving;
            return to_write(profile().cmi, static_cast<std::uint16_t>(control_ | save_bit));
        case stage::saving:
        case stage::taking_back: break;
        }
        constexpr std::uint16_t eeprom_access = 0x0001;
        return (word & eeprom_access) != 0 ? to_pause(look_period) : take_back();
    }

    constexpr wish take_back() noexcept
    {
        stage_ = stage::taking_back;
        return to_write(profile().cmi, control_);
    }

    constexpr wish after_write() noexcept
    {
        return stage_ == stage::taking_back ? end(ending::succeeded)
                                            : to_pause(profile().eeprom_time);
    }

    /// Ends, but not with the bit set.
    constexpr wish withdraw(errc error) noexcept
    {
        wish const over = end(error);
        return stage_ == stage::saving ? take_back() : over;
    }

    std::uint16_t control_{0};
    stage stage_{stage::looking};
};

/// Saves all settings of a stopped drive. The memory takes this 100 000 times in the drive's life: call
/// it when a person has finished a change, never in a cycle. The order is taken back at the end, also
/// where the save failed.
class save_to_eeprom : public drive_talk<save_script> {
public:
    template <device_type Device>
    explicit constexpr save_to_eeprom(station<Device> const& drive,
                                      duration limit = milliseconds(5'000)) noexcept
        : drive_talk{drive.unit(), save_script{Device::profile}, limit}
    {}
};

} // namespace rtuwire::altivar
