// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Text that a terminal only shows. A device may say anything of itself, and so may a file and whoever typed a word.
#pragma once

#include <string>
#include <string_view>

namespace tool {

/// The same text with everything that a terminal would act upon, and every byte that is no UTF-8, as "\\x1B".
[[nodiscard]] std::string plain_text(std::string_view text);

/// The same for the text of a JSON object, which keeps its meaning: "\\u007F".
[[nodiscard]] std::string plain_json(std::string_view text);

/// Says why a command ends, on the error output: "rtuwire: " and a plain text.
void tell_error(std::string_view text);

} // namespace tool
