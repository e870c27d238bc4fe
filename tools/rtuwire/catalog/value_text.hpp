// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// What a register holds, as people read it: "50.0 Hz", "SLF1: Modbus interrupted", "0x0237"; what rtuwire::text_of says
// of the same value where its type is known to the compiler. And the bits of a word in words, which it does not say.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "catalog/catalog.hpp"
#include "output/record.hpp"

namespace tool {

/// The step of a register. Where another register sets it, `setting` is what that one holds; nothing where that is
/// needed and not known, or is no step.
[[nodiscard]] std::optional<step_size> step_of(register_entry const& entry, drive_catalog const& drive,
                                               std::optional<std::uint16_t> setting = std::nullopt);

/// So many counts of a step: "-5.2", exact, with the digits of the step.
[[nodiscard]] std::string number_text(std::int64_t count, step_size step);

/// The same with the unit: "-5.2 Hz".
[[nodiscard]] std::string amount_text(std::int64_t count, step_size step, std::string_view unit);

/// What a word of a register means: an amount, an enumerator by its mnemonic and in words, bits as "0x0237".
[[nodiscard]] std::string text_of(register_entry const& entry, std::uint16_t word);
[[nodiscard]] std::string text_of(register_entry const& entry, std::uint16_t word, step_size step);

/// The bits that are 1: "ready to switch on, remote"; a bit without a name is "bit 12", and none is "none".
[[nodiscard]] std::string bits_text(register_entry const& entry, std::uint16_t word);

/// `text_of`, for bits with their words behind: "0x0237 (ready to switch on, ...)".
[[nodiscard]] std::string full_text(register_entry const& entry, std::uint16_t word);
[[nodiscard]] std::string full_text(register_entry const& entry, std::uint16_t word, step_size step);

/// A word for programs and for people.
struct register_value {
    cell value{};          ///< the amount in its unit, the enumerator, the bits as a number; nothing without a step
    std::string measure{}; ///< "Hz"
    std::string text{};    ///< `full_text`; without a step "30 steps of a size that UFR sets"
};
[[nodiscard]] register_value value_of(register_entry const& entry, std::uint16_t word, std::optional<step_size> step);

/// The same where another register may set the step, and `setting` is what that one holds: "30 steps" where that is not
/// known.
[[nodiscard]] std::string full_text_in(register_entry const& entry, std::uint16_t word, drive_catalog const& drive,
                                       std::optional<std::uint16_t> setting);

/// "0x0237".
[[nodiscard]] std::string hex_word(std::uint16_t word);

} // namespace tool
