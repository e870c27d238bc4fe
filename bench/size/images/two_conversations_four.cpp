// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// The two conversations on a client that asks four functions, in frames of 64 bytes.
#define OF_FOUR_FUNCTIONS
#include "two_conversations.cpp"
