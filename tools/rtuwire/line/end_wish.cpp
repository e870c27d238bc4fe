// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
#include "line/end_wish.hpp"

#include <atomic>

#include "../support/signals.hpp"

namespace tool {

namespace {

std::atomic<int> first_end{0};

} // namespace

void note_signals()
{
    note_first_end([](int number) { first_end = number; });
}

int noted_signal() { return first_end; }

} // namespace tool
