// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A client that is checked: servers are played to it, and judged is what it prints and what it sends next.
#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include <rtuwire/frames.hpp>

#include "check/client_process.hpp"
#include "check/verdict.hpp"
#include "port/served_port.hpp"

namespace tool {

/// How a client is asked.
struct client_call {
    std::vector<std::string> command{}; ///< empty: it asks by itself, and only its requests are seen
    std::string port{};                 ///< what it is told to open; empty: as the port is called
    line_time timeout{0};               ///< what it is told to wait for a response
};

/// What a client is told to ask: "read 1 100 2".
struct told_request {
    bool is_write{false};
    std::uint8_t unit{1};
    std::uint16_t address{0};
    std::uint16_t number{0}; ///< of registers, or the value
};

/// A frame that came from a client.
struct client_request {
    std::chrono::steady_clock::time_point at; ///< of its first byte
    line_bytes frame;
    std::size_t which; ///< which one it asks; `not_told` where it was told to ask nothing of the kind
    line_time silence; ///< before it, since the end of the last answer; the longest where there was none
};

/// What a client did in one run.
struct client_run {
    std::vector<told_request> told{};
    std::vector<client_request> requests{};
    std::vector<printed_line> printed{};
    bool has_ended{true}; ///< by itself
    line_time took{0};    ///< from its first request to its end
    std::string end{};    ///< how, where not well, and what it said last
    std::vector<passed_bytes> passed{};
};

class checked_client {
public:
    checked_client(served_port& port, exchange_log& log, rtuwire::line_timing const& wire, std::uint8_t unit,
                   client_call const& call);

    /// Runs it by a clause.
    judgement judged(clause const& which);

private:
    using clock = std::chrono::steady_clock;
    /// What it is answered, in words; empty for nothing.
    using answering = std::function<std::string(client_request const&)>;

    struct due_bytes {
        clock::time_point at;
        line_bytes bytes;
    };

    judgement judged_by_command(clause const& which);
    judgement judged_by_line(clause const& which);
    judgement judged_results(clause const& which, client_run const& run);
    judgement judged_requests(std::string_view rule, client_run const& run) const;
    judgement without_result(client_run const& run);
    client_run const& known_run(std::string_view asked, std::string_view answered);
    client_run run_by(std::string_view asked, std::string_view answered);
    std::string answer_to(client_request const& request, std::string_view answered, client_run const& run);
    /// How often it sends a read that gets no answer; 0 where it does not end.
    std::size_t times_sent();
    bool is_usable();
    line_time limit(std::size_t requests) const;

    void begin();
    /// Hears and answers until then.
    void pass(clock::time_point until, answering const& answer, client_run& run);
    void hear(rtuwire::byte_view bytes, answering const& answer, client_run& run);
    void take(line_bytes frame, answering const& answer, client_run& run);
    void send_due(client_run& run);

    served_port& port_;
    exchange_log& log_;
    rtuwire::line_timing wire_;
    known_places where_{};
    client_call call_;
    std::map<std::string, client_run> known_{};
    bool hangs_{false};

    line_bytes heard_{};
    clock::time_point first_byte_{}, last_byte_{};
    std::vector<due_bytes> due_{};
    std::optional<clock::time_point> last_said_{}; ///< the end of what was said last, or earlier
};

} // namespace tool
