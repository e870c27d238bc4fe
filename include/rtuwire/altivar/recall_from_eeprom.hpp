// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// Brings the settings back that a drive saved last: what was written since is gone. Only an ATV28 has the order, bit 2
// of CMI; other orders that stand there are not given again with it.
#pragma once

#include <cstdint>

#include <rtuwire/altivar/at_rest.hpp>
#include <rtuwire/altivar/drive_talk.hpp>
#include <rtuwire/core/version.hpp>
#include <rtuwire/table/device.hpp>

namespace rtuwire::inline RTUWIRE_BUILD::altivar {

/// The bit of CMI that recalls.
inline constexpr std::uint16_t recall_bit = 0x0004;

/// Decides a recall, word by word.
class recall_script : public script {
public:
    constexpr recall_script(drive_profile const& profile, terminal_options const& options) noexcept
        : script{profile}, look_{profile, options, {.ends_three_wire = true}}
    {}

    constexpr wish step(event const& what) noexcept
    {
        if (stage_ == stage::looking and what.what != event::kind::late) {
            return look(what);
        }
        switch (what.what) {
        case event::kind::word_read: return heard(what.word);
        case event::kind::written:
            return stage_ == stage::taking_back ? end(ending::not_taken)
                                                : to_pause(profile().eeprom_time);
        case event::kind::pause_over: return ask(stage::confirming, profile().cmi);
        case event::kind::failed: return fail(what.error);
        case event::kind::begun:
        case event::kind::late: break;
        }
        return fail(errc::timed_out);
    }

private:
    enum class stage : std::uint8_t {
        looking,
        reading_control,
        ordering,
        confirming, ///< the drive takes the bit back once it has accepted the order
        taking_back,
    };

    constexpr wish ask(stage next, std::uint16_t address) noexcept
    {
        stage_ = next;
        return to_read(address);
    }

    constexpr wish look(event const& what) noexcept
    {
        wish const next = run_inside(look_, what);
        return look_.reason().how == ending::succeeded ? ask(stage::reading_control, profile().cmi) : next;
    }

    constexpr wish heard(std::uint16_t word) noexcept
    {
        if (stage_ == stage::reading_control) {
            control_ = static_cast<std::uint16_t>(word & ~profile().cmi_orders);
            stage_ = stage::ordering;
            return once(to_rearrange(profile().cmi, static_cast<std::uint16_t>(control_ | recall_bit)));
        }
        if ((word & recall_bit) == 0) {
            return end(ending::succeeded);
        }
        // An order that stands would be executed some day.
        stage_ = stage::taking_back;
        return to_write(profile().cmi, control_);
    }

    /// Once the order has left, nobody knows whether it was executed, nor at which rate the drive listens.
    constexpr wish fail(errc error) noexcept
    {
        bool const may_be_done = stage_ == stage::ordering or stage_ == stage::confirming;
        return may_be_done and not is_exception(error) ? end(ending::executed_unconfirmed, error)
                                                       : end(error);
    }

    at_rest_script look_;
    std::uint16_t control_{0};
    stage stage_{stage::looking};
};

/// Recalls the saved settings of a drive that stands with its run inputs open: they may give the command elsewhere. The
/// drive is silent for up to 2 s. `not_taken` where it did not accept the order, which is then taken back;
/// `executed_unconfirmed` where it does not answer any more.
class recall_from_eeprom : public drive_talk<recall_script> {
public:
    template <device_type Device>
    explicit constexpr recall_from_eeprom(station<Device> const& drive,
                                          terminal_options const& options = {},
                                          duration limit = milliseconds(8'000)) noexcept
        : drive_talk{drive.unit(), recall_script{Device::profile, options}, limit}
    {
        static_assert((Device::profile.cmi_orders & recall_bit) != 0,
                      "this device cannot recall its saved settings over the line");
    }
};

} // namespace rtuwire::altivar
