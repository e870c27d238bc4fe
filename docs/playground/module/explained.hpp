// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// Bytes explained in JSON, by the decoder of the command line tool; and bytes as a person types them.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "catalog/catalog.hpp"
#include "frame/decode.hpp"
#include "json.hpp"

namespace playground {

/// A decoded frame as an object.
void put_frame(json_text& to, tool::decoded_frame const& frame);

/// Hexadecimal digits in pairs, with "0x" before them, and anything between that is no letter and no digit.
struct typed_bytes {
    std::vector<std::byte> bytes{};
    std::string flaw{}; ///< what cannot be read, and where: there are no bytes then; empty where nothing is wrong
};
[[nodiscard]] typed_bytes read_typed(std::string_view text);

/// What was typed, explained: with its CRC where it lacks one.
[[nodiscard]] std::string explain_typed(std::string_view text, tool::drive_catalog const& drive);

} // namespace playground
