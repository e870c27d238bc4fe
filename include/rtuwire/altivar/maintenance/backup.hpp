// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// Reads every parameter of a drive, by the fewest requests that its read limit and the holes of its map allow. What the
// drive refuses is told as refused, what was not reached as not read: each parameter once. Keeps no word.
//
// Compares what a configuration wants with what was read. Only settings count, those of the safety functions among them:
// what the drive measures, counts or shows differs from one moment to the next, and an order that it holds is no part of
// its configuration.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

#include <rtuwire/altivar/maintenance/block_walk.hpp>
#include <rtuwire/altivar/parameters/parameter.hpp>
#include <rtuwire/altivar/parameters/parameter_map.hpp>
#include <rtuwire/ask/conversation.hpp>
#include <rtuwire/core/literal.hpp>
#include <rtuwire/core/result.hpp>
#include <rtuwire/core/version.hpp>
#include <rtuwire/table/device.hpp>
#include <rtuwire/wire/function.hpp>
#include <rtuwire/wire/registers.hpp>

namespace rtuwire {
inline namespace RTUWIRE_BUILD {
namespace altivar {

/// Reads a parameter map in the order of addresses, and calls `sink(parameter_group const&, parameter const&,
/// result<std::uint16_t>)` once for each row: with its word, with the exception by which the drive refused it, or with
/// the error that ended the backup before it. A block that the drive refuses is asked for again in halves until the
/// register that it refuses stands alone.
///
/// `outcome()` is a success once all were asked, whatever was refused. A lost response is repeated as the client's
/// options say; what fails then, and an exception that is not about registers (01, 0A, 0B), ends the backup with this
/// error. The map's groups outlive it; `sink` does not throw.
template <typename Sink> class backup : public detail::finite_conversation {
public:
    static constexpr function_set asks{function_code::read_holding_registers};

    /// Reads the parameters of `its_map` from this drive; the sink is copied.
    template <device_type Device>
    constexpr backup(station<Device> const& its_drive, parameter_map const& its_map, Sink its_sink) noexcept
        : map_{its_map}, sink_{its_sink}, walk_{Device::limits.read}, unit_{its_drive.unit()}
    {
        static_assert(detail::implements<Device>(function_code::read_holding_registers),
                      "this device does not implement function 03");
        ask_next();
    }

    /// Reads all of it once more, and tells each parameter once more. Not to be called by the sink.
    constexpr void again() noexcept
    {
        reopen();
        walk_.begin();
        read_ = 0;
        refused_ = 0;
        ask_next();
    }

    constexpr std::optional<request_frame> next() const& noexcept
    {
        if (settled()) {
            return std::nullopt;
        }
        return request_frame{frame_};
    }
    std::optional<request_frame> next() const&& = delete;

    constexpr void accept(result<response> const& outcome) noexcept
    {
        result<register_view> const words = words_in(outcome, walk_.block().count);
        if (words) {
            take(*words);
        } else if (is_of_registers(words.error())) {
            refuse(words.error());
        } else {
            end(words.error());
        }
    }

    /// How many parameters were read.
    [[nodiscard]] constexpr std::uint16_t read() const noexcept { return read_; }

    /// How many the drive refused.
    [[nodiscard]] constexpr std::uint16_t refused() const noexcept { return refused_; }

private:
    static constexpr bool is_any(parameter const&) noexcept { return true; }

    constexpr void ask_next() noexcept
    {
        if (not walk_.find(map_, is_any)) {
            return settle(errc::none);
        }
        detail::address_block const block = walk_.block();
        static_cast<void>(encode_into(frame_, unit_, read_holding_registers{block.start, block.count}));
    }

    constexpr void take(register_view words) noexcept
    {
        for (std::size_t i = 0; i < words.size(); ++i) {
            tell(walk_.block().start + i, words[i]);
            ++read_;
        }
        walk_.pass();
        ask_next();
    }

    constexpr void refuse(errc error) noexcept
    {
        if (walk_.refuse()) {
            tell(walk_.block().start, error);
            ++refused_;
            walk_.pass();
        }
        ask_next();
    }

    constexpr void end(errc error) noexcept
    {
        for (std::uint32_t at = lowest_address(map_, walk_.position(), is_any); at != no_address;
             at = lowest_address(map_, at + 1, is_any)) {
            tell(at, error);
        }
        settle(error);
    }

    constexpr void tell(std::size_t address, result<std::uint16_t> const& word) noexcept
    {
        placed_row const found = row_at(map_, static_cast<std::uint16_t>(address));
        sink_(*found.group, *found.row, word);
    }

    parameter_map map_;
    Sink sink_;
    block_walk walk_;
    std::uint16_t read_{0};
    std::uint16_t refused_{0};
    std::array<std::byte, 8> frame_{};
    unit_id unit_;
};

template <typename Station, typename Sink> backup(Station, parameter_map, Sink) -> backup<Sink>;

/// What a comparison of one parameter gave.
enum class comparison : std::uint8_t {
    equal,
    differs,
    not_wanted,   ///< the configuration has no word for it
    not_compared, ///< it is no setting: `role_of` and `why` tell what it is
    unknown,      ///< the drive did not tell its word
};

/// A comparison in words.
[[nodiscard]] constexpr literal name_of(comparison found) noexcept
{
    switch (found) {
    case comparison::equal: return "equal";
    case comparison::differs: return "differs";
    case comparison::not_wanted: return "not wanted";
    case comparison::not_compared: return "not compared";
    case comparison::unknown: return "not known";
    }
    return "unknown";
}

/// Compares the word that is wanted of a parameter with the one that the drive holds.
[[nodiscard]] constexpr comparison compared(parameter const& row, std::optional<std::uint16_t> wanted,
                                            std::optional<std::uint16_t> held) noexcept
{
    parameter_role const role = role_of(row);
    if (not is_restorable(role) and role != parameter_role::safety) {
        return comparison::not_compared;
    }
    if (not wanted) {
        return comparison::not_wanted;
    }
    if (not held) {
        return comparison::unknown;
    }
    return *wanted == *held ? comparison::equal : comparison::differs;
}

/// A sink for `backup` that compares each parameter with the word which `wanted(parameter const&)` wants of it, a
/// `std::optional<std::uint16_t>`, and calls `report(parameter_group const&, parameter const&, comparison,
/// result<std::uint16_t>)` with what the drive told:
///
///     altivar::backup check{drive, atv320::parameters, altivar::compared_with{wanted, report}};
template <typename Wanted, typename Report> class compared_with {
public:
    /// Copies both; neither throws.
    constexpr compared_with(Wanted its_wanted, Report its_report) noexcept : wanted_{its_wanted}, report_{its_report} {}

    constexpr void operator()(parameter_group const& group, parameter const& row,
                              result<std::uint16_t> const& held) noexcept
    {
        std::optional<std::uint16_t> const word = held ? std::optional{*held} : std::nullopt;
        report_(group, row, compared(row, wanted_(row), word), held);
    }

private:
    Wanted wanted_;
    Report report_;
};
template <typename Wanted, typename Report> compared_with(Wanted, Report) -> compared_with<Wanted, Report>;

} // namespace altivar
} // namespace RTUWIRE_BUILD
} // namespace rtuwire
