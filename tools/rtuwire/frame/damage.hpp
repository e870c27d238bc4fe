// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// What has become of bytes that are no frame, as far as they tell it themselves.
#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include <rtuwire/frames.hpp>

#include "words/option_words.hpp"

namespace tool {

/// A message of Modbus TCP: its header, and behind it a unit and a PDU without a CRC.
struct tcp_message {
    unsigned transaction;
    rtuwire::byte_view frame; ///< unit and PDU
};

/// These bytes as one, where their header says so.
[[nodiscard]] std::optional<tcp_message> tcp_message_in(rtuwire::byte_view bytes);

/// Whether these bytes have the check of Modbus ASCII behind them, and a function's form in front.
[[nodiscard]] bool is_ascii_message(rtuwire::byte_view bytes);

/// Whether these bytes are the characters of Modbus ASCII.
[[nodiscard]] bool are_ascii_characters(rtuwire::byte_view bytes);

/// The cause and its remedy, of bytes whose CRC is wrong or that are too few: "its first 2 bytes are missing ...". Empty where
/// they tell none. `asked`: the request that they came to, empty where it is not known.
[[nodiscard]] std::string cause_of_damage(rtuwire::byte_view bytes, rtuwire::byte_view asked = {},
                                          option_form form = option_form::typed);

} // namespace tool
