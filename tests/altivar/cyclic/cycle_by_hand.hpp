// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A cycle of which each response is given by hand, at a clock that runs through zero.
#pragma once

#include <algorithm>
#include <array>
#include <initializer_list>

#include <rtuwire/altivar/cyclic/cyclic.hpp>

#include "support/commissioned.hpp"
#include "support/known_words.hpp"

namespace rtuwire::test {

using namespace detail;

/// Status words of a drive under remote control.
inline constexpr std::uint16_t not_ready = 0x0200, switch_on_disabled = 0x0250, ready = 0x0231;
inline constexpr std::uint16_t switched_on = 0x0233, running = 0x0237, quick_stop_active = 0x0217;
inline constexpr std::uint16_t in_fault = 0x0208, no_state = 0x0201, with_stop_key = 0x4000;

/// Registers and, of the scanner, what they stand for.
inline constexpr std::uint16_t cmd_address = 8501, eta_address = 3201, lfrd_address = 8602;
inline constexpr std::uint16_t rfrd_address = 8604, lft_address = 7121;
inline constexpr std::uint16_t inputs_address = 12'741, first_slot_address = 12'701;

/// Its client has read what the drive's control words mean.
template <typename Device> struct cycle_by_hand {
    using words = std::initializer_list<std::uint16_t>;

    altivar::cyclic<Device> loop;
    instant now{0xFFFF'FF00U};
    std::array<std::byte, 40> asked{}; ///< the last request; zeros for none

    explicit constexpr cycle_by_hand(altivar::cyclic_options const& options = {})
        : loop{with_known_words(altivar::cyclic<Device>{station<Device>{unit_id{3}}, options})}
    {}

    // Whether it asks something.

    constexpr bool asks_at(instant when)
    {
        now = when;
        loop.advance(now);
        auto const request = loop.next();
        asked = {};
        if (request) {
            byte_view const frame = request->frame();
            std::copy(frame.begin(), frame.end(), asked.begin());
        }
        return request.has_value();
    }
    constexpr bool asks() { return asks_at(now + milliseconds(100)); }
    constexpr bool asks_at_once() { return asks_at(now); }
    /// A period later, and no sooner.
    constexpr bool asks_later()
    {
        bool const is_early = asks_at(now + milliseconds(100) - microseconds(1));
        return not is_early and asks_at(now + microseconds(1));
    }

    // What it has asked.

    [[nodiscard]] constexpr std::uint16_t word(std::size_t at) const { return u16_at(byte_view{asked}, at); }
    [[nodiscard]] constexpr bool reads(std::uint16_t address, std::uint16_t count = 1) const
    {
        return asked[1] == std::byte{3} and word(2) == address and word(4) == count;
    }
    [[nodiscard]] constexpr bool says(std::uint16_t command) const
    {
        return asked[1] == std::byte{6} and word(2) == cmd_address and word(4) == command;
    }
    /// CHCF, and right behind it a word that is sent for the second time, or to withdraw an order.
    constexpr bool looks_before(std::uint16_t command)
    {
        bool const is_asked = reads(8401);
        hear({1});
        return is_asked and asks_at_once() and says(command);
    }
    [[nodiscard]] constexpr bool exchanges(std::uint16_t command, std::uint16_t reference) const
    {
        return asked[1] == std::byte{23} and word(11) == command and word(13) == reference;
    }

    // What comes of it.

    constexpr void hear(words read)
    {
        std::array<std::byte, 2 + 2 * 8> pdu{std::byte{3}, to_byte(static_cast<std::uint32_t>(2 * read.size()))};
        std::size_t at = 2;
        for (std::uint16_t const each : read) {
            pdu[at++] = to_byte(static_cast<std::uint32_t>(each >> 8U));
            pdu[at++] = to_byte(each);
        }
        loop.accept(result<response>{response{byte_view{pdu}.first(at)}});
    }
    /// The drive took what was written, by function 06 or 16.
    constexpr void confirm() { loop.accept(result<response>{response{byte_view{asked}.subspan(1, 5)}}); }
    constexpr void miss(errc why = errc::timed_out) { loop.accept(why); }

    // Requests with their responses.

    /// The requests of the check, up to the status that is its last word; each right behind the other.
    constexpr bool is_checked(std::uint16_t status = switch_on_disabled, std::uint16_t tto = 100)
    {
        for (unsigned i = 0; i < 12 and asks_at_once() and word(4) == 1; ++i) {
            bool const is_last = word(2) == eta_address;
            hear({is_last ? status : commissioned_word(word(2), tto)});
            if (is_last) {
                return true;
            }
        }
        return false;
    }
    /// The requests about the scanner's slots.
    constexpr bool tells_its_slots(words outputs = {cmd_address, lfrd_address, 0, 0})
    {
        bool const is_asked = asks_at_once() and reads(first_slot_address, 4);
        hear({eta_address, rfrd_address, 0, 0});
        bool const ok = is_asked and asks_at_once() and reads(first_slot_address + 20, 4);
        hear(outputs);
        return ok;
    }
    /// What follows a look, each request right behind the other: the last fault, the scanner's slots, the check.
    constexpr bool is_known(std::uint16_t status, std::uint16_t tto = 100,
                            words outputs = {cmd_address, lfrd_address, 0, 0})
    {
        hear({status});
        bool ok = asks_at_once() and reads(lft_address);
        hear({0});
        return ok and tells_its_slots(outputs) and is_checked(status, tto);
    }
    /// Up to its first exchange, which `exchange` answers.
    constexpr bool begins(std::uint16_t status = switch_on_disabled, std::uint16_t tto = 100)
    {
        return asks() and is_known(status, tto) and not loop.link_lost();
    }
    constexpr bool exchange(std::uint16_t status = switch_on_disabled, std::uint16_t speed = 0)
    {
        bool const is_asked = asks();
        hear({status, speed, 0, 0});
        return is_asked;
    }
    /// On its way up, from anywhere to just before the command to run.
    constexpr bool enables()
    {
        bool ok = loop.run(1'500_rpm) and exchange(ready) and exchange(switched_on) and asks();
        ok = ok and reads(cmd_address);
        hear({0x0007});
        return ok;
    }
    constexpr bool runs() { return begins() and enables() and exchange(running, 1'500); }
    constexpr bool fails(errc why = errc::timed_out)
    {
        bool const is_asked = asks();
        miss(why);
        return is_asked;
    }
};

} // namespace rtuwire::test
