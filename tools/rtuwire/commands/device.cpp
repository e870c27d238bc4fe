// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Checks register files: no line is needed.
#include <array>
#include <charconv>
#include <string>

#include "commands/commands.hpp"
#include "device/register_file.hpp"
#include "words/named_value.hpp"

namespace tool {

namespace {

/// "setting, moves, no value at 0x7FFF".
std::string notes_of(named_place const& each)
{
    std::string notes;
    auto const add = [&notes](bool is_so, std::string const& what) {
        notes += is_so ? (notes.empty() ? "" : ", ") + what : std::string{};
    };
    add(each.is_setting, "setting");
    add(each.is_stored, "stored");
    add(each.moves, "moves");
    for (std::uint64_t const number : each.invalid) {
        std::array<char, 32> text{};
        auto const end = std::to_chars(text.data(), text.data() + text.size(), number, 16).ptr;
        add(true, "no value at 0x" + upper({text.data(), end}));
    }
    return notes;
}

record row_of(named_place const& each)
{
    place bare = each.where;
    bare.name.clear();
    auto const limit = [](std::optional<double> const& number) { return number ? cell{*number} : cell{}; };
    return {{"register", each.where.name},
            {"place", text_of(bare)},
            {"access", std::string{each.is_writable ? "read, write" : "read only"}},
            {"lowest", limit(each.lowest)},
            {"highest", limit(each.highest)},
            {"choices", list_of_choices(each)},
            {"group", each.group},
            {"note", notes_of(each)}};
}

} // namespace

exit_status run_device(choices const& chosen)
{
    if (chosen.words.front() != "check" or chosen.words.size() < 2) {
        refuse_word("device checks register files: device check FILE");
    }
    output results{chosen.form, false};
    for (std::size_t i = 1; i < chosen.words.size(); ++i) {
        for (named_place const& each : register_file_at(chosen.words[i]).places) {
            results.put(row_of(each));
        }
    }
    results.finish();
    return exit_status::done;
}

} // namespace tool
