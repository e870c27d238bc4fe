// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Either end of a line over a pseudo-terminal, for so many transactions: `line serve COUNT` names its device on standard
// output and answers, `line serve COUNT MS` so many milliseconds late; `line ask COUNT DEVICE` asks, and
// `line ask COUNT DEVICE wait` lets `read` wait for the response.
#include <cstdio>
#include <cstdlib>
#include <string_view>

#include <unistd.h>

#include <rtuwire/port/posix_serial.hpp>
#include <rtuwire/port/pseudo_terminal.hpp>
#include <rtuwire/rtuwire.hpp>

using namespace rtuwire;

namespace {

constexpr std::uint32_t bits_per_second = 115'200;
constexpr line_timing timing = line_timing::host(bits_per_second, character_format::even_8_1);

/// A bank that knows how often it was read, and takes its time.
struct counted_bank : word_bank<16> {
    errc read(std::uint16_t start, std::size_t count, byte_writer& out) noexcept
    {
        ++reads;
        if (milliseconds_late > 0) {
            ::usleep(1'000 * milliseconds_late);
        }
        return word_bank<16>::read(start, count, out);
    }
    unsigned long reads{0};
    unsigned milliseconds_late{0};
};

int serve(unsigned long count, unsigned milliseconds_late)
{
    pseudo_terminal port;
    if (not port.open()) {
        return 1;
    }
    std::puts(port.path().c_str());
    std::fflush(stdout);
    server node{unit_id{1}, timing};
    counted_bank bank;
    bank.milliseconds_late = milliseconds_late;
    result<void> served;
    while (served and (bank.reads < count or node.poll_deadline())) {
        served = serve_once(node, port, bank, milliseconds(1'000));
    }
    // The last response is gone with the port, unless it was read.
    served = served ? serve_once(node, port, bank, milliseconds(300)) : served;
    return served ? 0 : 1;
}

int ask(unsigned long count, char const* device, bool waits_in_read)
{
    posix_serial port;
    if (not port.open(device, {.bits_per_second = bits_per_second, .waits_in_read = waits_in_read})) {
        std::fputs(port.failure().c_str(), stderr);
        return 1;
    }
    blocking_client line{port, timing};
    for (; count > 0; --count) {
        auto const response = line.ask(unit_id{1}, read_holding_registers{.start = 0, .count = 4});
        if (not response) {
            std::fprintf(stderr, "line: %s, %lu to go\n", name(response.error()).data(), count);
            return 1;
        }
    }
    return 0;
}

} // namespace

int main(int words, char** word)
{
    std::string_view const end = words > 2 ? word[1] : "";
    if (end == "serve") {
        unsigned long const late = words > 3 ? std::strtoul(word[3], nullptr, 10) : 0;
        return serve(std::strtoul(word[2], nullptr, 10), static_cast<unsigned>(late));
    }
    return end == "ask" and words > 3 ? ask(std::strtoul(word[2], nullptr, 10), word[3], words > 4) : 2;
}
