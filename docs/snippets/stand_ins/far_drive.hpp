// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// What the boards of the pages share, where no board is: a clock of virtual microseconds, and a simulated ATV320 at the
// other end of the line. After a second of its clock it ends the program, well only if the page's loop has shown values.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <deque>
#include <iostream>

#include <rtuwire/altivar/atv320.hpp>
#include <rtuwire/client.hpp>
#include <rtuwire/print.hpp>
#include <rtuwire/sim.hpp>

namespace stand_in {

using namespace rtuwire;

class far_drive {
public:
    far_drive() { unit_.advance(now_); }

    [[nodiscard]] instant now() const { return now_; }

    /// The whole frame has left when this returns.
    void send(byte_view frame)
    {
        now_ = now_ + timing.characters(frame.size());
        unit_.receive(frame, now_);
    }

    /// Lets time pass, with what the drive says meanwhile; ends the program when its time is over.
    void wait(duration length)
    {
        instant const end = now_ + length;
        while (not reached(now_, end)) {
            now_ = now_ + microseconds(250);
            unit_.advance(now_);
            if (byte_view const response = unit_.poll_transmit(); not response.empty()) {
                now_ = now_ + timing.characters(response.size());
                bytes_.insert(bytes_.end(), response.begin(), response.end());
                unit_.sent(now_);
            }
        }
        if (reached(now_, instant{0} + milliseconds(1'000))) {
            std::exit(rounds >= 5 ? EXIT_SUCCESS : EXIT_FAILURE);
        }
    }

    [[nodiscard]] bool has_byte() const { return not bytes_.empty(); }
    std::byte take()
    {
        std::byte const first = bytes_.front();
        bytes_.pop_front();
        return first;
    }

    int rounds{0};

private:
    static constexpr line_timing timing{19'200, character_format::even_8_1};
    instant now_{0};
    sim::unit<altivar::atv320::device> unit_{unit_id{7}, timing, now_};
    std::deque<std::byte> bytes_{};
};

inline far_drive line;

/// What a program does with a value.
inline void show(signed_decihertz speed)
{
    ++line.rounds;
    std::cout << speed << '\n';
}

} // namespace stand_in
