// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// What a person is told of a restore: a row a parameter, with the values in words, and how many of each kind there are.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "backup/restore_record.hpp"
#include "backup/saved_settings.hpp"
#include "output/output.hpp"

namespace tool {

/// Words for the parameters of one file. A dry run, once it is noted, knows what the drive held before the first write.
class restore_view {
public:
    explicit restore_view(saved_settings const& wanted) noexcept : wanted_{wanted} {}

    void note_plan(restore_record const& plan) noexcept { plan_ = &plan; }

    /// A word in the steps of the file.
    [[nodiscard]] std::string wanted_text(register_entry const& entry, std::uint16_t word) const;

    /// A word in the steps that the drive had before the first write.
    [[nodiscard]] std::string held_text(register_entry const& entry, std::uint16_t word,
                                        restore_record const& among) const;

    /// What the drive held of a parameter before the first write.
    [[nodiscard]] std::optional<std::uint16_t> before_of(restored_parameter const& of) const;

    [[nodiscard]] record row_of(restored_parameter const& of, restore_record const& among, rtuwire::unit_id unit,
                                output_form form) const;

private:
    saved_settings const& wanted_;
    restore_record const* plan_{nullptr};
};

/// Whether an outcome is one that its user has to look at.
[[nodiscard]] bool is_bad(restore_outcome outcome) noexcept;

/// What a restore that ended between a register of steps and one that counts in them has made of that one; empty where
/// there is none.
[[nodiscard]] std::string changed_steps(restore_record const& of);

/// How many parameters came to which end.
[[nodiscard]] std::string counts_text(restore_record const& of);

} // namespace tool
