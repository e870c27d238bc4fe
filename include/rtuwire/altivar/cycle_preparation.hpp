// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// What a cycle reads before it writes, and again after all that could have changed it: whether the drive may be ordered,
// and whether its scanner stands for the words of the cycle.
#pragma once

#include <cstddef>
#include <cstdint>

#include <rtuwire/altivar/cycle_words.hpp>
#include <rtuwire/altivar/supervision.hpp>
#include <rtuwire/core/version.hpp>
#include <rtuwire/table/device.hpp>
#include <rtuwire/wire/pdu/read_holding_registers.hpp>

namespace rtuwire::inline RTUWIRE_BUILD::altivar {

/// The readings of one drive, question by question.
template <device_type Device> class cycle_preparation {
    using words = cycle_words<Device>;

public:
    explicit constexpr cycle_preparation(supervision_options const& options) noexcept
        : options_{options}, check_{Device::profile, options}
    {}

    /// Nothing is known any more: all is read again.
    constexpr void renew() noexcept
    {
        finding_ = ending::pending;
        is_begun_ = false;
    }

    /// `pending` while there is something to read, then `succeeded`, or what is against an order.
    [[nodiscard]] constexpr ending finding() const noexcept { return finding_; }
    [[nodiscard]] constexpr bool succeeded() const noexcept { return finding_ == ending::succeeded; }

    /// What the last check found that came to its end.
    [[nodiscard]] constexpr supervision_report const& report() const noexcept { return report_; }

    /// What the drive's words mean, as long as that is known.
    [[nodiscard]] constexpr word_meaning meaning() const noexcept
    {
        return succeeded() ? report_.words : word_meaning::unknown;
    }

    /// What is read next.
    [[nodiscard]] constexpr read_holding_registers question() noexcept
    {
        if (not is_begun_) {
            is_begun_ = true;
            stage_ = stage::safeguards;
            check_ = supervision_script{Device::profile, options_};
            wish_ = check_.step({event::kind::begun});
        }
        switch (stage_) {
        case stage::inputs: return {scanner_input_addresses, words::inputs};
        case stage::outputs: return {scanner_output_addresses, words::outputs};
        case stage::safeguards: break;
        }
        return {wish_.address, 1};
    }

    /// What came. `in_use` has a bit for each output slot that need not be inactive.
    constexpr void take(register_view read, std::uint32_t in_use) noexcept
    {
        switch (stage_) {
        case stage::safeguards: return examine({event::kind::word_read, read[0]});
        case stage::inputs: return check_inputs(read);
        case stage::outputs: break;
        }
        check_outputs(read, in_use);
    }

    /// The drive refused to tell.
    constexpr void take_exception(errc error) noexcept
    {
        if (stage_ == stage::safeguards) {
            return examine({event::kind::failed, 0, error});
        }
        finding_ = ending::misconfigured;
    }

private:
    enum class stage : std::uint8_t { safeguards, inputs, outputs };

    constexpr void examine(event const& what) noexcept
    {
        wish_ = check_.step(what);
        if (wish_.what != wish::kind::end) {
            return;
        }
        report_ = check_.report();
        bool const is_ready = check_.reason().how == ending::succeeded;
        finding_ = is_ready and words::has_scanner ? ending::pending : check_.reason().how;
        stage_ = stage::inputs;
    }

    constexpr void check_inputs(register_view addresses) noexcept
    {
        constexpr drive_profile const& profile = Device::profile;
        bool const is_right = addresses[0] == profile.eta and addresses[1] == profile.rfrd;
        finding_ = is_right ? ending::pending : ending::misconfigured;
        stage_ = stage::outputs;
    }

    constexpr void check_outputs(register_view addresses, std::uint32_t in_use) noexcept
    {
        bool is_right = addresses[0] == Device::profile.cmd and
                        addresses[1] == words::reference.address;
        for (std::size_t slot = 2; slot < words::outputs; ++slot) {
            bool const is_in_use = ((in_use >> slot) & 1U) != 0;
            is_right = is_right and (is_in_use or addresses[slot] == 0);
        }
        finding_ = is_right ? ending::succeeded : ending::misconfigured;
    }

    supervision_options options_;
    supervision_script check_;
    supervision_report report_{};
    wish wish_{wish::kind::pause};
    ending finding_{ending::pending};
    stage stage_{stage::safeguards};
    bool is_begun_{false};
};

} // namespace rtuwire::altivar
