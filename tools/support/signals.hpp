// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Everything that would end or suspend a program by itself: noted, so that the motor can be stopped first. The comments on the
// functions stand in the form of POSIX.
#pragma once

#include <atomic>

namespace tool {

/// What signals have said since the program began. What is lock-free may be set in their handlers; on Windows these are
/// threads.
struct signal_notes {
    std::atomic<int> end{0};        ///< the last one that asks for an end, 0 for none
    std::atomic<int> interrupts{0}; ///< how often somebody pressed Ctrl-C
    std::atomic<int> suspend{0};    ///< somebody pressed Ctrl-Z
    std::atomic<int> resumed{0};    ///< the program was suspended, however, and goes on
};
static_assert(std::atomic<int>::is_always_lock_free);

inline signal_notes noted;

} // namespace tool

#ifdef _WIN32
#include "platform/win32_signals.hpp"
#else
#include "platform/posix_signals.hpp"
#endif
