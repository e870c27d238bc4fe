// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// The same, encoded when they are asked.
#include "client_frames.hpp"

int main()
{
    std::array<std::byte, 32> asked;
    ask_on([&asked](unsigned number) { return request(asked, number); });
}
