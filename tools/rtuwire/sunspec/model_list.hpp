// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Units that carry SunSpec's mark, and the models that stand behind it.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "line/open_line.hpp"

namespace tool {

struct sunspec_model {
    std::uint16_t id;
    std::uint16_t address; ///< of its number, which its length follows
    std::uint16_t length;  ///< of what stands behind both
};

struct sunspec_models {
    std::optional<std::uint16_t> mark{}; ///< where "SunS" stands; nothing where it does not
    std::vector<sunspec_model> models{};
    std::string failure{}; ///< why the list ends early, or no mark was looked for
    exit_status outcome{exit_status::done};
};

/// Looks for the mark at 40000, 0 and 50000, and walks from model to model. It only reads.
[[nodiscard]] sunspec_models sunspec_models_of(open_line& line, unit_address unit);

/// "SunSpec at 40000: model 1 at 40002, 66 registers; ..."
[[nodiscard]] std::string text_of(sunspec_models const& found);

} // namespace tool
