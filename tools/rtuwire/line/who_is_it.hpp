// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Which device a unit is: what it says of itself (43/14), and which drive's table fits it.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "catalog/catalog.hpp"
#include "line/line_words.hpp"
#include "line/open_line.hpp"

namespace tool {

/// Empty where nobody said.
struct identity_words {
    std::string vendor{};
    std::string product{};
    std::string revision{};
    std::string drive{}; ///< the name of a catalog
    std::string note{};  ///< why something is missing
    exit_status outcome{exit_status::done};
    bool is_another{false};   ///< it said that it is none of these drives, or refused to say who it is and is none
    bool has_answered{false}; ///< though it did not say who it is: --drive helps
    bool may_be_drive{false}; ///< which one is not known: it is of a family, or has the registers of one
};

/// What it says of itself by function 43: the basic objects, page by page. Why it does not.
rtuwire::errc read_identity(open_line& line, unit_address unit, identity_words& who);

/// Asks for its identification; then, where that leaves several drives or none, reads registers that tell them apart.
/// It writes nothing. `asked`: how that question ended just now, where it did without an identification; it is not asked again.
identity_words who_is_it(open_line& line, unit_address unit, std::optional<rtuwire::errc> asked = std::nullopt);

/// Whether a unit is known to be of another family than this drive, or calls itself a drive of a family without a table. False
/// where nothing is known of it, and between revisions of one family, which somebody may know better.
[[nodiscard]] bool is_of_another_family(identity_words const& who, drive_catalog const& drive);

/// "unit 61 calls itself 'A B', and is to be 'C D'"; empty where what it says of itself is what these words say.
[[nodiscard]] std::string why_another_device(unit_address unit, identity_words const& who, std::string const& vendor,
                                             std::string const& product);

/// Tells on the error output where a unit says that it is none of the device whose register file names its registers.
void tell_another_device(open_line& line, named_unit const& unit);

/// The catalog of the unit: the one that was chosen, else that of the drive that it is. Ends where it is none.
drive_catalog const& catalog_of(open_line& line, unit_address unit, std::string const& chosen);

/// Whether one that is of no known drive may be one all the same: it does not say by function 43 what it is, and has the
/// status word and the command word of a drive, or does not tell whether it has.
struct unnamed_drive {
    bool may_be_one{false};
    rtuwire::errc open{rtuwire::errc::none}; ///< why that is not known; none where it is
};
[[nodiscard]] unnamed_drive look_for_unnamed_drive(open_line& line, unit_address unit, identity_words const& who);

/// What --drive says of a unit that is no drive, or is not to be asked who it is.
inline constexpr std::string_view no_drive = "none";

/// The catalog of that name, null of `no_drive`; refuses others with the nearest.
drive_catalog const* catalog_or_none(std::string const& name);

/// By whose rules a unit is written.
struct write_rules {
    drive_catalog const* drive{nullptr};    ///< null of one that was said to be no drive
    std::optional<std::uint16_t> command{}; ///< of one that may be a drive all the same: where it has its command word
    bool says_it_is_none{false};            ///< by function 43 it is something else than a drive
    std::string says{};                     ///< vendor, product and revision, by function 43

    friend bool operator==(write_rules const&, write_rules const&) = default;
};

/// Of the unit's own table, or of one that was said to be no drive and is known to be none. A drive that is said to be none
/// is refused; with --allow-run its own table counts all the same. One that has the registers of a drive needs --allow-run,
/// too. One that calls itself a drive, or does not tell whether it has these registers, is refused whatever is said; so is one
/// that calls itself a drive of another family than the one that was said, or another device than its register file is of.
write_rules rules_to_write(open_line& line, named_unit const& unit, permissions const& allowed);

/// Why a unit that said who it is when these rules were made may be another one now: it does not say the same. Empty where it
/// does, or said nothing then. Where the port fails that is the reason, and nothing is thrown: something may have been written.
std::string why_exchanged(open_line& line, unit_address unit, write_rules const& rules);

/// The rules by what the unit tells of itself alone: of the table of the drive that it is, else as of one that was said to be
/// none. A type that somebody said only keeps another from being taken for it. `asked`: as for `who_is_it`.
write_rules rules_of_whoever(open_line& line, named_unit const& unit, permissions const& allowed,
                             std::optional<rtuwire::errc> asked = std::nullopt);

/// The catalog of that name; refuses others with the nearest.
drive_catalog const& catalog_chosen(std::string const& name);

} // namespace tool
