// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// The drives and all their parameters as arrays that a program walks at run time. The compiler derives them from the
// registers of the headers: nothing is written down twice. They live as long as the program.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include <rtuwire/altivar/own_parameters.hpp>
#include <rtuwire/client.hpp>
#include <rtuwire/drives.hpp>

namespace tool {

/// What the word of a register is.
enum class register_kind : std::uint8_t { number, signed_number, bits, enumeration };

/// How much of its unit one count of a register is: 1/10 of "Hz".
struct step_size {
    std::int64_t numerator{1};
    std::int64_t denominator{1};
};

/// One register of a drive.
struct register_entry {
    std::string_view code; ///< the mnemonic, in upper case
    std::uint16_t address;
    rtuwire::altivar::parameter const* row; ///< the same as the library's row
    std::string_view name;                  ///< for display
    std::string_view group;                 ///< of parameters: "motor_control"
    std::string_view menu; ///< the number that the drive's display has for it, "705.0"; empty where none is known
    bool is_for_driving;   ///< one of those that any program for this drive has, and that tell it from others
    rtuwire::access mode;
    register_kind kind;
    std::string_view unit;         ///< symbol of what is measured, "Hz"; empty where nothing is
    step_size step;                ///< of one count, in that unit
    std::string_view steps_set_by; ///< the register that sets the step instead; empty where none does
    rtuwire::bound min;            ///< in raw counts, or by another register
    rtuwire::bound max;            ///< in raw counts, or by another register
    std::int32_t gap_first;        ///< raw counts that are never written, none where the last is below the first
    std::int32_t gap_last;
    std::optional<std::int32_t> factory; ///< in raw counts, where known
    rtuwire::provenance source;
    std::span<rtuwire::choice const> choices;   ///< values of an enumeration, or bits of a word by number
    bool has_meanings;                          ///< whether the library's texts have their meanings
    std::span<std::string_view const, 16> bits; ///< of a word of bits: identifiers, empty where unnamed

    [[nodiscard]] bool is_writable() const noexcept { return mode != rtuwire::access::read_only; }
    /// The values of an enumeration.
    [[nodiscard]] std::span<rtuwire::choice const> values() const noexcept
    {
        return kind == register_kind::enumeration ? choices : std::span<rtuwire::choice const>{};
    }
    /// The value or bit of a number; null where it has none.
    [[nodiscard]] rtuwire::choice const* choice_of(std::uint16_t word) const noexcept;
    [[nodiscard]] bool is_amount() const noexcept
    {
        return kind == register_kind::number or kind == register_kind::signed_number;
    }

    /// The count that a word on the wire stands for: below zero only in a register of signed numbers.
    [[nodiscard]] std::int32_t count_of(std::uint16_t word) const noexcept
    {
        return kind == register_kind::signed_number ? static_cast<std::int16_t>(word) : std::int32_t{word};
    }
    [[nodiscard]] std::int32_t lowest_count() const noexcept;  ///< as far as it does not depend on another register
    [[nodiscard]] std::int32_t highest_count() const noexcept; ///< as far as it does not depend on another register
};

/// One type of drive.
struct drive_catalog {
    std::string_view name;                     ///< "atv320"
    std::string_view reference;                ///< one of the family, as function 43 returns it
    std::span<register_entry const> registers; ///< in the order of their addresses
    rtuwire::altivar::parameter_map map;       ///< the same as the library's rows, by their groups
    rtuwire::device_limits limits;             ///< registers a request
    rtuwire::function_set functions;
    rtuwire::unit_range units;
    rtuwire::altivar::drive_layout layout; ///< where its command, status and safeguards are
    std::uint16_t speed_reference;         ///< the register that takes rpm
    std::uint16_t frequency_reference;     ///< the register that takes Hz

    /// The register at an address; null where the table has none.
    [[nodiscard]] register_entry const* at(std::uint16_t address) const noexcept;

    /// The register of a mnemonic, in upper or lower case; null where there is none.
    [[nodiscard]] register_entry const* by_code(std::string_view code) const noexcept;

    /// The register of a number of the drive's menu, "705.0"; null where there is none.
    [[nodiscard]] register_entry const* by_menu(std::string_view number) const noexcept;
};

/// All drives of the library.
[[nodiscard]] std::span<drive_catalog const* const> all_catalogs() noexcept;

/// A drive by its name, in upper or lower case; null where there is none.
[[nodiscard]] drive_catalog const* catalog_named(std::string_view name) noexcept;

/// A limit as people read it, in counts: "400", "TFR", "1/2 INV", "1/10 HSP*SDS"; empty for an open one.
[[nodiscard]] std::string text_of_bound(rtuwire::bound const& limit);

/// Words for columns: "read only", "read, write", "read, write at rest"; "documented" and so on; "bits" and so on.
[[nodiscard]] std::string_view text_of(rtuwire::access mode) noexcept;
[[nodiscard]] std::string_view text_of(rtuwire::provenance source) noexcept;
[[nodiscard]] std::string_view text_of(register_kind kind) noexcept;

} // namespace tool
