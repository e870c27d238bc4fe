// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Lesson 10: who is it, and how is its line? Function 43/14 gives a device's name, function 08 its counters. Both are
// asked of a server in this program. Builds on lesson 2.
#include <iostream>
#include <string>

#include <rtuwire/client.hpp>
#include <rtuwire/print.hpp>
#include <rtuwire/server.hpp>
#include <rtuwire/sim.hpp>

using namespace rtuwire;

namespace {

// What the device says of itself: three objects at least, their numbers rising. 80 and above are the maker's own.
constexpr device_object objects[] = {
    {vendor_name, "Pumps & Sons"}, {product_code, "P-3"}, {major_minor_revision, "2.1"}, {0x80, "built on a Monday"}};
constexpr server_profile profile{.identity = identity_of<objects>};
constexpr unit_id device{5};

std::string as_text(byte_view bytes)
{
    std::string text;
    for (std::byte const each : bytes) {
        text += static_cast<char>(each);
    }
    return text;
}

/// One counter of the device, or nothing where it did not answer.
unsigned counter(auto& bench, subfunction which)
{
    single_request ask{device, diagnostics{which, register_block{0}}};
    auto const outcome = bench.run(ask);
    auto const response = outcome ? outcome->template to<diagnostics<>>() : outcome.error();
    return response ? response->data[0] : 0U;
}

} // namespace

int main()
{
    word_bank<4> registers;
    sim::bench bench{line_timing{19'200, character_format::even_8_1}, bank_at{device, registers, profile}};

    single_request who{device, read_device_identification{.access = identification_access::extended}};
    auto const outcome = bench.run(who);
    auto const page = outcome ? outcome->to<read_device_identification>() : outcome.error();
    if (not page) {
        std::cout << page.error() << '\n';
        return 1;
    }
    std::string all;
    for (auto at = page->first(); at; at = page->after(*at)) {
        std::cout << "object " << unsigned{at->id} << ": " << as_text(at->value) << '\n';
        all += as_text(at->value) + ';';
    }

    // A request that the device refuses shows in its counters: messages on the line, and exceptions.
    auto const refused = bench.run(single_request{device, read_holding_registers{.start = 99, .count = 1}});
    unsigned const messages = counter(bench, subfunction::bus_message_count);
    unsigned const exceptions = counter(bench, subfunction::bus_exception_error_count);
    unsigned const errors = counter(bench, subfunction::bus_communication_error_count);
    std::cout << "register 99: " << refused.error() << "\nthe device counts " << messages << " frames, " << exceptions
              << " exceptions, " << errors << " damaged frames\n";
    return all == "Pumps & Sons;P-3;2.1;built on a Monday;" and messages == 3 and exceptions == 1 and errors == 0 ? 0
                                                                                                                  : 1;
}
