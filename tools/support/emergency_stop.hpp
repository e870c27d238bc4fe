// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// What stops the motor when the program must not go on: one frame, made beforehand, straight to the port's
// descriptor. It uses nothing of the client or the port, whose state may be wrong, and nothing that a signal
// handler may not use.
#pragma once

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstddef>
#include <cstdint>
#include <ctime>
#include <exception>

#include <unistd.h>

#include <rtuwire/drives.hpp>
#include <rtuwire/frames.hpp>

namespace tool {

/// The frame that stops the motor and the line it goes to; no line while no motor is commanded.
struct emergency_stop {
    int volatile line{-1};
    std::array<std::byte, 260> frame{};
    std::size_t size{0};

    /// `port` is any that has a `descriptor_number()`, and `as_sent` where a frame goes there in another form; `command` is
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
        line = written ? port.descriptor_number() : -1;
    }

    void disarm() noexcept { line = -1; }

    /// Sends it twice: each time the line had time to fall silent, and the driver to send it. Does nothing
    /// when it is called again.
    void stop_motor() noexcept
    {
        int const target = line;
        line = -1;
        for (int i = 0; i < 2 and target >= 0; ++i) {
            wait(400);
            // The port does not block. What it does not take is lost, and sent again.
            ssize_t written = -1;
            do {
                written = ::write(target, frame.data(), size);
            } while (written < 0 and errno == EINTR);
        }
        if (target >= 0) {
            wait(100);
        }
    }

private:
    static void wait(long milliseconds) noexcept
    {
        timespec left{0, milliseconds * 1'000'000};
        while (::nanosleep(&left, &left) != 0 and errno == EINTR) {
        }
    }
};

inline emergency_stop emergency;

/// Stops the motor, and lets the signal do what it does.
extern "C" inline void stop_and_die(int number)
{
    emergency.stop_motor();
    std::raise(number);
}

/// What the program would have done at its end otherwise: say why.
inline std::terminate_handler last_words = nullptr;

/// An error of this program must not leave the motor running: an exception that nobody catches, a trap, a wrong
/// address, a stack that is used up.
inline void stop_motor_before_dying()
{
    last_words = std::set_terminate([] {
        emergency.stop_motor(); // before it is said: the output may block
        last_words();
    });
    // The program's own may be what is used up.
    alignas(16) static std::array<std::byte, 32'768> stack;
    stack_t other{};
    other.ss_sp = stack.data();
    other.ss_size = stack.size();
    ::sigaltstack(&other, nullptr);
    struct sigaction taken {};
    taken.sa_handler = stop_and_die;
    taken.sa_flags = static_cast<int>(SA_RESETHAND) | SA_NODEFER | SA_ONSTACK;
    for (int const each : {SIGABRT, SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGTRAP, SIGSYS}) {
        sigaction(each, &taken, nullptr);
    }
}

} // namespace tool
