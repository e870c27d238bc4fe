// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A drive whose header is missing: the door to what is done with drives only declares them.
// EXPECT: this device is only declared here: include its header, <rtuwire/altivar/atv320.hpp> for an ATV320
#include <rtuwire/drives.hpp>
#ifndef REFUSED
#include <rtuwire/altivar/atv320.hpp>
#endif

inline constexpr rtuwire::station<rtuwire::altivar::atv320::device> drive{rtuwire::unit_id{7}};
