// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// The ports of a host as a program of Windows has them, for lines.py: says on its output what came of each.
//
//     line_program ask WHERE COUNT         reads register 100 + i of unit 1 so many times: "100 of 100"
//     line_program read WHERE MS           "nothing", the bytes, or the error
//     line_program write WHERE COUNT MS    "sent", or the error
//     line_program pulled WHERE            "open"; behind a line on its input, what a read of a minute says, and whether it is open
//     line_program silence WHERE RATE      the silence before a request, in microseconds
//     line_program serve WHERE             "ready", and answers as unit 1: registers 100..199 hold their own address
//
// WHERE is COM9, tcp:HOST:PORT or mbap:HOST:PORT; at mbap, serve listens. A port that does not open: status 2, and its words.
#include <array>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

#include <rtuwire/client/blocking.hpp>
#include <rtuwire/port.hpp>
#include <rtuwire/server.hpp>
#include <rtuwire/server/blocking.hpp>
#include <rtuwire/wire/errc_name.hpp>
#include <rtuwire/wire/registers.hpp>

using namespace rtuwire;

namespace {

void say(std::string const& line)
{
    std::puts(line.c_str());
    std::fflush(stdout);
}

std::uint32_t number_in(char const* text) { return static_cast<std::uint32_t>(std::strtoul(text, nullptr, 10)); }

std::string error_text(errc error, std::string const& why) { return std::string{name(error)} + " | " + why; }

/// What was read, or why not.
template <typename Port> std::string text_of_read(Port& port, std::uint32_t limit)
{
    std::array<std::byte, 256> place{};
    auto const bytes = port.read(place, port.now() + milliseconds(limit));
    if (not bytes) {
        return error_text(bytes.error(), port.failure());
    }
    std::string text;
    for (std::byte const each : *bytes) {
        std::array<char, 4> digits{};
        std::snprintf(digits.data(), digits.size(), "%02X ", static_cast<unsigned>(each));
        text += digits.data();
    }
    return text.empty() ? "nothing" : text;
}

template <typename Port> int ask(Port& port, line_timing const& timing, std::uint32_t count)
{
    blocking_client line{port, timing, {.response_timeout = milliseconds(2'000), .retries = 0}};
    std::uint32_t right = 0;
    for (std::uint32_t i = 0; i < count; ++i) {
        auto const address = static_cast<std::uint16_t>(100 + i % 100);
        auto const answer = line.ask(unit_id{1}, read_holding_registers{address, 1});
        right += answer and answer->registers[0] == address ? 1U : 0U;
        if (not answer) {
            say(error_text(answer.error(), port.failure()));
        }
    }
    say(std::to_string(right) + " of " + std::to_string(count));
    return 0;
}

template <typename Port> int serve(Port& port, line_timing const& timing)
{
    word_bank<100> bank{100};
    for (std::uint16_t address = 100; address < 200; ++address) {
        static_cast<void>(bank.set(address, address));
    }
    constexpr server_profile profile{.limits = {63, 61, 20, 20}};
    server node{unit_id{1}, timing, profile};
    instant const silent = port.now() + timing.frame_end() + milliseconds(10);
    while (not reached(port.now(), silent)) { // nothing is heard before the line was silent once
        static_cast<void>(serve_once(node, port, bank, milliseconds(10)));
    }
    say("ready");
    while (serve_once(node, port, bank, milliseconds(200))) {
    }
    say(port.failure());
    return 1;
}

template <typename Port> int write_so_many(Port& port, std::uint32_t count, std::uint32_t limit)
{
    std::vector<std::byte> const bytes(count, std::byte{0x55});
    auto const written = port.write(bytes, port.now() + milliseconds(limit));
    say(written ? "sent" : error_text(written.error(), port.failure()));
    return 0;
}

template <typename Port> int pulled(Port& port)
{
    say(port.is_open() ? "open" : "closed");
    static_cast<void>(std::getchar());
    say(text_of_read(port, 60'000));
    say(port.is_open() ? "open" : "closed");
    return 0;
}

/// What all ports can do.
template <typename Port> int done(Port& port, line_timing const& timing, std::vector<std::string> const& words)
{
    std::uint32_t const number = words.size() > 2 ? number_in(words[2].c_str()) : 0;
    if (words[0] == "ask") {
        return ask(port, timing, number);
    }
    if (words[0] == "read") {
        say(text_of_read(port, number));
        return 0;
    }
    if (words[0] == "write") {
        return write_so_many(port, number, number_in(words.at(3).c_str()));
    }
    if (words[0] == "pulled") {
        return pulled(port);
    }
    return 2;
}

template <typename Port> int not_open(Port const& port)
{
    std::fprintf(stderr, "%s\n", port.failure().c_str());
    return 2;
}

/// HOST:PORT behind a word.
struct address {
    std::string host;
    std::uint16_t port;
};
address address_in(std::string const& where)
{
    std::size_t const first = where.find(':');
    std::size_t const last = where.rfind(':');
    return {where.substr(first + 1, last - first - 1), static_cast<std::uint16_t>(number_in(&where[last + 1]))};
}

} // namespace

int main(int argc, char** argv)
{
    std::vector<std::string> const words(argv + 1, argv + argc);
    std::string const where = words.at(1);
    if (where.starts_with("tcp:")) {
        tcp_stream port;
        return port.open(address_in(where).host, address_in(where).port)
                   ? done(port, line_timing::without_wire(), words)
                   : not_open(port);
    }
    if (where.starts_with("mbap:") and words[0] == "serve") {
        mbap_listener port;
        return port.open(address_in(where).host, address_in(where).port, {1})
                   ? serve(port, line_timing::without_wire(milliseconds(1)))
                   : not_open(port);
    }
    if (where.starts_with("mbap:")) {
        mbap_stream port;
        return port.open(address_in(where).host, address_in(where).port) ? done(port, port.timing(), words)
                                                                         : not_open(port);
    }
    // A pseudo-terminal has no parity, and Wine says so.
    serial_settings settings{.format = character_format::none_8_1};
    if (words[0] == "silence") {
        settings.bits_per_second = number_in(words.at(2).c_str());
    }
    host_serial port;
    if (not port.open(where, settings)) {
        return not_open(port);
    }
    if (words[0] == "silence") {
        say(std::to_string(port.timing().silence().microseconds));
        return 0;
    }
    return words[0] == "serve" ? serve(port, port.timing()) : done(port, port.timing(), words);
}
