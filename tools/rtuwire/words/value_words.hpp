// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// What a person types to write a register: `ACC=1.3s`, `CHCF=SEP`, `3104=60Hz`, `LFR=-50`, `CMI=save_to_eeprom`,
// `HSP=0x01F4`. All that the table forbids is refused here, before a frame leaves.
//
// A number without a unit counts in the unit of its register where that has its name: LFR=50 is 50 Hz. By its address
// such a register takes the unit (3104=50Hz) or a raw count, which is typed in hexadecimal or with a mark: HSP=0x01F4,
// 3104=#500.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "catalog/catalog.hpp"
#include "words/named_places.hpp"
#include "words/place.hpp"
#include "words/words.hpp"

namespace tool {

/// What the register of a mnemonic holds now, as a word; nothing where it has not been read.
using known_words = std::function<std::optional<std::uint16_t>(std::string_view code)>;

/// A value on its way to a register. It may be written where `is_ready()`.
struct value_to_write {
    place where{0};
    register_entry const* entry{nullptr}; ///< null where no table knows the address
    named_place const* named{nullptr};    ///< where it is written by its name in a register file
    std::vector<std::uint16_t>
        words{};                     ///< what stands on the wire; of a drive one; of bits they alone; of a coil 0 or 1
    std::string text{};              ///< the same for people: "1.3 s"
    bool is_with_previous{false};    ///< it goes in one request with the value before it
    std::optional<step_size> step{}; ///< of one count of a drive's register, where it is known
    /// Registers that set its limits or its step and have to be read first: read them, and check again.
    std::vector<register_entry const*> needed{};
    std::optional<refusal> refused{};

    [[nodiscard]] bool is_ready() const noexcept { return not refused and needed.empty(); }
    /// Whether the words of that place are it.
    [[nodiscard]] bool is_held_by(std::span<std::uint16_t const> held) const;
    /// What other words of that place are for people.
    [[nodiscard]] std::string text_of_words(std::span<std::uint16_t const> held) const;
};

/// Checks a word "REG=VALUE". Whatever can be refused without a request is refused at the first call, which knows
/// nothing; a second call has the words of the registers that the first one needed. Without a drive (null) there are
/// only places and their forms. Of a drive a place is one of its holding registers, whatever its form: the word that it
/// means is checked as the same raw count at the address is.
[[nodiscard]] value_to_write check_value(std::string_view word, vocabulary const& meant, known_words const& known = {});

/// The limits of a register for people: "10.0 Hz to TFR, which is not known", "0.0 s to 999.9 s".
[[nodiscard]] std::string limits_text(register_entry const& entry, step_size step, known_words const& known,
                                      drive_catalog const& drive);

} // namespace tool
