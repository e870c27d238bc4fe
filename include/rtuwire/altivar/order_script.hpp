// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// What every order to run has in common: the check of the drive before it, the STOP key meanwhile, and the way back.
#pragma once

#include <cstdint>

#include <rtuwire/altivar/stop.hpp>
#include <rtuwire/altivar/supervision.hpp>
#include <rtuwire/core/version.hpp>

namespace rtuwire::inline RTUWIRE_BUILD::altivar {

/// The base of the scripts that order a drive to run.
class order_script : public script {
public:
    static constexpr bool is_order = true;

    /// To bring a drive to rest that was told to run and must not.
    static constexpr duration grace{milliseconds(30'000)};

    [[nodiscard]] constexpr supervision_report const& report() const noexcept
    {
        return check_.report();
    }
    [[nodiscard]] constexpr duration drive_timeout() const noexcept
    {
        return check_.drive_timeout();
    }
    [[nodiscard]] constexpr bool takes_back() const noexcept { return how_ != ending::pending; }

protected:
    constexpr order_script(drive_profile const& profile, supervision_script const& check) noexcept
        : script{profile}, check_{check}, rest_{profile, stop_by::freewheel, word_meaning::unknown}
    {}

    /// Goes on with the check. Where the drive is ready behind it, its last word was a status word.
    constexpr wish examine(event const& what) noexcept { return run_inside(check_, what); }
    [[nodiscard]] constexpr bool is_ready() const noexcept
    {
        return check_.reason().how == ending::succeeded;
    }

    /// Whether the STOP key was pressed since the look before. A drive that was stopped so earlier shows it until it runs:
    /// what the first look returns is nothing new, and its caller drops it.
    constexpr bool is_key_pressed(std::uint16_t status) noexcept
    {
        bool const is_shown = (status & stop_key_bit) != 0;
        bool const is_new = is_shown and not shows_key_;
        shows_key_ = is_shown;
        return is_new;
    }

    /// What the drive's LFT told; an ending in fault names it.
    constexpr void note_code(std::uint16_t code) noexcept { fault_ = code; }

    constexpr wish finish(ending how, errc error) noexcept
    {
        return how == ending::in_fault ? end_in_fault(fault_) : end(how, error);
    }

    /// Takes back what the drive was told, and ends so when it stands.
    constexpr wish take_back(ending how, errc error, stop_by mode, word_meaning known) noexcept
    {
        how_ = how;
        error_ = error;
        plan_rest(mode, known);
        return rest_.step({event::kind::begun}); // which does not end it
    }
    constexpr wish come_to_rest(event const& what) noexcept
    {
        wish const next = rest_.step(what);
        note_readings_of(rest_);
        if (next.what != wish::kind::end) {
            return next;
        }
        note_state(rest_.reason().state);
        return finish(how_, error_);
    }

private:
    /// Not inlined: what it takes of the stack is free again when the rest begins.
    [[gnu::noinline]] constexpr void plan_rest(stop_by mode, word_meaning known) noexcept
    {
        rest_ = stop_script{profile(), mode, known};
    }

    supervision_script check_;
    stop_script rest_;
    std::uint16_t fault_{0};
    ending how_{ending::pending};
    errc error_{errc::none};
    bool shows_key_{false}; ///< at the last look
};

} // namespace rtuwire::altivar
