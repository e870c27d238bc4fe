// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Reads any registers and bits of a unit by few requests: neighbours together, as many as its drive allows, and never
// over a hole.
#pragma once

#include <compare>
#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include <rtuwire/frames.hpp>

#include "catalog/catalog.hpp"
#include "line/open_line.hpp"
#include "words/register_words.hpp"
#include "words/value_words.hpp"

namespace tool {

/// What the last round read of a value, or why not.
struct held_words {
    rtuwire::errc why{rtuwire::errc::invalid_address_range};
    std::vector<std::uint16_t> words{}; ///< as they came; of a bit 0 or 1
    std::string failure{};              ///< why, in words
};

/// Asks for so many addresses, as many as one request may have.
held_words read_run(open_line& line, unit_address unit, register_space space, std::uint16_t start, std::uint16_t count);

/// Asks for one place.
held_words read_place(open_line& line, unit_address unit, place const& where);
/// Whether a unit of whom nobody expects a response has one: sent once, and what comes may be the answer to something before.
held_words look_at_place(open_line& line, unit_address unit, place const& where);

class register_reader {
public:
    /// With the registers that set the steps of those that were chosen. Without a drive (null) up to 125 at once, or as many
    /// as a register file says.
    register_reader(std::vector<chosen_register> const& chosen, vocabulary const& known);

    /// One round. What a unit refuses together is read in halves, and in the next round as this one left them. Ends where
    /// the port fails. With `ends_at_silence` a unit that does not respond to a request is asked nothing more, and
    /// that one last in the next round.
    void read(open_line& line, unit_address unit, bool ends_at_silence = false);

    /// The same, which ends at silence, in turns between those of others: from where the last turn ended to the first response that
    /// did not come at once; of a drive, whose steps are to be of the same round, to the end. Whether the round is through.
    bool read_on(open_line& line, unit_address unit);
    /// The next turn begins a round.
    void begin_anew() { left_ = 0; }
    /// Whether the last turn asked for it.
    bool is_of_last_turn(place const& where) const { return last_turn_.contains(run_of(where)); }
    /// Whether a request of the last turn was sent again, or had to wait for what the unit owes.
    bool was_repeated() const { return was_repeated_; }

    /// What the last round read of a place that was chosen.
    held_words const& held(place const& where) const;
    /// Of a single holding register.
    rtuwire::result<std::uint16_t> at(std::uint16_t address) const;
    /// The same by mnemonic, as values and limits want it.
    known_words known() const;

    /// Why it could not be read, in words; of one that could, nothing.
    std::string why_not(std::uint16_t address) const { return held({address}).failure; }

    /// Why the last round lacks something; none where it is whole.
    rtuwire::errc first_error() const { return first_error_; }
    /// The same in words.
    std::string const& first_failure() const { return first_failure_; }

private:
    /// The registers of one value, or one bit: they come by one response.
    struct run {
        register_space space;
        std::uint16_t start;
        std::uint16_t count;

        unsigned end() const { return start + unsigned{count}; }
        friend auto operator<=>(run const&, run const&) = default;
    };
    /// The runs of one request.
    using block = std::vector<run>;

    /// Nothing of it could be read.
    void fail(block const& which, rtuwire::errc why, std::string const& failure);
    static run run_of(place const& where);
    static run whole(block const& which);
    void add(run const& one);
    /// Whether a request over both meets only registers that somebody asked for, or that the drive has.
    bool may_reach(run const& from, run const& to) const;
    unsigned limit_of(register_space space) const;
    rtuwire::errc ask(open_line& line, unit_address unit, block const& which);
    rtuwire::errc read_parts(open_line& line, unit_address unit, block const& which, std::vector<block>& learned);
    void begin_turn();
    rtuwire::errc read_next(open_line& line, unit_address unit, bool ends_at_silence);

    drive_catalog const* drive_;
    named_places const* names_;
    std::vector<block> blocks_{};
    std::size_t left_{0}; ///< of the round, which are first
    unsigned asked_{0};
    std::map<run, held_words> held_{};
    std::set<run> last_turn_{};
    bool was_repeated_{false};
    rtuwire::errc first_error_{};
    std::string first_failure_{};
};

} // namespace tool
