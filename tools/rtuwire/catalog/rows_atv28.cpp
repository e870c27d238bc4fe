// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
#include "catalog/rows_atv28.hpp"

#include <rtuwire/altivar/atv28.hpp>
#include <rtuwire/altivar/own_parameters.hpp>

namespace tool {

namespace {

namespace atv28 = rtuwire::altivar::atv28;
namespace as = rtuwire::altivar::roles;
using rtuwire::altivar::parameter;
using rtuwire::altivar::parameter_group;
using rtuwire::altivar::row_of;

// clang-format off
/// What commands it.
constexpr parameter commanding[]{
    row_of(atv28::cmd, as::commands), row_of(atv28::cmi, as::recalls),
};

/// What is set.
constexpr parameter set[]{
    row_of(atv28::cod, as::ordinary), row_of(atv28::crl, as::scaling), row_of(atv28::crh, as::scaling),
    row_of(atv28::tcc, as::wiring), row_of(atv28::add, as::this_line), row_of(atv28::bdr, as::other_bus),
    row_of(atv28::bfr, as::speed_range), row_of(atv28::sds, as::scaling), row_of(atv28::aot, as::ordinary),
    row_of(atv28::sfr, as::ordinary), row_of(atv28::tfr, as::speed_limit), row_of(atv28::frs, as::ordinary),
    row_of(atv28::uns, as::ordinary), row_of(atv28::tun, as::autotuning), row_of(atv28::nrd, as::ordinary),
    row_of(atv28::uft, as::ordinary), row_of(atv28::bra, as::ramp), row_of(atv28::frt, as::ramp),
    row_of(atv28::li3, as::input_use), row_of(atv28::li4, as::input_use), row_of(atv28::ai2, as::input_use),
    row_of(atv28::r2, as::relay), row_of(atv28::ao, as::ordinary), row_of(atv28::atr, as::restarts),
    row_of(atv28::opl, as::reaction), row_of(atv28::ipl, as::reaction), row_of(atv28::flr, as::catching),
    row_of(atv28::stp, as::reaction), row_of(atv28::drn, as::ordinary), row_of(atv28::hsp, as::speed_limit),
    row_of(atv28::lsp, as::speed_limit), row_of(atv28::acc, as::ramp), row_of(atv28::dec, as::ramp),
    row_of(atv28::ufr, as::tuning), row_of(atv28::flg, as::tuning), row_of(atv28::ith, as::ordinary),
    row_of(atv28::slp, as::tuning), row_of(atv28::ac2, as::ramp), row_of(atv28::de2, as::ramp),
    row_of(atv28::jog, as::moves), row_of(atv28::sp2, as::speed), row_of(atv28::sp3, as::speed),
    row_of(atv28::sp4, as::speed), row_of(atv28::sp5, as::speed), row_of(atv28::sp6, as::speed),
    row_of(atv28::sp7, as::speed), row_of(atv28::idc, as::stopping), row_of(atv28::tdc, as::stopping),
    row_of(atv28::tls, as::skipped), row_of(atv28::rpg, as::regulation), row_of(atv28::rig, as::regulation),
    row_of(atv28::fbs, as::regulation), row_of(atv28::ctd, as::ordinary), row_of(atv28::ttd, as::ordinary),
    row_of(atv28::ftd, as::ordinary), row_of(atv28::jpf, as::skipped), row_of(atv28::pic, as::regulation),
    row_of(atv28::lfr, as::setpoint), row_of(atv28::rpi, as::regulation),
    row_of(atv28::iolr, as::sets_output), row_of(atv28::aor, as::sets_output),
    row_of(atv28::cmdd, as::commands), row_of(atv28::lfrd, as::setpoint),
    row_of(atv28::smil, as::another_form), row_of(atv28::smal, as::another_form),
    row_of(atv28::spal, as::another_form), row_of(atv28::spat, as::another_form),
    row_of(atv28::spdl, as::another_form), row_of(atv28::spdt, as::another_form),
};

/// What it shows.
constexpr parameter shown[]{
    row_of(atv28::li1), row_of(atv28::li2), row_of(atv28::rot), row_of(atv28::frh), row_of(atv28::rfr),
    row_of(atv28::spd), row_of(atv28::lcr), row_of(atv28::uln), row_of(atv28::thr), row_of(atv28::thd),
    row_of(atv28::lft), row_of(atv28::eta), row_of(atv28::eti), row_of(atv28::eti2), row_of(atv28::eti3),
    row_of(atv28::dp1), row_of(atv28::dp2), row_of(atv28::dp3), row_of(atv28::dp4), row_of(atv28::ai1r),
    row_of(atv28::ai2r), row_of(atv28::df1), row_of(atv28::df2), row_of(atv28::olo), row_of(atv28::opr),
    row_of(atv28::tim), row_of(atv28::cpu), row_of(atv28::ncv), row_of(atv28::vcal), row_of(atv28::inv),
    row_of(atv28::errd), row_of(atv28::etad), row_of(atv28::frhd), row_of(atv28::rfrd), row_of(atv28::smih),
    row_of(atv28::smah), row_of(atv28::spah), row_of(atv28::spdh),
};
// clang-format on

} // namespace

std::span<rtuwire::altivar::parameter_group const> rows_of_atv28() noexcept
{
    static constexpr parameter_group groups[]{{"command", commanding}, {"settings", set}, {"monitoring", shown}};
    return groups;
}

} // namespace tool
