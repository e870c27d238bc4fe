// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// What the lists of registers say of a drive (tests/parameters/facts.tsv), read when the test runs: the simulation is made
// of the headers' rows, and is held against these.
#pragma once

#include "support/catch.hpp"
#include "support/own_file.hpp"

#include <charconv>
#include <cstdint>
#include <fstream>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace rtuwire::test {

/// One line of the lists; what it does not tell is empty.
struct fact {
    std::string code;
    std::uint16_t address{0};
    std::string access; ///< r, rw, conf
    std::string kind;   ///< u16, i16, enum, bits
    std::optional<std::int32_t> least;
    std::optional<std::int32_t> most;
    std::string factory;                         ///< a count, or the mnemonic of a value
    std::map<std::uint16_t, std::string> values; ///< of an enumeration
    bool has_scale{false};

    [[nodiscard]] bool is_number() const { return kind == "u16" or kind == "i16"; }
    [[nodiscard]] bool is_writable() const { return access == "rw" or access == "conf"; }
};

inline std::vector<std::string> split(std::string_view text, char at)
{
    std::vector<std::string> parts;
    while (true) {
        std::size_t const end = text.find(at);
        parts.emplace_back(text.substr(0, end));
        if (end == std::string_view::npos) {
            return parts;
        }
        text.remove_prefix(end + 1);
    }
}

inline std::optional<std::int32_t> number_of(std::string_view text)
{
    std::int32_t number = 0;
    auto const [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    bool const is_whole = error == std::errc{} and end == text.data() + text.size();
    return is_whole ? std::optional{number} : std::nullopt;
}

inline fact fact_of(std::vector<std::string> const& columns)
{
    fact made{.code = columns[2],
              .address = static_cast<std::uint16_t>(*number_of(columns[3])),
              .access = columns[4],
              .kind = columns[5],
              .least = number_of(columns[8]),
              .most = number_of(columns[9]),
              .factory = columns[10],
              .values = {},
              .has_scale = not columns[7].empty() and columns[7] != "?"};
    if (made.kind == "enum" and not columns[11].empty()) {
        for (std::string const& each : split(columns[11], ';')) {
            std::size_t const sign = each.find('=');
            made.values[static_cast<std::uint16_t>(*number_of(each.substr(0, sign)))] = each.substr(sign + 1);
        }
    }
    return made;
}

/// Whether a line tells no more than that there is a register: it is no parameter. ETAD is one of those for driving.
inline bool tells_nothing(std::vector<std::string> const& columns)
{
    bool const has_scale = not columns[7].empty() and columns[7] != "?";
    bool is_empty = not has_scale and columns[2] != "ETAD";
    for (std::size_t const column : {4U, 6U, 8U, 9U, 10U, 11U}) {
        is_empty = is_empty and columns[column].empty();
    }
    return is_empty;
}

/// The lines of one drive in the public list; of the ATV310 those of its manual, too, for what only it has.
inline std::vector<fact> facts_of(std::string const& drive)
{
    std::ifstream file{own_file("parameters/facts.tsv")};
    std::map<std::uint16_t, fact> found;
    for (std::string line; std::getline(file, line);) {
        auto const columns = split(line, '\t');
        if (columns.size() == 12 and columns[1] == drive and not tells_nothing(columns)) {
            fact made = fact_of(columns);
            bool const is_public = columns[0] == "public";
            is_public ? found.insert_or_assign(made.address, made) : found.try_emplace(made.address, made);
        }
    }
    std::vector<fact> all;
    for (auto const& [address, each] : found) {
        all.push_back(each);
    }
    return all;
}

} // namespace rtuwire::test
