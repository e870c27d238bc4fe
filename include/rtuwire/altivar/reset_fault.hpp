// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// Clears a fault: bit 7 low, high, and low again, because only its rising edge counts. A drive that is
// in no fault is left alone.
#pragma once

#include <cstdint>

#include <rtuwire/altivar/drive_talk.hpp>
#include <rtuwire/core/version.hpp>
#include <rtuwire/table/device.hpp>

namespace rtuwire::inline RTUWIRE_BUILD::altivar {

/// Decides a reset, word by word.
class reset_script : public script {
public:
    explicit constexpr reset_script(drive_profile const& profile) noexcept : script{profile} {}

    constexpr wish step(event const& what) noexcept
    {
        switch (what.what) {
        case event::kind::begun:
        case event::kind::pause_over: return to_read(profile().eta);
        case event::kind::word_read:
            return stage_ == stage::reading_fault ? end_in_fault(what.word) : look(what.word);
        case event::kind::written: return after_write();
        case event::kind::failed: return end(what.error);
        case event::kind::late: break;
        }
        stage_ = stage::reading_fault;
        return to_read(profile().lft);
    }

private:
    enum class stage : std::uint8_t { looking, low, high, low_again, checking, reading_fault };

    constexpr wish look(std::uint16_t status) noexcept
    {
        cia402::state const at = note(status);
        if (at == cia402::state::unknown or at == cia402::state::fault_reaction_active) {
            return to_pause(look_period);
        }
        if (at != cia402::state::fault) {
            return end(ending::succeeded);
        }
        if (stage_ == stage::checking) {
            return to_pause(look_period);
        }
        return give(stage::low, 0);
    }

    constexpr wish give(stage next, std::uint16_t word) noexcept
    {
        stage_ = next;
        return to_reset(profile().cmd, word);
    }

    constexpr wish after_write() noexcept
    {
        if (stage_ == stage::low) {
            return give(stage::high, cia402::fault_reset_bit);
        }
        if (stage_ == stage::high) {
            return give(stage::low_again, 0);
        }
        stage_ = stage::checking;
        return to_read(profile().eta);
    }

    stage stage_{stage::looking};
};

/// Clears a fault whose cause is gone. Where it is not, the ending is `in_fault` with its LFT.
class reset_fault : public drive_talk<reset_script> {
public:
    template <device_type Device>
    explicit constexpr reset_fault(station<Device> const& drive,
                                   duration limit = milliseconds(2'000)) noexcept
        : drive_talk{drive.unit(), reset_script{Device::profile}, limit}
    {}
};

} // namespace rtuwire::altivar
