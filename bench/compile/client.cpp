// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// The engine alone: what a program costs to compile before it knows any drive.
#include <rtuwire/client/client.hpp>

void run(rtuwire::client& link, rtuwire::instant now) { link.advance(now); }
