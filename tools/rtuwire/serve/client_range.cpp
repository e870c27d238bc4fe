// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
#include "serve/client_range.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>

#include "../support/platform.hpp"
#include "port/usage_error.hpp"

namespace tool {

namespace {

constexpr unsigned bits_of_six = 128;
constexpr char const* loopback[]{"127.0.0.0/8", "::1"};

} // namespace

std::optional<client_range::bytes> client_range::bytes_of(std::string const& host)
{
    bytes all{};
    if (::inet_pton(AF_INET, host.c_str(), &all[12]) == 1) {
        all[10] = all[11] = 0xFF;
        return all;
    }
    return ::inet_pton(AF_INET6, host.c_str(), all.data()) == 1 ? std::optional{all} : std::nullopt;
}

client_range::bytes client_range::begin_of(bytes const& address, unsigned length)
{
    bytes begin{};
    for (unsigned bit = 0; bit < length; ++bit) {
        begin[bit / 8] = static_cast<std::uint8_t>(begin[bit / 8] | (address[bit / 8] & (0x80U >> bit % 8)));
    }
    return begin;
}

std::optional<client_range> client_range::of(std::string const& word)
{
    std::size_t const slash = word.find('/');
    std::string const host = word.substr(0, slash);
    auto const all = bytes_of(host);
    unsigned const before = host.find(':') == host.npos ? bits_before_four : 0;
    unsigned const most = bits_of_six - before;
    std::string const length = slash == word.npos ? std::to_string(most) : word.substr(slash + 1);
    auto const typed = number_in(length);
    // "/024" is 20 to whoever counts in octal.
    if (not all or not typed or *typed > most or std::to_string(*typed) != length) {
        return std::nullopt;
    }
    client_range range;
    range.length_ = before + *typed;
    range.first_ = *all;
    return begin_of(*all, range.length_) == *all ? std::optional{range} : std::nullopt;
}

bool client_range::has(std::string const& host) const
{
    auto const all = bytes_of(host);
    return all and begin_of(*all, length_) == first_;
}

bool client_range::meets(client_range const& other) const
{
    unsigned const shared = std::min(length_, other.length_);
    return begin_of(first_, shared) == begin_of(other.first_, shared);
}

bool client_range::can_reach(std::string const& host) const
{
    for (char const* const here : loopback) {
        if (client_range const own = *of(here); own.has(host)) {
            return meets(own);
        }
    }
    client_range const four = *of("0.0.0.0/0");
    bool const is_all_six = bytes_of(host) == bytes{};
    bool const has_six = not meets(four) or length_ < bits_before_four;
    return is_all_six or (four.has(host) ? meets(four) : has_six);
}

bool is_all_here(std::string const& host) { return host == "0.0.0.0" or host == "::"; }

std::string plain_host(std::string host)
{
    if (host.ends_with('.')) {
        host.pop_back();
    }
    std::uint32_t const number = host.empty() ? INADDR_NONE : ::inet_addr(host.c_str());
    if (number == INADDR_NONE) {
        return host;
    }
    std::array<std::uint8_t, 4> bytes{};
    std::memcpy(bytes.data(), &number, bytes.size());
    std::string text;
    for (unsigned const each : bytes) {
        text += (text.empty() ? "" : ".") + std::to_string(each);
    }
    return text;
}

bool are_one_place(std::string const& one, std::string const& other)
{
    auto const takes = [](std::string const& host, std::string const& at) {
        auto const range = client_range::of(is_all_here(host) ? host + "/0" : host);
        return host == at or (range and range->has(at));
    };
    return takes(one, other) or takes(other, one);
}

bool is_loopback(std::string const& host)
{
    return std::ranges::any_of(loopback, [&host](char const* here) { return client_range::of(here)->has(host); });
}

std::string host_of(std::string const& place)
{
    bool const has_brackets = place.starts_with('[');
    std::string const host = has_brackets ? place.substr(1, place.find(']') - 1) : place.substr(0, place.rfind(':'));
    return host.substr(0, host.find('%'));
}

} // namespace tool
