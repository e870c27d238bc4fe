// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// Public header: the registers of the ATV12. What is done with them stands in altivar/procedure and altivar/cyclic.
#pragma once

// What refuses a mistake stands directly below this header, each header before those that include it: GCC prints a line
// for every header between the source and the one that refuses, and its sentence comes after them.
#include <rtuwire/core/quantity.hpp>
#include <rtuwire/core/units.hpp>
#include <rtuwire/table/table.hpp>
#include <rtuwire/wire/unit_id.hpp>

#include <rtuwire/table/device.hpp>
#include <rtuwire/table/setting.hpp>

#include <rtuwire/altivar/device/atv12.hpp>
