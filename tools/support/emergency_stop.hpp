// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// What stops the motor when the program must not go on: one frame, made beforehand, straight to the port's
// descriptor. It uses nothing of the client or the port, whose state may be wrong, and nothing that a signal
// handler may not use.
#pragma once

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <span>

#include <rtuwire/drives.hpp>
#include <rtuwire/frames.hpp>

#include "platform.hpp"
#include "signals.hpp"

namespace tool {

/// The frame that stops the motor and the line it goes to; no line while no motor is commanded.
struct emergency_stop {
    std::atomic<int> line{-1};
    std::array<std::byte, 260> frame{};
    std::size_t size{0};

    /// `port` is any that has a number of the system's, and `as_sent` where a frame goes there in another form; `command` is
    /// the address of the drive's control word.
    template <typename Port> void arm(Port const& port, rtuwire::unit_id drive, std::uint16_t command)
    {
        constexpr std::uint16_t disable_voltage = 0;
        std::array<std::byte, 8> place{};
        std::array<std::byte, 260> other_form{};
        auto const written =
            rtuwire::encode_into(place, drive, rtuwire::write_single_register{command, disable_voltage});
        rtuwire::byte_view sent = written ? rtuwire::byte_view{*written} : rtuwire::byte_view{};
        if constexpr (requires { port.as_sent(sent, other_form); }) {
            sent = port.as_sent(sent, other_form);
        }
        std::copy(sent.begin(), sent.end(), frame.begin());
        size = sent.size();
        line = written ? number_of(port) : -1;
    }

    void disarm() noexcept { line = -1; }

    /// Sends it twice: each time the line had time to fall silent, and the driver to send it. Does nothing
    /// when it is called again.
    void stop_motor() noexcept
    {
        int const target = line.exchange(-1);
        for (int i = 0; i < 2 and target >= 0; ++i) {
            pause_for(std::chrono::milliseconds{400});
            // What the port does not take is lost, and sent again.
            write_past_port(target, std::span{frame}.first(size));
        }
        if (target >= 0) {
            pause_for(std::chrono::milliseconds{100});
        }
    }
};

inline emergency_stop emergency;

/// What the program would have done at its end otherwise: say why.
inline std::terminate_handler last_words = nullptr;

/// Neither an error of this program must leave the motor running (an exception that nobody catches, a trap, a wrong address, a
/// stack that is used up), nor a system that ends it before the motor stands.
inline void stop_motor_before_dying()
{
    last_words = std::set_terminate([] {
        emergency.stop_motor(); // before it is said: the output may block
        last_words();
    });
    call_before_dying([] { emergency.stop_motor(); });
    call_before_closing([] { emergency.stop_motor(); });
}

} // namespace tool
