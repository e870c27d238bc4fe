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
    {parameter_role::order, "switches an output", "OL1R AO1R IOLR AOR"},
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
    {parameter_role::frequency_limit, "limits the speed, and is written so that LSP <= HSP <= TFR", "TFR HSP LSP"},
    {parameter_role::motion, "is a speed of the motor",
     "SP2 SP3 SP4 SP5 SP6 SP7 SP8 SP9 SP10 SP11 SP12 SP13 SP14 SP15 SP16 JGF LFF HSP2 HSP3 HSP4"},
    {parameter_role::motion, "sets speeds and their limits", "BFR SRP STR MFR RIN"},
    {parameter_role::motion, "says which speeds the motor skips, or does not stay at", "JPF JF2 JF3 JFH TLS SLE JGT"},
    {parameter_role::motion, "says what reference a signal or a word stands for",
     "SDS SPFN SPFD BSP AI1E AI1F AI1L AI1S AI1T AI2E AI2F AI2L AI2S AI2T AI3E AI3F AI3L AI3S AI3T AIC2 CRH CRL CRH1 "
     "CRL1 CRH3 CRL3 UIH1 UIH2 UIL1 UIL2 PFI PFR PIL"},
    {parameter_role::motion, "sets a ramp", "ACC DEC AC2 DE2 FRT RPT TA1 TA2 TA3 TA4 BRA"},
    {parameter_role::motion, "says how the motor stops",
     "STT DOTD QSTD DCF FFT ADC IDC TDC TDI SDC1 TDC1 TDC2 DSF STD SFD NLS STM TSM"},
    {parameter_role::motion, "belongs to the PI regulator, which sets the speed",
     "RPI RP2 RP3 RP4 RPG RIG RDG PRP RPH RPL POH POL PIC PIF PIF1 PIF2 PII PIM PIP1 PIP2 PSR FBS FPI RSL SFS UPP"},
    {parameter_role::motion, "starts and stops pumps as the flow changes", "FON FOF TON TOF RON ROF MDE FFD LFD NFD"},
    {parameter_role::motion, "belongs to the brake and to hoisting",
     "BED BEN BET BIP BIR BRH BRR BRT BST JDC TBE TTR CP1 CP2 LP1 LP2 COF COR HSO LBA LBC LBC1 LBC2 LBC3 LBF OSP RSTL "
     "SCL TOS DAS DBS"},
    {parameter_role::motion, "winds: it moves the speed up and down", "DTF QSH QSL TBO TDN TRH TRL TUP"},
    {parameter_role::motion, "tunes how the motor follows its reference", "FLG STA SLP UFR PFL SPG SIT SFC SPGU CLI"},
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
    {parameter_role::run_input, "says what an input does, which may be on now", "LI3 LI4 AI2"},
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

/// How many mnemonics the list has.
/// Internal.
[[nodiscard]] consteval std::size_t count_special_parameters() noexcept
{
    std::size_t count = 0;
    for (role_entry const& each : special_parameters) {
        ++count;
        for (char const letter : each.codes) {
            count += letter == ' ' ? 1U : 0U;
        }
    }
    return count;
}

/// A mnemonic as a number, which orders the list; 0 for one of more than 7 characters, which the list does not have.
/// Internal.
[[nodiscard]] constexpr std::uint64_t mnemonic_key(char const* first, char const* last) noexcept
{
    std::uint64_t key = 0;
    if (last - first <= 7) {
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
                    insert(place_of(mnemonic_key(begin, at)) | entry);
                    begin = at + 1;
                }
            }
        }
    }

    /// The entry of a mnemonic; null where it is in no list.
    [[nodiscard]] constexpr role_entry const* find(literal code) const noexcept
    {
        std::uint64_t const wanted = place_of(mnemonic_key(code.begin(), code.end()));
        std::size_t first = 0;
        std::size_t last = size_;
        while (first < last) {
            std::size_t const middle = first + (last - first) / 2;
            if (places_[middle] < wanted) {
                first = middle + 1;
            } else {
                last = middle;
            }
        }
        bool const is_listed = first < size_ and place_of(places_[first] >> 8U) == wanted;
        return is_listed ? &special_parameters[places_[first] & 0xFFU] : nullptr;
    }

private:
    static_assert(std::size(special_parameters) <= 256);

    /// A mnemonic with room for the number of its entry behind it.
    [[nodiscard]] static constexpr std::uint64_t place_of(std::uint64_t key) noexcept { return key << 8U; }

    constexpr void insert(std::uint64_t what) noexcept
    {
        std::size_t at = size_++;
        for (; at > 0 and what < places_[at - 1]; --at) {
            places_[at] = places_[at - 1];
        }
        places_[at] = what;
    }

    // No std::array: Clang counts a step for each of its accesses, and takes a million at most.
    std::uint64_t places_[count_special_parameters()]{};
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

} // namespace altivar
} // namespace RTUWIRE_BUILD
} // namespace rtuwire
