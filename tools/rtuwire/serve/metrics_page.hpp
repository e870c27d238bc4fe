// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// One request of HTTP, of which there is only GET /metrics. Knows no socket.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <string_view>

namespace tool {

inline constexpr std::size_t longest_http_request = 4'096;

/// The whole response to what has come; nothing while the request is not whole. `metrics` makes the text.
[[nodiscard]] std::optional<std::string> http_response(std::string_view came,
                                                       std::function<std::string()> const& metrics);

} // namespace tool
