// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// What a restore has told of each parameter, in the order in which it came to them.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "backup/drive_restore.hpp"
#include "backup/saved_settings.hpp"

namespace tool {

using rtuwire::altivar::restore_outcome;

/// One parameter: what it held before anything was written, and the last that was told of it.
struct restored_parameter {
    register_entry const* entry;
    std::optional<std::uint16_t> before{};
    rtuwire::altivar::restore_report last{};
    bool was_written{false}; ///< what was sent may have reached the drive
};

class restore_record {
public:
    void note(register_entry const& entry, rtuwire::altivar::restore_report const& what);

    /// By the order in which they were written, or would be.
    [[nodiscard]] std::vector<restored_parameter> const& parameters() const noexcept { return parameters_; }
    [[nodiscard]] std::size_t count(restore_outcome outcome) const noexcept;

    /// How many the options left out.
    [[nodiscard]] std::size_t left_out() const noexcept;

    /// What was told of a mnemonic; null where nothing was.
    [[nodiscard]] restored_parameter const* find(std::string_view code) const noexcept;

private:
    std::vector<restored_parameter> parameters_{};
    std::map<std::uint16_t, std::size_t> places_{};
};

/// Whether something was sent, whatever became of it.
[[nodiscard]] bool is_write(restore_outcome outcome) noexcept;

/// Whether an outcome is worth a line: not that it holds what is wanted, is in no file, or is no setting at all.
[[nodiscard]] bool is_worth_a_line(restored_parameter const& of, saved_settings const& wanted) noexcept;

/// How a restore ended, for people.
[[nodiscard]] std::string sentence_of(rtuwire::altivar::reason const& why);

} // namespace tool
