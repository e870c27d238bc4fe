// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// All parameters of the drive that nobody makes, as somebody writes them down from its list (own_list.csv): by public
// names alone.
#pragma once

#include <rtuwire/altivar/own_parameters.hpp>

#include "altivar/device/sixth_drive.hpp"

namespace atv99 {

namespace rows {

using namespace roles;

// clang-format off
//! [values]
// Who may write them, and that the drive's own list says it.
inline constexpr row_access ro{access::read_only, provenance::documented};
inline constexpr row_access rw{access::read_write, provenance::documented};
inline constexpr row_access cfg{access::configuration, provenance::documented};

// When the fan runs.
inline constexpr choice fan_mode[]{{0, "Auto", "while the drive is warm"}, {1, "On", "always"}, {3, "Off", "never"}};
//! [values]

//! [rows]
// Words that command the drive and tell what it does.
inline constexpr parameter control[]{
    row_of(cmd, commands), row_of(lfr, setpoint), row_of(lfrd, setpoint), row_of(cmi, recalls),
    row_of(rfrd), row_of(eta), row_of(eti), row_of(rfr), row_of(lft),
};

// Everyday settings.
inline constexpr parameter settings[]{
    row_of(hsp, speed_limit),
    row_of(acc, ramp),
    row_of(dec, ramp),
    // SP2,1003,rw,uint16,Hz,0.1,0,400,10,
    {"SP2", 1003, rw,  in<decihertz>, 0, 4000, 100, "Preset speed 2", &speed},
    // SP3,1004,rw,uint16,Hz,0.1,0,400,15,
    {"SP3", 1004, rw,  in<decihertz>, 0, 4000, 150, "Preset speed 3", &speed},
    // FFM,1005,conf,enum,,,,,Auto,0=Auto;1=On;3=Off
    {"FFM", 1005, cfg, fan_mode, {}, {}, 0, "Fan operation"},
};

// What stands on the motor.
inline constexpr parameter nameplate[]{row_of(nsp, ordinary), row_of(frs, ordinary)};

// The line, and where the reference comes from.
inline constexpr parameter communication[]{
    row_of(add, this_line), row_of(tto, timeout), row_of(sll, link_loss), row_of(fr1, references),
};

// The scanner.
inline constexpr parameter scanner[]{
    row_of(in1, ordinary), row_of(in2, ordinary), row_of(in3, ordinary),
    row_of(out1, cyclic_words), row_of(out2, cyclic_words), row_of(out3, cyclic_words),
    row_of(iw1), row_of(iw2), row_of(iw3),
    row_of(ow1, passed_on), row_of(ow2, passed_on), row_of(ow3, passed_on),
};
//! [rows]
// clang-format on

} // namespace rows

//! [groups]
inline constexpr parameter_group menu[]{
    {"control", rows::control},     {"settings", rows::settings},
    {"nameplate", rows::nameplate}, {"communication", rows::communication},
    {"scanner", rows::scanner},
};

/// All parameters, as rows to walk.
inline constexpr parameter_map parameters{menu};

/// The drive with all of them, for typed access and for the simulation.
struct full_device : device {
    using registers = row_table<full_device, device::registers, parameters>;
};

/// Those without an object, by their mnemonics: `read<parameter<"SP2">>(drive)`.
template <mnemonic Code> inline constexpr auto const& parameter = parameter_called<full_device, Code>;
//! [groups]

static_assert(drive_check<full_device>::passed);

} // namespace atv99
