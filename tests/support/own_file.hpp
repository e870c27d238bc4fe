// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Lists that tests read when they run. Where they are says one small file that the build writes: all others are the same in
// every clone, so that a compiler's cache knows them.
#pragma once

#include <string>

namespace rtuwire::test {

extern char const* const folder_of_tests;

/// The path of a file, given from tests/.
inline std::string own_file(std::string const& name) { return std::string{folder_of_tests} + "/" + name; }

} // namespace rtuwire::test
