// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
#include "check/told_verdicts.hpp"

#include <algorithm>
#include <cstdio>
#include <utility>

#include "line/end_wish.hpp"
#include "output/plain_text.hpp"

namespace tool {

namespace {

bool is_wanted(clause const& which, std::string const& only)
{
    if (only.empty()) {
        return true;
    }
    for (std::size_t from = 0; from <= only.size();) {
        std::size_t const end = std::min(only.find(',', from), only.size());
        std::string_view const word = std::string_view{only}.substr(from, end - from);
        // A clause, a function's or a group's letter: F03.1, F03, F.
        bool const is_part = which.id.starts_with(word) and
                             (which.id.size() == word.size() or which.id[word.size()] == '.' or word.size() == 1);
        if (not word.empty() and is_part) {
            return true;
        }
        from = end + 1;
    }
    return false;
}

} // namespace

std::vector<clause const*> wanted_clauses(std::span<clause const> all, std::string const& only)
{
    std::vector<clause const*> wanted;
    for (clause const& each : all) {
        if (is_wanted(each, only)) {
            wanted.push_back(&each);
        }
    }
    if (wanted.empty()) {
        refuse_word("--only " + only + ": no clause is called so; --list names all");
    }
    // Clang 14 cannot use the one of std::ranges.
    std::stable_partition(wanted.begin(), wanted.end(),
                          [](clause const* each) { return each->state != clause_state::last; });
    return wanted;
}

told_verdicts::told_verdicts(choices const& chosen, std::vector<clause const*> clauses)
    : chosen_{chosen}, clauses_{std::move(clauses)}, results_{chosen.form, true}, bar_{clauses_.size()}
{}

void told_verdicts::begin(clause const& which) { bar_.show(rows_.size(), ": " + std::string{which.id}); }

void told_verdicts::add(judged_clause row)
{
    bar_.clear();
    bool const is_shown = chosen_.form != output_form::table or row.found.how == verdict::fails or
                          row.found.how == verdict::told or row.found.how == verdict::known;
    if (is_shown) {
        results_.put(record_of(row, chosen_.form), row.found.how == verdict::fails);
    }
    rows_.push_back(std::move(row));
}

void told_verdicts::end()
{
    bar_.clear();
    results_.finish();
}

std::vector<judged_clause> told_verdicts::all_rows() const
{
    std::vector<judged_clause> all = rows_;
    for (std::size_t i = rows_.size(); i < clauses_.size(); ++i) {
        std::string const why = "ended by signal " + std::to_string(noted_signal());
        all.push_back({clauses_[i], {verdict::not_tried, why, {}}, i == rows_.size()});
    }
    return all;
}

exit_status told_verdicts::tell(std::string const& what) const
{
    auto const count = [this](verdict how, auto... level) {
        return std::ranges::count_if(rows_, [&](judged_clause const& each) {
            return each.found.how == how and ((each.which->level == level) and ...);
        });
    };
    auto const fails = count(verdict::fails, clause_level::must);
    std::fprintf(stderr, "%zd clauses hold, %zd musts and %zd shoulds fail, %zd do not apply, %zd were not tried\n",
                 count(verdict::holds), fails, count(verdict::fails, clause_level::should),
                 count(verdict::does_not_apply), count(verdict::not_tried));
    auto const hidden = std::ranges::find_if(rows_, [](judged_clause const& each) {
        return each.found.is_hidden and each.which->level == clause_level::must;
    });
    if (fails == 0 and hidden != rows_.end()) {
        tell_error(std::string{hidden->which->id} + " was not tried: " + hidden->found.why);
    }
    if (noted_signal() != 0) {
        std::fprintf(stderr, "ended after %zu of %zu clauses\n", rows_.size(), clauses_.size());
    }
    if (not chosen_.check.junit.empty()) {
        write_junit(chosen_.check.junit, what, all_rows());
    }
    if (noted_signal() != 0) {
        return static_cast<exit_status>(128 + noted_signal());
    }
    return fails > 0 or hidden != rows_.end() ? exit_status::differs : exit_status::done;
}

} // namespace tool
