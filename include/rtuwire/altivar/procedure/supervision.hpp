// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// What has to be known about a drive before its first order: that it would stop by itself when its line goes silent,
// that Modbus commands it, and that it would not start by itself. It reads and never writes. A wrong setting is refused
// and its register reported, unless the risk was accepted by its name.
#pragma once

#include <cstdint>

#include <rtuwire/altivar/procedure/procedure_runner.hpp>
#include <rtuwire/altivar/procedure/supervision_report.hpp>
#include <rtuwire/core/version.hpp>
#include <rtuwire/table/device.hpp>

namespace rtuwire::inline RTUWIRE_BUILD::altivar {

/// Decides the check, word by word. It ends as `succeeded` where the drive may be ordered.
class supervision_procedure : public procedure {
public:
    explicit constexpr supervision_procedure(drive_layout const& layout,
                                             supervision_options const& options = {}) noexcept
        : procedure{layout}, options_{options}
    {
        report_.period.longest_gap = options.longest_gap;
    }

    /// Takes the result of an earlier check.
    constexpr supervision_procedure(drive_layout const& layout, supervision_report const& found) noexcept
        : procedure{layout}, report_{found}, is_known_{true}
    {}

    constexpr action step(event const& what) noexcept
    {
        switch (what.what) {
        case event::kind::begun: return is_known_ ? end(report_.finding) : ask();
        case event::kind::word_read: return go_on(judge(what.word), what.word);
        case event::kind::failed: return go_without(what.error);
        case event::kind::written:
        case event::kind::pause_over:
        case event::kind::late: break;
        }
        return end(outcome_kind::silent, errc::timed_out);
    }

    [[nodiscard]] constexpr supervision_report const& report() const noexcept { return report_; }

    /// How long the drive keeps running without a request, as it was read; else the longest that can be set.
    [[nodiscard]] constexpr duration drive_timeout() const noexcept
    {
        bool const is_read = report_.period.timeout != duration{};
        return is_read ? report_.period.timeout : layout().longest_silence;
    }

private:
    /// Read in this order: the channel defines what the others mean.
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
        status, ///< every drive has it
    };

    static constexpr std::uint16_t together = 1, apart = 2;

    constexpr std::uint16_t address() const noexcept
    {
        safeguard_layout const& at = layout().safeguards;
        bool const is_local_first = at.is_local_at_power_up;
        switch (at_) {
        case look::reaction: return at.nto != 0 ? layout().cmi : at.sll;
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
        return layout().eta;
    }

    constexpr action ask() noexcept
    {
        while (address() == 0) {
            at_ = after(at_);
        }
        return to_read(address());
    }

    static constexpr look after(look at) noexcept { return static_cast<look>(static_cast<unsigned>(at) + 1U); }

    /// Why a word forbids ordering the drive; `succeeded` where it does not.
    constexpr outcome_kind judge(std::uint16_t word) noexcept
    {
        constexpr std::uint16_t by_modbus = 10, reference_by_modbus = 164;
        switch (at_) {
        case look::reaction: return judge_reaction(word);
        case look::timeout: return judge_timeout(word);
        case look::mode: return judge_mode(word);
        case look::command: return unless(word == by_modbus, outcome_kind::other_channel);
        case look::reference: return unless(word == reference_by_modbus, outcome_kind::other_channel);
        case look::local_input: report_.has_local_input = word != 0; break;
        // 2 on an ATV28: after a mains failure it restarts by its terminals, which counts as well.
        case look::restart: return unless(word == 0, outcome_kind::restarts_by_itself);
        case look::disable: stops_on_ramp_ = word == 1; break;
        case look::wiring: is_three_wire_ = word == 1; break;
        case look::inputs: return judge_inputs(word);
        case look::status: note(word); return unless((word & remote_bit) != 0, outcome_kind::local_control);
        }
        return outcome_kind::succeeded;
    }

    static constexpr outcome_kind unless(bool is_right, outcome_kind kind) noexcept
    {
        return is_right ? outcome_kind::succeeded : kind;
    }

    constexpr outcome_kind judge_reaction(std::uint16_t word) noexcept
    {
        safeguard_layout const& at = layout().safeguards;
        if (at.nto != 0) {
            is_watched_ = (word & at.nto) == 0;
            report_.period.timeout = is_watched_ ? at.fixed_timeout : duration{};
            return unless(is_watched_, outcome_kind::unsupervised);
        }
        is_watched_ = word != 0;
        switch (word) {
        case 0: return outcome_kind::unsupervised;
        case 1: // 1, 2, 6, 7, 8: freewheel, as STT sets, ramp, fast stop, DC injection
        case 2:
        case 6:
        case 7:
        case 8: return outcome_kind::succeeded;
        case 4:
        case 5: return outcome_kind::runs_on_without_link;
        default: return outcome_kind::unknown_register;
        }
    }

    constexpr outcome_kind judge_timeout(std::uint16_t word) noexcept
    {
        report_.period.timeout = is_watched_ ? milliseconds(100) * word : duration{};
        return unless(word != 0, outcome_kind::unsupervised);
    }

    constexpr outcome_kind judge_mode(std::uint16_t word) noexcept
    {
        mode_ = word;
        if (word == io_profile) {
            return outcome_kind::not_drive_profile;
        }
        return unless(word == together or word == apart, outcome_kind::unknown_register);
    }

    constexpr outcome_kind judge_inputs(std::uint16_t word) const noexcept
    {
        bool const asks_to_run = not is_three_wire_ and (word & options_.run_inputs) != 0;
        return unless(not asks_to_run, outcome_kind::run_input_closed);
    }

    /// Skips a register that the drive does not have; any other error ends the check.
    constexpr action go_without(errc error) noexcept
    {
        if (error != errc::illegal_data_address) {
            return end(error);
        }
        bool const is_needed = at_ != look::local_input and at_ != look::disable and at_ != look::wiring;
        return go_on(is_needed ? outcome_kind::unknown_register : outcome_kind::succeeded, 0, error);
    }

    constexpr action go_on(outcome_kind found, std::uint16_t word, errc error = errc::none) noexcept
    {
        if (found != outcome_kind::succeeded) {
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

    constexpr action conclude(outcome_kind found, errc error = errc::none) noexcept
    {
        report_.finding = found;
        return end(found, error);
    }

    /// Whether a finding is accepted; an accepted one is kept in the report.
    constexpr bool accepts(outcome_kind found) noexcept
    {
        for (named_risk const& each : named_risks) {
            if (each.found == found and options_.risks.*each.risk) {
                report_.accepted.*each.risk = true;
                return true;
            }
        }
        return false;
    }

    constexpr action finish() noexcept
    {
        safeguard_layout const& at = layout().safeguards;
        bool const is_known = mode_ == together or mode_ == apart;
        bool const has_one_meaning = layout().chcf == 0 or is_known;
        bool const is_on_ramp = at.dotd == 0 or stops_on_ramp_;
        report_.words = has_one_meaning and is_on_ramp ? word_meaning::cia402 : word_meaning::unknown;
        if (not report_.period.holds()) {
            report_.address = at.tto;
            report_.word = static_cast<std::uint16_t>(report_.period.timeout.microseconds / 100'000);
            if (not accepts(outcome_kind::timeout_too_short)) {
                return conclude(outcome_kind::timeout_too_short);
            }
        }
        return conclude(outcome_kind::succeeded);
    }

    supervision_options options_;
    supervision_report report_{};
    std::uint16_t mode_{0};
    look at_{look::reaction};
    bool is_watched_{true};
    bool stops_on_ramp_{false};
    bool is_three_wire_{false};
    bool is_known_{false}; ///< an earlier check gave the report
};

/// Checks a drive before its first order: at most nine reads. It ends as `succeeded` (`ready`), or with the reason
/// against it; the report then names the register and its word, and for `timeout_too_short` both times. An ATV12 and
/// an ATV310 have no ATR; a second channel that an input switches to (CCS, RFC) is not checked.
class check_supervision : public procedure_runner<supervision_procedure> {
public:
    template <device_type Device>
    explicit constexpr check_supervision(station<Device> const& drive, supervision_options const& options = {},
                                         duration limit = milliseconds(10'000)) noexcept
        : procedure_runner{drive.unit(), supervision_procedure{Device::layout, options}, limit}
    {}

    /// Whether the drive may be ordered, accepted risks included.
    [[nodiscard]] constexpr bool ready() const noexcept { return succeeded(); }

    /// What was found; complete once it is settled.
    [[nodiscard]] constexpr supervision_report const& report() const noexcept { return told().report(); }
};

} // namespace rtuwire::altivar
