// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A conversation with a drive, answered by hand, and a clock that is about to wrap.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include <rtuwire/altivar/procedure/procedure_runner.hpp>

namespace rtuwire::test {

using namespace detail;

/// A conversation and a clock.
template <typename Conversation> struct by_hand {
    Conversation conversation;
    instant now{0xFFFF'FF00U};
    unsigned count{1};    ///< how many registers were asked for last
    std::size_t place{0}; ///< of the one that was meant

    constexpr void wait(std::uint32_t time_ms)
    {
        now = now + milliseconds(time_ms);
        conversation.advance(now);
    }
    constexpr bool reads(std::uint16_t address)
    {
        auto const request = conversation.next();
        if (not request or request->frame()[1] != std::byte{3}) {
            return false;
        }
        std::uint16_t const first = u16_at(request->frame(), 2);
        count = u16_at(request->frame(), 4);
        place = static_cast<std::size_t>(address - first);
        return address >= first and address < first + count and count <= 2;
    }
    constexpr bool writes(std::uint16_t address, std::uint16_t word)
    {
        auto const request = conversation.next();
        return request and request->frame()[1] == std::byte{6} and u16_at(request->frame(), 2) == address and
               u16_at(request->frame(), 4) == word;
    }
    /// The word of the register that `reads` named; and that of its neighbour, where both were asked for.
    constexpr void hear(std::uint16_t word, std::uint16_t beside = 0)
    {
        std::array<std::byte, 6> pdu{std::byte{3}, to_byte(2U * count)};
        put_u16(&pdu[2], place == 0 ? word : beside);
        put_u16(&pdu[4], place == 0 ? beside : word);
        conversation.accept(result<response>{response{byte_view{pdu}.first(2U + 2U * count)}});
    }
    constexpr void confirm() { conversation.accept(result<response>{response{}}); }
    constexpr void miss() { conversation.accept(errc::timed_out); }

    /// The same, at once.
    constexpr bool reads_and_hears(std::uint16_t address, std::uint16_t word, std::uint16_t beside = 0)
    {
        bool const is_right = reads(address);
        hear(word, beside);
        return is_right;
    }
    constexpr bool writes_and_confirms(std::uint16_t address, std::uint16_t word)
    {
        bool const is_right = writes(address, word);
        confirm();
        return is_right;
    }
    [[nodiscard]] constexpr bool ended_as(altivar::outcome_kind kind) const
    {
        return conversation.settled() and conversation.reason().kind == kind;
    }
};

} // namespace rtuwire::test
