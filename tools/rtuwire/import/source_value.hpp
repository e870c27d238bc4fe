// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A file of another program as a tree of texts with their places, whether it is JSON, YAML or TOML. None is deep, none has
// many values, and none refers to itself.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "files/text_place.hpp"

namespace tool {

enum class source_kind : std::uint8_t { none, truth, number, text, list, table };

struct source_value {
    source_kind kind{source_kind::none};
    text_place place{};
    std::string text{};                                         ///< of a truth, a number or a text, as it is written
    std::string tag{};                                          ///< of YAML: "!lambda"
    std::vector<std::pair<std::string, source_value>> fields{}; ///< of a table; of a list without names

    /// A field of a table; null where it has none, or one that says nothing.
    [[nodiscard]] source_value const* find(std::string_view name) const noexcept;
    /// The text of a field that is a truth, a number or a text; empty where there is none.
    [[nodiscard]] std::string text_of(std::string_view name) const;
    [[nodiscard]] bool is_true(std::string_view name) const;
    /// A number, also one that is written as a text: 16, "0x10", 0.1.
    [[nodiscard]] std::optional<double> number() const;
    [[nodiscard]] std::optional<std::int64_t> whole_number() const;
    [[nodiscard]] bool is_plain() const noexcept { return kind >= source_kind::truth and kind <= source_kind::text; }
};

constexpr std::size_t most_source_bytes = 4U << 20U;

/// Each ends the command at the first thing that is wrong, with its line and column.
[[nodiscard]] source_value json_source(std::string const& file, std::string_view text);
[[nodiscard]] source_value yaml_source(std::string const& file, std::string const& text);
[[nodiscard]] source_value toml_source(std::string const& file, std::string const& text);

/// Builds a tree out of what a parser meets one after the other.
class source_builder {
public:
    explicit source_builder(std::string const& file) : file_{file} {}

    void begin(source_kind kind, text_place place, std::string tag = {});
    void end();
    void add(source_value value);
    /// The name of what comes next, in a table.
    void name(std::string text);
    [[nodiscard]] bool is_in_table() const noexcept
    {
        return not open_.empty() and open_.back().second.kind == source_kind::table;
    }
    [[nodiscard]] bool has_name() const noexcept { return has_name_; }
    [[nodiscard]] source_value take() { return std::move(whole_); }

private:
    void count(text_place place);

    std::string const& file_;
    std::vector<std::pair<std::string, source_value>> open_{}; ///< with their names
    source_value whole_{};
    std::string name_{};
    bool has_name_{false};
    std::size_t values_{0};
};

} // namespace tool
