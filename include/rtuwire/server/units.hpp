// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// The unit addresses that a server answers for: one; or several, each with its own bank and profile. What is executed on
// which bank; the line they have in common is the server's.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <type_traits>
#include <utility>

#include <rtuwire/core/version.hpp>
#include <rtuwire/server/banks.hpp>
#include <rtuwire/server/decoded_request.hpp>
#include <rtuwire/server/respond.hpp>
#include <rtuwire/wire/errc.hpp>
#include <rtuwire/wire/unit_id.hpp>

namespace rtuwire {
inline namespace RTUWIRE_BUILD {

/// Says: this bank answers as this unit, by every public function that it has something for (coils, a queue, files and
/// so on) and its server has, or by those that a profile allows. The bank and the profile are stored elsewhere, and must
/// outlive what is made of this.
template <register_bank Bank> struct bank_at {
    unit_id address;
    Bank& bank;
    server_profile const& profile;

    /// This bank at this address, with the functions that the profile allows.
    constexpr bank_at(unit_id its_unit, Bank& served, server_profile const& allowed = every_function) noexcept
        : address{its_unit}, bank{served}, profile{allowed}
    {}
    /// Deleted: a temporary profile would be gone.
    bank_at(unit_id, Bank&, server_profile const&&) = delete;

private:
    static constexpr server_profile every_function{};
};

namespace detail {

/// What a server of several units stores of an argument: a `bank_at`, or a view of an array of them.
template <typename T> struct entry_for;
template <register_bank Bank> struct entry_for<bank_at<Bank>> {
    using type = bank_at<Bank>;
};
template <register_bank Bank, std::size_t Count> struct entry_for<std::array<bank_at<Bank>, Count>> {
    using type = std::span<bank_at<Bank> const>;
};
template <register_bank Bank, std::size_t Extent> struct entry_for<std::span<bank_at<Bank> const, Extent>> {
    using type = std::span<bank_at<Bank> const>;
};

template <typename T>
concept names_units = requires
{
    typename entry_for<std::remove_cvref_t<T>>::type;
};

/// The entry of an argument, which is an lvalue or a `bank_at`.
template <typename Argument> struct checked_entry {
    static_assert(names_units<Argument>,
                  "a server of several units is made of bank_at{unit_id{3}, bank}, or of a std::array of these");
    static_assert(
        std::is_lvalue_reference_v<Argument> or not requires { std::declval<Argument>().size(); },
        "an array that ends with its expression cannot be served: give it a name first");
    using type = typename entry_for<std::remove_cvref_t<Argument>>::type;
};
template <typename Argument> using unit_entry = typename checked_entry<Argument>::type;

/// The unit address of a server that has one; 0 for none.
struct one_unit {
    static constexpr bool has_banks = false;
    std::uint8_t number;

    [[nodiscard]] constexpr bool contains(std::uint8_t unit) const noexcept { return unit == number; }

    /// Executes a request on its bank; returns the exception, or none.
    template <typename Functions, typename Bank, typename Diagnostics>
    static constexpr errc execute_on(std::uint8_t, request_head const& asked, pdu_buffer& pdu, Bank& bank,
                                     server_profile const& profile, Diagnostics& line) noexcept
    {
        return asked.has_effect<Functions>() ? execute<Functions>(asked.function, pdu, bank, profile, line)
                                             : errc::illegal_function;
    }
};

/// Banks and their unit addresses, in the order in which they were named; some of them in arrays.
template <typename... Entries> class unit_list {
public:
    constexpr unit_list() noexcept = default;
    template <typename Visit> static constexpr void for_each(Visit&&) noexcept {}
};
template <typename First, typename... Rest> class unit_list<First, Rest...> {
public:
    explicit constexpr unit_list(First const& its_first, Rest const&... rest) noexcept
        : first_{its_first}, rest_{rest...}
    {}

    /// Calls `visit` with each `bank_at`.
    template <typename Visit> constexpr void for_each(Visit&& visit) const noexcept
    {
        if constexpr (requires { first_.address; }) {
            visit(first_);
        } else {
            for (auto const& each : first_) {
                visit(each);
            }
        }
        rest_.for_each(visit);
    }

private:
    First first_;
    [[no_unique_address]] unit_list<Rest...> rest_;
};

/// In the place of a bank: each unit has its own.
struct own_banks {};

/// The unit addresses of a server of several, and what it executes on their banks: a request on the bank of its unit, by
/// those of the server's functions that this bank has something for; a broadcast on every bank. An address that is named
/// twice has the first bank.
template <typename... Entries> class unit_set {
public:
    static constexpr bool has_banks = true;

    explicit constexpr unit_set(Entries const&... entries) noexcept : entries_{entries...} {}

    [[nodiscard]] constexpr bool contains(std::uint8_t unit) const noexcept
    {
        bool is_one = false;
        entries_.for_each([&](auto const& at) { is_one = is_one or at.address.byte() == unit; });
        return is_one;
    }

    /// Executes a request to a unit, or a broadcast; returns the exception, or none. Each bank finds a broadcast as it
    /// came: a write changes no more of it than an exception's two bytes. A function of a bank's own is no broadcast.
    template <typename Functions, typename Diagnostics>
    constexpr errc execute_on(std::uint8_t unit, request_head const& asked, pdu_buffer& pdu, own_banks,
                              server_profile const&, Diagnostics& line) const noexcept
    {
        errc wrong = errc::none;
        bool is_done = false;
        entries_.for_each([&](auto const& at) {
            if (asked.is_broadcast) {
                errc const refused = execute_again<Functions>(at, asked, pdu, line);
                wrong = wrong == errc::none ? refused : wrong;
            } else if (at.address.byte() == unit and not is_done) {
                is_done = true;
                wrong = execute_at<Functions>(at, asked, pdu, line);
            }
        });
        // Of one unit's listen-only mode, another whose profile has no function 08 would tell by its exception.
        if (wrong != errc::none and line.is_listen_only()) {
            pdu.size = 0;
            return errc::none;
        }
        return wrong;
    }

private:
    template <typename Functions, typename Bank, typename Diagnostics>
    static constexpr errc execute_again(bank_at<Bank> const& at, request_head const& asked, pdu_buffer& pdu,
                                        Diagnostics& line) noexcept
    {
        std::byte const function = pdu.bytes[0], second = pdu.bytes[1];
        pdu_buffer same = pdu;
        errc const wrong = execute_at<Functions>(at, asked, same, line);
        pdu.bytes[0] = function;
        pdu.bytes[1] = second;
        return wrong;
    }

    template <typename Functions, typename Bank, typename Diagnostics>
    static constexpr errc execute_at(bank_at<Bank> const& at, request_head const& asked, pdu_buffer& pdu,
                                     Diagnostics& line) noexcept
    {
        using chosen = typename choose_functions<Bank, function_list<>, Functions>::type;
        return asked.has_effect<chosen>() ? execute<chosen>(asked.function, pdu, at.bank, at.profile, line)
                                          : errc::illegal_function;
    }

    unit_list<Entries...> entries_;
};

} // namespace detail

} // namespace RTUWIRE_BUILD
} // namespace rtuwire
