// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Functions 03, 06, 16, 23 and 43/14, asked with constant frames by firmware that cuts the responses by silence.
#include "client_frames.hpp"

int main()
{
    ask_on([](unsigned number) { return known::requests[number]; });
}
