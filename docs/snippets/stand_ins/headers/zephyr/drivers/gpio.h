// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// The stand-in for Zephyr's pins by this name, so that the page's program compiles as it stands.
#pragma once

#include "../../../zephyr.hpp"
