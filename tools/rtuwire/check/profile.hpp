// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// What somebody says of a device before it is checked: the functions that it has, and the clauses that it is known to break.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "check/verdict.hpp"

namespace tool {

class check_profile {
public:
    /// Of a file; empty without one. Ends the command where something in it is wrong, with its line.
    explicit check_profile(std::string file);

    std::vector<unsigned> const& functions() const { return functions_; }

    /// A clause that fails as it is known to is a known deviation, with its reason.
    judgement judged(judgement found, std::string_view clause);

    /// What was known, and what is none any more.
    void tell() const;

private:
    std::string file_;
    std::vector<unsigned> functions_{};                       ///< claimed
    std::map<std::string, std::string, std::less<>> known_{}; ///< clause and reason
    std::string met_{}, gone_{};                              ///< clauses
};

} // namespace tool
