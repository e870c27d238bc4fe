// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// The command line and the configuration file.
#pragma once

#include <optional>
#include <string>

#include "choices.hpp"
#include "exit_status.hpp"

namespace tool {

/// Either what was chosen, or how the program ends at once: help was shown, or a word refused.
struct parsed {
    std::optional<choices> chosen{};
    exit_status status{exit_status::done};
};

/// Shows help on standard output, complaints on the error output.
parsed parse(int argc, char** argv);

} // namespace tool
