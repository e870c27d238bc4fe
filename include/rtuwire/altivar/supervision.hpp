// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// What has to be known of a drive before its first order: that it would stop by itself when its line goes silent, that
// Modbus commands it, and that it would not start by itself. Reads, and never writes. What it finds wrong it refuses,
// with the register that says so, unless the risk was accepted by its name.
#pragma once

#include <cstdint>

#include <rtuwire/altivar/drive_talk.hpp>
#include <rtuwire/altivar/supervision_report.hpp>
#include <rtuwire/core/version.hpp>
#include <rtuwire/table/device.hpp>

namespace rtuwire::inline RTUWIRE_BUILD::altivar {

/// Decides the check, word by word. It ends as `succeeded` where the drive may be ordered.
class supervision_script : public script {
public:
    explicit constexpr supervision_script(drive_profile const& profile,
                                          supervision_options const& options = {}) noexcept
        : script{profile}, options_{options}
    {
        report_.period.longest_gap = options.longest_gap;
    }

    /// What another check has found.
    constexpr supervision_script(drive_profile const& profile,
                                 supervision_report const& found) noexcept
        : script{profile}, report_{found}, is_known_{true}
    {}

    constexpr wish step(event const& what) noexcept
    {
        switch (what.what) {
        case event::kind::begun: return is_known_ ? end(report_.finding) : ask();
        case event::kind::word_read: return go_on(judge(what.word), what.word);
        case event::kind::failed: return go_without(what.error);
        case event::kind::written:
        case event::kind::pause_over:
        case event::kind::late: break;
        }
        return end(ending::silent, errc::timed_out);
    }

    [[nodiscard]] constexpr supervision_report const& report() const noexcept { return report_; }

    /// How long the drive goes on without a request, as it was read; else the most that can be set.
    [[nodiscard]] constexpr duration drive_timeout() const noexcept
    {
        bool const is_read = report_.period.timeout != duration{};
        return is_read ? report_.period.timeout : profile().longest_silence;
    }

private:
    /// In this order: the channel decides what the others mean.
    enum class look : std::uint8_t {
        reaction,
        timeout,
        mode,
        command,
        reference,
        local_input,
        restart,
        disable,
        wiring,
        inputs,
        status, ///< which each drive has
    };

    static constexpr std::uint16_t together = 1, apart = 2;

    constexpr std::uint16_t address() const noexcept
    {
        safeguard_layout const& at = profile().safeguards;
        bool const is_local_first = at.is_local_at_power_up;
        switch (at_) {
        case look::reaction: return at.nto != 0 ? profile().cmi : at.sll;
        case look::timeout: return at.tto;
        case look::mode: return at.chcf;
        case look::command: return mode_ == together ? std::uint16_t{0} : at.cd1;
        case look::reference: return at.fr1;
        case look::local_input: return at.flo;
        case look::restart: return at.atr;
        case look::disable: return at.dotd;
        case look::wiring: return is_local_first ? at.tcc : std::uint16_t{0};
        case look::inputs: return is_local_first ? at.inputs : std::uint16_t{0};
        case look::status: break;
        }
        return profile().eta;
    }

    constexpr wish ask() noexcept
    {
        while (address() == 0) {
            at_ = after(at_);
        }
        return to_read(address());
    }

    static constexpr look after(look at) noexcept
    {
        return static_cast<look>(static_cast<unsigned>(at) + 1U);
    }

    /// What a word says against ordering the drive; `succeeded` for nothing.
    constexpr ending judge(std::uint16_t word) noexcept
    {
        constexpr std::uint16_t by_modbus = 10, reference_by_modbus = 164;
        switch (at_) {
        case look::reaction: return judge_reaction(word);
        case look::timeout: return judge_timeout(word);
        case look::mode: return judge_mode(word);
        case look::command: return unless(word == by_modbus, ending::other_channel);
        case look::reference: return unless(word == reference_by_modbus, ending::other_channel);
        case look::local_input: report_.has_local_input = word != 0; break;
        // 2 on an ATV28: after a lack of mains it goes on by its terminals, which counts as well.
        case look::restart: return unless(word == 0, ending::restarts_by_itself);
        case look::disable: stops_on_ramp_ = word == 1; break;
        case look::wiring: is_three_wire_ = word == 1; break;
        case look::inputs: return judge_inputs(word);
        case look::status:
            note(word);
            return unless((word & remote_bit) != 0, ending::local_control);
        }
        return ending::succeeded;
    }

    static constexpr ending unless(bool is_right, ending how) noexcept
    {
        return is_right ? ending::succeeded : how;
    }

    constexpr ending judge_reaction(std::uint16_t word) noexcept
    {
        safeguard_layout const& at = profile().safeguards;
        if (at.nto != 0) {
            is_watched_ = (word & at.nto) == 0;
            report_.period.timeout = is_watched_ ? at.fixed_timeout : duration{};
            return unless(is_watched_, ending::unsupervised);
        }
        is_watched_ = word != 0;
        switch (word) {
        case 0: return ending::unsupervised;
        case 1: // freewheel, as STT says, ramp, fast stop, DC injection
        case 2:
        case 6:
        case 7:
        case 8: return ending::succeeded;
        case 4:
        case 5: return ending::runs_on_without_link;
        default: return ending::unknown_register;
        }
    }

    constexpr ending judge_timeout(std::uint16_t word) noexcept
    {
        report_.period.timeout = is_watched_ ? milliseconds(100) * word : duration{};
        return unless(word != 0, ending::unsupervised);
    }

    constexpr ending judge_mode(std::uint16_t word) noexcept
    {
        mode_ = word;
        if (word == io_profile) {
            return ending::not_drive_profile;
        }
        return unless(word == together or word == apart, ending::unknown_register);
    }

    constexpr ending judge_inputs(std::uint16_t word) const noexcept
    {
        bool const asks_to_run = not is_three_wire_ and (word & options_.run_inputs) != 0;
        return unless(not asks_to_run, ending::run_input_closed);
    }

    /// A register that the drive does not have; what else fails ends the check.
    constexpr wish go_without(errc error) noexcept
    {
        if (error != errc::illegal_data_address) {
            return end(error);
        }
        bool const is_needed =
            at_ != look::local_input and at_ != look::disable and at_ != look::wiring;
        return go_on(is_needed ? ending::unknown_register : ending::succeeded, 0, error);
    }

    constexpr wish go_on(ending found, std::uint16_t word, errc error = errc::none) noexcept
    {
        if (found != ending::succeeded) {
            report_.address = address();
            report_.word = word;
            if (not accepts(found)) {
                return conclude(found, error);
            }
        }
        if (at_ == look::status) {
            return finish();
        }
        at_ = after(at_);
        return ask();
    }

    constexpr wish conclude(ending found, errc error = errc::none) noexcept
    {
        report_.finding = found;
        return end(found, error);
    }

    /// Whether a finding is accepted, which is kept.
    constexpr bool accepts(ending found) noexcept
    {
        for (named_risk const& each : named_risks) {
            if (each.found == found and options_.risks.*each.risk) {
                report_.accepted.*each.risk = true;
                return true;
            }
        }
        return false;
    }

    constexpr wish finish() noexcept
    {
        safeguard_layout const& at = profile().safeguards;
        bool const is_known = mode_ == together or mode_ == apart;
        bool const has_one_meaning = profile().chcf == 0 or is_known;
        bool const is_on_ramp = at.dotd == 0 or stops_on_ramp_;
        report_.words =
            has_one_meaning and is_on_ramp ? word_meaning::drive_profile : word_meaning::unknown;
        if (not report_.period.holds()) {
            report_.address = at.tto;
            report_.word =
                static_cast<std::uint16_t>(report_.period.timeout.microseconds / 100'000);
            if (not accepts(ending::timeout_too_short)) {
                return conclude(ending::timeout_too_short);
            }
        }
        return conclude(ending::succeeded);
    }

    supervision_options options_;
    supervision_report report_{};
    std::uint16_t mode_{0};
    look at_{look::reaction};
    bool is_watched_{true};
    bool stops_on_ramp_{false};
    bool is_three_wire_{false};
    bool is_known_{false}; ///< by another check
};

/// Checks a drive before its first order: at most nine reads. It ends as `succeeded` (`ready`), or with what is
/// against it; the report then names the register and its word, and for `timeout_too_short` both times. An ATV12 and
/// an ATV310 have no ATR; a second channel that an input switches to (CCS, RFC) is not looked for.
class check_supervision : public drive_talk<supervision_script> {
public:
    template <device_type Device>
    explicit constexpr check_supervision(station<Device> const& drive,
                                         supervision_options const& options = {},
                                         duration limit = milliseconds(10'000)) noexcept
        : drive_talk{drive.unit(), supervision_script{Device::profile, options}, limit}
    {}

    /// Whether the drive may be ordered, accepted risks included.
    [[nodiscard]] constexpr bool ready() const noexcept { return succeeded(); }

    /// What was found; whole once it is settled.
    [[nodiscard]] constexpr supervision_report const& report() const noexcept
    {
        return told().report();
    }
};

} // namespace rtuwire::altivar
