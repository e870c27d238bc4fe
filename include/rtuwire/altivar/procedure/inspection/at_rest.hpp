// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// Checks that a drive is at rest and that no run input is closed. This is read before any write that may give the
// command to the terminals, or take it from them. Other procedures run this one inside.
// Internal: may change with any version.
#pragma once

#include <cstdint>

#include <rtuwire/altivar/procedure/procedure.hpp>
#include <rtuwire/core/version.hpp>

namespace rtuwire {
inline namespace RTUWIRE_BUILD {
namespace altivar {

/// What is known about the wiring of a drive's terminals.
struct terminal_options {
    /// Logic inputs that command run in two-wire control, LI1 in bit 0: LI1 forward, LI2 reverse. Inputs with another
    /// function may be closed: where LI1 and LI2 have one, name the inputs that command run.
    std::uint16_t run_inputs{0x0003};
    /// Whether a drive is accepted whose inputs cannot be read (ATV310): a closed one starts its motor.
    bool accept_unseen_inputs{false};
};

/// How the check depends on the write that follows.
struct alignas(2) at_rest_rules { // copied as one
    bool accepts_fault{false};    ///< the write may be the remedy for the fault
    bool ends_three_wire{false};  ///< the write may restore two-wire control, where a closed LI1 runs
};

/// Decides the check, word by word. It ends as `succeeded` in states 2, 3 and 4, and in 8 with `accepts_fault`, with
/// the run inputs open. In three-wire control a steady input does not start the motor, so the inputs are not read.
///
/// | read of  | answer                 | next                                            |
/// |----------|------------------------|-------------------------------------------------|
/// | ETA      | 2, 3, 4                | read TCC                                        |
/// |          | 8, where accepted      | read TCC                                        |
/// |          | 7, 8                   | read LFT                                        |
/// |          | 5, 6                   | end: refused_while_running                      |
/// |          | 1, or no state         | end: aborted                                    |
/// | TCC      | three-wire             | end: succeeded                                  |
/// |          | other, or exception 02 | read the inputs                                 |
/// | inputs   | a run input is closed  | end: run_input_closed                           |
/// |          | other                  | end: succeeded                                  |
/// |          | exception 02           | end: unknown_register; succeeded where accepted |
/// | LFT      | any                    | end: in_fault                                   |
/// | anything | no response            | end: silent                                     |
/// |          | refused otherwise      | end: refused                                    |
/// |          | limit over             | end: aborted; of LFT: in_fault, 0               |
///
/// TCC is not read where the drive has none, or where two-wire control may come back. A drive without a register of its
/// inputs is as one that answers 02. Without run inputs, ETA decides alone.
class at_rest_procedure : public procedure {
public:
    constexpr at_rest_procedure(drive_layout const& layout, terminal_options const& options,
                                at_rest_rules const& rules = {}) noexcept
        : procedure{layout}, options_{options}, rules_{rules}
    {}

    [[nodiscard]] constexpr at_rest_procedure anew() const noexcept { return {layout(), options_, rules_}; }

    constexpr action step(event what) noexcept
    {
        switch (what.what()) {
        case event::kind::begun: return ask(asked::status, layout().eta);
        case event::kind::word_read: return on_response(what.word());
        case event::kind::failed: return go_without(what.error());
        case event::kind::written:
        case event::kind::pause_over:
        case event::kind::late: break;
        }
        return asked_ == asked::fault ? end_in_fault(0) : end(outcome_kind::aborted);
    }

    /// The register that was read last, and its value.
    [[nodiscard]] constexpr std::uint16_t address() const noexcept { return address_; }
    [[nodiscard]] constexpr std::uint16_t word() const noexcept { return word_; }

private:
    enum class asked : std::uint8_t { status, fault, wiring, inputs };

    constexpr action ask(asked what, std::uint16_t address) noexcept
    {
        asked_ = what;
        address_ = address;
        word_ = 0;
        return to_read(address);
    }

    constexpr action on_response(std::uint16_t word) noexcept
    {
        word_ = word;
        switch (asked_) {
        case asked::status: return judge(note(word));
        case asked::fault: return end_in_fault(word);
        case asked::wiring: return judge_wiring(word);
        case asked::inputs: break;
        }
        return end((word & options_.run_inputs) != 0 ? outcome_kind::run_input_closed : outcome_kind::succeeded);
    }

    constexpr action judge(cia402::state at) noexcept
    {
        bool const is_trusted = at == cia402::state::fault and rules_.accepts_fault;
        if (cia402::is_in_fault(at) and not is_trusted) {
            return ask(asked::fault, layout().lft);
        }
        if (not stands(at)) {
            return end_running();
        }
        safeguard_layout const& where = layout().safeguards;
        return options_.run_inputs == 0                   ? end(outcome_kind::succeeded)
               : where.tcc == 0 or rules_.ends_three_wire ? look_at_inputs()
                                                          : ask(asked::wiring, where.tcc);
    }

    constexpr action judge_wiring(std::uint16_t word) noexcept
    {
        constexpr std::uint16_t three_wire = 1;
        return word == three_wire ? end(outcome_kind::succeeded) : look_at_inputs();
    }

    constexpr action look_at_inputs() noexcept
    {
        std::uint16_t const inputs = layout().safeguards.inputs;
        return inputs == 0 ? trust_or(errc::none) : ask(asked::inputs, inputs);
    }

    constexpr action trust_or(errc error) noexcept
    {
        return options_.accept_unseen_inputs ? end(outcome_kind::succeeded)
                                             : end(outcome_kind::unknown_register, error);
    }

    constexpr action go_without(errc error) noexcept
    {
        if (error != errc::illegal_data_address) {
            return end(error);
        }
        switch (asked_) {
        case asked::wiring: return look_at_inputs(); // treated as two-wire control
        case asked::inputs: return trust_or(error);
        case asked::status:
        case asked::fault: break;
        }
        return end(error);
    }

    terminal_options options_;
    std::uint16_t address_{0};
    std::uint16_t word_{0};
    asked asked_{asked::status};
    at_rest_rules rules_;
};

} // namespace altivar
} // namespace RTUWIRE_BUILD
} // namespace rtuwire
