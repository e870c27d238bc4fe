// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A register file out of another program's: told apart by what is in it, not by its name.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "device/register_file_writer.hpp"

namespace tool {

struct import_choices {
    std::optional<std::int64_t> base{}; ///< is added to each address of a form that counts from a place of its own
    std::optional<std::int64_t> unit{}; ///< whose registers, where a file has several
};

/// Ends the command where the file is none of these forms, or broken.
[[nodiscard]] register_file_writer import_file(std::string const& file, std::string const& text,
                                               import_choices const& how);

} // namespace tool
