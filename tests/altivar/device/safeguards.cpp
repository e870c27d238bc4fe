// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Where each drive tells of its time-out, its channels and its restart: the addresses of the published parameter
// files and of the ATV28's bulletin, and no others. And the rule for periods.
#include "support/proof.hpp"

#include <array>

#include <rtuwire/altivar/atv12.hpp>
#include <rtuwire/altivar/atv28.hpp>
#include <rtuwire/altivar/atv310.hpp>
#include <rtuwire/altivar/atv320.hpp>
#include <rtuwire/altivar/procedure/inspection/supervision_report.hpp>

using namespace rtuwire;
using namespace rtuwire::altivar;

namespace {

/// A register of a drive, as its file has it; 0 where it lists none.
struct published {
    literal code;
    std::uint16_t address;
};
using row = std::array<published, 10>;

// SLL, TTO, CHCF, CD1, FR1, FLO, ATR, DOTD, logic inputs, TCC.
constexpr row atv12_file{{{"SLL", 7010},
                          {"TTO", 6005},
                          {"CHCF", 8401},
                          {"CD1", 8423},
                          {"FR1", 8413},
                          {"FLO", 8431},
                          {"ATR", 0},
                          {"DOTD", 0},
                          {"IL1I", 5201},
                          {"TCC", 11101}}};
constexpr row atv310_file{{{"SLL", 7010},
                           {"TTO", 6005},
                           {"CHCF", 8401},
                           {"CD1", 8423},
                           {"FR1", 8413},
                           {"FLO", 8431},
                           {"ATR", 0},
                           {"DOTD", 0},
                           {"IL1I", 0},
                           {"TCC", 0}}};
constexpr row atv320_file{{{"SLL", 7010},
                           {"TTO", 6005},
                           {"CHCF", 8401},
                           {"CD1", 8423},
                           {"FR1", 8413},
                           {"FLO", 8431},
                           {"ATR", 7122},
                           {"DOTD", 8652},
                           {"IL1R", 5202},
                           {"TCC", 11101}}};
constexpr row atv28_file{{{"SLL", 0},
                          {"TTO", 0},
                          {"CHCF", 0},
                          {"CD1", 0},
                          {"FR1", 0},
                          {"FLO", 0},
                          {"ATR", 150},
                          {"DOTD", 0},
                          {"IOLR", 478},
                          {"TCC", 6}}};

/// Whether the profile has these addresses, and the device's table those that are there, by the same name.
template <typename Device> constexpr bool agrees(row const& file)
{
    safeguard_layout const& at = Device::layout.safeguards;
    std::array const told{at.sll, at.tto, at.chcf, at.cd1, at.fr1, at.flo, at.atr, at.dotd, at.inputs, at.tcc};
    bool ok = true;
    for (std::size_t i = 0; i < file.size(); ++i) {
        bool is_there = false;
        Device::registers::for_each([&]<auto const & R>() {
            is_there = is_there or (R.code == file[i].code and R.address == file[i].address);
        });
        ok = ok and told[i] == file[i].address and is_there == (file[i].address != 0);
    }
    return ok;
}
STATIC_CHECK(agrees<atv12::device>(atv12_file));
STATIC_CHECK(agrees<atv310::device>(atv310_file));
STATIC_CHECK(agrees<atv310::device_2026>(atv310_file));
STATIC_CHECK(agrees<atv320::device>(atv320_file));
STATIC_CHECK(agrees<atv28::device>(atv28_file));

// Only the ATV28: a fixed time-out, NTO in bit 14 of CMI, terminals in command at power-up.
constexpr safeguard_layout old = atv28::device::layout.safeguards;
STATIC_CHECK(old.nto == 1U << 14U and old.fixed_timeout == milliseconds(7'000));
STATIC_CHECK(old.fixed_timeout == atv28::device::silence.factory);
STATIC_CHECK(old.is_local_at_power_up);
constexpr safeguard_layout later = atv320::device::layout.safeguards;
STATIC_CHECK(later.nto == 0 and later.fixed_timeout == duration{} and not later.is_local_at_power_up);

// Three gaps in a time-out, to the microsecond.
constexpr period_rule rule_of(std::uint32_t timeout, std::uint32_t gap) { return {duration{timeout}, duration{gap}}; }
STATIC_CHECK(rule_of(3'000, 1'000).holds() and not rule_of(2'999, 1'000).holds());
STATIC_CHECK(rule_of(0, 1'000).holds() and rule_of(100, 0).holds());
STATIC_CHECK(not rule_of(30'000'000, 0xFFFF'FFFFU).holds());
STATIC_CHECK(rule_of(7'000'000, 1'000).longest_period() == duration{2'333'333});
STATIC_CHECK(longest_gap_of(30, milliseconds(20), milliseconds(1'000)) == milliseconds(1'600));

} // namespace
