// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// What comes from one client as requests, and what goes to it as answers: messages of Modbus TCP, or RTU frames over TCP. Holds
// no more than two of the longest. Knows no socket.
#pragma once

#include <array>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include <rtuwire/frames.hpp>
#include <rtuwire/port.hpp>

#include "serve/request_queue.hpp"

namespace tool {

enum class client_protocol : std::uint8_t { mbap, rtu };

class client_requests {
public:
    /// A part of a request that is not whole by then ends the connection.
    static constexpr std::chrono::seconds longest_part{10};
    /// In RTU frames over TCP, where nothing else tells the end of a frame that is damaged or of a function that is not public.
    /// It ends no frame whose function says that more is to come: a segment that is lost comes a second or more later.
    static constexpr std::chrono::milliseconds silence{500};

    explicit client_requests(client_protocol which) : is_rtu_{which == client_protocol::rtu} {}

    [[nodiscard]] bool is_rtu() const { return is_rtu_; }

    /// Where the next bytes go; empty while requests are to be taken first.
    [[nodiscard]] rtuwire::byte_span room();
    /// So many have come there.
    void add(std::size_t count, serve_time now);

    /// The next request, of which unit, number, data and time are set.
    [[nodiscard]] std::optional<served_request> take(serve_time now);

    /// It was not read for a while: its client could send no more.
    void resume(serve_time now) { begun_ = begun_ ? std::optional{now} : begun_; }

    /// Whether what came is none of its protocol: no request is found behind it.
    [[nodiscard]] bool is_broken() const;

    /// Whether what came is the other of both protocols: a client that is set up for that one, which is told what to set.
    [[nodiscard]] bool is_other_protocol() const { return is_other_; }

    /// What came and is no whole request.
    [[nodiscard]] rtuwire::byte_view rest() const;

    /// Bytes that were no frame, and were dropped, since the last call.
    [[nodiscard]] std::size_t take_dropped();

    /// When a part of a request, or what is none, has been there for too long.
    [[nodiscard]] std::optional<serve_time> part_ends() const;
    /// When a silence has to be looked at by `take`.
    [[nodiscard]] std::optional<serve_time> silence_ends() const;

    /// An answer as it goes to this client.
    [[nodiscard]] std::vector<std::byte> answer(served_request const& to, rtuwire::byte_view pdu) const;

private:
    std::optional<served_request> take_message(serve_time now);
    std::optional<served_request> take_frame(serve_time now);
    [[nodiscard]] bool has_half() const;
    void drop(std::size_t count);

    bool is_rtu_;
    rtuwire::mbap_cutter messages_{};
    std::array<std::byte, 2 * rtuwire::max_adu_size> bytes_{};
    std::size_t size_{0};
    std::size_t resumed_at_{0};  ///< where bytes came behind a silence; 0: nowhere
    bool waits_for_rest_{false}; ///< a silence was looked at, and ends nothing
    std::size_t dropped_{0};
    bool begins_as_frame_{false}; ///< of Modbus TCP: by chance, where a message is whole all the same
    bool has_taken_{false};       ///< a request
    bool is_other_{false};
    serve_time latest_{};               ///< when bytes came
    std::optional<serve_time> begun_{}; ///< when the first byte came of what is no whole request yet
};

} // namespace tool
