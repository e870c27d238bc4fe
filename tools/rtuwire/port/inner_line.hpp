// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A line that this program makes: a pseudo-terminal. Windows has none; there two ends in one program are a connection within
// this computer, and nobody else is served but at an address or on a serial port.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>

#include <rtuwire/port.hpp>

#include "port/served_port.hpp"

namespace tool {

#ifdef _WIN32

/// The end of simulated drives: waits for the client of this program at a port that is free.
class drives_end {
public:
    bool open()
    {
        listening_ = std::make_unique<tcp_listener>();
        return listening_->listen({"127.0.0.1", 0}).empty();
    }
    /// "127.0.0.1:49152".
    std::string const& path() const { return listening_->device(); }

    rtuwire::result<void> write(rtuwire::byte_view bytes, rtuwire::instant until)
    {
        listening_->write(bytes, until);
        return {};
    }
    rtuwire::result<rtuwire::byte_span> read(rtuwire::byte_span place, rtuwire::instant until)
    {
        return listening_->read(place, until);
    }
    static rtuwire::instant now() noexcept { return rtuwire::steady_now(); }

private:
    std::unique_ptr<tcp_listener> listening_{};
};

using client_end = rtuwire::tcp_stream;

inline rtuwire::result<void> open_end(client_end& end, std::string const& path)
{
    std::size_t const colon = path.rfind(':');
    return end.open(path.substr(0, colon), static_cast<std::uint16_t>(std::stoul(path.substr(colon + 1))));
}

#else

using drives_end = rtuwire::pseudo_terminal;
using client_end = rtuwire::posix_serial;

/// Opens the other end.
inline rtuwire::result<void> open_end(client_end& end, std::string const& path) { return end.open(path); }

#endif

} // namespace tool
