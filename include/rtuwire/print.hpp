// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// Public header: values, errors and outcomes on a host's streams: `std::cout << *speed << '\n'`. docs/names.md lists
// what is public. fmt's headers, where they are used, come before this one.
#pragma once

#include <rtuwire/port/show.hpp>
