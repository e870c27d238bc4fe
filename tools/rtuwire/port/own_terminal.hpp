// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A pseudo-terminal that other programs open, where the system has such.
#pragma once

#include <string>

#include <rtuwire/port.hpp>

#ifndef _WIN32
#include <filesystem>
#include <system_error>

#include <fcntl.h>
#include <termios.h>
#include <unistd.h>
#endif

namespace tool {

#ifdef _WIN32

/// There is none to be had.
class own_terminal {
public:
    static bool open() { return false; }
    static void close() noexcept {}
    static bool is_open() noexcept { return false; }
    static int descriptor_number() noexcept { return -1; }
    std::string const& path() const { return path_; }
    static rtuwire::result<void> write(rtuwire::byte_view, rtuwire::instant) { return rtuwire::errc::device_not_open; }
    static rtuwire::result<rtuwire::byte_span> read(rtuwire::byte_span, rtuwire::instant)
    {
        return rtuwire::errc::device_not_open;
    }
    static rtuwire::instant now() noexcept { return rtuwire::steady_now(); }

private:
    std::string path_{};
};

/// `instead`: what to say on Windows.
inline std::string no_terminal_text(std::string const& instead)
{
    return "Windows has no pseudo-terminals; say " + instead;
}

/// A port that is made for a client.
constexpr char const* new_client_port = "tcp://127.0.0.1:4001";

inline bool is_pseudo_terminal(std::string const&) { return false; }
inline void set_unusual_rate(std::string const&) {}

#else

using own_terminal = rtuwire::pseudo_terminal;

inline std::string no_terminal_text(std::string const&) { return "no pseudo-terminal to be had"; }

constexpr char const* new_client_port = "pty";

/// Whether a device is one, through links.
inline bool is_pseudo_terminal(std::string const& path)
{
    std::error_code none;
    return std::filesystem::canonical(path, none).string().starts_with("/dev/pts/");
}

/// A pseudo-terminal has no parity: a client's request for 8E1 is refused where nothing of it changes anything, so it finds
/// another bit rate here than any that it asks for.
inline void set_unusual_rate(std::string const& path)
{
    int const far = ::open(path.c_str(), O_RDWR | O_NOCTTY | O_CLOEXEC);
    termios settings{};
    if (far >= 0 and ::tcgetattr(far, &settings) == 0) {
        ::cfsetspeed(&settings, B50);
        static_cast<void>(::tcsetattr(far, TCSANOW, &settings));
    }
    if (far >= 0) {
        ::close(far);
    }
}

#endif

} // namespace tool
