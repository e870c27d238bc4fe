// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A file that is there as a whole, or as it was before.
#pragma once

#include <string>
#include <string_view>

namespace tool {

/// Writes a text to a file beside it, and puts that in its place once all of it is on the disk. Why not; empty where it was
/// written. A device, a pipe or a folder of that name is refused.
std::string write_whole_file(std::string const& path, std::string_view text);

/// The same for a file that is not there yet.
std::string write_new_file(std::string const& path, std::string_view text);

} // namespace tool
