// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
#include "port/port_word.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <fstream>
#include <utility>

#include <sys/stat.h>

#include "../support/platform.hpp"
#include "port/simulated_words.hpp"
#include "port/usage_error.hpp"

namespace tool {

namespace {

std::string forms()
{
    return std::string{"a port is "} + example_port +
           ", tcp://host:4001, mbap://host, sim:atv320:7,atv12:3, sim:meter.toml:61 or a capture file";
}

/// What a word means; or what is wrong with it, and what may have been meant.
struct meaning {
    std::optional<port_description> port{};
    std::string why{};
    std::string nearest{};
};

meaning found(port_description port) { return {std::move(port)}; }

meaning wrong(std::string why, std::string nearest = {}) { return {std::nullopt, std::move(why), std::move(nearest)}; }

bool starts_with_word(std::string_view word, std::string_view start)
{
    return is_same_word(word.substr(0, start.size()), start);
}

/// Where the port of "host:4001" or "[::1]:4001" begins; behind the end where there is none.
std::size_t colon_of(std::string_view place) noexcept
{
    if (not place.empty() and place.front() == '[') {
        std::size_t const end = place.find(']');
        return end != place.npos and end + 1 < place.size() and place[end + 1] == ':' ? end + 1 : place.npos;
    }
    return place.rfind(':');
}

bool is_ipv4(std::string const& host)
{
    in_addr place{};
    return ::inet_pton(AF_INET, host.c_str(), &place) == 1;
}

/// "::1", "fe80::1%eth0".
bool is_ipv6(std::string_view host)
{
    in6_addr place{};
    return ::inet_pton(AF_INET6, std::string{host.substr(0, host.find('%'))}.c_str(), &place) == 1;
}

/// 224.0.0.1, ff02::1 or 255.255.255.255: many machines at once. A system lets somebody listen there, to whom nobody can connect.
bool is_group(std::string_view host)
{
    in_addr four{};
    in6_addr six{};
    std::string const number{host.substr(0, host.find('%'))};
    bool const is_four = ::inet_pton(AF_INET, number.c_str(), &four) == 1;
    bool const is_six = ::inet_pton(AF_INET6, number.c_str(), &six) == 1;
    return is_four ? ntohl(four.s_addr) >> 24U >= 224U : is_six and six.s6_addr[0] == 0xFFU;
}

std::string host_in(std::string_view host)
{
    bool const has_brackets = host.size() >= 2 and host.front() == '[' and host.back() == ']';
    return std::string{has_brackets ? host.substr(1, host.size() - 2) : host};
}

/// How an address begins, and what holds of it.
struct address_form {
    std::string_view start;             ///< "tcp://"
    std::string_view example;           ///< a whole one
    std::string_view likely;            ///< the port that a word without one may mean
    std::optional<std::uint32_t> usual; ///< or the port that it has then
    bool is_here{false};                ///< somebody listens there: port 0 is any that is free
};

constexpr address_form tcp_server{"tcp://", "tcp://host:4001", ":4001", std::nullopt};
constexpr address_form mbap_server{"mbap://", "mbap://host", "", mbap_address::usual_port};
constexpr address_form tcp_here{"tcp://", "tcp://127.0.0.1:4001", ":4001", std::nullopt, true};
constexpr address_form mbap_here{"mbap://", "mbap://127.0.0.1:1502", ":1502", std::nullopt, true};

/// A host and its port; or what is wrong with them.
meaning read_host(std::string_view place, address_form const& form)
{
    std::string const start{form.start};
    std::string const likely{form.likely};
    unsigned const least = form.is_here ? 0 : 1;
    if (place.find('/') != place.npos) {
        return wrong("nothing stands behind the port of a host", start + std::string{place.substr(0, place.find('/'))});
    }
    std::size_t const colon = colon_of(place);
    if (colon == 0 or host_in(place.substr(0, colon)).empty()) {
        return wrong("no host is named; it is like " + std::string{form.example});
    }
    if (colon == place.npos and not form.usual) {
        return wrong(form.is_here ? "no port is named; it is like " + std::string{form.example}
                                  : "no port is named, as the serial device server has it set: often 4001, 502 or 23",
                     start + std::string{place} + likely);
    }
    std::string_view const host = place.substr(0, colon);
    std::string_view const behind = colon == place.npos ? std::string_view{} : place.substr(colon + 1);
    auto const port = colon == place.npos ? form.usual : number_in(std::string{behind});
    if (host.front() != '[' and host.find(':') != host.npos) {
        bool const has_port = port and is_ipv6(host);
        std::string const number = "[" + std::string{has_port ? host : place} + "]";
        return wrong("a number of IPv6 stands in brackets",
                     not has_port and not is_ipv6(place)
                         ? std::string{}
                         : start + number + (has_port ? ":" + std::string{behind} : likely));
    }
    if (not port or *port < least or *port > 0xFFFF) {
        return wrong("a port is a number from " + std::to_string(least) + " to 65535",
                     start + std::string{host} + likely);
    }
    auto const number = static_cast<std::uint16_t>(*port);
    std::string name = host_in(host);
    if (form.is_here and is_same_word(name, "localhost")) {
        name = "127.0.0.1";
    } else if (form.is_here and not is_ipv4(name) and not is_ipv6(name)) {
        // To look a name up takes time that whoever listens needs for others, and what is found may be another machine.
        return wrong("who listens names an address of this machine, 127.0.0.1 for itself alone, 0.0.0.0 for all that "
                     "reach it; no name is looked up",
                     name == "*" ? start + "0.0.0.0:" + std::to_string(number) : std::string{});
    } else if (form.is_here and is_group(name)) {
        return wrong(
            "this is an address of many machines at once, to which nobody can connect; who listens names one of "
            "this machine, 127.0.0.1 for itself alone, 0.0.0.0 for all that reach it");
    }
    return form.start == mbap_server.start ? found(mbap_address{name, number}) : found(tcp_address{name, number});
}

/// A word with the wrong start, or the name of something that is not there.
meaning unknown(std::string_view word)
{
    constexpr std::array<std::string_view, 3> starts{"tcp", "mbap", "sim"};
    std::size_t const colon = word.find(':');
    std::string_view const nearest = nearest_word(word.substr(0, colon), starts);
    if (colon != word.npos and not nearest.empty()) {
        bool const is_host = nearest != "sim";
        std::size_t const rest = is_host ? word.find_first_not_of("/", colon + 1) : colon + 1;
        return wrong("there is no such kind of port",
                     std::string{nearest} + (is_host ? "://" : ":") +
                         std::string{word.substr(rest == word.npos ? word.size() : rest)});
    }
    struct stat info {};
    if (std::string device = "/dev/" + std::string{word}; not word.empty() and ::stat(device.c_str(), &info) == 0) {
        return wrong("there is no such file here", std::move(device));
    }
    return wrong(forms());
}

/// A file of frames begins with the block of a section (pcapng), or with one of two numbers in one of two orders (pcap).
bool is_capture(std::string const& path)
{
    using namespace std::string_view_literals;
    constexpr std::array<std::string_view, 5> starts{"\x0A\x0D\x0D\x0A"sv, "\xD4\xC3\xB2\xA1"sv, "\xA1\xB2\xC3\xD4"sv,
                                                     "\x4D\x3C\xB2\xA1"sv, "\xA1\xB2\x3C\x4D"sv};
    std::array<char, 4> first{};
    std::ifstream file{path, std::ios::binary};
    std::string_view const found{first.data(), first.size()};
    return file.read(first.data(), first.size()) and std::find(starts.begin(), starts.end(), found) != starts.end();
}

meaning read_path(std::string_view word)
{
    std::string const path{word};
    if (is_port_name(word)) {
        return found(serial_device{path});
    }
    struct stat info {};
    if (::stat(path.c_str(), &info) != 0) {
        return word.find('/') == word.npos ? unknown(word) : found(serial_device{path});
    }
    if (S_ISDIR(info.st_mode)) {
        return wrong("a directory is no port");
    }
    if (not S_ISREG(info.st_mode)) {
        return found(serial_device{path});
    }
    return is_capture(path) ? found(capture_file{path}) : wrong("a file that is no capture: neither pcapng nor pcap");
}

meaning read_drives(std::string_view words)
{
    auto const drives = read_simulated_drives(words);
    return drives.why.empty() ? found(simulated_drives_choice{drives.drives})
                              : wrong(drives.why, drives.nearest.empty() ? "" : "sim:" + drives.nearest);
}

/// Nothing where the word is of neither form.
std::optional<meaning> read_address(std::string_view word, address_form const& tcp, address_form const& mbap)
{
    for (address_form const* const each : {&tcp, &mbap}) {
        if (starts_with_word(word, each->start)) {
            return read_host(word.substr(each->start.size()), *each);
        }
    }
    return std::nullopt;
}

meaning read_listening(std::string_view word)
{
    auto const address = read_address(word, tcp_here, mbap_here);
    return address ? *address : wrong("an address to listen at is like mbap://127.0.0.1:1502 or tcp://127.0.0.1:4001");
}

meaning read(std::string_view word)
{
    if (auto const address = read_address(word, tcp_server, mbap_server)) {
        return *address;
    }
    if (starts_with_word(word, "sim:")) {
        return read_drives(word.substr(4));
    }
    // The path of a device may hold colons; what another scheme begins with is none.
    bool const has_scheme =
        word.find("://") != word.npos or starts_with_word(word, "tcp:") or starts_with_word(word, "mbap:");
    return has_scheme and word.front() != '/' and word.front() != '.' ? unknown(word) : read_path(word);
}

port_choice choice_of(std::string_view word, meaning (*read_word)(std::string_view))
{
    meaning meant = read_word(word);
    if (meant.port) {
        return {std::move(*meant.port)};
    }
    std::string sentence = "port " + std::string{word} + ": " + meant.why;
    // A word with two mistakes: what mends one of them is no help.
    if (not meant.nearest.empty() and not read_word(meant.nearest).port) {
        meant.nearest.clear();
    }
    if (not meant.nearest.empty()) {
        sentence += "; did you mean " + meant.nearest + "?";
    }
    return {{}, refusal{"wrong_port", std::string{word}, std::move(sentence), std::move(meant.nearest)}};
}

} // namespace

port_choice read_port_word(std::string_view word) { return choice_of(word, read); }

port_choice read_listen_word(std::string_view word) { return choice_of(word, read_listening); }

} // namespace tool
