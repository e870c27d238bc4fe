// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Times as messages carry them: UTC, by ISO 8601.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace tool::gateway {

/// "2026-11-30T01:02:03.456Z".
[[nodiscard]] std::string utc_text(std::uint64_t unix_microseconds);

/// Microseconds since 1970 of "2026-11-30T01:02:08Z", "2026-11-30T01:02:08.25+01:00"; nothing where it is no such time. A time
/// without its zone is none.
[[nodiscard]] std::optional<std::uint64_t> time_in(std::string_view text);

} // namespace tool::gateway
