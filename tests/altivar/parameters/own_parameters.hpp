// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// All parameters of the drive that nobody makes, as somebody writes them down from its list (own_list.csv): by public
// names alone.
#pragma once

#include <array>

#include <rtuwire/altivar/own_parameters.hpp>

#include "altivar/device/sixth_drive.hpp"

//! [values]
namespace atv99 {

/// When the fan runs.
enum class fan_mode : std::uint16_t { automatic = 0, always = 1, never = 3 };

} // namespace atv99

template <>
inline constexpr std::array<rtuwire::named_value, 3> rtuwire::enumerators<atv99::fan_mode>{
    {{0, "Auto"}, {1, "On"}, {3, "Off"}}};
template <>
inline constexpr std::array<rtuwire::named_value, 3> rtuwire::meanings<atv99::fan_mode>{
    {{0, "while the drive is warm"}, {1, "always"}, {3, "never"}}};
//! [values]

namespace atv99 {

// clang-format off
//! [rows]
// code,address,access,type,unit,scale,min,max,default,values
// SP2,1003,rw,uint16,Hz,0.1,0,400,10,
inline constexpr reg<decihertz> sp2{.code = "SP2", .address = 1'003, .min = {0}, .max = {4000}, .factory = 100, .name = "Preset speed 2"};
// SP3,1004,rw,uint16,Hz,0.1,0,400,15,
inline constexpr reg<decihertz> sp3{.code = "SP3", .address = 1'004, .min = {0}, .max = {4000}, .factory = 150, .name = "Preset speed 3"};
// FFM,1005,conf,enum,,,,,Auto,0=Auto;1=On;3=Off
inline constexpr reg<fan_mode> ffm{.code = "FFM", .address = 1'005, .mode = access::configuration, .factory = 0, .name = "Fan operation"};
//! [rows]
// clang-format on

//! [groups]
namespace groups {

/// Words that command the drive and tell what it does.
struct control : parameter_list<cmd, lfr, lfrd, cmi, rfrd, eta, eti, rfr, lft> {};

/// Everyday settings.
struct settings : parameter_list<hsp, acc, dec, sp2, sp3, ffm> {};

/// What stands on the motor.
struct nameplate : parameter_list<nsp, frs> {};

/// The line, and where the reference comes from.
struct communication : parameter_list<add, tto, sll, fr1> {};

/// The scanner.
struct scanner : parameter_list<in1, in2, in3, out1, out2, out3, iw1, iw2, iw3, ow1, ow2, ow3> {};

} // namespace groups

inline constexpr parameter_group menu[]{
    group_of<groups::control>("control"),     group_of<groups::settings>("settings"),
    group_of<groups::nameplate>("nameplate"), group_of<groups::communication>("communication"),
    group_of<groups::scanner>("scanner"),
};

/// All parameters, as rows to walk.
inline constexpr parameter_map parameters{menu};

/// The drive with all of them, for typed access and for the simulation.
struct full_device : device {
    using registers =
        grouped_table<groups::control, groups::settings, groups::nameplate, groups::communication, groups::scanner>;
};
//! [groups]

static_assert(drive_check<full_device>::passed);

} // namespace atv99
