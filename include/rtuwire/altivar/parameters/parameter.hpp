// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// One register of a drive as a row: what its line in the manual's table says. A menu is an array of them:
//
//     {"TDC1", 10402, rw,  in<deciseconds>, 1, 300, 5,  "Automatic DC injection: first time", &stopping},
//     {"NST",  11202, cfg, logic_input,     {}, {}, 0,  "Input for freewheel stop", &stop_input},
//      mnemonic, address, who may write it, what it holds, least, most, as delivered, name, what it is for a restore
//
// `rw` is written at any time, `cfg` only at rest, `ro` never; each drive's file defines these three, with the
// provenance. Where that is `inferred`, as of an ATV320, a restore writes the row only `with_inferred`. It holds
// amounts, `in<...>` their unit and step, or one of a list of choices, or bits. Limits and the value as delivered are
// counts of that step; `{}` is none, or not known. A limit may be another register: "TFR". Behind the name stands only
// what is special: why it is no ordinary setting, and which register sets the size of its steps. What it is for a
// restore: an ordinary setting, one that needs a decision of its own, or nothing that a configuration consists of.
#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include <rtuwire/core/literal.hpp>
#include <rtuwire/core/version.hpp>
#include <rtuwire/table/enumeration.hpp>
#include <rtuwire/table/register.hpp>
#include <rtuwire/table/row.hpp>

namespace rtuwire {
inline namespace RTUWIRE_BUILD {
namespace altivar {

/// What a parameter is for a restore and for a comparison.
enum class parameter_role : std::uint8_t {
    setting,         ///< an ordinary one
    macro,           ///< sets many others
    step_size,       ///< says what the counts of others mean
    frequency_limit, ///< LSP <= HSP <= TFR at any time
    motion,          ///< how a motor turns that runs: speeds, ramps, how it is regulated, braked and stopped
    supervision,     ///< can switch off what stops the motor, its brake and its contactors among it
    restart,         ///< lets the drive do something by itself, or a fault be reset by an input
    run_input,       ///< an input that is closed may act at once
    channel,         ///< says who commands the motor, or where a controller's words go
    link_timeout,    ///< when the drive stops for want of requests
    other_link,      ///< the drive's place on another bus
    link,            ///< its place on this line: once written, it may answer elsewhere
    read_only,
    derived,       ///< another form of a setting
    measured,      ///< a counter that may be written
    of_this_drive, ///< goes with the device, not with its configuration
    order,         ///< does something when it is written
    safety,        ///< of the safety functions, which have tools and a signature of their own
};

/// Whether a parameter of this role belongs to a configuration, and may be restored at all.
[[nodiscard]] constexpr bool is_restorable(parameter_role role) noexcept { return role < parameter_role::read_only; }

/// Whether a write of this role changes how a motor turns that runs, at once: what sets its speed or its ramps, the limits
/// of both, the size of their steps, and their other forms. At rest it is an ordinary setting. What may let a motor turn
/// that stands has other roles.
[[nodiscard]] constexpr bool acts_on_running_motor(parameter_role role) noexcept
{
    return role == parameter_role::motion or role == parameter_role::frequency_limit or
           role == parameter_role::step_size or role == parameter_role::derived;
}

/// What a parameter is for a restore, and why: the end of a sentence that begins with its mnemonic.
struct row_role {
    parameter_role role;
    literal why{};
};

/// What a row says of itself. An ordinary setting says nothing.
namespace roles {

inline constexpr row_role ordinary{parameter_role::setting};

// Orders.
inline constexpr row_role commands{parameter_role::order, "commands the motor"};
inline constexpr row_role setpoint{parameter_role::order, "is a reference of the motor"};
inline constexpr row_role recalls{parameter_role::order, "saves, recalls or resets the settings"};
inline constexpr row_role autotuning{parameter_role::order, "starts an autotune, with current in the motor"};
inline constexpr row_role drive_restart{parameter_role::order, "restarts the drive"};
inline constexpr row_role clears{parameter_role::order, "clears counters"};
inline constexpr row_role loads_set{parameter_role::order, "loads a parameter set"};
inline constexpr row_role runs_blocks{parameter_role::order, "runs and stops the function blocks"};
inline constexpr row_role accepts{parameter_role::order, "accepts a wrong configuration"};
inline constexpr row_role sets_output{parameter_role::order, "switches an output"};
inline constexpr row_role passed_on{parameter_role::order,
                                    "is passed on by the scanner, to the command word among others"};

// What belongs to this drive, or to others.
inline constexpr row_role counter{parameter_role::measured, "counts time"};
inline constexpr row_role device_identity{parameter_role::of_this_drive, "tells what device it is"};
inline constexpr row_role cards{parameter_role::of_this_drive, "ties the drive to its cards"};
inline constexpr row_role another_form{parameter_role::derived, "is LSP, HSP, ACC or DEC in another form"};
inline constexpr row_role of_safety{parameter_role::safety, "belongs to the safety functions"};

// Settings on which others depend.
inline constexpr row_role macro{parameter_role::macro, "sets inputs, channels and many others"};
inline constexpr row_role steps{parameter_role::step_size, "says what the counts of others mean"};
inline constexpr row_role speed_limit{parameter_role::frequency_limit,
                                      "limits the speed, and is written so that LSP <= HSP <= TFR"};

// How a motor turns that runs.
inline constexpr row_role speed{parameter_role::motion, "is a speed of the motor"};
inline constexpr row_role speed_range{parameter_role::motion, "sets speeds and their limits"};
inline constexpr row_role skipped{parameter_role::motion, "says which speeds the motor skips, or does not stay at"};
inline constexpr row_role scaling{parameter_role::motion, "says what reference a signal or a word stands for"};
inline constexpr row_role ramp{parameter_role::motion, "sets a ramp"};
inline constexpr row_role stopping{parameter_role::motion, "says how the motor stops"};
inline constexpr row_role regulation{parameter_role::motion, "belongs to the PI regulator, which sets the speed"};
inline constexpr row_role pumping{parameter_role::motion, "starts and stops pumps as the flow changes"};
inline constexpr row_role brake{parameter_role::motion, "belongs to the brake and to hoisting"};
inline constexpr row_role winding{parameter_role::motion, "winds: it moves the speed up and down"};
inline constexpr row_role tuning{parameter_role::motion, "tunes how the motor follows its reference"};

// What may switch off what stops a motor.
inline constexpr row_role link_loss{parameter_role::supervision, "can let the motor run on without its link"};
inline constexpr row_role reaction{parameter_role::supervision, "can switch off the reaction to a fault"};
inline constexpr row_role blind{parameter_role::supervision, "can switch off a detection"};
inline constexpr row_role relay{parameter_role::supervision,
                                "switches an output at once: a brake, a contactor, whatever hangs on it"};
inline constexpr row_role stop_input{parameter_role::supervision,
                                     "can take away an input or a key that stops the motor"};

// What may let a motor turn that stands.
inline constexpr row_role restarts{parameter_role::restart, "lets the drive start again by itself"};
inline constexpr row_role catching{parameter_role::restart, "catches a motor that spins"};
inline constexpr row_role reset_input{parameter_role::restart, "lets an input reset a fault or restart the drive"};
inline constexpr row_role self_tuning{parameter_role::restart, "lets the drive tune by itself when power comes"};
inline constexpr row_role wiring{parameter_role::run_input, "says how the terminals command"};
inline constexpr row_role moves{parameter_role::run_input, "lets an input or a key move the motor"};
inline constexpr row_role input_use{parameter_role::run_input, "says what an input does, which may be on now"};
inline constexpr row_role selection{parameter_role::run_input,
                                    "lets an input choose other settings, or start the function blocks"};

// Who commands.
inline constexpr row_role commander{parameter_role::channel, "says who commands the motor"};
inline constexpr row_role references{parameter_role::channel, "says whose reference counts"};
inline constexpr row_role cyclic_words{parameter_role::channel, "says which registers a controller's words go to"};
inline constexpr row_role targets{parameter_role::channel,
                                  "says which registers function blocks and parameter sets write to"};

// The link.
inline constexpr row_role timeout{parameter_role::link_timeout, "says when the drive stops for want of requests"};
inline constexpr row_role other_bus{parameter_role::other_link, "is the drive's place on another bus"};
inline constexpr row_role this_line{parameter_role::link, "is the drive's place on this line"};

} // namespace roles

/// One parameter, as its row.
struct parameter {
    literal code; ///< the mnemonic, in upper case
    std::uint16_t address;
    row_access is_written;
    held_values type;
    bound min = detail::open_bound;                              ///< in raw counts, or by another register
    bound max = detail::open_bound;                              ///< in raw counts, or by another register
    std::optional<std::int32_t> factory = detail::unknown_count; ///< in raw counts, where known
    literal name = detail::no_text;                              ///< for display
    row_role const* role{&roles::ordinary};   ///< what it is for whoever copies a configuration, and why
    literal steps_set_by = detail::no_text;   ///< the register that sets the size of a step; empty where none does
    detail::count_range gap = detail::no_gap; ///< raw counts inside the limits that are never written

    /// Each is a holding register of one word: a restore writes no other.
    static constexpr bool is_plain = true;

    [[nodiscard]] constexpr access mode() const noexcept { return is_written.mode; }
    [[nodiscard]] constexpr provenance source() const noexcept { return is_written.source; }

    /// Whether it can be written at all.
    [[nodiscard]] constexpr bool is_writable() const noexcept { return is_written.mode != access::read_only; }

    /// The values of an enumeration, or the bits of a word by number.
    [[nodiscard]] constexpr std::span<choice const> choices() const noexcept { return type.choices(); }

    /// The choices that a word has to be one of: those of an enumeration. Without any, each word is one.
    [[nodiscard]] constexpr std::span<choice const> listed() const noexcept
    {
        return type->kind == parameter_kind::enumeration ? type.choices() : std::span<choice const>{};
    }

    /// The count that a word on the wire stands for: below zero only in a register of signed numbers.
    [[nodiscard]] constexpr std::int32_t count_of(std::uint16_t word) const noexcept
    {
        return type->kind == parameter_kind::signed_number ? std::int32_t{static_cast<std::int16_t>(word)}
                                                           : std::int32_t{word};
    }

    /// Whether a count lies within the limits, as far as they do not depend on another register, and not in the gap, and is
    /// one of the values that the enumeration lists.
    [[nodiscard]] constexpr bool takes(std::int32_t count) const noexcept
    {
        bool const is_signed = type->kind == parameter_kind::signed_number;
        std::int64_t const lowest = min.is_number() ? min.raw() : is_signed ? -32'768 : 0;
        std::int64_t const highest = max.is_number() ? max.raw() : is_signed ? 32'767 : 65'535;
        return count >= lowest and count <= highest and not gap.contains(count) and
               detail::has_meaning(listed(), static_cast<std::uint16_t>(count));
    }
};

/// Never defined: reached only in a constant expression, so that the compiler prints the name.
void a_register_that_is_written_says_what_it_is_for_a_restore();

/// The row of a register that has an object, and what it is for whoever copies a configuration.
template <detail::register_value T>
[[nodiscard]] constexpr parameter row_of(reg<T> const& from, row_role const& role) noexcept
{
    return {from.code, from.address, {from.mode, from.source}, in<T>,   from.min, from.max, from.factory,
            from.name, &role,        from.steps_set_by,        from.gap};
}

/// The same of a register that is only read.
template <detail::register_value T> [[nodiscard]] consteval parameter row_of(reg<T> const& from) noexcept
{
    if (from.mode != access::read_only) {
        a_register_that_is_written_says_what_it_is_for_a_restore();
    }
    return row_of(from, roles::ordinary);
}

/// What a parameter is. One that the map does not let be written is `read_only`, whatever its row says.
[[nodiscard]] constexpr parameter_role role_of(parameter const& row) noexcept
{
    return row.is_writable() ? row.role->role : parameter_role::read_only;
}

/// Why a parameter is no ordinary setting, as the end of a sentence that begins with its mnemonic; empty where it is one.
[[nodiscard]] constexpr literal why(parameter const& row) noexcept
{
    return row.is_writable() ? row.role->why : literal{"is read-only"};
}

} // namespace altivar

} // namespace RTUWIRE_BUILD
} // namespace rtuwire
