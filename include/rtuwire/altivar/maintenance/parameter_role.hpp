// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// What each parameter is for whoever copies a configuration: an ordinary setting, one that needs a decision of its own,
// or nothing that a configuration consists of. The list names what is not ordinary, each with its reason.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include <rtuwire/altivar/parameters/parameter.hpp>
#include <rtuwire/core/literal.hpp>
#include <rtuwire/core/version.hpp>

namespace rtuwire::inline RTUWIRE_BUILD::altivar {

/// What a parameter is for a restore and for a comparison.
enum class parameter_role : std::uint8_t {
    setting,         ///< an ordinary one
    macro,           ///< sets many others
    step_size,       ///< says what the counts of others mean
    frequency_limit, ///< LSP <= HSP <= TFR at any time
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

/// Parameters of one role for one reason: their mnemonics, with a space between.
/// Internal.
struct role_entry {
    parameter_role role;
    literal why;
    literal codes;
};

/// Whatever is no ordinary setting, over all drives.
/// Internal.
inline constexpr role_entry special_parameters[]{
    {parameter_role::order, "commands the motor", "CMD CMDD"},
    {parameter_role::order, "is a reference of the motor", "LFR LFRD PISP AIV1"},
    {parameter_role::order, "saves, recalls or resets the settings", "CMI SCS FCS"},
    {parameter_role::order, "starts an autotune, with current in the motor", "TUN"},
    {parameter_role::order, "restarts the drive", "RP"},
    {parameter_role::order, "clears counters", "RPR"},
    {parameter_role::order, "loads a parameter set", "VAL"},
    {parameter_role::order, "runs and stops the function blocks", "FBCD"},
    {parameter_role::order, "accepts a wrong configuration", "CIC"},
    {parameter_role::order, "switches an output", "OL1R AO1R"},
    {parameter_role::order, "is passed on by the scanner, to the command word among others",
     "NC1 NC2 NC3 NC4 NC5 NC6 NC7 NC8"},
    {parameter_role::measured, "counts time", "TAC TAC2 PET"},
    {parameter_role::of_this_drive, "tells what device it is", "NCV VCAL SPN"},
    {parameter_role::of_this_drive, "ties the drive to its cards", "PPI"},
    {parameter_role::derived, "is LSP, HSP, ACC or DEC in another form", "SMIL SMAL SPAL SPAT SPDL SPDT"},
    {parameter_role::safety, "belongs to the safety functions",
     "SLSA SLT SLSP SLTT SS1A SSRT SSRU SSSL SSTT STOA PWRM LIDT LIRT"},
    {parameter_role::macro, "sets inputs, channels and many others", "CFG"},
    {parameter_role::step_size, "says what the counts of others mean", "INR INTP"},
    {parameter_role::frequency_limit, "is written so that LSP <= HSP <= TFR", "TFR HSP LSP"},
    {parameter_role::supervision, "can let the motor run on without its link", "SLL COL CLL"},
    {parameter_role::supervision, "can switch off the reaction to a fault",
     "EPL IPL OPL OHL OLL TNL LFL1 LFL3 UDL ODL MPI SSB DLB RSD USB STP SAT FBSM FBDF"},
    {parameter_role::supervision, "can switch off a detection", "THT MTM PTCL ULT TOL TDS TQB TLD LPI ODT FQF RCA BCI"},
    {parameter_role::supervision, "switches an output at once: a brake, a contactor, whatever hangs on it",
     "R1 R2 LO1 DO1 R1S R2S LO1S DO1S BLC LLC OCC"},
    {parameter_role::supervision, "can take away an input or a key that stops the motor",
     "ETF LET INH NST FST DCI SAF SAR DAF DAR CLS PAS SAL DAL LES PST"},
    {parameter_role::restart, "lets the drive start again by itself", "ATR TAR FTU FTO"},
    {parameter_role::restart, "catches a motor that spins", "FLR"},
    {parameter_role::restart, "lets an input reset a fault or restart the drive", "RSF RPA"},
    {parameter_role::restart, "lets the drive tune by itself when power comes", "AUT"},
    {parameter_role::run_input, "says how the terminals command", "TCC TCT RRS NPL"},
    {parameter_role::run_input, "lets an input or a key move the motor", "JOG TUL FLI FLU FN1 FN2 FN3 FN4 BMP"},
    {parameter_role::run_input, "lets an input choose other settings, or start the function blocks",
     "CHA1 CHA2 CNF1 CNF2 FBRM"},
    {parameter_role::channel, "says who commands the motor", "CHCF CD1 CD2 CCS FLO FLOT COP"},
    {parameter_role::channel, "says whose reference counts", "FR1 FR1B FR2 RFC RCB FLOC"},
    {parameter_role::channel, "says which registers a controller's words go to",
     "NCA1 NCA2 NCA3 NCA4 NCA5 NCA6 NCA7 NCA8"},
    {parameter_role::channel, "says which registers function blocks and parameter sets write to",
     "LA01 LA02 LA03 LA04 LA05 LA06 LA07 LA08 AD01 AD02 AD03 AD04 AD05 AD06 AD07 AD08 AD09 AD10 AD11 AD12 AD13 AD14 "
     "AD15"},
    {parameter_role::link_timeout, "says when the drive stops for want of requests", "TTO"},
    {parameter_role::other_link, "is the drive's place on another bus",
     "ADCO BDCO ADRC BDR AMOC PRC GLB BTUA BTUC BTPI"},
    {parameter_role::link, "is the drive's place on this line", "ADD TBR TFO"},
};

/// A mnemonic as a number, which orders the list; 0 for one of more than 8 characters, which the list does not have.
/// Internal.
[[nodiscard]] constexpr std::uint64_t mnemonic_key(char const* first, char const* last) noexcept
{
    std::uint64_t key = 0;
    if (last - first <= 8) {
        for (; first != last; ++first) {
            key = (key << 8U) | static_cast<unsigned char>(*first);
        }
    }
    return key;
}

/// The list by mnemonics, so that each look-up takes a few comparisons.
/// Internal.
class role_index {
public:
    consteval role_index() noexcept
    {
        for (std::size_t entry = 0; entry < std::size(special_parameters); ++entry) {
            literal const codes = special_parameters[entry].codes;
            char const* begin = codes.begin();
            for (char const* at = begin; at <= codes.end(); ++at) {
                if (at == codes.end() or *at == ' ') {
                    insert({mnemonic_key(begin, at), static_cast<std::uint8_t>(entry)});
                    begin = at + 1;
                }
            }
        }
    }

    /// The entry of a mnemonic; null where it is in no list.
    [[nodiscard]] constexpr role_entry const* find(literal code) const noexcept
    {
        std::uint64_t const key = mnemonic_key(code.begin(), code.end());
        std::size_t first = 0;
        std::size_t last = size_;
        while (first < last) {
            std::size_t const middle = first + (last - first) / 2;
            if (places_[middle].key < key) {
                first = middle + 1;
            } else {
                last = middle;
            }
        }
        return first < size_ and places_[first].key == key ? &special_parameters[places_[first].entry] : nullptr;
    }

private:
    struct place {
        std::uint64_t key{0};
        std::uint8_t entry{0};
    };
    static constexpr std::size_t most = 224;

    constexpr void insert(place const& what) noexcept
    {
        std::size_t at = size_++;
        for (; at > 0 and what.key < places_[at - 1].key; --at) {
            places_[at] = places_[at - 1];
        }
        places_[at] = what;
    }

    std::array<place, most> places_{};
    std::size_t size_{0};
};
/// Internal.
inline constexpr role_index parameter_roles;

/// What a parameter is. One that the map does not let be written is `read_only`, whatever the list says.
[[nodiscard]] constexpr parameter_role role_of(parameter const& row) noexcept
{
    if (not row.is_writable()) {
        return parameter_role::read_only;
    }
    role_entry const* const found = parameter_roles.find(row.code);
    return found == nullptr ? parameter_role::setting : found->role;
}

/// Why a parameter is no ordinary setting, as the end of a sentence that begins with its mnemonic; empty where it is one.
[[nodiscard]] constexpr literal why(parameter const& row) noexcept
{
    if (not row.is_writable()) {
        return "is read-only";
    }
    role_entry const* const found = parameter_roles.find(row.code);
    return found == nullptr ? literal{} : found->why;
}

} // namespace rtuwire::altivar
