// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// What the command line says of a line that clients ask.
#pragma once

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "choices.hpp"
#include "port/port_word.hpp"
#include "serve/client_range.hpp"
#include "serve/client_requests.hpp"
#include "serve/write_gate.hpp"

namespace tool {

struct listen_place {
    client_protocol protocol;
    tcp_address at;
};

/// "mbap".
[[nodiscard]] constexpr std::string_view name_of(client_protocol which)
{
    return which == client_protocol::mbap ? "mbap" : "tcp";
}

struct serve_settings {
    std::vector<listen_place> listen{};
    gate_rules gate{};
    std::vector<client_range> from{}; ///< empty: from anywhere
    std::optional<tcp_address> metrics{};
    std::chrono::steady_clock::duration longest_idle{std::chrono::minutes{10}}; ///< of a client that asks nothing
    std::optional<double> last{}; ///< seconds; nothing: until somebody ends the program

    /// Whether `from` leaves nobody out.
    [[nodiscard]] bool is_for_anybody() const
    {
        return from.empty() or std::ranges::any_of(from, &client_range::has_all);
    }

    /// Whether drives are served, which are those that somebody named.
    [[nodiscard]] bool names_units() const { return gate.units.has_value(); }
};

/// Refuses what is wrong in itself.
[[nodiscard]] serve_settings serve_settings_in(choices const& chosen);

/// Whether who opens this port asks who listens there, as far as its word tells.
[[nodiscard]] bool is_asked_at(std::string const& word, tcp_address const& at);

/// Why a place to listen at cannot be the line's own port; empty where none is.
[[nodiscard]] std::string why_it_asks_itself(serve_settings const& settings, line_choices const& line);

/// Why none of `from` can connect to a place to listen at; empty where some can to each.
[[nodiscard]] std::string why_nobody_comes(serve_settings const& settings);

} // namespace tool
