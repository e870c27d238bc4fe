// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// One line of a result: named values, in the order in which they are shown.
#pragma once

#include <cstdint>
#include <initializer_list>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace tool {

/// Nothing, where a value is not known. A number is shown with the fewest digits that mean it, so whoever computes one divides
/// once, at the end: twelve steps of 0.1 A are 12 / 10.0.
using cell = std::variant<std::monostate, bool, std::int64_t, std::uint64_t, double, std::string>;

struct field {
    std::string name;
    cell value;
};

class record {
public:
    record() = default;
    record(std::initializer_list<field> fields) : fields_{fields} {}

    record& add(std::string name, cell value)
    {
        fields_.push_back({std::move(name), std::move(value)});
        return *this;
    }

    std::vector<field> const& fields() const { return fields_; }

private:
    std::vector<field> fields_{};
};

/// As a person reads it: nothing is an empty text.
std::string text_of_cell(cell const& value);

} // namespace tool
