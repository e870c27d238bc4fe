// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// The first of six procedures, a start.
#define PROCEDURES 1
#include "procedures.hpp"
