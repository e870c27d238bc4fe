// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// Configures which registers a drive's scanner maps to its input and output words, so that one request
// transfers them all. Slots that are not named become inactive.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include <rtuwire/altivar/device/cycle_registers.hpp>
#include <rtuwire/altivar/device/drive_type.hpp>
#include <rtuwire/altivar/procedure/procedure_runner.hpp>
#include <rtuwire/ask/access.hpp>
#include <rtuwire/core/version.hpp>
#include <rtuwire/table/device.hpp>

namespace rtuwire {
inline namespace RTUWIRE_BUILD {
namespace altivar {

/// Registers that the scanner reads, in the order of its input words.
template <auto const&... Registers> struct scanner_inputs {
    static constexpr std::size_t count = sizeof...(Registers);
    static constexpr std::array<std::uint16_t, count> addresses{Registers.address...};
    template <typename Device> static constexpr bool are_of = (detail::has_register<Device, Registers> and ...);
};

/// Registers that the scanner writes, in the order of its output words.
template <auto const&... Registers> struct scanner_outputs {
    static constexpr std::size_t count = sizeof...(Registers);
    static constexpr std::array<std::uint16_t, count> addresses{Registers.address...};
    template <typename Device> static constexpr bool are_of = (detail::has_register<Device, Registers> and ...);
    static constexpr bool are_writable = ((Registers.mode != access::read_only) and ...);
};

/// Decides a configuration, word by word.
///
/// | stage         | word read             | confirmed      | no response | refused      | limit over   |
/// |---------------|-----------------------|----------------|-------------|--------------|--------------|
/// | looking       | 5, 6, 7: end: running |                | end: silent | end: refused | end: aborted |
/// |               | 2, 3, 4, 8: slot 1    |                |             |              |              |
/// |               | else: end: aborted    |                |             |              |              |
/// | a slot        |                       | write the next | end: silent | end: refused | end: aborted |
/// | the last slot |                       | end: succeeded | end: silent | end: refused | end: aborted |
///
/// "Running" is `refused_while_running`. The input slots come first; one without a register is written 0.
/// Internal.
class scanner_procedure : public procedure {
public:
    using addresses = std::span<std::uint16_t const>;

    constexpr scanner_procedure(drive_layout const& layout, scanner_registers const& scanner, addresses inputs,
                                addresses outputs) noexcept
        : procedure{layout}, scanner_{&scanner}, inputs_{inputs}, outputs_{outputs}
    {}

    [[nodiscard]] constexpr scanner_procedure anew() const noexcept { return {layout(), *scanner_, inputs_, outputs_}; }

    constexpr action step(event what) noexcept
    {
        switch (what.what()) {
        case event::kind::begun: return to_read(layout().eta);
        case event::kind::word_read: return stands(note(what.word())) ? write_slot() : end_running();
        case event::kind::written: ++at_; return write_slot();
        case event::kind::failed: return end(what.error());
        case event::kind::late:
        case event::kind::pause_over: break;
        }
        return end(outcome_kind::aborted);
    }

private:
    constexpr action write_slot() noexcept
    {
        std::size_t const slot_count = scanner_->words;
        if (at_ == 2 * slot_count) {
            return end(outcome_kind::succeeded);
        }
        bool const is_input = at_ < slot_count;
        std::size_t const slot = is_input ? at_ : at_ - slot_count;
        addresses const chosen = is_input ? inputs_ : outputs_;
        std::uint16_t const first = is_input ? scanner_->input_addresses : scanner_->output_addresses;
        return to_rearrange(static_cast<std::uint16_t>(first + slot),
                            slot < chosen.size() ? chosen[slot] : std::uint16_t{0});
    }

    scanner_registers const* scanner_;
    addresses inputs_;
    addresses outputs_;
    std::size_t at_{0};
};

/// Configures the scanner of a stopped drive: `configure_scanner<Inputs, Outputs> conversation{drive}`. Where it does not
/// succeed after a slot was written, the scanner is partly configured: do it again. Never map CMI with its save bit
/// set: each cycle would write the EEPROM.
template <typename Inputs, typename Outputs> class configure_scanner : public procedure_runner<scanner_procedure> {
public:
    /// Sets the scanner of this drive, within `limit`.
    template <device_type Device>
    explicit constexpr configure_scanner(station<Device> const& drive, duration limit = milliseconds(5'000)) noexcept
        : procedure_runner{drive.unit(),      limit, drive_check<Device>::layout, Device::scanner, Inputs::addresses,
                           Outputs::addresses}
    {
        static_assert(Device::scanner.words > 0, "this device has no scanner");
        static_assert(Inputs::count <= Device::scanner.words and Outputs::count <= Device::scanner.words,
                      "this device's scanner has fewer words");
        static_assert(Inputs::template are_of<Device> and Outputs::template are_of<Device>,
                      "this device has no such register");
        static_assert(Outputs::are_writable, "the scanner cannot write a read-only register");
    }
};

} // namespace altivar
} // namespace RTUWIRE_BUILD
} // namespace rtuwire
