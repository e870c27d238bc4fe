// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// What stops the motor when the program must not go on: one frame, made beforehand, straight to the port.
// It uses nothing of the client, whose state may be wrong.
#pragma once

#include <array>
#include <chrono>
#include <cstddef>
#include <thread>

#include <rtuwire/cia402/command.hpp>
#include <rtuwire/port/posix_serial.hpp>
#include <rtuwire/table/device.hpp>
#include <rtuwire/wire/adu.hpp>
#include <rtuwire/wire/pdu/write_single_register.hpp>

namespace examples {

/// The frame that stops the motor and the port it goes to; no port while no motor is commanded.
struct emergency_stop {
    rtuwire::posix_serial* port{nullptr};
    std::array<std::byte, 8> frame{};

    template <rtuwire::device_type Device>
    void arm(rtuwire::posix_serial& line, rtuwire::station<Device> const& drive)
    {
        using namespace rtuwire;
        auto const written =
            encode_into(frame, drive.unit(),
                        write_single_register{Device::profile.cmd,
                                              cia402::word_of(cia402::command::disable_voltage)});
        port = written ? &line : nullptr;
    }

    /// Sends it twice: each time the line had time to fall silent, and the driver to send it.
    void stop_motor() const noexcept
    {
        for (int i = 0; i < 2 and port != nullptr; ++i) {
            std::this_thread::sleep_for(std::chrono::milliseconds{400});
            static_cast<void>(port->write(frame, port->now() + rtuwire::milliseconds(1'000)));
        }
        std::this_thread::sleep_for(std::chrono::milliseconds{100});
    }
};

inline emergency_stop emergency{};

} // namespace examples
