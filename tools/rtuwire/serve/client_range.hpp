// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Addresses of clients: "192.168.1.0/24", "fd00::/8", "10.0.0.7".
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>

namespace tool {

class client_range {
public:
    /// Nothing where a word is none: also where bits behind its length are set, for nobody knows what was meant.
    [[nodiscard]] static std::optional<client_range> of(std::string const& word);

    /// Whether an address is one of them; `host` is its number. One of IPv4 is the same as IPv6 maps it.
    [[nodiscard]] bool has(std::string const& host) const;

    /// Whether one of them can connect to who listens at that number: by IPv4 to one of IPv4, by IPv6 to one of IPv6, by both to "::";
    /// from this machine alone to one by which it reaches itself.
    [[nodiscard]] bool can_reach(std::string const& host) const;

    /// Whether it leaves nobody out that has an address of IPv4.
    [[nodiscard]] bool has_all() const { return length_ <= bits_before_four and has("0.0.0.0"); }

private:
    using bytes = std::array<std::uint8_t, 16>;      ///< of IPv6; one of IPv4 as IPv6 maps it
    static constexpr unsigned bits_before_four = 96; ///< where IPv6 maps IPv4

    static std::optional<bytes> bytes_of(std::string const& host);
    static bytes begin_of(bytes const& address, unsigned length);
    bool meets(client_range const& other) const; ///< some address is of both

    bytes first_{};
    unsigned length_{0}; ///< so many bits are the same
};

/// 0.0.0.0 or ::, at which whoever listens does so at all addresses of this machine.
[[nodiscard]] bool is_all_here(std::string const& host);

/// The same host as addresses are written here: "127.1" and "0x7f000001" are 127.0.0.1, "localhost." is without its dot.
[[nodiscard]] std::string plain_host(std::string host);

/// Whether who listens at one of these addresses takes connections to the other, too.
[[nodiscard]] bool are_one_place(std::string const& one, std::string const& other);

/// Whether it is an address by which this machine reaches itself, and nobody else does.
[[nodiscard]] bool is_loopback(std::string const& host);

/// The host of "192.168.1.7:50123", "[fd00::1%eth0]:50123", by its number alone.
[[nodiscard]] std::string host_of(std::string const& place);

} // namespace tool
