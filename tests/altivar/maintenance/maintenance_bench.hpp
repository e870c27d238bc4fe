// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A client and a drive on paper at the two ends of a line, and what a restore told.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "altivar/maintenance/small_map.hpp"

#include <rtuwire/altivar/maintenance/restore.hpp>
#include <rtuwire/sim/bench.hpp>

namespace rtuwire::test {

inline constexpr station<altivar::atv320::device> paper_station{unit_id{7}};
inline constexpr line_timing paper_line{19'200, character_format::even_8_1};

/// Words by mnemonics.
using word_list = std::map<std::string, std::uint16_t>;

inline std::string text_of(literal from) { return {from.begin(), from.end()}; }

/// The words as a restore wants them.
struct words_by_code {
    word_list const* words;

    std::optional<std::uint16_t> operator()(altivar::parameter const& row) const
    {
        auto const found = words->find(text_of(row.code));
        return found == words->end() ? std::nullopt : std::optional{found->second};
    }
};

/// What was told of each parameter, in order.
struct told_list {
    std::map<std::string, std::vector<altivar::restore_report>> of;
    std::vector<std::string> written; ///< in the order of the writes

    void operator()(altivar::parameter const& row, altivar::restore_report const& what)
    {
        of[text_of(row.code)].push_back(what);
        if (what.outcome == altivar::restore_outcome::written or
            what.outcome == altivar::restore_outcome::not_read_back) {
            written.push_back(text_of(row.code));
        }
    }
    [[nodiscard]] altivar::restore_report last(std::string const& code) const { return of.at(code).back(); }
};

/// The line, with a client that commands.
template <std::size_t Identity = 320> struct paper_bench {
    paper_drive& drive;
    sim::bench<drive_client<4>, detail::bank_unit<paper_drive>> line;

    explicit paper_bench(paper_drive& its_drive, std::uint8_t retries = 2)
        : drive{its_drive}, line{drive_client<4>{paper_line, client_options{.response_timeout = milliseconds(100),
                                                                            .retries = retries}},
                                 bank_at{unit_id{7}, drive, paper_identity<Identity>::profile}}
    {}

    /// Restores words; what it told is added to `told`.
    altivar::reason restore(word_list const& words, told_list& told, altivar::restore_options const& options,
                            char const (&family)[7] = "atv320")
    {
        auto const report = [&](altivar::parameter_group const&, altivar::parameter const& row,
                                altivar::restore_report const& what) { told(row, what); };
        altivar::restore conversation{
            paper_station, small_map,
            altivar::wanted_settings{altivar::drive_family::of(literal{family}), words_by_code{&words}}, report,
            options};
        altivar::reason const how = line.run(conversation, milliseconds(600'000));
        written = conversation.written();
        failed = conversation.failed();
        saved = conversation.saved();
        return how;
    }

    unsigned written{0};
    unsigned failed{0};
    bool saved{false};
};

/// A configuration that differs from the drive in everything that can be restored.
inline word_list other_words()
{
    return {{"CFG", 2},  {"TFR", 900}, {"HSP", 800}, {"LSP", 700},    {"ACC", 55},  {"DEC", 66}, {"INR", 2},
            {"SP2", 11}, {"SP3", 12},  {"SP4", 13},  {"SP6", 14},     {"FLR", 1},   {"ATR", 1},  {"SLL", 0},
            {"TTO", 50}, {"CHCF", 2},  {"FR1", 1},   {"CD1", 1},      {"FLO", 129}, {"TCC", 1},  {"NST", 130},
            {"ADD", 9},  {"TBR", 28},  {"TFO", 4},   {"NCV", 99},     {"TUN", 1},   {"CMD", 15}, {"CMI", 3},
            {"LFR", 99}, {"TAC", 0},   {"STOA", 1},  {"ETA", 0x0237}, {"RFR", 1},   {"IL1R", 1}};
}

/// Everything may be written.
inline constexpr altivar::restore_options all_of_it{.with_channels = true,
                                                    .with_link = true,
                                                    .with_inferred = true,
                                                    .with_supervision = true,
                                                    .with_autorestart = true};
inline constexpr altivar::restore_options ordinary_ones{.with_inferred = true};

} // namespace rtuwire::test
