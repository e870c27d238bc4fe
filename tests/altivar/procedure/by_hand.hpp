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

    constexpr void wait(std::uint32_t time_ms)
    {
        now = now + milliseconds(time_ms);
        conversation.advance(now);
    }
    constexpr bool reads(std::uint16_t address)
    {
        auto const request = conversation.next();
        return request and request->frame()[1] == std::byte{3} and u16_at(request->frame(), 2) == address;
    }
    constexpr bool writes(std::uint16_t address, std::uint16_t word)
    {
        auto const request = conversation.next();
        return request and request->frame()[1] == std::byte{6} and u16_at(request->frame(), 2) == address and
               u16_at(request->frame(), 4) == word;
    }
    constexpr void hear(std::uint16_t word)
    {
        std::array<std::byte, 4> const pdu{std::byte{3}, std::byte{2}, to_byte(word >> 8U), to_byte(word)};
        conversation.accept(result<response>{response{pdu}});
    }
    constexpr void confirm() { conversation.accept(result<response>{response{}}); }
    constexpr void miss() { conversation.accept(errc::timed_out); }

    /// The same, at once.
    constexpr bool reads_and_hears(std::uint16_t address, std::uint16_t word)
    {
        bool const is_right = reads(address);
        hear(word);
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
