// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// Of which family a configuration is, what a restore of it may write, and what it tells of each parameter.
#pragma once

#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <optional>

#include <rtuwire/altivar/parameters/parameter.hpp>
#include <rtuwire/altivar/procedure/inspection/at_rest.hpp>
#include <rtuwire/core/bytes.hpp>
#include <rtuwire/core/literal.hpp>
#include <rtuwire/core/version.hpp>
#include <rtuwire/wire/errc.hpp>

namespace rtuwire {
inline namespace RTUWIRE_BUILD {
namespace altivar {

/// The letters and the number that a text begins with: "ATV320" of "ATV320U07M2C" and of "atv320". Unknown where a text
/// does not begin so, or goes on for more than 8 characters before its number ends.
class drive_family {
public:
    /// Unknown.
    constexpr drive_family() noexcept = default;

    /// The family that a text names.
    [[nodiscard]] static constexpr drive_family of(literal text) noexcept
    {
        drive_family found;
        for (std::size_t i = 0; i < text.size() and found.push(text[i]); ++i) {
        }
        return found.whole();
    }

    /// The same of a text that is known when the program runs: a std::string_view, a std::string.
    template <typename Text>
        requires requires(Text const& text) { requires std::same_as<decltype(text[text.size() - 1]), char const&>; }
    [[nodiscard]] static constexpr drive_family of(Text const& text) noexcept
    {
        drive_family found;
        for (std::size_t i = 0; i < text.size() and found.push(text[i]); ++i) {
        }
        return found.whole();
    }

    /// The same of a text as it came over the line.
    [[nodiscard]] static constexpr drive_family of(byte_view text) noexcept
    {
        drive_family found;
        for (std::size_t i = 0; i < text.size() and found.push(static_cast<char>(detail::to_u8(text[i]))); ++i) {
        }
        return found.whole();
    }

    [[nodiscard]] constexpr bool is_known() const noexcept { return size_ != 0; }

    friend constexpr bool operator==(drive_family const&, drive_family const&) noexcept = default;

private:
    static constexpr bool is_digit(char what) noexcept { return what >= '0' and what <= '9'; }
    static constexpr bool is_letter(char what) noexcept { return what >= 'A' and what <= 'Z'; }
    static constexpr char upper(char what) noexcept
    {
        return what >= 'a' and what <= 'z' ? static_cast<char>(what - 'a' + 'A') : what;
    }

    /// Takes one more character; whether the next one may belong to the family, too.
    constexpr bool push(char what) noexcept
    {
        char const each = upper(what);
        bool const is_part = is_digit(each) ? size_ > 0 : is_letter(each) and not has_number();
        if (is_part and size_ == text_.size()) {
            size_ = 0; // too long for any
            return false;
        }
        if (is_part) {
            text_[size_++] = each;
        }
        return is_part;
    }

    [[nodiscard]] constexpr bool has_number() const noexcept { return size_ > 0 and is_digit(text_[size_ - 1U]); }
    [[nodiscard]] constexpr drive_family whole() const noexcept { return has_number() ? *this : drive_family{}; }

    std::array<char, 8> text_{};
    std::uint8_t size_{0};
};

/// What a drive shall hold: `words(parameter const&)` gives the word of a parameter as a `std::optional<std::uint16_t>`,
/// always the same. `family` is the family of the drive that these words are of.
template <typename Words> struct wanted_settings {
    drive_family family;
    Words words;
};
template <typename Words> wanted_settings(drive_family, Words) -> wanted_settings<Words>;

/// What a restore may write beside ordinary settings. Each is left out unless it is named here, and told so.
struct restore_options {
    bool dry_run{false};          ///< tells what would be written, and writes nothing
    bool with_channels{false};    ///< who commands, run inputs; and CFG, which sets both
    bool with_link{false};        ///< addresses, rates, formats, time-outs of this line and of other buses
    bool with_inferred{false};    ///< rows whose source is not `documented`: of an ATV320 nearly all
    bool with_supervision{false}; ///< what can switch off whatever stops the motor; outputs, which switch at once
    bool with_autorestart{false}; ///< what lets the drive start by itself, or a fault be reset by an input
    bool save{false};             ///< to the EEPROM, where the drive then holds all that was wanted and allowed
    terminal_options terminals{}; ///< for CFG, channels, run inputs and automatic restart, as in `set_channel`
};

/// What became of one parameter.
enum class restore_outcome : std::uint8_t {
    holds,             ///< the drive holds the wanted word; one told as `written` before still does
    planned,           ///< will be written; in a dry run, would be
    written,           ///< written, and read back
    not_read_back,     ///< the drive confirmed it, and may answer elsewhere from now on
    confirmed,         ///< the drive confirmed it; what it holds since was not read, by `error`
    unconfirmed,       ///< sent, and no response: it holds the old word or the new one
    differs,           ///< confirmed, and reads back otherwise
    refused,           ///< the drive refused it, by the exception in `error`
    unreadable,        ///< the drive refuses to tell what it holds; never written then
    not_reached,       ///< the restore ended before
    other_steps,       ///< never sent: it would count in other steps than the configuration does, or make others do so
    not_wanted,        ///< the configuration has no word for it
    out_of_limits,     ///< never sent: the wanted word is none of this register, or LSP <= HSP <= TFR would not hold
    never_written,     ///< it is no setting: see `role_of` and `why`; or its row does not say what the drive does
    needs_channels,    ///< left out: `with_channels` was not given
    needs_link,        ///< left out: `with_link` was not given
    needs_inferred,    ///< left out: `with_inferred` was not given
    needs_supervision, ///< left out: `with_supervision` was not given
    needs_autorestart, ///< left out: `with_autorestart` was not given
};

/// An outcome in words.
[[nodiscard]] constexpr literal name_of(restore_outcome outcome) noexcept
{
    switch (outcome) {
    case restore_outcome::holds: return "holds the wanted word";
    case restore_outcome::planned: return "to be written";
    case restore_outcome::written: return "written and read back";
    case restore_outcome::not_read_back: return "written, not read back: the drive may answer elsewhere";
    case restore_outcome::confirmed: return "confirmed, not read back";
    case restore_outcome::unconfirmed: return "sent, not confirmed: old or new";
    case restore_outcome::differs: return "written, and reads back otherwise";
    case restore_outcome::refused: return "refused by the drive";
    case restore_outcome::unreadable: return "cannot be read, so it is not written";
    case restore_outcome::not_reached: return "not reached";
    case restore_outcome::other_steps: return "not written: steps differ (INR)";
    case restore_outcome::not_wanted: return "not in the configuration";
    case restore_outcome::out_of_limits: return "outside its limits";
    case restore_outcome::never_written: return "never written";
    case restore_outcome::needs_channels: return "left out: channels and run inputs were not asked for";
    case restore_outcome::needs_link: return "left out: the link was not asked for";
    case restore_outcome::needs_inferred: return "left out: inferred parameters were not asked for";
    case restore_outcome::needs_supervision: return "left out: supervision was not asked for";
    case restore_outcome::needs_autorestart: return "left out: automatic restart was not asked for";
    }
    return "unknown";
}

/// Whether a parameter was left out for want of an option.
/// Internal.
[[nodiscard]] constexpr bool needs_option(restore_outcome outcome) noexcept
{
    return outcome >= restore_outcome::needs_channels;
}

/// Whether an outcome is that of a parameter which the configuration has a word for that it can take.
/// Internal.
[[nodiscard]] constexpr bool has_fitting_word(restore_outcome judgement) noexcept
{
    return judgement == restore_outcome::planned or needs_option(judgement);
}

/// What a restore tells of one parameter.
struct restore_report {
    restore_outcome outcome;
    std::optional<std::uint16_t> held{}; ///< what the drive held when it was last read; empty where it was not
    errc error{errc::none};              ///< of one refused, unreadable, confirmed, unconfirmed or not reached

    friend constexpr bool operator==(restore_report const&, restore_report const&) noexcept = default;
};

/// What the options leave out of a parameter's role and source; `planned` where they allow it.
/// Internal.
[[nodiscard]] constexpr restore_outcome allowed_by(restore_options const& options, parameter const& row) noexcept
{
    switch (role_of(row)) {
    case parameter_role::macro:
    case parameter_role::run_input:
    case parameter_role::channel:
        if (not options.with_channels) {
            return restore_outcome::needs_channels;
        }
        break;
    case parameter_role::link_timeout:
    case parameter_role::other_link:
    case parameter_role::link:
        if (not options.with_link) {
            return restore_outcome::needs_link;
        }
        if (role_of(row) == parameter_role::link_timeout and not options.with_supervision) {
            return restore_outcome::needs_supervision;
        }
        break;
    case parameter_role::supervision:
        if (not options.with_supervision) {
            return restore_outcome::needs_supervision;
        }
        break;
    case parameter_role::restart:
        if (not options.with_autorestart) {
            return restore_outcome::needs_autorestart;
        }
        break;
    case parameter_role::setting:
    case parameter_role::step_size:
    case parameter_role::frequency_limit:
    case parameter_role::motion: break;
    case parameter_role::read_only:
    case parameter_role::derived:
    case parameter_role::measured:
    case parameter_role::of_this_drive:
    case parameter_role::order:
    case parameter_role::safety: return restore_outcome::never_written;
    }
    bool const is_sure = row.source() == provenance::documented or options.with_inferred;
    return is_sure ? restore_outcome::planned : restore_outcome::needs_inferred;
}

/// What is known of a parameter before the drive is asked: left out, and why; `planned` where it is to be compared, and
/// written where it differs.
/// Internal.
[[nodiscard]] constexpr restore_outcome judged(restore_options const& options, parameter const& row,
                                               std::optional<std::uint16_t> wanted) noexcept
{
    restore_outcome const allowed = allowed_by(options, row);
    if (allowed == restore_outcome::never_written) {
        return allowed;
    }
    if (not wanted) {
        return restore_outcome::not_wanted;
    }
    if (not row.takes(row.count_of(*wanted))) {
        return restore_outcome::out_of_limits;
    }
    return allowed;
}

} // namespace altivar
} // namespace RTUWIRE_BUILD
} // namespace rtuwire
