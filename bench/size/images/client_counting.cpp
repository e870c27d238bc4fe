// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// The client that counts for its line.
#include "client.hpp"

#include <rtuwire/client/statistics.hpp>

int main()
{
    rtuwire::basic_client<rtuwire::observed_by<rtuwire::line_statistics>> link{timing};
    ask_on(link);
}
