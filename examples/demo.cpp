// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A client and a server exchange the manuals' examples over a pseudo-terminal, the server in a process
// of its own; each frame is shown with its meaning. With --port the client asks a real unit instead,
// and only reads: what the manuals write would start a motor.
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <optional>
#include <string>

#include <csignal>
#include <sys/wait.h>
#include <unistd.h>

#include <rtuwire/client/blocking.hpp>
#include <rtuwire/core/hex.hpp>
#include <rtuwire/port/posix_serial.hpp>
#include <rtuwire/port/pseudo_terminal.hpp>
#include <rtuwire/rtuwire.hpp>
#include <rtuwire/server/blocking.hpp>

using namespace rtuwire;

namespace {

struct options {
    std::string port{};
    unsigned long unit{2};
    serial_settings line{};
};

constexpr char usage[] = "usage: demo [--port DEVICE --unit 1..247 [--baud RATE] "
                         "[--format 8E1|8O1|8N1|8N2]]\n";

std::optional<character_format> format_named(char const* name)
{
    if (std::strcmp(name, "8E1") == 0) {
        return character_format::even_8_1;
    }
    if (std::strcmp(name, "8O1") == 0) {
        return character_format::odd_8_1;
    }
    if (std::strcmp(name, "8N1") == 0) {
        return character_format::none_8_1;
    }
    if (std::strcmp(name, "8N2") == 0) {
        return character_format::none_8_2;
    }
    return std::nullopt;
}

/// A whole decimal number, or nothing.
std::optional<unsigned long> number_in(char const* text)
{
    char* end = nullptr;
    unsigned long const value = std::strtoul(text, &end, 10);
    if (*text < '0' or *text > '9' or *end != '\0') {
        return std::nullopt;
    }
    return value;
}

std::optional<options> parse(int argc, char** argv)
{
    options chosen;
    for (int i = 1; i < argc; ++i) {
        std::string const flag = argv[i];
        if (i + 1 == argc) {
            return std::nullopt;
        }
        char const* const word = argv[++i];
        auto const number = number_in(word);
        if (flag == "--port") {
            chosen.port = word;
        } else if (flag == "--unit" and number) {
            chosen.unit = *number;
        } else if (flag == "--baud" and number) {
            chosen.line.bits_per_second = static_cast<std::uint32_t>(*number);
        } else if (flag == "--format" and format_named(word)) {
            chosen.line.format = *format_named(word);
        } else {
            return std::nullopt;
        }
    }
    return chosen;
}

/// A port that shows each frame that passes.
class talking_port {
public:
    explicit talking_port(posix_serial& port) : port_{port} {}

    static instant now() { return posix_serial::now(); }

    result<void> write(byte_view octets, instant until)
    {
        show("->", octets);
        return port_.write(octets, until);
    }

    result<void> drain() { return port_.drain(); }

    result<byte_span> read(byte_span place, instant until)
    {
        auto const octets = port_.read(place, until);
        if (octets and not octets->empty()) {
            show("<-", *octets);
        }
        return octets;
    }

private:
    static void show(char const* way, byte_view octets)
    {
        char text[3 * max_adu_size];
        auto const hex = to_hex(octets, text);
        std::printf("  %s %.*s\n", way, static_cast<int>(hex.size()), hex.data());
    }

    posix_serial& port_;
};

using client_line = blocking_client<talking_port>;

/// Says what came of a question; whether it is what was expected.
template <typename Answer>
bool report(result<Answer> const& answer, bool is_right, char const* meaning)
{
    if (answer) {
        std::printf("     %s%s\n\n", meaning, is_right ? "" : " -- NOT what was expected");
    } else {
        std::printf("     %s\n\n", std::string{name(answer.error())}.c_str());
    }
    return answer and is_right;
}

bool show_read(client_line& line, unit_id unit, bool is_simulated)
{
    std::puts("Read W3102..W3105 (function 03):");
    auto const answer = line.ask(unit, read_holding_registers{3102, 4});
    if (not answer) {
        return report(answer, false, "");
    }
    auto const words = answer->registers;
    char meaning[120];
    std::snprintf(meaning, sizeof meaning,
                  "SFR %u.%u kHz, TFR %u.%u Hz, HSP %u.%u Hz, LSP %u.%u Hz", words[0] / 10U,
                  words[0] % 10U, words[1] / 10U, words[1] % 10U, words[2] / 10U, words[2] % 10U,
                  words[3] / 10U, words[3] % 10U);
    bool const is_manual = words == register_block{40, 600, 500, 0}.view();
    return report(answer, is_manual or not is_simulated, meaning);
}

bool show_identification(client_line& line, unit_id unit, bool is_simulated)
{
    std::puts("Read device identification (function 43/14):");
    auto const page = line.ask(unit, read_device_identification{});
    if (not page) {
        bool const is_optional = not is_simulated and page == errc::illegal_function;
        return report(page, false, "") or is_optional;
    }
    std::string meaning;
    for (auto at = page->first(); at; at = page->after(*at)) {
        for (std::byte const octet : at->value) {
            meaning += static_cast<char>(to_u8(octet));
        }
        meaning += at->id < page->count - 1 ? ", " : "";
    }
    bool const is_manual = meaning == "Schneider Electric, ATV310H037N4, 0201";
    return report(page, is_manual or not is_simulated, meaning.c_str());
}

bool show_writes(client_line& line, unit_id unit)
{
    std::puts("Write W9001 (function 06):");
    auto const one = line.ask(unit, write_single_register{9001, 13});
    bool ok = report(one, one and one->value == 13, "ACC 1.3 s");
    std::puts("Write W9001, W9002 (function 16):");
    auto const two = line.ask(unit, write_multiple_registers{9001, register_block{20, 30}});
    ok = report(two, two and two->count == 2, "ACC 2.0 s, DEC 3.0 s") and ok;
    std::puts("Write W12761..W12763, then read W12741..W12743 (function 23):");
    auto const both = line.ask(
        unit, read_write_multiple_registers{12741, 3, 12761, register_block{0x000F, 1500, 0}});
    bool const is_manual = both and both->registers == register_block{0x0237, 1500, 0}.view();
    return report(both, is_manual, "ETA 0237 (operation enabled), RFRD 1500 rpm, ETI 0") and ok;
}

bool show_refusal(client_line& line, unit_id unit)
{
    std::puts("Read a register that does not exist:");
    auto const answer = line.ask(unit, read_holding_registers{1, 1});
    report(answer, false, "");
    return answer == errc::illegal_data_address;
}

/// The registers of the manuals' examples. What the scanner reads follows from what it was written.
class example_bank {
public:
    example_bank()
    {
        constexpr std::uint16_t settings[] = {40, 600, 500, 0};
        for (std::uint16_t i = 0; i < 4; ++i) {
            static_cast<void>(words_.set(static_cast<std::uint16_t>(3102 + i), settings[i]));
        }
    }

    errc check_read(std::uint16_t start, std::size_t count) const
    {
        return words_.check_read(start, count);
    }
    errc check_write(std::uint16_t start, register_view values) const
    {
        return words_.check_write(start, values);
    }
    errc read(std::uint16_t start, std::size_t count, byte_writer& out)
    {
        bool const runs = words_.get(12761) == 0x000F;
        static_cast<void>(words_.set(12741, runs ? 0x0237 : 0x0250));
        static_cast<void>(words_.set(12742, runs ? words_.get(12762) : std::uint16_t{0}));
        return words_.read(start, count, out);
    }
    errc write(std::uint16_t start, register_view values) { return words_.write(start, values); }

private:
    word_bank<10'000> words_{3000};
};

constexpr device_object objects[] = {{vendor_name, "Schneider Electric"},
                                     {product_code, "ATV310H037N4"},
                                     {major_minor_revision, "0201"}};
constexpr server_profile profile{.limits = {63, 61, 4, 4}, .identity = objects};

[[noreturn]] void serve(pseudo_terminal& line)
{
    server node{unit_id{2}, line_timing::host(19'200, character_format::even_8_1), profile};
    example_bank bank;
    while (serve_once(node, line, bank, milliseconds(100))) {
    }
    std::_Exit(1);
}

bool talk(posix_serial& device, options const& chosen, unit_id unit, bool is_simulated)
{
    talking_port port{device};
    auto const timing = line_timing::host(chosen.line.bits_per_second, chosen.line.format);
    client_line line{port, timing};
    bool ok = show_read(line, unit, is_simulated);
    if (is_simulated) {
        ok = show_writes(line, unit) and ok;
    }
    ok = show_identification(line, unit, is_simulated) and ok;
    if (is_simulated) {
        ok = show_refusal(line, unit) and ok;
    }
    std::puts(ok ? "Every answer was right." : "Not every answer was right.");
    return ok;
}

int run_on_device(options const& chosen, unit_id unit)
{
    posix_serial device;
    if (not device.open(chosen.port, chosen.line)) {
        std::fprintf(stderr, "%s\n", device.failure().c_str());
        return 1;
    }
    return talk(device, chosen, unit, false) ? 0 : 1;
}

int run_simulated(options const& chosen, unit_id unit)
{
    pseudo_terminal far_end;
    if (not far_end.open()) {
        std::fputs("no pseudo-terminal to be had\n", stderr);
        return 1;
    }
    std::fflush(stdout);
    pid_t const child = ::fork();
    if (child == 0) {
        serve(far_end);
    }
    posix_serial device;
    bool ok = false;
    if (device.open(far_end.path(), chosen.line)) {
        // The unit hears nothing before the line was silent for a while.
        ::usleep(150'000);
        std::printf("A client and unit 2 on %s:\n\n", device.device().c_str());
        ok = talk(device, chosen, unit, true);
    } else {
        std::fprintf(stderr, "%s\n", device.failure().c_str());
    }
    ::kill(child, SIGTERM);
    ::waitpid(child, nullptr, 0);
    return ok ? 0 : 1;
}

} // namespace

int main(int argc, char** argv)
{
    auto const chosen = parse(argc, argv);
    auto const unit = unit_id::checked(chosen ? static_cast<std::uint32_t>(chosen->unit) : 0);
    if (not chosen or not unit) {
        std::fputs(usage, stderr);
        return 2;
    }
    return chosen->port.empty() ? run_simulated(*chosen, unit_id{2})
                                : run_on_device(*chosen, *unit);
}
