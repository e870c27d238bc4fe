// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// The clauses of a run: which are wanted, each verdict as it is found, and what is said at the end.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "check/report.hpp"
#include "choices.hpp"
#include "exit_status.hpp"
#include "output/progress.hpp"

namespace tool {

/// Those of "L07,F03,I", all for an empty text. Refuses a text that names none.
std::vector<clause const*> wanted_clauses(std::span<clause const> all, std::string const& only);

class told_verdicts {
public:
    told_verdicts(choices const& chosen, std::vector<clause const*> clauses);

    /// On the terminal, while it is tried.
    void begin(clause const& which);
    /// A table shows what fails and what is told; everything else all.
    void add(judged_clause row);
    /// Nothing comes behind it.
    void end();
    /// How many of each, and the file for other programs, which has all clauses, those behind a signal as well; 1 where a must
    /// fails. `what` was checked.
    exit_status tell(std::string const& what) const;

private:
    std::vector<judged_clause> all_rows() const;

    choices const& chosen_;
    std::vector<clause const*> clauses_;
    output results_;
    progress bar_;
    std::vector<judged_clause> rows_{};
};

} // namespace tool
