// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// The rounds of one line: what is due is read, oldest first; a setting goes before. The turn of a reading, and of an
// identification, ends behind a response that did not come at once: the rest comes behind what else is due. A device that
// is silent is asked with growing pauses, and behind what one of them costs others have nine times as long, 2 s at most. A
// device is silent where a request and its repetition had no response; where it was lost before within a minute, behind as
// many rounds more. A device is identified before its values count, and again once it was lost.
#pragma once

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "asked_line.hpp"
#include "line/asked_less.hpp"
#include "line_board.hpp"
#include "stored_writes.hpp"

namespace tool::gateway {

class line_rounds {
public:
    using clock = asked_line::clock;

    /// So long a step waits at most, so that a setting or an end is not overlooked.
    static constexpr std::chrono::milliseconds longest_wait{50};
    /// Between two looks at what has another device's place.
    static constexpr std::chrono::seconds wrong_device_pause{60};

    line_rounds(line_plan const& plan, asked_line& line, line_board& board, stored_writes& stored);
    line_rounds(line_rounds const&) = delete;
    line_rounds& operator=(line_rounds const&) = delete;
    ~line_rounds() { line_.beat_by({}); }

    /// What is due next: opens the port, writes a setting, reads a part; else it waits. Where the port fails it is closed, and
    /// opened again in a later step, with growing pauses.
    void step();

    /// No further step comes: what waited is answered.
    void end();

private:
    struct turn_reading {
        part_reading found;
        std::uint64_t time;   ///< microseconds since 1970, when it began: none of its values is older
        clock::duration cost; ///< of the line
    };
    struct part {
        device_part what;
        clock::duration period;
        clock::time_point due;
        bool is_read_in_part{false};           ///< some of it had no response, the last time
        std::optional<turn_reading> reading{}; ///< that counts once its device has said who it is
    };
    struct taken_setting {
        waiting_setting what;
        bool goes_on{false}; ///< it had a turn
    };
    struct device {
        asked_less patience{1, longest_pause};
        bool is_identified{false};
        bool is_looked_at{false};  ///< in turns: its identification is not through
        bool is_read_next{false};  ///< before another setting: one took turns
        clock::time_point turn{};  ///< its last, where its responses do not come at once: behind others that are due
        clock::time_point heard{}; ///< last
        bool was_told{false};      ///< that it is lost, or another's
        unsigned misses{0};
        unsigned late_readings{0}; ///< in a row
        bool was_lateness_told{false};
        bool was_doubt_told{false}; ///< of who it is
        unsigned losses{0};         ///< within a minute, of which the first was
        clock::time_point first_lost{};
        clock::time_point wrong_until{};
        slot_content content{};
    };

    static constexpr std::chrono::minutes unsteady_time{1};   ///< behind which losses are forgotten
    static constexpr std::chrono::seconds longest_unheard{3}; ///< behind which another may be in a device's place
    static constexpr std::chrono::seconds longest_doubt{5};   ///< of a port that was opened again
    static constexpr unsigned late_readings_told = 3;
    static constexpr std::size_t most_reasons = 4;          ///< of a loss, that are told until it is confirmed
    static constexpr std::chrono::seconds longest_pause{2}; ///< so that who is back is so within 3 s

    void act();
    void open();
    void lose_port(std::string const& why);
    /// Somebody responded on it, or it has been open for a while: it is no port that hangs up on each request.
    void confirm_port();
    void ask_parts(clock::time_point now);
    /// Null where none is due that may be asked for.
    part* first_due(clock::time_point now);
    clock::time_point place_of(part const& one) const { return std::max(one.due, devices_[one.what.device].turn); }
    bool may_ask(device const& which, clock::time_point now) const;
    bool has_live_ones() const;
    /// Whether each device was met, or is known to be away.
    bool is_settled() const;
    void ask(part& one);
    /// Whether it has to be identified before it is read.
    bool may_be_another(std::size_t which) const;
    bool says_who(std::size_t which) const;
    device_finding::kind identify(std::size_t which);
    /// Its device is asked who it is in a later turn.
    void look_later(std::size_t which);
    /// What is due of it comes behind what is due of others.
    void end_turn(std::size_t which);
    /// Whether its device is the right one; where not, its next turn is set.
    bool is_of_right_one(part& one);
    /// False where its device may have gone meanwhile, or another one have answered behind a response that was lost.
    bool read(part& one);
    /// What was read counts. Whether it is through with that.
    bool take(part& one);
    void schedule(part& one, bool is_live);
    void begin_patience(device& one) const;
    void note_silence(std::size_t which, std::string const& why, clock::duration cost);
    void mark_lost(std::size_t which, std::string const& why);
    void take_settings();
    /// Gives one its turn.
    void write_next();
    /// Whether it has its answer, or goes on in a later turn.
    bool write(taken_setting& setting);
    bool is_expired(taken_setting const& setting) const;
    /// What became of it while it waited for its turn; nothing where it waits still.
    std::optional<setting_outcome> ended_waiting(taken_setting const& setting) const;
    std::string why_away(setting_request const& request) const;
    /// Why its device may not be written so soon again; empty where it may, which is noted.
    std::string claim(setting_request const& request);
    void answer(setting_request const& request, setting_result result, std::string why);
    void put(std::size_t which);
    void put(std::size_t which, std::uint64_t time);
    void tell(event_kind what, std::string const& who, std::string const& text);
    void show_state();

    line_plan const& plan_;
    asked_line& line_;
    line_board& board_;
    stored_writes& stored_;
    std::vector<part> parts_{};
    std::vector<device> devices_{};
    std::vector<taken_setting> settings_{}; ///< one of a device at most and what has expired, the oldest first
    asked_less port_patience_{1, longest_pause};
    clock::time_point settled_from_{};
    bool was_settled_{false};         ///< behind the round before
    clock::time_point probes_from_{}; ///< a silent one is asked then, at the earliest
    clock::time_point opened_at_{};
    std::vector<std::string> told_losses_{}; ///< why the port is away, as it was told since it was confirmed
    std::uint64_t silences_{0};              ///< so far
    clock::time_point silent_at_{};          ///< when one was seen last
    bool was_overrun_told_{false};
    line_state state_{.why = "not opened yet"};
};

} // namespace tool::gateway
