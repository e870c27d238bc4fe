// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A serial port with a simulated drive behind it, for blocking clients; its clock jumps to whatever is next.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <rtuwire/rtu/line.hpp>
#include <rtuwire/sim/drive/unit.hpp>

namespace rtuwire::test {

using namespace detail;

template <typename Device> struct drive_port {
    static constexpr line_timing timing{19'200, character_format::even_8_1};

    sim::unit<Device> far{unit_id{3}, timing, instant{0}};
    instant clock{0};
    std::vector<std::vector<std::byte>> sent{};

    instant now() const { return clock; }

    result<void> write(byte_view bytes, instant)
    {
        sent.emplace_back(bytes.begin(), bytes.end());
        clock = clock + timing.characters(bytes.size());
        far.receive(bytes, clock);
        return {};
    }

    result<byte_span> read(byte_span place, instant until)
    {
        for (;;) {
            far.advance(clock);
            if (byte_view const frame = far.poll_transmit(); not frame.empty()) {
                std::copy(frame.begin(), frame.end(), place.begin());
                byte_span const got = place.first(frame.size());
                clock = clock + timing.characters(frame.size());
                far.sent(clock);
                return got;
            }
            if (reached(clock, until)) {
                return place.first(0);
            }
            instant next = clock + milliseconds(1);
            if (deadline const due = far.poll_deadline(); due and not reached(clock, *due) and reached(next, *due)) {
                next = *due;
            }
            clock = reached(next, until) ? until : next;
        }
    }

    /// How often a control word was written.
    std::size_t commands(std::uint16_t word) const
    {
        auto const is_it = [word](std::vector<std::byte> const& frame) {
            return frame.size() == 8 and frame[1] == std::byte{6} and u16_at(frame, 2) == Device::layout.cmd and
                   u16_at(frame, 4) == word;
        };
        return static_cast<std::size_t>(std::count_if(sent.begin(), sent.end(), is_it));
    }
    bool has_power() { return cia402::has_power(far.drive().state_machine().state()); }
};

} // namespace rtuwire::test
