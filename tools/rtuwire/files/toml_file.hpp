// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// TOML that somebody wrote: what is wrong in it ends the command, with its line and column.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace tool {

/// What the parser asserts of its text does not hold: that of Debian 12 asserts that a header has a name.
struct toml_assertion {};

[[noreturn]] inline void refuse_assertion() { throw toml_assertion{}; }

} // namespace tool

// With NDEBUG the parser would believe what it asserts.
#pragma push_macro("NDEBUG")
#undef NDEBUG
#define TOML_ASSERT(expr) ((expr) ? static_cast<void>(0) : ::tool::refuse_assertion())
#define TOML_HEADER_ONLY 1
#define TOML_EXCEPTIONS 0
#define TOML_ENABLE_FORMATTERS 0
#include <toml++/toml.h>
#pragma pop_macro("NDEBUG")

namespace tool {

/// Bytes; a longer text is refused before it is looked at.
inline constexpr std::size_t longest_toml = 1U << 20U;

/// "meter.toml:2:8: name is a text".
[[noreturn]] void refuse_at(std::string const& file, toml::source_region const& where, std::string const& why);

/// What to say of a line that has a text without its quotation marks, or with one of them: `format = 8E1`. Else nothing.
std::string hint_at_text(std::string_view text, toml::source_region const& where);

toml::table toml_in(std::string const& file, std::string const& text);

/// Refuses a key that is none of these, with the nearest of them.
void check_keys(std::string const& file, toml::table const& from, std::vector<std::string_view> const& known,
                std::string_view what = "key here");

} // namespace tool
