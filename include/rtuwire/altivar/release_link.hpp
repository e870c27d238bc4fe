// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// An ATV28 gives its control back to its terminals, or takes it from them, by a word of its serial link. After power-up
// the terminals have it until the line commands. A drive that is released obeys a run input that stands closed at once,
// so it is released only where it stands and its run inputs were just read as open.
#pragma once

#include <cstdint>

#include <rtuwire/altivar/at_rest.hpp>
#include <rtuwire/altivar/atv28.hpp>
#include <rtuwire/altivar/drive_talk.hpp>
#include <rtuwire/core/version.hpp>
#include <rtuwire/table/device.hpp>

namespace rtuwire::inline RTUWIRE_BUILD::altivar::atv28 {

/// Control words with bit 15, which the states of the drive profile do not lead to. Those that run have bits 1 and 3
/// set, and so have those that stop.
inline constexpr std::uint16_t link_activated = 0x8000; ///< bit 1 low: no power to the motor
inline constexpr std::uint16_t link_released = 0x8100;
inline constexpr std::uint16_t direct_run = 0x800A; ///< at the reference, which has a sign
inline constexpr std::uint16_t direct_run_reverse = 0x880A;
inline constexpr std::uint16_t direct_ramp_stop = 0x900A;
inline constexpr std::uint16_t direct_dc_stop = 0xA00A;
inline constexpr std::uint16_t direct_fast_stop = 0xC00A;

/// Decides a release or its opposite, word by word.
class link_script : public script {
public:
    constexpr link_script(bool is_release, terminal_options const& options) noexcept
        : script{device::profile}, look_{device::profile, options}, is_release_{is_release}
    {}

    constexpr wish step(event const& what) noexcept
    {
        if (stage_ == stage::looking and what.what != event::kind::late) {
            return look(what);
        }
        switch (what.what) {
        case event::kind::written: return after_write();
        case event::kind::pause_over: return ask(stage::confirming, profile().eta);
        case event::kind::word_read: return heard(what.word);
        case event::kind::failed:
            return stage_ == stage::taking_back ? end(ending::started_by_terminals, what.error)
                                                : end(what.error);
        case event::kind::begun:
        case event::kind::late: break;
        }
        return end(ending::stuck, errc::timed_out);
    }

private:
    enum class stage : std::uint8_t { looking, telling, confirming, asking_source, taking_back };

    constexpr wish ask(stage next, std::uint16_t address) noexcept
    {
        stage_ = next;
        return to_read(address);
    }

    constexpr wish look(event const& what) noexcept
    {
        wish const next = run_inside(look_, what);
        if (look_.reason().how != ending::succeeded) {
            return next;
        }
        stage_ = stage::telling;
        return to_rearrange(profile().cmd, is_release_ ? link_released : link_activated);
    }

    constexpr wish after_write() noexcept
    {
        return stage_ == stage::taking_back ? end(ending::started_by_terminals)
                                            : to_pause(look_period);
    }

    constexpr wish heard(std::uint16_t word) noexcept
    {
        if (stage_ == stage::confirming) {
            if (cia402::has_power(note(word))) {
                // The link may always be activated, and its word takes the power away.
                stage_ = stage::taking_back;
                return to_stop(profile().cmd, link_activated);
            }
            return ask(stage::asking_source, profile().eti);
        }
        constexpr std::uint16_t source_link = 0x4000;
        bool const is_by_link = (word & source_link) != 0;
        return end(is_by_link != is_release_ ? ending::succeeded : ending::not_taken);
    }

    at_rest_script look_;
    stage stage_{stage::looking};
    bool is_release_;
};

/// Gives the control of a drive that stands to its terminals or its keypad. Refused while it runs, in a fault, and while
/// a run input is closed; a motor that starts all the same has its power taken away by activating the link again, and
/// ends as `started_by_terminals`. `not_taken` where the drive says that the link still commands.
class release_link : public drive_talk<link_script> {
public:
    explicit constexpr release_link(station<device> const& drive,
                                    terminal_options const& options = {},
                                    duration limit = milliseconds(3'000)) noexcept
        : drive_talk{drive.unit(), link_script{true, options}, limit}
    {}
};

/// Takes the control of a drive that stands; it stands afterwards in "switch on disabled". Refused while somebody runs
/// it at its terminals, and by an exception in forced local.
class activate_link : public drive_talk<link_script> {
public:
    explicit constexpr activate_link(station<device> const& drive,
                                     duration limit = milliseconds(3'000)) noexcept
        : drive_talk{drive.unit(), link_script{false, terminal_options{.run_inputs = 0}}, limit}
    {}
};

} // namespace rtuwire::altivar::atv28
