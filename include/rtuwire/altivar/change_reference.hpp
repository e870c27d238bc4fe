// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// Gives a running drive another speed or direction, and waits until it says that it turns so.
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
        case event::kind::begun: return ask(asked::status, profile().eta);
        case event::kind::pause_over: return ask(asked::status, profile().eta);
        case event::kind::word_read: return heard(what.word);
        case event::kind::written: is_written_ = true; return to_pause(look_period);
        case event::kind::failed: return end(what.error);
        case event::kind::late: break;
        }
        return end(ending::stuck);
    }

private:
    enum class asked : std::uint8_t { status, fault, control, frequency };

    constexpr wish ask(asked what, std::uint16_t address) noexcept
    {
        asked_ = what;
        return to_read(address);
    }

    constexpr wish heard(std::uint16_t word) noexcept
    {
        switch (asked_) {
        case asked::status: return judge(word);
        case asked::fault: return end_in_fault(word);
        case asked::control: return write(word);
        case asked::frequency: break;
        }
        return count_reached(word != 0);
    }

    constexpr wish judge(std::uint16_t status) noexcept
    {
        cia402::state const at = note(status);
        if (cia402::is_in_fault(at)) {
            return ask(asked::fault, profile().lft);
        }
        if ((status & remote_bit) == 0) {
            return end(ending::local_control);
        }
        if (at != cia402::state::operation_enabled) {
            return end(ending::stuck);
        }
        if (not is_written_) {
            return ask(asked::control, profile().cmd);
        }
        if ((status & reference_limited_bit) != 0) {
            return end(ending::reference_limited);
        }
        bool const is_reached = (status & reference_reached_bit) != 0;
        bool const turns_back = (status & runs_backwards_bit) != 0;
        if (reference_.is_zero() or not is_reached or turns_back != reference_.is_reverse()) {
            return count_reached(reference_.is_zero() and is_reached);
        }
        return ask(asked::frequency, profile().rfr);
    }

    /// A drive may still show that it has reached the reference before this one, so once is not enough.
    constexpr wish count_reached(bool is_reached) noexcept
    {
        constexpr int looks_at_it = 2;
        reached_ = is_reached ? reached_ + 1 : 0;
        return reached_ >= looks_at_it ? end(ending::succeeded) : to_pause(look_period);
    }

    /// One write of the reference with its sign: the direction bit stands as it stands.
    constexpr wish write(std::uint16_t control) noexcept
    {
        if ((control & profile().halt) != 0) {
            return end(ending::halted);
        }
        reference_write const told = reference_.under(control);
        return to_enable(told.address, told.word);
    }

    reference_write reference_;
    int reached_{0};
    asked asked_{asked::status};
    bool is_written_{false};
};

/// Changes the reference of a drive in operation; a negative one is in reverse. Done where the drive says twice,
/// after the write, that it has reached it, and turns in that direction; `reference_limited` where the drive limits
/// it, `halted` where the halt bit is set, `stuck` where it is in another state or not there in time. A long ramp
/// needs a long limit.
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
