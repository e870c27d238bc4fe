// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A stop of everyone without a line: its requests as text, its responses and the clock by hand.
#pragma once

#include <algorithm>
#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "support/catch.hpp"
#include "support/known_words.hpp"

#include <rtuwire/altivar/procedure/motion/broadcast_stop.hpp>
#include <rtuwire/client/orders.hpp>

namespace rtuwire::test {

using namespace detail;

using frames = std::vector<std::string>;

inline constexpr instant start_of_all{0xFFFF'FF00U};

/// A stop of everyone, and a line's knowledge of whose motor was ordered.
template <std::size_t Drives> struct everyone_by_hand {
    altivar::broadcast_stop<Drives> all;
    orders<4> motors{};
    instant now{start_of_all};

    template <typename... Told> explicit everyone_by_hand(Told const&... told) : all{told...} {}

    /// Of drives whose control words this line has read.
    everyone_by_hand&& with_known_words() &&
    {
        for (altivar::stop const& each : all.stops()) {
            test::confirm_words(motors, each.unit(), now);
        }
        return std::move(*this);
    }

    /// The frame of the next request without its check, or nothing. Whoever reads CHCF hears at once of the drive profile.
    std::string asks()
    {
        std::string told = asks_once();
        for (unsigned i = 0; i < 4 and told.size() > 2 and told.substr(2) == " 03 20 D1 00 01"; ++i) {
            hear(1);
            told = asks_once();
        }
        return told;
    }
    std::string asks_once()
    {
        motors.advance(now, false, 0);
        all.advance(now);
        motors.take_note_of_all(all, now);
        for (altivar::stop& each : all.stops()) {
            if (motors.take_note_of(each, now)) {
                each.note_loss();
            }
        }
        if (all.is_urgent()) {
            motors.lose_all_but_its_own(all, now);
        }
        motors.note_ordered(all);
        std::string told;
        if (auto const request = all.next()) {
            motors.note_start(now);
            for (altivar::stop& each : all.stops()) {
                if (request->frame()[0] == std::byte{each.unit().byte()}) {
                    motors.note_asked(each, all.intent(), each.drive_timeout(), each.tolerated_misses());
                }
            }
            constexpr std::string_view digits{"0123456789ABCDEF"};
            std::ranges::copy(request->frame().first(6), asked_.begin());
            for (std::byte const each : asked_) {
                told += told.empty() ? "" : " ";
                told += digits[to_u8(each) >> 4U];
                told += digits[to_u8(each) & 0xFU];
            }
        }
        return told;
    }
    std::string asks_after(std::uint32_t time_ms)
    {
        wait(time_ms);
        return asks();
    }
    void wait(std::uint32_t time_ms) { now = now + milliseconds(time_ms); }
    void confirm() { all.accept(result<response>{response{}}); }
    /// The status, or the only word that was asked for; of a look, the word beside it.
    void hear(std::uint16_t word, std::uint16_t beside = 0)
    {
        constexpr std::uint16_t fault_before_status = 457;
        bool const is_behind =
            asked_[2] == to_byte(fault_before_status >> 8U) and asked_[3] == to_byte(fault_before_status);
        unsigned const size = 2U * to_u8(asked_[5]);
        std::array<std::byte, 6> pdu{std::byte{3}, to_byte(size)};
        put_u16(&pdu[2], is_behind ? beside : word);
        put_u16(&pdu[4], is_behind ? word : beside);
        all.accept(result<response>{response{byte_view{pdu}.first(2 + size)}});
    }
    void miss(std::uint8_t unit)
    {
        motors.note_outcome(unit, errc::timed_out, false, now);
        all.accept(errc::timed_out);
    }

    /// What is asked now, each confirmed, until there is nothing to ask or it is somebody's own.
    frames broadcasts(std::uint32_t turnaround_ms = 0)
    {
        frames told;
        while (all.is_urgent()) {
            std::string const next = asks();
            if (next.empty()) {
                break;
            }
            told.push_back(next);
            wait(turnaround_ms);
            confirm();
        }
        return told;
    }
    /// All the broadcasts, and the wait between them.
    void tell_everyone()
    {
        broadcasts();
        wait(1'000);
        broadcasts();
        REQUIRE_FALSE(all.is_urgent());
    }
    /// Whether the next requests are these words, which are confirmed.
    void confirms(frames const& expected)
    {
        for (std::string const& each : expected) {
            CHECK(asks() == each);
            confirm();
        }
    }

private:
    std::array<std::byte, 6> asked_{};
};

} // namespace rtuwire::test
