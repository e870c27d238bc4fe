// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// The line that clients ask: who is on it, what may be written there, and what becomes of each request.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "choices.hpp"
#include "line/open_line.hpp"
#include "line/who_is_it.hpp"
#include "serve/served_clients.hpp"
#include "serve/silent_units.hpp"
#include "words/value_words.hpp"

namespace tool {

class served_line {
public:
    served_line(choices const& chosen, serve_settings const& settings, served_clients& clients, serve_counts& counts,
                serve_events const& events)
        : chosen_{chosen}, settings_{settings}, clients_{clients}, counts_{counts}, events_{events}
    {
        clients_.refuse_at_once(
            [this](std::uint8_t unit) { return not silent_.is_due(unit, std::chrono::steady_clock::now()); });
    }
    served_line(served_line const&) = delete;
    served_line& operator=(served_line const&) = delete;

    /// From here on this line is asked. While it waits its owner has the clients served.
    void begin(open_line& line);
    /// Until the next one nobody can be asked, and nothing is known of who is there.
    void end();
    /// Whether there is one: a request during which it is lost ends it.
    [[nodiscard]] bool has_line() const { return line_ != nullptr; }
    /// How the last one was lost.
    [[nodiscard]] std::string const& why_lost() const { return why_lost_; }

    /// Answers a request.
    void handle(served_request const& request);
    /// A unit is asked by somebody else: it is not to wait for one that is silent.
    void note_asked(std::uint8_t unit) { silent_.note_request(unit, std::chrono::steady_clock::now()); }
    /// What came of it: one that is silent is not asked for clients, too.
    void note_outcome_of_other(std::uint8_t unit, bool has_responded)
    {
        silent_.note(unit, has_responded, std::chrono::steady_clock::now(), {});
    }

private:
    /// What a unit tells of itself; until it is silent, a request had to be repeated, or the port is lost, and for as long as
    /// nobody can have put another in its place.
    struct known_unit {
        std::optional<write_rules> rules{}; ///< nothing: it may be a drive, which one is not known
        std::string why{};                  ///< nothing is written there then
        bool has_said_nothing{false};       ///< to function 43, which may have been lost
        serve_time asked{};                 ///< who it is
        serve_time heard{};                 ///< last

        [[nodiscard]] bool may_be_drive() const { return not rules or rules->drive != nullptr or rules->command; }
    };

    /// Forgets who a unit is where that may be another by now: for a write behind 1 s without an answer of it, for a read
    /// behind 60 s; and where it could not say who it is, behind 10 s, or 60 s where its registers tell what it may be.
    void forget_old(std::uint8_t unit, bool is_read);
    /// Whether a read carries no frame for another unit; where it does, it is answered.
    bool holds_no_frame(served_request const& request);
    void lose(std::string const& why);
    void broadcast(served_request const& request);
    /// Whether its unit is known now; where not, the request is answered.
    bool identify(served_request const& request, named_unit const& unit);
    /// Whether a unit answers at all, and what it made of the question who it is.
    struct look {
        rtuwire::errc outcome;
        std::optional<rtuwire::errc> silence{}; ///< where that question had none: how it ended
    };
    /// By two requests at most, each sent once: a unit that is off costs no more.
    look look_for(named_unit const& unit);
    /// The values of a write that may go to a unit that is known, and is noted; where it may not, it is answered.
    std::optional<std::vector<value_to_write>> judge_write(served_request const& request, named_unit const& unit);
    /// Asks the unit, and answers the client. How it ended, where that is not by a response.
    std::string forward(served_request const& request, named_unit const& unit);
    /// Whether a request that had no whole response is sent again, in a later turn: a read, where its unit has answered before.
    bool is_to_be_repeated(served_request const& request) const;
    /// Whether a write can be noted in writes.log; where it cannot, it is answered.
    bool can_be_noted(served_request const& request, std::size_t rows);
    /// `sender`: who may have left since.
    void note_write(served_request const& request, std::vector<value_to_write> const& values, std::string const& sender,
                    std::string const& outcome);
    /// `began`: when it was asked.
    void note_outcome(std::uint8_t unit, bool has_responded, serve_time began);
    void refuse_as(served_request const& request, rtuwire::errc exception, std::string const& kind,
                   std::string const& why);
    void tell_not_served(std::uint8_t unit, std::string const& what);
    named_unit unit_at(std::uint8_t number) const;

    choices const& chosen_;
    serve_settings const& settings_;
    served_clients& clients_;
    serve_counts& counts_;
    serve_events const& events_;
    open_line* line_{nullptr};
    std::string why_lost_{};
    silent_units silent_{};
    std::map<std::uint8_t, known_unit> known_{};
    std::set<std::uint8_t> told_units_{}; ///< of which was said why they are not served
};

/// The line of a program that does nothing else: it is opened again where it was lost.
class reopened_line {
public:
    static constexpr std::chrono::seconds reopening_pause{1};

    /// Opens the port, and listens there first, as every command does.
    reopened_line(choices const& chosen, serve_settings const& settings, served_clients& clients, serve_counts& counts,
                  serve_events const& events);

    /// Until somebody ends it.
    void run();

private:
    /// The line is open.
    void begin();
    bool open_again();
    void lose(std::string const& why);
    /// Says why the port is away, each reason once until it is back.
    void tell_away(std::string const& event, std::string const& why, std::string const& behind);
    /// Says once that the port is back: a device by being there, a connection by what has come over it.
    void tell_back();

    choices const& chosen_;
    served_clients& clients_;
    serve_counts& counts_;
    serve_events const& events_;
    std::unique_ptr<open_line> line_;
    served_line served_;
    serve_time opened_{};
    serve_time next_opening_{};
    std::set<std::string> told_away_{}; ///< why the port is away; empty while it is there
};

} // namespace tool
