// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// The client without counts.
#include "client.hpp"

int main()
{
    rtuwire::client link{timing};
    ask_on(link);
}
