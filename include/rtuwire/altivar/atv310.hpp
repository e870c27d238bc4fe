// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// Public header: the registers of the ATV310, of 2014 and of 2026. What is done with them stands in altivar/procedure and altivar/cyclic.
#pragma once

// What refuses a mistake stands directly below this header: see altivar/atv12.hpp.
#include <rtuwire/core/quantity.hpp>
#include <rtuwire/core/units.hpp>
#include <rtuwire/table/table.hpp>
#include <rtuwire/wire/unit_id.hpp>

#include <rtuwire/table/device.hpp>
#include <rtuwire/table/setting.hpp>

#include <rtuwire/altivar/device/atv310.hpp>
