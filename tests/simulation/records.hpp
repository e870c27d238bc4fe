// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// What is known of the requests, their transmissions and their outcomes, and what may be wrong with them.
#pragma once

#include <array>
#include <cstdio>
#include <vector>

#include "frames.hpp"
#include "setting.hpp"
#include "shared_line.hpp"

namespace rtuwire::simulation {

/// What may be wrong.
enum class fault : std::uint8_t {
    foreign_response, ///< the response to another request was accepted
    invented,         ///< what was accepted was sent by nobody
    unasked,          ///< an outcome for a conversation that asked nothing, or something else
    alien_bytes,      ///< a frame on the line that is not the request under way
    overlap,          ///< a frame begins before the one before it has left
    short_silence,    ///< less than t3.5 before a frame, where the client's times want that
    short_turnaround, ///< a frame too early after a broadcast
    too_many,         ///< a request went out more often than it may
    too_few,          ///< it was given up too early
    early_timeout,    ///< a response was not waited for long enough
    late_timeout,     ///< or too long
    short_pause,      ///< a busy unit was asked again too early
    refused,          ///< a response that was right and in time was not accepted
    never_ended,      ///< a request has no outcome for far too long
    slow_recovery,    ///< the line is good, and a request fails or takes too long
    wrong_write,      ///< a server wrote what nobody asked for
    wrong_response,   ///< or answers with something else
    stale_response,   ///< a server answers a request after more came in
    deaf,             ///< a server did not take a request that it heard well
    spin,             ///< poll_deadline is now, and nothing happens
    share,            ///< silent units cost more than their share
    starved,          ///< or one of them is never asked again
    count_,
};

inline constexpr std::size_t fault_count = static_cast<std::size_t>(fault::count_);

inline char const* name_of(fault what)
{
    constexpr std::array<char const*, fault_count> names{
        "foreign responses",     "invented responses",   "unasked outcomes",  "alien bytes",
        "overlapping frames",    "short silences",       "short turnarounds", "too many transmissions",
        "too few transmissions", "early time-outs",      "late time-outs",    "short pauses",
        "refused responses",     "requests without end", "slow recoveries",   "wrong writes",
        "wrong responses",       "stale responses",      "deaf servers",      "spins",
        "shares exceeded",       "starved units"};
    return names[static_cast<std::size_t>(what)];
}

/// What was counted over all lives.
struct tally {
    std::array<unsigned long, fault_count> faults{};
    std::array<unsigned long, fault_count> first_after{}; ///< so many requests
    unsigned long inquiries{0};
    unsigned long answered{0};
    unsigned long failed{0};
    unsigned long given_up{0};      ///< cancelled, or their conversation is gone
    unsigned long beyond_rule{0};   ///< wrong, of a unit that took longer than any rule of time can cover
    unsigned long by_chance{0};     ///< spoiled, with a good CRC
    unsigned long spoiled{0};       ///< frames that somebody may have taken for another
    unsigned long late_accepted{0}; ///< right answers to an older transmission of the same request

    void note(fault what)
    {
        auto const index = static_cast<std::size_t>(what);
        if (faults[index]++ == 0) {
            first_after[index] = inquiries;
        }
    }
};

/// One request of a conversation.
struct inquiry {
    std::uint32_t id{0};
    frame request{};
    bool may_repeat{true};
    bool is_first_try_only{false}; ///< its bus knows the unit as silent
    bool is_health_known{true};    ///< whether that is sure
    unsigned round{0};             ///< how often the conversation gave it to the client
    unsigned sent{0};              ///< transmissions in this round
    unsigned pauses{0};            ///< exceptions 05 and 06 to them
    bool was_cancelled{false};
    bool is_unsure{false}; ///< a response came when the client may just have stopped waiting
    bool was_away{false};  ///< its conversation was, since it was given
    moment begun{0};
    moment given{0};

    bool is_broadcast() const { return request[0] == 0; }
};

/// One transmission of a request.
struct transmission {
    std::uint32_t number{0};
    std::uint32_t inquiry{0};
    unsigned round{0};
    moment start{0};
    moment end{0};
};

/// What happened, for whoever wants to understand a fault.
struct event {
    moment at{0};
    char const* what{""};
    std::uint32_t number{0};
    frame bytes{};
};

class journal {
public:
    void note(moment at, char const* what, std::uint32_t number = 0, bytes_view bytes = {})
    {
        event& one = events_[next_++ % events_.size()];
        one.at = at;
        one.what = what;
        one.number = number;
        one.bytes.assign(bytes.first(bytes.size() < 20 ? bytes.size() : 20));
    }

    void print() const
    {
        std::size_t const first = next_ > events_.size() ? next_ - events_.size() : 0;
        for (std::size_t i = first; i < next_; ++i) {
            event const& one = events_[i % events_.size()];
            std::printf("  %12.3f ms  %-34s %6u ", double(one.at) / 1e3, one.what, one.number);
            for (std::size_t at = 0; at < one.bytes.size(); ++at) {
                std::printf(" %02X", one.bytes[at]);
            }
            std::printf("\n");
        }
    }

private:
    std::array<event, 64> events_{};
    std::size_t next_{0};
};

/// The last of many things, by their number.
template <typename T> class latest {
public:
    explicit latest(std::size_t size) : all_(size) {}

    T& add(std::uint32_t number)
    {
        T& place = (*this)[number];
        place = T{};
        return place;
    }
    T& operator[](std::uint32_t number) { return all_[number % all_.size()]; }

private:
    std::vector<T> all_;
};

/// Everything that one life notes.
class records {
public:
    records(setting const& how, tally& counts) : inquiries{how.measures_share ? 65'536U : 1'024U}, counts_{counts} {}

    void accuse(fault what, moment now)
    {
        counts_.note(what);
        events.note(now, name_of(what));
        has_fault_ = true;
    }
    bool has_fault() const { return has_fault_; }
    tally& counts() { return counts_; }

    latest<inquiry> inquiries;
    latest<transmission> transmissions{4'096};
    journal events{};

private:
    tally& counts_;
    bool has_fault_{false};
};

} // namespace rtuwire::simulation
