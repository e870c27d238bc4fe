// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// The first four of six procedures.
#define PROCEDURES 4
#include "procedures.hpp"
