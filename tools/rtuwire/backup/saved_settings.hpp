// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// The parameters of a drive at some time, as a file has them or as they were read: each register once, with its word, or
// why there is none.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "backup/saved_text.hpp"
#include "catalog/catalog.hpp"

namespace tool {

/// One parameter. It has a word or an error.
struct saved_parameter {
    register_entry const* entry;
    std::optional<std::uint16_t> word;
    std::string error{}; ///< why the drive did not tell it
    text_place place{};  ///< of its value in a file
};

struct saved_settings {
    drive_catalog const* drive{nullptr};
    std::vector<std::pair<std::string, std::string>>
        head{}; ///< "vendor", "product", "time" and so on, as they are shown
    std::vector<saved_parameter> parameters{};

    [[nodiscard]] saved_parameter const* find(std::string_view code) const noexcept;
    [[nodiscard]] std::optional<std::uint16_t> word_of(std::string_view code) const noexcept;
};

/// Why a file is none of this program's, or has lost rows; nothing where it may be read. A backup says how many rows it has.
[[nodiscard]] std::optional<file_fault> why_no_whole_backup(saved_text const& text);

/// A number as other languages write it: "12,5" is 12.5. Nothing else has a comma.
[[nodiscard]] std::string with_point(std::string text);

/// A file's settings, or the first thing that is wrong in it.
struct settings_reading {
    saved_settings settings{};
    std::vector<file_fault> left_out{}; ///< rows of registers that this program does not know, and never writes
    std::optional<file_fault> fault{};
};

/// What the rows of a file mean. Refuses registers that the drive does not have or that stand twice, counts that no word
/// holds, a value that contradicts its raw count. A row with the address of a register that is not known stays out: a backup
/// of another version of this program may have read it. `drive` is what --drive says: it is needed where the file names none.
[[nodiscard]] settings_reading settings_in(saved_text const& text, std::string_view drive);

/// The word that a parameter's value stands for: 12.5 or "12,5 Hz", "SEP", "0x0237". `set_by` is what the register holds
/// that sets its steps. A sentence says what is wrong.
struct value_reading {
    std::optional<std::uint16_t> word{};
    std::string sentence{};
};
[[nodiscard]] value_reading read_saved_value(register_entry const& entry, drive_catalog const& drive,
                                             std::string const& value, std::string const& unit,
                                             std::optional<std::uint16_t> set_by);

/// A file's value of a word: what `read_saved_value` reads. Empty where a word has no value that can be written.
struct saved_value {
    std::string text{};
    bool is_number{false};
    std::string unit{};
};
[[nodiscard]] saved_value value_to_save(register_entry const& entry, drive_catalog const& drive, std::uint16_t word,
                                        std::optional<std::uint16_t> set_by);

} // namespace tool
