// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Requests of many clients, until the line is free for them: each client in turn, each one's in their order. Those for a unit
// that is left alone for a moment keep nobody else waiting. Knows no socket and no clock.
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <map>
#include <optional>
#include <vector>

namespace tool {

using serve_time = std::chrono::steady_clock::time_point;

struct served_request {
    std::uint64_t client{0}; ///< its connection's number, which no other ever has
    std::uint16_t number{0}; ///< of Modbus TCP
    std::uint8_t unit{0};
    std::vector<std::byte> pdu{};
    serve_time came{};
    unsigned sent{0}; ///< so often, without a response
};

class request_queue {
public:
    static constexpr std::size_t most_of_client = 16;
    static constexpr std::size_t most = 256;
    static constexpr std::chrono::seconds oldest{5};

    /// False where its client, or all of them, have as many as may wait.
    [[nodiscard]] bool add(served_request request);

    /// A client has gone, and nobody waits for its answers.
    void drop(std::uint64_t client);

    /// The first of the client whose turn it is, of those whose unit is not left alone.
    [[nodiscard]] std::optional<served_request> take(serve_time now);

    /// It comes again with the next turn of its client.
    void put_back(served_request request);

    /// Until then nothing is taken for this unit.
    void leave_alone(std::uint8_t unit, serve_time until) { alone_until_[unit] = until; }
    [[nodiscard]] bool is_left_alone(std::uint8_t unit, serve_time now) const { return now < free_from(unit); }

    /// When one can be taken; nothing where none waits.
    [[nodiscard]] std::optional<serve_time> next_turn() const;

    /// Whether a client has one that waits.
    [[nodiscard]] bool has(std::uint64_t client) const { return waiting_.count(client) > 0; }

    /// Those that have waited too long, each with all that its client sent behind it: none of these is to be done where the
    /// one before was not.
    [[nodiscard]] std::vector<served_request> take_old(serve_time now);

    /// When the next has waited too long.
    [[nodiscard]] std::optional<serve_time> next_old() const;

    [[nodiscard]] std::size_t size() const { return size_; }

private:
    serve_time free_from(std::uint8_t unit) const
    {
        auto const known = alone_until_.find(unit);
        return known == alone_until_.end() ? serve_time{} : known->second;
    }

    std::map<std::uint8_t, serve_time> alone_until_{};
    std::map<std::uint64_t, std::deque<served_request>> waiting_{}; ///< none of them empty
    std::uint64_t latest_{0};                                       ///< the client whose turn was last
    std::size_t size_{0};
};

} // namespace tool
