// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Clients of Modbus TCP that a line of the gateway answers between its own requests, by the parts of `rtuwire serve`. They only
// read.
#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>

#include "choices.hpp"
#include "serve/serve_settings.hpp"
#include "serve/served_clients.hpp"
#include "serve/served_line.hpp"

namespace tool::gateway {

class line_clients {
public:
    using clock = std::chrono::steady_clock;

    /// Between two tries to listen.
    static constexpr std::chrono::seconds listening_pause{2};
    /// For so long an own reading's turn is kept, where it is not taken.
    static constexpr std::chrono::seconds kept{2};

    /// Of a plan that serves. `tell` takes what there is to know, a sentence each. In the thread of the line.
    line_clients(choices const& chosen, std::function<void(std::string const&)> tell);
    line_clients(line_clients const&) = delete;
    line_clients& operator=(line_clients const&) = delete;
    ~line_clients();

    /// This line is open; they are served whenever it waits.
    void begin(open_line& line)
    {
        line_ = &line;
        served_.begin(line);
    }
    /// It is away, and who asks is told so.
    void end() { served_.end(); }
    /// The gateway asks a unit: clients' requests for one that is silent do not hold that up.
    void note_asked(std::uint8_t unit)
    {
        clients_.note_kept_done(unit);
        served_.note_asked(unit);
    }
    /// The gateway's own reading of a unit is due, and waits for what that may owe to a client.
    void keep_turn(std::uint8_t unit) { clients_.keep(unit, clock::now() + kept); }
    /// What came of that: one that is silent is not asked for clients, too.
    void note_outcome(std::uint8_t unit, bool has_responded) { served_.note_outcome_of_other(unit, has_responded); }
    /// An answer by this function may come to the gateway from this unit until then.
    void leave_alone(std::uint8_t unit, std::byte function, clock::time_point until)
    {
        clients_.leave_alone({.unit = unit, .pdu = {function}}, clock::now(), until);
    }

    [[nodiscard]] client_counts counts() const { return {requests_, counts_.silences()}; }

    /// Answers one request, where one waits. Ends where the port fails.
    void serve_one();
    /// Serves them until one has a request, or then. `line`: whose end is noticed, -1 for none; ends where that comes.
    void wait(int line, clock::time_point until);
    /// Serves them until the descriptor can be read, or then. Whether it can.
    bool wait_for_bytes(int descriptor, clock::time_point until) { return clients_.wait_for_bytes(descriptor, until); }

private:
    /// What is to be known of them: the line's own events are told by its rounds.
    class events final : public serve_events {
    public:
        explicit events(std::function<void(std::string const&)> tell)
            : serve_events{output_form::table}, tell_{std::move(tell)}
        {}
        void note(std::string_view, record const&, std::string const&) const override {}
        void tell(std::string_view event, record const&, std::string const& text) const override
        {
            if (event == "refused") {
                tell_(text);
            }
        }

    private:
        std::function<void(std::string const&)> tell_;
    };

    /// Where that fails, again and again.
    void listen();

    choices chosen_;
    std::function<void(std::string const&)> tell_;
    serve_settings settings_;
    serve_counts counts_{};
    events events_;
    served_clients clients_;
    served_line served_;
    open_line* line_{nullptr};
    std::uint64_t requests_{0};
    bool is_listening_{false};
    clock::time_point next_listening_{};
    std::string told_failure_{};
};

} // namespace tool::gateway
