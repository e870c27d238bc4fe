// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A unit that is checked: what it has, found by asking, its known states, and what clauses found out about it.
#pragma once

#include <optional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "check/clause.hpp"
#include "check/probed_line.hpp"
#include "choices.hpp"

namespace tool {

inline constexpr line_time known_silence{60'000}; ///< before what begins from a known state

/// One question and its answer.
struct kept_exchange_of_check {
    line_bytes asked;
    line_answer answer;
    std::string_view clause;
};

/// Whether an answer is an exception, or would be with its high bit.
[[nodiscard]] bool is_refusal(line_bytes const& came, line_bytes const& asked);

/// Why a clause is not asked.
struct obstacle {
    bool is_of_unit; ///< the unit has nothing to ask for; else it was not allowed, or this port cannot show it
    std::string why;
};

/// What may be changed.
struct scratch_places {
    std::optional<std::uint16_t> first{};
    unsigned count{0};
    std::optional<std::uint16_t> first_coil{}; ///< of 16
};

/// Refuses words that name none.
scratch_places scratch_in(check_choices const& how);

class checked_unit {
public:
    checked_unit(probed_line& line, std::uint8_t unit, check_choices const& how) : line_{line}, how_{how}
    {
        where_.unit = unit;
    }

    /// Asks it, once for each function and place that the wanted clauses need; of the scratch places it writes what stands
    /// there. False where nothing came at all.
    bool discover(std::span<clause const* const> wanted, scratch_places const& scratch);

    /// Nothing where a clause can be asked.
    std::optional<obstacle> why_not_asked(clause const& which) const;

    /// False where the unit does not come to it.
    bool establish(clause_state state);

    /// Of a unit that supervises its line, and may be without a request that it answers for so long; `why` is said of clauses
    /// that would take longer.
    void keep_fed(line_time longest_pause, std::string why)
    {
        longest_pause_ = longest_pause;
        may_pause_ = std::move(why);
    }
    /// Asks the plain read where that would become too long with what takes so long. False where it is not answered.
    bool feed_before(line_time next);
    /// The same, with steps.
    bool feed_before(std::span<std::string_view const> steps)
    {
        return not longest_pause_ or feed_before(time_of(steps));
    }
    /// Of these steps the first that go without a read between them: up to the plain read that judges them, or one alone. Where
    /// that lasts too long, up to the end of an exchange.
    std::span<std::string_view const> run_of(std::span<std::string_view const> steps) const;

    line_answer ask(std::vector<sent_piece> const& pieces, std::string_view clause);
    line_answer ask(std::string_view words, std::string_view clause) { return ask(pieces_of(words, where_), clause); }

    /// What stood in the scratch places; says what could not be put back, empty where all was.
    std::string put_back();

    probed_line& line() { return line_; }
    check_choices const& how() const { return how_; }
    /// Twice the longest that it took for an answer so far: for a question that may get none.
    line_time usual_wait() const { return 2 * longest_answer_ + line_time{2'000}; }
    known_places const& where() const { return where_; }
    line_time longest_answer() const { return longest_answer_; }
    /// Between the parts of an answer.
    line_time longest_gap() const { return longest_gap_; }
    std::vector<kept_exchange_of_check> const& exchanges() const { return exchanges_; }
    /// Those of a clause that failed are that clause's.
    void forget(std::string_view clause);
    bool has_function(unsigned function) const { return functions_.contains(function); }

    /// What somebody says that it has.
    void claim(std::vector<unsigned> const& functions) { claimed_ = functions; }
    std::vector<unsigned> const& claimed() const { return claimed_; }

private:
    line_time time_of(std::span<std::string_view const> steps) const;
    line_time longest_pause_of(clause const& which) const;
    std::optional<obstacle> pause_obstacle(clause const& which) const;
    line_answer ask_fed(std::vector<sent_piece> const& pieces);
    bool is_needed(std::string_view need) const;
    bool needs_serial_line(clause const& which) const;
    bool reads(std::string_view words, std::size_t data);
    std::optional<std::uint16_t> first_readable(unsigned function);
    std::optional<std::uint16_t> first_missing(unsigned function, std::uint16_t there);
    bool is_there(unsigned function, std::uint16_t address);
    /// Whether it says so: exception 02.
    bool is_missing(unsigned function, std::uint16_t address);
    line_bytes ask_from_known(std::vector<sent_piece> const& pieces);
    void find_crc_place();
    void find_functions();
    void find_other();
    line_bytes scratch_data(unsigned function, std::uint16_t first, unsigned count, std::size_t size,
                            std::string const& option);
    void find_writing(std::span<line_bytes const> pdus);
    void find_scratch(scratch_places const& places);
    bool holds_words(std::vector<std::uint16_t> const& values);
    bool write_words(std::vector<std::uint16_t> const& values);
    bool holds_coils(std::uint16_t bits);
    bool write_coils(std::uint16_t bits);
    std::optional<obstacle> obstacle_of(std::string_view need) const;

    probed_line& line_;
    check_choices const& how_;
    std::optional<line_time> longest_pause_{};
    std::string may_pause_{};
    std::span<clause const* const> wanted_{};
    known_places where_{};
    std::set<unsigned> functions_{}; ///< that it has
    std::vector<unsigned> claimed_{};
    std::set<unsigned> subfunctions_{}; ///< of function 08
    bool names_singly_{false};          ///< by function 43/14
    bool is_lost_{false};               ///< no try brought it to the known state
    bool is_end_known_{false};          ///< nothing is behind the scratch registers
    std::vector<std::uint16_t> words_before_{};
    std::optional<std::uint16_t> coils_before_{};
    std::vector<kept_exchange_of_check> exchanges_{};
    line_time longest_answer_{0};
    line_time longest_gap_{0};
};

} // namespace tool
