// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// Public header: all parameters of the ATV12: typed access by `station<full_device>`, and rows to walk. It has all that
// altivar/atv12.hpp has.
#pragma once

#include <rtuwire/altivar/atv12.hpp>
#include <rtuwire/altivar/parameters/atv12.hpp>
