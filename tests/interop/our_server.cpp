// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Our server for others' clients: unit 1 on the device named on the command line, until it is ended.
// Registers 100..199 hold their own address; it limits quantities as an ATV320 does.
#include "served_device.hpp"

using namespace rtuwire;

namespace {

// Too much for one page.
constexpr device_object objects[] = {{vendor_name, "rtuwire"},
                                     {product_code, "ATV310H037N4"},
                                     {major_minor_revision, "0201"},
                                     {3, "0123456789012345678901234567890123456789"
                                         "0123456789012345678901234567890123456789"
                                         "0123456789012345678901234567890123456789"},
                                     {4, "interoperability test"},
                                     {5, "0123456789012345678901234567890123456789"
                                         "0123456789012345678901234567890123456789"
                                         "0123456789012345678901234567890123456789"}};
constexpr server_profile profile{.limits = {63, 61, 20, 20}, .identity = identity_of<objects>};

} // namespace

int main(int argc, char** argv)
{
    word_bank<100> bank{100};
    for (std::uint16_t address = 100; address < 200; ++address) {
        static_cast<void>(bank.set(address, address));
    }
    // Short: the clients under test send nothing to other units between whose frames gaps would count.
    auto const line = line_timing::host(19'200, character_format::even_8_1);
    server node{unit_id{1}, line, profile};
    return test::serve_device(argc, argv, line, node, bank);
}
