// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// A server that answers for several unit addresses of one line, each with its own bank and profile, over one framer and
// one frame's memory. What it hears between other units ends its frames as in a server of one; the counters of function
// 08, and its listen-only mode, are those of the line, so all units show the same.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include <rtuwire/core/time.hpp>
#include <rtuwire/core/version.hpp>
#include <rtuwire/server/served_functions.hpp>
#include <rtuwire/server/server.hpp>
#include <rtuwire/server/units/bank_at.hpp>

namespace rtuwire::inline RTUWIRE_BUILD {

/// Banks and their unit addresses, in the order in which they were named; some of them in arrays.
/// Internal.
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
/// Internal.
struct own_banks {};

/// The unit addresses of a server, and what it executes on their banks.
/// Internal.
template <typename... Entries> class unit_set {
public:
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

/// Made by `server::for_units`; used as a server, but served without a bank: `node.serve(now)`. A request is executed
/// on the bank of its unit, by those of the server's functions that this bank has something for; a broadcast on every
/// bank, and answered by none. An address that is named twice has the first bank. Counters and listen-only mode of
/// function 08 are one for all: the line's.
/// Internal.
template <typename Diagnostics, typename Functions, typename... Entries>
class several_units : public server_engine<Diagnostics, unit_set<Entries...>> {
    using engine = server_engine<Diagnostics, unit_set<Entries...>>;

public:
    explicit constexpr several_units(line_timing const& its_timing, Entries const&... entries) noexcept
        : engine{unit_set<Entries...>{entries...}, its_timing, engine::default_profile}
    {}

    /// Calls `advance`; then executes the waiting request and prepares the response.
    constexpr void serve(instant now) noexcept { this->template serve_by<Functions>(own_banks{}, now); }
};

} // namespace rtuwire
