// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// What a write may do to a motor, against lists that were made by hand from the manuals and the manufacturer's files: a
// register that can be written while the motor runs is in one of them, or moves a motor that stands, too.
#include "motion/moving_registers.hpp"

#include <set>
#include <sstream>
#include <string>
#include <string_view>

#include "support/catch.hpp"

namespace {

struct drive_by_hand {
    std::string_view name;
    std::string_view moves; ///< sets the speed, the ramps, the stop or the regulation of a motor that runs
    std::string_view quiet; ///< can be written while the motor runs, which turns on as it did
};

constexpr drive_by_hand drives[]{
    {"atv12",
     "LSP HSP HSP2 HSP3 HSP4 TFR BFR SP2 SP3 SP4 SP5 SP6 SP7 SP8 JGF JPF LFF TLS SLE RIN ACC DEC AC2 DE2 RPT BRA STT "
     "DCF ADC SDC1 TDC1 RPI RP2 RP3 RP4 RPL RPH RPG RIG RDG PRP FBS PIC PIF PII PIM SFS RSL UPP FON FOF TON TOF RON "
     "ROF MDE FFD LFD NFD FLG STA SLP UFR PFL SPGU SFC CLI AI1T CRL1 CRH1",
     "ITH CTD FTD SFR FTU FTO LUL LOC LPI TPI SPN PET"},
    {"atv28",
     "LSP HSP TFR BFR SMIL SMAL SP2 SP3 SP4 SP5 SP6 SP7 JOG JPF TLS ACC DEC AC2 DE2 FRT SPAL SPAT SPDL SPDT BRA IDC "
     "TDC "
     "RPI RPG RIG FBS PIC FLG SLP UFR SDS CRL CRH LI3 LI4 AI2",
     "ITH CTD TTD FTD SFR OPL IPL STP DRN"},
    {"atv310", "LSP HSP TFR BFR ACC DEC AC2 DE2 STT", "ITH SFR"},
    {"atv310_2026", "LSP HSP TFR BFR ACC DEC AC2 DE2 STT", "ITH SFR"},
    {"atv320",
     "LSP HSP HSP2 HSP3 HSP4 TFR BFR SMIL SMAL SP2 SP3 SP4 SP5 SP6 SP7 SP8 SP9 SP10 SP11 SP12 SP13 SP14 SP15 SP16 JGF "
     "JGT JPF JF2 JF3 JFH LFF TLS SRP MFR STR RIN BSP SPFN SPFD INR ACC DEC AC2 DE2 FRT RPT TA1 TA2 TA3 TA4 BRA SPAL "
     "SPAT SPDL SPDT STT DOTD QSTD DCF FFT ADC TDC1 TDC2 TDC TDI STM TSM DSF STD SFD NLS "
     "RPI RP2 RP3 RP4 RPG RIG RDG PRP POL POH PIC PIF PIF1 PIF2 PII PIM PIP1 PIP2 PSR FPI RSL "
     "BEN BET BIP BIR BRR BRT BED BRH BST JDC TBE TTR LP1 LP2 CP1 CP2 COF COR HSO LBA LBC LBC1 LBC2 LBC3 LBF OSP SCL "
     "TOS "
     "RSTL DAS DBS DTF QSH QSL TBO TDN TRH TRL TUP SPG SIT SFC SPGU SLP UFR INTP "
     "AI1T AI2T AI3T AI1E AI1F AI1L AI1S AI2E AI2F AI2L AI2S AI3E AI3F AI3L AI3S AIC2 UIL1 UIH1 UIL2 UIH2 CRL3 CRH3 "
     "PIL PFR PFI",
     "ITH CTD TTD TTD2 TTD3 FTD F2D TTL TTH SRB THA SFR VBR FFM TBS ODT RMUD LUL LUN FQC STO "
     "PAN0 PAN1 PAN2 PAN3 PAN4 PAN5 PAN6 PAN7"},
};

std::set<std::string> words_of(std::string_view text)
{
    std::istringstream in{std::string{text}};
    std::set<std::string> found;
    for (std::string word; in >> word;) {
        found.insert(word);
    }
    return found;
}

tool::drive_catalog const& catalog(std::string_view name)
{
    tool::drive_catalog const* const found = tool::catalog_named(name);
    REQUIRE(found != nullptr);
    return *found;
}

/// Whether a write of it needs --allow-run whatever the motor does, or is never made.
bool is_always_guarded(tool::register_entry const& entry, tool::drive_catalog const& drive)
{
    return tool::commands_a_motor(entry.address, drive) or not tool::why_it_may_move(entry).empty();
}

/// Orders that save and count.
bool is_quiet_order(tool::register_entry const& entry)
{
    std::set<std::string> const all = words_of("CMI SCS FCS RPR");
    return all.count(std::string{entry.code}) != 0;
}

} // namespace

TEST_CASE("defect: D22 what sets the speed or the ramp of a motor that runs needs --allow-run, on each drive")
{
    REQUIRE(std::size(drives) == tool::all_catalogs().size());
    for (drive_by_hand const& by_hand : drives) {
        tool::drive_catalog const& drive = catalog(by_hand.name);
        for (std::string const& code : words_of(by_hand.moves)) {
            INFO(by_hand.name << ' ' << code);
            tool::register_entry const* const entry = drive.by_code(code);
            REQUIRE((entry != nullptr and entry->is_writable()));
            CHECK((is_always_guarded(*entry, drive) or not tool::why_it_runs_otherwise(*entry).empty()));
        }
    }
}

TEST_CASE("defect: D22 each register that can be written while the motor runs was judged")
{
    for (drive_by_hand const& by_hand : drives) {
        tool::drive_catalog const& drive = catalog(by_hand.name);
        std::set<std::string> const moves = words_of(by_hand.moves);
        std::set<std::string> const quiet = words_of(by_hand.quiet);
        for (tool::register_entry const& entry : drive.registers) {
            std::string const code{entry.code};
            INFO(by_hand.name << ' ' << code);
            if (entry.mode == rtuwire::access::read_write) {
                CHECK((moves.count(code) != 0 or quiet.count(code) != 0 or is_always_guarded(entry, drive) or
                       is_quiet_order(entry)));
            }
            // Nobody is asked for --allow-run without need, nor told two reasons.
            bool const is_told = not tool::why_it_runs_otherwise(entry).empty();
            CHECK((not is_told or (moves.count(code) != 0 and not is_always_guarded(entry, drive))));
            CHECK((not is_told or entry.is_writable()));
        }
    }
}
