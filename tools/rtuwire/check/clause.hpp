// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// What a server of Modbus RTU is held to, and a client: a row a clause. An id never changes and is never used again.
#pragma once

#include <span>
#include <string_view>

namespace tool {

enum class clause_level {
    must,   ///< the specification leaves no choice; these alone decide the exit status
    should, ///< the specification, or a device's user, wants it; a device may have a reason
    may,    ///< told, never judged
};

/// What is established before a clause.
enum class clause_state {
    quiet, ///< 1 s without a byte
    known, ///< quiet, and a plain read that is answered
    words, ///< the same, and the scratch registers hold 5A00h, 5A01h, ...
    coils, ///< the same, and the scratch coils are off
    last,  ///< judges what came in the whole run
};

struct clause {
    std::string_view id;
    std::string_view group;
    clause_level level;
    std::string_view source;
    std::string_view needs; ///< words of `why_not_asked`
    clause_state state;
    std::string_view sends; ///< in the words of `clause_words.hpp`, " / " between steps; for people behind an @
    std::string_view comes; ///< the same, as many steps
    std::string_view harm;  ///< what breaks in the field where it does not hold
    std::string_view applies;
};

/// Of a server, in the order in which they are asked, but for those that come last.
std::span<clause const> all_clauses();

/// Of a client: `sends` is what it is told to ask, `comes` what it is answered, in the words of `client_table.cpp`, and
/// `applies` what is judged: what it prints of each request, and how it sends them.
std::span<clause const> all_client_clauses();

/// A word of what a client is answered.
struct client_word {
    std::string_view word;
    std::string_view meaning;
};

std::span<client_word const> client_words();

inline constexpr std::string_view client_group{"client"};

} // namespace tool
