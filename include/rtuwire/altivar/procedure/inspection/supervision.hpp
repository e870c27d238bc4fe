// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// What has to be known about a drive before its first order: that it would stop by itself when its line goes silent,
// that Modbus commands it, and that it would not start by itself. It reads and never writes. A wrong setting is refused
// and its register reported, unless the risk was accepted by its name.
#pragma once

#include <cstdint>

#include <rtuwire/altivar/device/drive_type.hpp>
#include <rtuwire/altivar/procedure/inspection/safeguard_words.hpp>
#include <rtuwire/altivar/procedure/inspection/supervision_report.hpp>
#include <rtuwire/altivar/procedure/procedure_runner.hpp>
#include <rtuwire/core/version.hpp>
#include <rtuwire/table/device.hpp>

namespace rtuwire {
inline namespace RTUWIRE_BUILD {
namespace altivar {

/// Decides the check, word by word. It ends as `succeeded` where the drive may be ordered.
///
/// Each register that the drive has is read, in the order of `safeguard`; `safeguard_words` has the findings.
///
/// | answer                       | next                                                                    |
/// |------------------------------|-------------------------------------------------------------------------|
/// | a word without a finding     | read the next register; after ETA: end: succeeded, or timeout_too_short |
/// | a finding, its risk accepted | the same                                                                |
/// | a finding                    | end: the finding                                                        |
/// | exception 02: FLO, DOTD, TCC | read the next register                                                  |
/// | exception 02: ETA            | end: refused                                                            |
/// | exception 02: another        | the finding unknown_register                                            |
/// | refused otherwise            | end: refused                                                            |
/// | no response, to the first    | end: silent                                                             |
/// | no response, to a later one  | read the first again: the drive may have lost its power                 |
/// | limit over                   | end: aborted, by the error of the last response that was lost           |
///
/// Lost responses are not counted: a register that never answers ends a check, and its start, at the limit.
/// Internal.
class supervision_procedure : public procedure {
public:
    /// `is_by_speed`: its report is to hold the limits of a speed, too.
    explicit constexpr supervision_procedure(drive_layout const& layout, supervision_options const& options = {},
                                             bool is_by_speed = true) noexcept
        : procedure{layout}, is_by_speed_{is_by_speed},
          words_{options.run_inputs, options.beyond == beyond_limits::refuse, is_by_speed}, options_{options}
    {
        report_.period.longest_gap = options.longest_gap;
    }

    /// Takes the result of an earlier check, without its limits where they are not to refuse a reference.
    constexpr supervision_procedure(drive_layout const& layout, supervision_report const& found,
                                    beyond_limits beyond = beyond_limits::refuse) noexcept
        : procedure{layout}, is_known_{true}, words_{0, false, false}, report_{found}
    {
        report_.limits = beyond == beyond_limits::refuse ? found.limits : found.limits.without_frequencies();
    }

    [[nodiscard]] constexpr supervision_procedure anew() const noexcept
    {
        return is_known_ ? supervision_procedure{layout(), report_}
                         : supervision_procedure{layout(), options_, is_by_speed_};
    }

    /// Before another `begun`, behind a response that was lost: reads all of it again.
    constexpr void restart(errc lost) noexcept
    {
        note_lost(lost);
        at_ = safeguard::highest;
        has_read_ = false;
        forget_end();
    }

    constexpr action step(event what) noexcept
    {
        switch (what.what()) {
        case event::kind::begun: return is_known_ ? end(report_.finding) : ask();
        case event::kind::word_read: has_read_ = true; return go_on(judge(what.word()), what.word());
        case event::kind::failed: return go_without(what.error());
        case event::kind::written:
        case event::kind::pause_over:
        case event::kind::late: break;
        }
        return end(outcome_kind::aborted, reason().error);
    }

    [[nodiscard]] constexpr supervision_report const& report() const noexcept { return report_; }

    /// How long the drive keeps running without a request, as it was read; else the longest that can be set.
    [[nodiscard]] constexpr duration drive_timeout() const noexcept
    {
        bool const is_read = report_.period.timeout != duration{};
        return is_read ? report_.period.timeout : layout().longest_silence;
    }

private:
    constexpr std::uint16_t address() const noexcept { return words_.address_of(at_, layout()); }

    /// The first read is repeated as the client's options say: nothing was read before it that a loss of power makes old.
    constexpr action ask() noexcept
    {
        while (address() == 0) {
            at_ = after(at_);
        }
        return has_read_ ? once(to_read(address())) : to_read(address());
    }

    static constexpr safeguard after(safeguard at) noexcept
    {
        return static_cast<safeguard>(static_cast<unsigned>(at) + 1U);
    }

    constexpr outcome_kind judge(std::uint16_t word) noexcept
    {
        if (at_ == safeguard::status) {
            note(word);
        }
        return words_.judge(at_, word, layout().safeguards, report_);
    }

    /// Skips a register that the drive does not have; any other error ends the check. Without a status word no drive is
    /// ordered, whatever risk is accepted.
    constexpr action go_without(errc error) noexcept
    {
        if (has_read_ and not is_exception(error) and error != errc::unit_lost) {
            restart(error);
            return ask();
        }
        if (error != errc::illegal_data_address or at_ == safeguard::status) {
            return end(error);
        }
        bool const is_needed = at_ != safeguard::local_input and at_ != safeguard::disable and at_ != safeguard::wiring;
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
        if (at_ == safeguard::status) {
            return finish();
        }
        at_ = after(at_);
        return ask();
    }

    constexpr action conclude(outcome_kind found, errc error = errc::none) noexcept
    {
        report_.finding = found;
        if (found == outcome_kind::not_drive_profile) {
            note_meaning(detail::other_meaning);
        }
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
        report_.words = words_.meaning(layout());
        note_meaning(report_.words == word_meaning::cia402 ? control_word() : std::uint16_t{0});
        if (not report_.period.holds()) {
            report_.address = layout().safeguards.tto;
            report_.word = words_.timeout();
            if (not accepts(outcome_kind::timeout_too_short)) {
                return conclude(outcome_kind::timeout_too_short);
            }
        }
        return conclude(outcome_kind::succeeded);
    }

    // Small processors reach bytes with short instructions only where they are near.
    safeguard at_{safeguard::highest};
    bool is_by_speed_{false};
    bool is_known_{false}; ///< an earlier check gave the report
    bool has_read_{false};
    safeguard_words words_;
    supervision_report report_{};
    supervision_options options_{};
};

/// Checks a drive before its first order: at most nine reads, and four of its limits. It ends as `succeeded` (`ready`), or with the reason
/// against it; the report then names the register and its word, and for `timeout_too_short` both times. An ATV12 and
/// an ATV310 have no ATR; a second channel that an input switches to (CCS, RFC) is not checked.
class check_supervision : public procedure_runner<supervision_procedure> {
public:
    /// `its_options` accept risks by name; `its_limit` counts from the first `advance`.
    template <device_type Device>
    explicit constexpr check_supervision(station<Device> const& its_drive, supervision_options const& its_options = {},
                                         duration its_limit = milliseconds(10'000)) noexcept
        : procedure_runner{its_drive.unit(), its_limit, drive_check<Device>::layout, its_options}
    {}

    /// Whether the drive may be ordered, accepted risks included.
    [[nodiscard]] constexpr bool ready() const noexcept { return succeeded(); }

    /// What was found; complete once it is settled.
    [[nodiscard]] constexpr supervision_report const& report() const noexcept { return told().report(); }
};

} // namespace altivar
} // namespace RTUWIRE_BUILD
} // namespace rtuwire
