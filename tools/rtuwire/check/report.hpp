// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// What a check found: a record a clause, and a file for the programs that collect test results.
#pragma once

#include <span>
#include <string>

#include "check/verdict.hpp"
#include "output/output.hpp"

namespace tool {

struct judged_clause {
    clause const* which;
    judgement found;
    bool is_cut{false}; ///< the run was ended in it: an error where programs read it, for nothing was found
};

/// With all bytes where programs read it.
record record_of(judged_clause const& each, output_form form);

/// "L07, must, SL 2.2: ..." with what is sent and what may come.
std::string explained(clause const& which);

/// A file of JUnit's form; ends where it cannot be written.
void write_junit(std::string const& path, std::string const& unit, std::span<judged_clause const> all);

} // namespace tool
