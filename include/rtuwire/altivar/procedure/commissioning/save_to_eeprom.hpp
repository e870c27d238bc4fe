// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// Saves a drive's settings to its EEPROM, and clears the order: a CMI that keeps the bit set wears
// the memory out. Orders left in CMI from before are not repeated with it.
#pragma once

#include <cstdint>

#include <rtuwire/altivar/device/drive_type.hpp>
#include <rtuwire/altivar/procedure/procedure_runner.hpp>
#include <rtuwire/core/version.hpp>
#include <rtuwire/table/device.hpp>

namespace rtuwire {
inline namespace RTUWIRE_BUILD {
namespace altivar {

/// Decides a save, word by word.
///
/// "Undo" writes CMI without its orders, and then ends so. "Running" is `refused_while_running`.
///
/// | stage           | word read              | confirmed | no response  | refused       | limit over          |
/// |-----------------|------------------------|-----------|--------------|---------------|---------------------|
/// | looking         | 5, 6, 7: end: running  |           | end: silent  | end: refused  | end: aborted        |
/// |                 | 2, 3, 4, 8: read CMI   |           |              |               |                     |
/// |                 | else: end: aborted     |           |              |               |                     |
/// | reading_control | write CMI to save      |           | end: silent  | end: refused  | end: aborted        |
/// | saving          |                        | wait      | undo: silent | undo: refused | undo: aborted       |
/// | waiting         | still saving: wait     |           | undo: silent | undo: refused | undo: state_timeout |
/// |                 | other: undo: succeeded |           |              |               |                     |
/// | taking_back     |                        | end: so   | end: silent  | end: refused  | write it again      |
///
/// A wait ends with a read of ETI, or with "undo: succeeded" where the drive does not show there that it saves. In
/// taking_back an outcome that stands already stays.
/// Internal.
class save_procedure : public procedure {
public:
    explicit constexpr save_procedure(drive_layout const& layout) noexcept : procedure{layout} {}

    [[nodiscard]] constexpr save_procedure anew() const noexcept { return save_procedure{layout()}; }

    constexpr action step(event what) noexcept
    {
        switch (what.what()) {
        case event::kind::begun: return to_read(layout().eta);
        case event::kind::word_read: return on_response(what.word());
        case event::kind::written: return after_write();
        case event::kind::pause_over: return layout().shows_eeprom_access ? to_read(layout().eti) : take_back();
        case event::kind::failed: return abort(kind_for(what.error()), what.error());
        case event::kind::late: break;
        }
        return end_late();
    }

    /// Whether the order is being taken back, which has to reach the drive.
    [[nodiscard]] constexpr bool is_taking_back() const noexcept { return stage_ == stage::taking_back; }

private:
    enum class stage : std::uint8_t {
        looking,
        reading_control,
        saving,  ///< the order is written
        waiting, ///< until the drive has saved
        taking_back,
    };

    constexpr action on_response(std::uint16_t word) noexcept
    {
        switch (stage_) {
        case stage::looking:
            if (not stands(note(word))) {
                return end_running();
            }
            stage_ = stage::reading_control;
            return to_read(layout().cmi);
        case stage::reading_control:
            control_ = static_cast<std::uint16_t>(word & ~layout().cmi_orders);
            stage_ = stage::saving;
            return to_write(layout().cmi, static_cast<std::uint16_t>(control_ | save_bit));
        case stage::saving:
        case stage::waiting:
        case stage::taking_back: break;
        }
        constexpr std::uint16_t eeprom_access = 0x0001;
        return (word & eeprom_access) != 0 ? to_pause(status_period) : take_back();
    }

    constexpr action take_back() noexcept
    {
        stage_ = stage::taking_back;
        return to_write(layout().cmi, control_);
    }

    constexpr action after_write() noexcept
    {
        if (stage_ == stage::taking_back) {
            return end(outcome_kind::succeeded);
        }
        stage_ = stage::waiting;
        return to_pause(layout().eeprom_time);
    }

    constexpr action end_late() noexcept
    {
        if (stage_ == stage::taking_back) {
            return take_back(); // still has to be sent
        }
        return abort(stage_ == stage::waiting ? outcome_kind::state_timeout : outcome_kind::aborted, errc::none);
    }

    /// Ends, but not with the bit set.
    constexpr action abort(outcome_kind kind, errc error) noexcept
    {
        bool const may_be_set = stage_ == stage::saving or stage_ == stage::waiting;
        action const over = end(kind, error);
        return may_be_set ? take_back() : over;
    }

    std::uint16_t control_{0};
    stage stage_{stage::looking};
};

/// Saves all settings of a stopped drive; `state_timeout` where it was still saving at the limit. The memory endures this
/// 100 000 times in the drive's life: call it when a person has finished a change, never in a cycle. The order is
/// cleared at the end, also where the save failed.
class save_to_eeprom : public procedure_runner<save_procedure> {
public:
    /// Saves the settings of this drive, within `limit`.
    template <device_type Device>
    explicit constexpr save_to_eeprom(station<Device> const& drive, duration limit = milliseconds(5'000)) noexcept
        : procedure_runner{drive.unit(), limit, drive_check<Device>::layout}
    {}
};

} // namespace altivar
} // namespace RTUWIRE_BUILD
} // namespace rtuwire
