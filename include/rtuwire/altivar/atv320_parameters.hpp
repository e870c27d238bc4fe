// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// Public header: all parameters of the ATV320: typed access by `station<full_device>`, and rows to walk. It has all
// that altivar/atv320.hpp has.
#pragma once

#include <rtuwire/altivar/atv320.hpp>
#include <rtuwire/altivar/parameters/atv320.hpp>
