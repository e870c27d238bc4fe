// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// Public header: the registers of all drives, for what goes through `altivar::all_drives`.
#pragma once

#include <rtuwire/altivar/all_drives.hpp>
#include <rtuwire/altivar/atv12.hpp>
#include <rtuwire/altivar/atv28.hpp>
#include <rtuwire/altivar/atv310.hpp>
#include <rtuwire/altivar/atv320.hpp>
