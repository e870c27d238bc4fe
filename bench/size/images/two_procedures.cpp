// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// The first two of six procedures.
#define PROCEDURES 2
#include "procedures.hpp"
