// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// Tells a drive's scanner which registers its input and output words are, so that one question moves
// them all. Slots that are not named become inactive.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include <rtuwire/altivar/drive_talk.hpp>
#include <rtuwire/client/access.hpp>
#include <rtuwire/core/version.hpp>
#include <rtuwire/table/device.hpp>

namespace rtuwire::inline RTUWIRE_BUILD::altivar {

/// Registers that the scanner reads, in the order of its input words.
template <auto const&... Registers> struct scanner_inputs {
    static constexpr std::size_t count = sizeof...(Registers);
    static constexpr std::array<std::uint16_t, count> addresses{Registers.address...};
    template <typename Device>
    static constexpr bool are_of = (Device::registers::template contains<Registers> and ...);
};

/// Registers that the scanner writes, in the order of its output words.
template <auto const&... Registers> struct scanner_outputs {
    static constexpr std::size_t count = sizeof...(Registers);
    static constexpr std::array<std::uint16_t, count> addresses{Registers.address...};
    template <typename Device>
    static constexpr bool are_of = (Device::registers::template contains<Registers> and ...);
    static constexpr bool are_writable = ((Registers.mode != access::read_only) and ...);
};

/// Where the slots of the Altivar scanners stand.
inline constexpr std::uint16_t scanner_input_addresses = 12'701;  ///< NMA1
inline constexpr std::uint16_t scanner_output_addresses = 12'721; ///< NCA1
inline constexpr std::uint16_t scanner_input_words = 12'741;      ///< NM1
inline constexpr std::uint16_t scanner_output_words = 12'761;     ///< NC1

/// Decides a configuration, word by word.
class scanner_script : public script {
public:
    using addresses = std::span<std::uint16_t const>;

    constexpr scanner_script(drive_profile const& profile, addresses inputs,
                             addresses outputs) noexcept
        : script{profile}, inputs_{inputs}, outputs_{outputs}
    {}

    constexpr wish step(event const& what) noexcept
    {
        switch (what.what) {
        case event::kind::begun: return to_read(profile().eta);
        case event::kind::word_read:
            if (cia402::has_power(note(what.word))) {
                return end(ending::refused_while_running);
            }
            return write_slot();
        case event::kind::written: ++at_; return write_slot();
        case event::kind::failed: return end(what.error);
        case event::kind::late:
        case event::kind::pause_over: break;
        }
        return end(ending::silent, errc::timed_out);
    }

private:
    constexpr wish write_slot() noexcept
    {
        std::size_t const slots = profile().scanner_words;
        if (at_ == 2 * slots) {
            return end(ending::succeeded);
        }
        bool const is_input = at_ < slots;
        std::size_t const slot = is_input ? at_ : at_ - slots;
        addresses const chosen = is_input ? inputs_ : outputs_;
        std::uint16_t const first = is_input ? scanner_input_addresses : scanner_output_addresses;
        return to_rearrange(static_cast<std::uint16_t>(first + slot),
                        slot < chosen.size() ? chosen[slot] : std::uint16_t{0});
    }

    addresses inputs_;
    addresses outputs_;
    std::size_t at_{0};
};

/// Configures the scanner of a stopped drive: `configure_scanner<Inputs, Outputs> talk{drive}`. Never
/// map CMI with its save bit set: each cycle would write the EEPROM.
template <typename Inputs, typename Outputs>
class configure_scanner : public drive_talk<scanner_script> {
public:
    template <device_type Device>
    explicit constexpr configure_scanner(station<Device> const& drive,
                                         duration limit = milliseconds(5'000)) noexcept
        : drive_talk{drive.unit(),
                     scanner_script{Device::profile, Inputs::addresses, Outputs::addresses}, limit}
    {
        static_assert(Device::profile.scanner_words > 0, "this device has no scanner");
        static_assert(Inputs::count <= Device::profile.scanner_words and
                          Outputs::count <= Device::profile.scanner_words,
                      "this device's scanner has fewer words");
        static_assert(Inputs::template are_of<Device> and Outputs::template are_of<Device>,
                      "this device has no such register");
        static_assert(Outputs::are_writable, "the scanner cannot write a read-only register");
    }
};

} // namespace rtuwire::altivar
