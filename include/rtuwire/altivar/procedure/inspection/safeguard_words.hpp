// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// What the words of a drive's safeguard registers mean for an order: which register each check reads, and which words
// forbid an order. It knows no requests and no accepted risks.
// Internal: may change with any version.
#pragma once

#include <cstddef>
#include <cstdint>

#include <rtuwire/altivar/device/drive_layout.hpp>
#include <rtuwire/altivar/procedure/inspection/supervision_report.hpp>
#include <rtuwire/altivar/procedure/outcome.hpp>
#include <rtuwire/core/version.hpp>

namespace rtuwire {
inline namespace RTUWIRE_BUILD {
namespace altivar {

/// What is read, in this order: a reference beyond the limits needs no more; the channel defines what the others mean.
enum class safeguard : std::uint8_t {
    highest,
    lowest,
    rated_frequency,
    rated_speed, ///< or what 1 Hz is in rpm
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

/// The words that were read of a drive's safeguards.
///
/// | register         | word                                   | finding                        |
/// |------------------|----------------------------------------|--------------------------------|
/// | HSP, LSP, FRS    | any                                    | noted                          |
/// | NSP, SDS         | 0                                      | unknown_register               |
/// |                  | other                                  | noted                          |
/// | SLL              | 1, 2, 6, 7, 8                          |                                |
/// |                  | 0                                      | unsupervised                   |
/// |                  | 4, 5                                   | runs_on_without_link           |
/// |                  | other                                  | unknown_register               |
/// | CMI, without SLL | NTO                                    | unsupervised                   |
/// | TTO              | 0                                      | unsupervised                   |
/// | CHCF             | 1                                      | CD1 is not read                |
/// |                  | 2                                      |                                |
/// |                  | 3                                      | not_drive_profile              |
/// |                  | other                                  | unknown_register               |
/// | CD1              | not 10                                 | other_channel                  |
/// | FR1              | not 164                                | other_channel                  |
/// | FLO              | any                                    | noted                          |
/// | ATR              | not 0                                  | restarts_by_itself             |
/// | DOTD             | any                                    | noted: 1 is the ramp           |
/// | TCC              | any                                    | noted: 1 is three-wire control |
/// | inputs           | a run input, not in three-wire control | run_input_closed               |
/// | ETA              | in local control                       | local_control                  |
///
/// TCC and the inputs count only where the terminals command after power-up, the limits where they refuse a reference; FRS,
/// NSP and SDS for one in rpm, whose sign rests on them, too.
class safeguard_words {
public:
    constexpr safeguard_words(std::uint16_t run_inputs, bool has_limits, bool is_by_speed) noexcept
        : has_limits_{has_limits}, is_by_speed_{is_by_speed}, run_inputs_{run_inputs}
    {}

    /// The register to read; 0 where the drive has none.
    [[nodiscard]] constexpr std::uint16_t address_of(safeguard what, drive_layout const& layout) const noexcept
    {
        bool const is_left_out = what <= safeguard::lowest        ? not has_limits_
                                 : what <= safeguard::rated_speed ? not is_by_speed_
                                                                  : what == safeguard::command and mode_ == together;
        return is_left_out ? std::uint16_t{0} : layout.checked[static_cast<std::size_t>(what)];
    }

    /// Why a word forbids an order; `succeeded` where it does not. Notes in the report what it says besides.
    constexpr outcome_kind judge(safeguard what, std::uint16_t word, safeguard_layout const& at,
                                 supervision_report& report) noexcept
    {
        constexpr std::uint16_t by_modbus = 10, reference_by_modbus = 164;
        switch (what) {
        case safeguard::highest: report.limits.highest = word; break;
        case safeguard::lowest: report.limits.lowest = word; break;
        case safeguard::rated_frequency: rated_ = word; break;
        case safeguard::rated_speed:
            return unless(report.limits.note_scale(rated_, word), outcome_kind::unknown_register);
        case safeguard::reaction: return judge_reaction(word, at, report.period);
        case safeguard::timeout: return judge_timeout(word, report.period);
        case safeguard::mode: return judge_mode(word);
        case safeguard::command: return unless(word == by_modbus, outcome_kind::other_channel);
        case safeguard::reference: return unless(word == reference_by_modbus, outcome_kind::other_channel);
        case safeguard::local_input: report.has_local_input = word != 0; break;
        // 2 on an ATV28: after a mains failure it restarts by its terminals, which counts as well.
        case safeguard::restart: return unless(word == 0, outcome_kind::restarts_by_itself);
        case safeguard::disable: stops_on_ramp_ = word == 1; break;
        case safeguard::wiring: is_three_wire_ = word == 1; break;
        case safeguard::inputs: return judge_inputs(word);
        case safeguard::status: return unless((word & remote_bit) != 0, outcome_kind::local_control);
        }
        return outcome_kind::succeeded;
    }

    /// TTO as it was read, 0.1 s; 0 where it was not.
    [[nodiscard]] constexpr std::uint16_t timeout() const noexcept { return timeout_; }

    /// What the drive's control words mean.
    [[nodiscard]] constexpr word_meaning meaning(drive_layout const& layout) const noexcept
    {
        bool const has_one_meaning = not may_have_io_profile(layout) or is_drive_profile(mode_);
        bool const is_on_ramp = layout.safeguards.dotd == 0 or stops_on_ramp_;
        return has_one_meaning and is_on_ramp ? word_meaning::cia402 : word_meaning::unknown;
    }

private:
    static constexpr std::uint16_t together = 1, apart = 2;

    static constexpr outcome_kind unless(bool is_right, outcome_kind kind) noexcept
    {
        return is_right ? outcome_kind::succeeded : kind;
    }

    constexpr outcome_kind judge_reaction(std::uint16_t word, safeguard_layout const& at, period_rule& period) noexcept
    {
        if (at.nto != 0) {
            is_watched_ = (word & at.nto) == 0;
            period.timeout = is_watched_ ? at.fixed_timeout : duration{};
            return unless(is_watched_, outcome_kind::unsupervised);
        }
        is_watched_ = word != 0;
        if (not is_watched_) {
            return outcome_kind::unsupervised;
        }
        constexpr std::uint16_t undescribed = 3, at_its_speed = 4, at_fallback_speed = 5, last = 8;
        if (word == at_its_speed or word == at_fallback_speed) {
            return outcome_kind::runs_on_without_link;
        }
        // 1, 2, 6, 7, 8: freewheel, as STT sets, ramp, fast stop, DC injection
        return unless(word <= last and word != undescribed, outcome_kind::unknown_register);
    }

    constexpr outcome_kind judge_timeout(std::uint16_t word, period_rule& period) noexcept
    {
        constexpr std::uint16_t tenth = 100,
                                most = detail::longest_duration.microseconds / milliseconds(tenth).microseconds;
        timeout_ = word;
        period.timeout =
            is_watched_ ? duration{milliseconds(tenth).microseconds * (word < most ? word : most)} : duration{};
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
        bool const asks_to_run = not is_three_wire_ and (word & run_inputs_) != 0;
        return unless(not asks_to_run, outcome_kind::run_input_closed);
    }

    bool has_limits_;
    bool is_by_speed_;
    bool is_watched_{true};
    bool stops_on_ramp_{false};
    bool is_three_wire_{false};
    std::uint16_t run_inputs_;
    std::uint16_t mode_{0};
    std::uint16_t rated_{0};   ///< FRS
    std::uint16_t timeout_{0}; ///< TTO
};

} // namespace altivar
} // namespace RTUWIRE_BUILD
} // namespace rtuwire
