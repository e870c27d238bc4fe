// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A line on which any bytes are sent with any silence between them, and what comes is kept as it comes.
#pragma once

#include <array>
#include <chrono>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "check/clause_words.hpp"
#include "line/exchange_log.hpp"
#include "port/any_port.hpp"

namespace tool {

/// What passed, for whoever wants to see why a clause fails.
struct passed_bytes {
    std::chrono::steady_clock::time_point at; ///< when its last byte had passed
    bool is_sent;
    line_bytes bytes;
};

using line_time = std::chrono::microseconds;

struct line_answer {
    line_bytes bytes{};
    line_time took{0};        ///< from the last byte that was sent to the first that came
    line_time largest_gap{0}; ///< between its parts
};

/// The whole size of a response by what it says of itself; nothing while that has not come, or of a function that is not known.
/// `asked` is its request, whose size that of an echo is.
[[nodiscard]] std::optional<std::size_t> stated_size(rtuwire::byte_view came, rtuwire::byte_view asked);

/// A normal answer to a frame with that function.
[[nodiscard]] bool is_normal(line_bytes const& came, line_bytes const& asked);

class probed_line {
public:
    /// `longest_wait`: for a response. `unit`: that is checked.
    probed_line(any_port& port, exchange_log& log, rtuwire::line_timing const& wire, line_time longest_wait,
                std::uint8_t unit);

    /// Keeps the silence before a frame, sends, and waits for the answer.
    line_answer ask(std::vector<sent_piece> const& pieces) { return ask(pieces, longest_wait_); }
    line_answer ask(std::vector<sent_piece> const& pieces, line_time wait);
    line_answer ask(line_bytes const& frame) { return ask({sent_piece{.bytes = frame}}); }

    /// How long asking takes at most where no answer comes.
    [[nodiscard]] line_time time_without_answer(std::vector<sent_piece> const& pieces, line_time wait) const;
    /// Since the unit heard a request that it answered as one: no exception.
    [[nodiscard]] line_time since_answered() const;

    /// Drops what comes until nothing came for so long; at most ten times as long. A whole frame behind a request that got no
    /// answer is a late one.
    void wait_for_quiet(line_time silence);

    /// Whether this machine kept the silences inside of what was sent last on the side of t1.5 and t3.5 on which they are wanted.
    [[nodiscard]] bool has_kept_silences() const { return has_kept_silences_; }
    [[nodiscard]] rtuwire::line_timing const& wire() const { return wire_; }
    [[nodiscard]] line_time longest_wait() const { return longest_wait_; }
    /// Whether the port has a wire with a bit rate, and no pseudo-terminal or network in its place.
    [[nodiscard]] bool has_wire() const { return has_wire_; }
    /// Whether it is Modbus TCP, where only whole frames go.
    [[nodiscard]] bool has_numbers() const { return port_.has_numbers(); }
    /// t3.5, and what the port wants beyond it.
    [[nodiscard]] line_time silence() const;

    /// The first answer that came behind the wait for it; empty where none did.
    [[nodiscard]] line_bytes const& late_answer() const { return late_answer_; }

    /// What passed since the last call.
    std::vector<passed_bytes> take_passed() { return std::exchange(passed_, {}); }

private:
    using clock = std::chrono::steady_clock;

    void send(std::vector<sent_piece> const& pieces);
    /// What comes until then; empty where nothing does.
    line_bytes read_until(clock::time_point end);
    void note(bool is_sent, line_bytes const& bytes);

    any_port& port_;
    exchange_log& log_;
    rtuwire::line_timing wire_; ///< of the settings, where the port has none, too
    line_time longest_wait_;
    std::byte unit_;
    bool has_wire_;
    std::vector<passed_bytes> passed_{};
    clock::time_point last_byte_{clock::now()}; ///< that passed
    clock::time_point answered_{clock::now()};  ///< when the last request had left that the unit answered
    bool has_kept_silences_{true};
    line_bytes early_{};        ///< what came inside of that request
    bool is_unanswered_{false}; ///< the request that went last
    line_bytes late_answer_{};
};

} // namespace tool
