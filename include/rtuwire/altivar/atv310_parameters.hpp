// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// Public header: all parameters of the ATV310: typed access by `station<full_device>`, and rows to walk. It has all
// that altivar/atv310.hpp has, and the menu numbers.
#pragma once

#include <rtuwire/altivar/atv310.hpp>
#include <rtuwire/altivar/parameters/atv310.hpp>
