// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// What is known of a register, as people read it: no unit is asked.
#pragma once

#include <cstdint>
#include <string>

#include "catalog/catalog.hpp"

namespace tool {

/// A count in the register's unit: "12.5 Hz"; "30 steps" where another register sets the step.
[[nodiscard]] std::string amount_of(std::int64_t count, register_entry const& entry, drive_catalog const& drive);

/// A count as `text_of` shows it, a value of an enumeration by its name.
[[nodiscard]] std::string default_text(std::int32_t count, register_entry const& entry, drive_catalog const& drive);

/// A limit: "599.0 Hz", "TFR"; empty for an open one.
[[nodiscard]] std::string limit_text(rtuwire::bound const& limit, register_entry const& entry,
                                     drive_catalog const& drive);

/// What sets its step, and which counts are never written.
[[nodiscard]] std::string note_on(register_entry const& entry, drive_catalog const& drive);

/// Whether a drive's display has numbers for some of its registers.
[[nodiscard]] bool has_menu(drive_catalog const& drive) noexcept;

/// A register as it is named to people: "TFR (308)" where the display has a number for it.
[[nodiscard]] std::string code_and_menu(register_entry const& entry);

} // namespace tool
