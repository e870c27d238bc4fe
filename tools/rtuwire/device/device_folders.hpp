// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Register files by their names: those of a user, and those that come with the program.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace tool {

/// The register file of that name in a folder; nothing where there is none.
[[nodiscard]] std::optional<std::string> device_file_named(std::string const& word);

/// The names of all of them, sorted.
[[nodiscard]] std::vector<std::string> device_file_names();

/// Where those that come with the program would be, if they are not there: "; ... looked for in ..., which is not there"; else
/// empty.
[[nodiscard]] std::string words_of_missing_folder();

/// The path of a register file. A word with a point or a slash is one; else it is the name of a file of a folder, without
/// ".toml". Refuses a name that no folder has, with the nearest.
[[nodiscard]] std::string path_of_device(std::string const& word);

} // namespace tool
