// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// The drives of a simulated line as a person names them: "atv320:7,atv12:3"; devices by their register files, "meter.toml:61".
// Without a number it is unit 1.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "port/port_word.hpp"

namespace tool {

/// The drives; or why they are refused, and the nearest right words.
struct simulated_words {
    std::vector<simulated_drive_choice> drives;
    std::string why{}; ///< empty where nothing is wrong
    std::string nearest{};
};

[[nodiscard]] simulated_words read_simulated_drives(std::string_view words);

} // namespace tool
