// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Prints the script for Wireshark: wireshark_lua > rtuwire.lua
#include <iostream>

#include "lua_script.hpp"

int main()
{
    wireshark::write_lua_script(std::cout);
    return std::cout.flush() ? 0 : 1;
}
