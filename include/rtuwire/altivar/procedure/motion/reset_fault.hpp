// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// Clears a fault: bit 7 low, high, and low again, because only its rising edge counts. A drive without a fault is
// not written to.
#pragma once

#include <cstdint>

#include <rtuwire/altivar/procedure/procedure_runner.hpp>
#include <rtuwire/core/version.hpp>
#include <rtuwire/table/device.hpp>

namespace rtuwire::inline RTUWIRE_BUILD::altivar {

/// Decides a reset, word by word.
///
/// | stage         | word read     | confirmed  | no response | refused      | limit over         |
/// |---------------|---------------|------------|-------------|--------------|--------------------|
/// | looking       | a status      |            | end: silent | end: refused | end: aborted       |
/// | low           |               | write 0080 | end: silent | end: refused | read LFT           |
/// | high          |               | write 0000 | end: silent | end: refused | read LFT           |
/// | low_again     |               | read ETA   | end: silent | end: refused | read LFT           |
/// | checking      | a status      |            | end: silent | end: refused | end: state_timeout |
/// | reading_fault | end: in_fault |            | end: silent | end: refused |                    |
///
/// | status         | looking        | checking       |
/// |----------------|----------------|----------------|
/// | 1 to 6         | end: succeeded | end: succeeded |
/// | 7, or no state | wait           | wait           |
/// | 8 fault        | write 0000     | wait           |
///
/// A wait ends with another read of ETA. Where the state read last is 7 or 8, the limit has LFT read.
/// Internal.
class reset_procedure : public procedure {
public:
    explicit constexpr reset_procedure(drive_layout const& layout) noexcept : procedure{layout} {}

    constexpr action step(event const& what) noexcept
    {
        switch (what.what) {
        case event::kind::begun:
        case event::kind::pause_over: return to_read(layout().eta);
        case event::kind::word_read:
            return stage_ == stage::reading_fault ? end_in_fault(what.word) : judge_status(what.word);
        case event::kind::written: return after_write();
        case event::kind::failed: return end(what.error);
        case event::kind::late: break;
        }
        return end_late();
    }

private:
    enum class stage : std::uint8_t { looking, low, high, low_again, checking, reading_fault };

    constexpr action judge_status(std::uint16_t status) noexcept
    {
        cia402::state const at = note(status);
        if (at == cia402::state::unknown or at == cia402::state::fault_reaction_active) {
            return to_pause(status_period);
        }
        if (at != cia402::state::fault) {
            return end(outcome_kind::succeeded);
        }
        if (stage_ == stage::checking) {
            return to_pause(status_period);
        }
        return send_command(stage::low, 0);
    }

    constexpr action send_command(stage next, std::uint16_t word) noexcept
    {
        stage_ = next;
        return to_reset(layout().cmd, word);
    }

    constexpr action after_write() noexcept
    {
        if (stage_ == stage::low) {
            return send_command(stage::high, cia402::fault_reset_bit);
        }
        if (stage_ == stage::high) {
            return send_command(stage::low_again, 0);
        }
        stage_ = stage::checking;
        return to_read(layout().eta);
    }

    /// The limit is over. Only a drive that was read in fault ends it so; its LFT is read for that.
    constexpr action end_late() noexcept
    {
        if (not cia402::is_in_fault(reason().state)) {
            return end(stage_ == stage::looking ? outcome_kind::aborted : outcome_kind::state_timeout);
        }
        stage_ = stage::reading_fault;
        return to_read(layout().lft);
    }

    stage stage_{stage::looking};
};

/// Clears a fault whose cause is gone. Where it is not, the outcome is `in_fault` with its LFT. `aborted`: the limit was
/// over before a state was read; nothing was written. `state_timeout`: it was over while the drive showed no state.
class reset_fault : public procedure_runner<reset_procedure> {
public:
    template <device_type Device>
    explicit constexpr reset_fault(station<Device> const& drive, duration limit = milliseconds(2'000)) noexcept
        : procedure_runner{drive.unit(), reset_procedure{Device::layout}, limit}
    {}
};

} // namespace rtuwire::altivar
