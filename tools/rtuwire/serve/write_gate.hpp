// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// What a client may ask of whom, by its bytes alone: before anything else is looked at.
#pragma once

#include <cstdint>
#include <optional>
#include <set>
#include <string>

#include <rtuwire/frames.hpp>

#include "words/option_words.hpp"

namespace tool {

struct gate_rules {
    std::optional<std::set<std::uint8_t>> units{};     ///< nothing: all of 1 to 247
    std::optional<std::set<std::uint8_t>> functions{}; ///< nothing: all
    bool may_write{false};
    bool may_broadcast{false};
    option_form form{option_form::of_serve}; ///< by which a message names what would let a request pass
};

struct gate_verdict {
    rtuwire::errc refused{rtuwire::errc::none}; ///< the exception that is answered; none where the request goes on
    std::string kind{};     ///< "unit", "function", "write", "broadcast", "malformed": a word for programs
    std::string why{};      ///< and for people, what would let it pass
    bool only_reads{false}; ///< of what goes on; all else is judged by the unit, too
};

[[nodiscard]] gate_verdict judge_request(gate_rules const& rules, std::uint8_t unit, rtuwire::byte_view pdu);

} // namespace tool
