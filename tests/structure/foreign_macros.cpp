// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// All portable headers, behind macros of others. With -DCLASH=NAME it has one of their names, and must not compile.
#include "foreign_macros.hpp"

#ifdef CLASH
constexpr int CLASH(int);
#else
#include <rtuwire/rtuwire.hpp>
#endif
