// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// How many columns of a terminal a text in UTF-8 takes.
#pragma once

#include <cstddef>
#include <string_view>

namespace tool {

/// The bytes of the first character of a text that is not empty; of what is no UTF-8, the first byte at least.
std::string_view first_character(std::string_view text);

/// Two for each character of East Asia and for pictures, none for what stands on the letter before it, one for all else.
std::size_t width_of(std::string_view text);

} // namespace tool
