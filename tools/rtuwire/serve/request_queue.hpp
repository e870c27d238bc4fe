// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Requests of many clients, until the line is free for them: each client in turn, each one's in their order. Those for a unit
// that is left alone for a moment keep nobody else waiting. Knows no socket and no clock.
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <functional>
#include <map>
#include <optional>
#include <utility>
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

    /// Those of a unit of which this is true are refused without a frame: they wait for nothing. Of none, unless it was said.
    void refuse_at_once(std::function<bool(std::uint8_t)> of_unit) { is_refused_at_once_ = std::move(of_unit); }

    /// The first of the client whose turn it is, of those that need not wait for their unit.
    [[nodiscard]] std::optional<served_request> take(serve_time now);

    /// It comes again with the next turn of its client.
    void put_back(served_request request);

    /// A request has no answer, or one of two: another may come yet. Until `all` nothing is taken for its unit, and until
    /// `others` nothing but the same again of its function, whose answer that might be taken for.
    void leave_alone(served_request const& unanswered, serve_time all, serve_time others);
    /// Another's reading of a unit waits for that, and comes first: until then, or until it was done, none is taken for it.
    void keep(std::uint8_t unit, serve_time until) { kept_until_[unit] = until; }
    void note_kept_done(std::uint8_t unit) { kept_until_.erase(unit); }
    /// Whether one that it owes might be taken for the answer to this request.
    [[nodiscard]] bool is_held(served_request const& request, serve_time now) const { return now < free_from(request); }

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
    struct owed_answer {
        std::vector<std::byte> pdu{}; ///< of the request
        serve_time until{};
    };

    serve_time free_from(served_request const& request) const;
    /// The time to take it, from which on it is refused or asked.
    serve_time turn_of(served_request const& request) const;

    std::map<std::uint8_t, serve_time> alone_until_{};
    std::map<std::uint8_t, serve_time> kept_until_{};
    std::map<std::pair<std::uint8_t, std::byte>, owed_answer> owed_{}; ///< of a unit, by function
    std::function<bool(std::uint8_t)> is_refused_at_once_{};
    std::map<std::uint64_t, std::deque<served_request>> waiting_{}; ///< none of them empty
    std::uint64_t latest_{0};                                       ///< the client whose turn was last
    std::size_t size_{0};
};

} // namespace tool
