// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
#include "check/profile.hpp"

#include <algorithm>
#include <cstdio>
#include <utility>

#include "exit_status.hpp"
#include "files/regular_file.hpp"
#include "files/toml_file.hpp"
#include "output/plain_text.hpp"
#include "words/suggestion.hpp"

namespace tool {

namespace {

std::vector<unsigned> functions_in(std::string const& file, toml::node const& from)
{
    toml::array const* const list = from.as_array();
    if (list == nullptr) {
        refuse_at(file, from.source(), "functions is a list of numbers: [3, 6, 0x10]");
    }
    std::vector<unsigned> all;
    for (toml::node const& each : *list) {
        auto const number = each.value_exact<std::int64_t>();
        if (not number or *number < 1 or *number > 127) {
            refuse_at(file, each.source(), "a function is a number from 1 to 127");
        }
        all.push_back(static_cast<unsigned>(*number));
    }
    return all;
}

/// Clause and reason.
std::pair<std::string, std::string> deviation_in(std::string const& file, toml::key const& key, toml::node const& value)
{
    std::vector<std::string_view> ids;
    for (clause const& each : all_clauses()) {
        ids.push_back(each.id);
    }
    std::string const id{key.str()};
    if (value.is_table()) {
        refuse_at(file, key.source(), "the name of a clause with a point is written in quotation marks: \"F03.5\"");
    }
    if (std::ranges::count(ids, std::string_view{id}) == 0) {
        refuse_at(file, key.source(), "'" + id + "' is no clause" + suggestion(id, ids) + " check --list names all");
    }
    auto const reason = value.value_exact<std::string>();
    if (not reason or reason->empty()) {
        refuse_at(file, value.source(), id + " has a reason: a text");
    }
    return {id, *reason};
}

} // namespace

check_profile::check_profile(std::string file) : file_{std::move(file)}
{
    if (file_.empty()) {
        return;
    }
    file_text const found = text_of_file(file_);
    if (not found.failure.empty()) {
        refuse_word("--profile " + file_ + ": " + found.failure);
    }
    toml::table const all = plain_toml_in(file_, found.text);
    check_keys(file_, all, {"functions", "deviations"});
    if (toml::node const* const functions = all.get("functions")) {
        functions_ = functions_in(file_, *functions);
    }
    if (toml::node const* const deviations = all.get("deviations")) {
        if (not deviations->is_table()) {
            refuse_at(file_, deviations->source(), "deviations are a table: a line for each clause below [deviations]");
        }
        for (auto const& [key, value] : *deviations->as_table()) {
            known_.insert(deviation_in(file_, key, value));
        }
    }
}

judgement check_profile::judged(judgement found, std::string_view clause)
{
    auto const listed = known_.find(clause);
    if (listed != known_.end() and found.how == verdict::fails) {
        found.how = verdict::known;
        found.why = listed->second + ": " + found.why;
        met_ += (met_.empty() ? "" : ", ") + listed->first;
    } else if (listed != known_.end() and found.how == verdict::holds) {
        gone_ += (gone_.empty() ? "" : ", ") + listed->first;
    }
    return found;
}

void check_profile::tell() const
{
    if (not met_.empty()) {
        std::fprintf(stderr, "known deviations by %s: %s\n", plain_text(file_).c_str(), met_.c_str());
    }
    if (not gone_.empty()) {
        std::fprintf(stderr, "note: no deviation any more, remove it from %s: %s\n", plain_text(file_).c_str(),
                     gone_.c_str());
    }
}

} // namespace tool
