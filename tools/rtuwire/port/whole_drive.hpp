// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Which device is simulated for a drive: the one with all its parameters, where the library knows them.
#pragma once

#include <concepts>
#include <rtuwire/altivar/all.hpp>

#include <rtuwire/altivar/atv12_parameters.hpp>
#include <rtuwire/altivar/atv310_parameters.hpp>
#include <rtuwire/altivar/atv320_parameters.hpp>

namespace tool {

/// Of an ATV28 the library knows the registers for driving, and no others.
template <typename Drive> struct whole_drive {
    using type = Drive;
};
template <> struct whole_drive<rtuwire::altivar::atv12::device> {
    using type = rtuwire::altivar::atv12::full_device;
};
template <> struct whole_drive<rtuwire::altivar::atv310::device> {
    using type = rtuwire::altivar::atv310::full_device_2014;
};
template <> struct whole_drive<rtuwire::altivar::atv310::device_2026> {
    using type = rtuwire::altivar::atv310::full_device;
};
template <> struct whole_drive<rtuwire::altivar::atv320::device> {
    using type = rtuwire::altivar::atv320::full_device;
};

/// Whether the library knows all parameters of a drive.
template <typename Drive>
concept has_all_parameters = not std::same_as<typename whole_drive<Drive>::type, Drive>;

} // namespace tool
