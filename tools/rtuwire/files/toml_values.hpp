// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Values of the tables of one file: of the right kind and within their limits, or refused with their line and column.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "files/toml_file.hpp"

namespace tool {

class toml_values {
public:
    /// The name of the file, which lives longer.
    explicit toml_values(std::string const& file) : file_{file} {}

    [[nodiscard]] std::string const& file() const { return file_; }

    [[noreturn]] void refuse(toml::source_region const& where, std::string const& why) const
    {
        refuse_at(file_, where, why);
    }

    /// A table of the file; null where it has none. `name`: as its header has it, "line.serve".
    [[nodiscard]] toml::table const* table_in(toml::table const& from, std::string_view name) const;

    /// The tables behind [[name]]; null where there are none. Refuses what is something else, and more than `most`.
    [[nodiscard]] toml::array const* tables_in(toml::table const& from, std::string_view name, std::size_t most) const;

    /// A whole number within limits; nothing where a table has none.
    [[nodiscard]] std::optional<unsigned> whole_in(toml::table const& from, std::string_view key, unsigned lowest,
                                                   unsigned highest) const;

    /// False where a table does not say.
    [[nodiscard]] bool flag_in(toml::table const& from, std::string_view key) const;

    /// A text of one table; nothing where it has none.
    [[nodiscard]] std::optional<std::string> text_in(toml::table const& from, std::string_view key) const;

    /// A number of one table, as it may be typed; nothing where it has none.
    [[nodiscard]] std::optional<double> number_in(toml::table const& from, std::string_view key) const;

private:
    std::string const& file_;
};

} // namespace tool
