// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A message on `set/NAME`: which of them may be acted upon, and what it asks for; and the answer to it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "setting_request.hpp"

namespace tool::gateway {

inline constexpr std::size_t longest_setting_message = 1'024; ///< bytes

/// What a connection knows of a message besides its bytes.
struct message_arrival {
    std::uint64_t time;      ///< microseconds since 1970
    bool is_retained{false}; ///< the broker kept it: nobody knows since when
    bool is_connected{true}; ///< it came once the connection was complete
};

struct setting_message {
    std::optional<setting_result> refused{}; ///< refused or expired; nothing where it may be written
    std::string why{};                       ///< in words
    std::string id{};                        ///< JSON: "\"a1\"", "7", "null" where it has none
    std::string value{};                     ///< as it is typed: "21.5", "on"
    std::uint64_t expires{0};                ///< microseconds since 1970
};

/// Reads a message. What is retained, has no time at which it expires, is late or too far ahead is none to be acted upon.
[[nodiscard]] setting_message read_setting_message(std::string_view payload, message_arrival const& arrival);

/// {"id":"a1","result":"done","why":"…","time":"…"}.
[[nodiscard]] std::string answer_text(std::string const& id, setting_result result, std::string_view why,
                                      std::uint64_t time);

} // namespace tool::gateway
