// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// Whether a drive stands and no terminal asks it to run: what is looked at before anything is written that may give
// the command to its terminals, or take it from them. Other conversations run this one inside.
#pragma once

#include <cstdint>

#include <rtuwire/altivar/script.hpp>
#include <rtuwire/core/version.hpp>

namespace rtuwire::inline RTUWIRE_BUILD::altivar {

/// What is known of the wires at a drive's terminals.
struct terminal_options {
    /// Logic inputs that ask to run in two-wire control, LI1 in bit 0: LI1 forward, LI2 reverse. Where they have another
    /// function they may be closed; name the right ones then.
    std::uint16_t run_inputs{0x0003};
    /// Whether a drive is trusted whose inputs cannot be read (ATV310): a closed one starts its motor.
    bool accept_unseen_inputs{false};
};

/// What else counts as standing, by what is to be written.
struct at_rest_rules {
    bool accepts_fault{false};   ///< for what may be the fault's remedy
    bool ends_three_wire{false}; ///< two-wire control may come back by it, where a closed LI1 runs
};

/// Decides the look, word by word. It ends as `succeeded` in states 2, 3 and 4, and in 8 where that is said, with the
/// run inputs open. In three-wire control a standing input does not start the motor, so none is looked at.
class at_rest_script : public script {
public:
    constexpr at_rest_script(drive_profile const& profile, terminal_options const& options,
                             at_rest_rules const& rules = {}) noexcept
        : script{profile}, options_{options}, rules_{rules}
    {}

    constexpr wish step(event const& what) noexcept
    {
        switch (what.what) {
        case event::kind::begun: return ask(asked::status, profile().eta);
        case event::kind::word_read: return heard(what.word);
        case event::kind::failed: return go_without(what.error);
        case event::kind::written:
        case event::kind::pause_over:
        case event::kind::late: break;
        }
        return end(ending::silent, errc::timed_out);
    }

    /// The register that was asked last, and what it held.
    [[nodiscard]] constexpr std::uint16_t address() const noexcept { return address_; }
    [[nodiscard]] constexpr std::uint16_t word() const noexcept { return word_; }

private:
    enum class asked : std::uint8_t { status, fault, wiring, inputs };

    constexpr wish ask(asked what, std::uint16_t address) noexcept
    {
        asked_ = what;
        address_ = address;
        word_ = 0;
        return to_read(address);
    }

    constexpr wish heard(std::uint16_t word) noexcept
    {
        word_ = word;
        switch (asked_) {
        case asked::status: return judge(note(word));
        case asked::fault: return end_in_fault(word);
        case asked::wiring: return judge_wiring(word);
        case asked::inputs: break;
        }
        return end((word & options_.run_inputs) != 0 ? ending::run_input_closed
                                                     : ending::succeeded);
    }

    constexpr wish judge(cia402::state at) noexcept
    {
        bool const is_trusted = at == cia402::state::fault and rules_.accepts_fault;
        if (cia402::is_in_fault(at) and not is_trusted) {
            return ask(asked::fault, profile().lft);
        }
        if (cia402::has_power(at)) {
            return end(ending::refused_while_running);
        }
        bool const stands = is_trusted or at == cia402::state::switch_on_disabled or
                            at == cia402::state::ready_to_switch_on or
                            at == cia402::state::switched_on;
        if (not stands) {
            return end(ending::stuck);
        }
        safeguard_layout const& where = profile().safeguards;
        return options_.run_inputs == 0                   ? end(ending::succeeded)
               : where.tcc == 0 or rules_.ends_three_wire ? look_at_inputs()
                                                          : ask(asked::wiring, where.tcc);
    }

    constexpr wish judge_wiring(std::uint16_t word) noexcept
    {
        constexpr std::uint16_t three_wire = 1;
        return word == three_wire ? end(ending::succeeded) : look_at_inputs();
    }

    constexpr wish look_at_inputs() noexcept
    {
        std::uint16_t const inputs = profile().safeguards.inputs;
        return inputs == 0 ? trust_or(errc::none) : ask(asked::inputs, inputs);
    }

    constexpr wish trust_or(errc error) noexcept
    {
        return options_.accept_unseen_inputs ? end(ending::succeeded)
                                             : end(ending::unknown_register, error);
    }

    constexpr wish go_without(errc error) noexcept
    {
        if (error != errc::illegal_data_address) {
            return end(error);
        }
        switch (asked_) {
        case asked::wiring: return look_at_inputs(); // as if they counted
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

} // namespace rtuwire::altivar
