// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// Public header: devices of your own as rows: arrays of registers of any kind, each named by its mnemonic.
#pragma once

#include <rtuwire/table/row.hpp>
#include <rtuwire/table/row_table.hpp>
