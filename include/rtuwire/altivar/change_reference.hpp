// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// Gives a running drive another speed, and waits until it is reached.
#pragma once

#include <cstdint>
#include <type_traits>

#include <rtuwire/altivar/drive_talk.hpp>
#include <rtuwire/altivar/reference.hpp>
#include <rtuwire/core/version.hpp>

namespace rtuwire::inline RTUWIRE_BUILD::altivar {

/// Decides a change of the reference, word by word.
class reference_script : public script {
public:
    constexpr reference_script(drive_profile const& profile, reference_write reference) noexcept
        : script{profile}, reference_{reference}
    {}

    constexpr wish step(event const& what) noexcept
    {
        switch (what.what) {
        case event::kind::begun:
        case event::kind::pause_over: return to_read(profile().eta);
        case event::kind::word_read:
            return is_reading_fault_ ? end_in_fault(what.word) : look(what.word);
        case event::kind::written: is_written_ = true; return to_pause(look_period);
        case event::kind::failed: return end(what.error);
        case event::kind::late: break;
        }
        return end(ending::stuck);
    }

private:
    constexpr wish look(std::uint16_t status) noexcept
    {
        cia402::state const at = note(status);
        if (cia402::is_in_fault(at)) {
            is_reading_fault_ = true;
            return to_read(profile().lft);
        }
        if ((status & remote_bit) == 0) {
            return end(ending::local_control);
        }
        if (at != cia402::state::operation_enabled) {
            return end(ending::stuck);
        }
        if (not is_written_) {
            return to_write(reference_.address, reference_.word);
        }
        if ((status & reference_limited_bit) != 0) {
            return end(ending::reference_limited);
        }
        return (status & reference_reached_bit) != 0 ? end(ending::succeeded)
                                                     : to_pause(look_period);
    }

    reference_write reference_;
    bool is_written_{false};
    bool is_reading_fault_{false};
};

/// Changes the reference of a drive in operation; `stuck` where it is in another state or does not
/// reach the speed in time. A long ramp needs a long limit.
class change_reference : public drive_talk<reference_script> {
public:
    template <device_type Device>
    constexpr change_reference(station<Device> const& drive,
                               std::type_identity_t<reference<Device>> const& to,
                               duration limit = milliseconds(30'000)) noexcept
        : drive_talk{drive.unit(), reference_script{Device::profile, to.write()}, limit}
    {}
};

} // namespace rtuwire::altivar
