// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// The forms of other programs' files that are imported, each known by what is in it.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

#include "device/register_file_writer.hpp"
#include "import/source_value.hpp"

namespace tool {

/// A template of wb-mqtt-serial (JSON with comments).
[[nodiscard]] bool is_wirenboard(source_value const& file);
void import_wirenboard(source_value const& file, std::optional<std::int64_t> base, register_file_writer& into);

/// A model of SunSpec (JSON). Its points count from where it stands in a device: `base`.
[[nodiscard]] bool is_sunspec(source_value const& file);
void import_sunspec(source_value const& file, std::optional<std::int64_t> base, register_file_writer& into);

/// `modbus:` of a configuration of Home Assistant, or the list behind it (YAML).
[[nodiscard]] bool is_home_assistant(source_value const& file);
void import_home_assistant(source_value const& file, register_file_writer& into);

/// `modbus_controller` of a configuration of ESPHome (YAML).
[[nodiscard]] bool is_esphome(source_value const& file);
void import_esphome(source_value const& file, register_file_writer& into);

/// `inputs.modbus` of a configuration of Telegraf (TOML).
[[nodiscard]] bool is_telegraf(source_value const& file);
void import_telegraf(source_value const& file, register_file_writer& into);

/// Of a form whose addresses are those of the device.
void refuse_base(register_file_writer const& into, std::optional<std::int64_t> base);

/// Tells each field that is in neither list: a name that was taken, or one that says nothing of a register.
void lose_other_fields(register_file_writer& into, source_value const& from, std::string_view name,
                       std::span<std::string_view const> taken);

/// Whether a name stands twice in a table, which each program reads otherwise; tells which.
[[nodiscard]] bool has_names_twice(register_file_writer& into, source_value const& from);

/// A field that is a whole number; tells one that is none.
[[nodiscard]] std::optional<std::int64_t> whole_field(register_file_writer& into, source_value const& from,
                                                      std::string_view key);
/// The same of any number.
[[nodiscard]] std::optional<double> number_field(register_file_writer& into, source_value const& from,
                                                 std::string_view key);

/// A scale or an offset; where it is none, what the registers hold is not the value.
[[nodiscard]] double number_or_raw(source_value const& from, std::string_view key, double otherwise,
                                   written_register& one);
/// The same of what is written: a whole number.
[[nodiscard]] std::int64_t whole_or_raw(source_value const& from, std::string_view key, std::int64_t otherwise,
                                        written_register& one);

/// A number that means no value; tells one that is none, or beyond the register's bits.
void read_invalid(register_file_writer& into, source_value const& from, std::string_view key, written_register& one);

} // namespace tool
