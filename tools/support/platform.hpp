// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// What systems do differently, as the programs of this repository use it. Both forms have the same functions; the comments
// on them stand in that of POSIX.
#pragma once

#ifdef _WIN32
#include "platform/win32.hpp"
#else
#include "platform/posix.hpp"
#endif
