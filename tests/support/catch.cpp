// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// What the precompiled header belongs to.
#include "support/catch.hpp"
