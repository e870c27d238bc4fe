// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// Limits of registers with what other registers hold now.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "words/value_words.hpp"

namespace tool {

/// One end of what a register takes, in counts.
struct register_limit {
    std::optional<std::int32_t> count;           ///< nothing where it depends on a register that is not known
    std::vector<register_entry const*> needed{}; ///< those, whether known or not
    std::string set_by{};                        ///< "TFR", "1/2 INV"; empty for a number
    bool is_absurd{false};                       ///< by a register that holds what it cannot hold
};

[[nodiscard]] register_limit lowest_of(register_entry const& entry, drive_catalog const& drive,
                                       known_words const& known);
[[nodiscard]] register_limit highest_of(register_entry const& entry, drive_catalog const& drive,
                                        known_words const& known);

} // namespace tool
