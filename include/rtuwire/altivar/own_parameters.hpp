// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// Public header: lists of all parameters for a drive of one's own: groups of registers, the rows that a program walks,
// and a device with all of them.
#pragma once

#include <rtuwire/altivar/parameters/family_words.hpp>
#include <rtuwire/altivar/parameters/parameter_map.hpp>
#include <rtuwire/altivar/parameters/row_table.hpp>
