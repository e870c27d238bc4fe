// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Six procedures.
#define PROCEDURES 6
#include "procedures.hpp"
