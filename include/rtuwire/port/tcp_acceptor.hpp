// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// The other end of TCP: waits for connections at an address of this machine, and hands them out as streams.
#pragma once

#include <array>
#include <cerrno>
#include <cstdint>
#include <cstring>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include <rtuwire/core/result.hpp>
#include <rtuwire/core/time.hpp>
#include <rtuwire/core/version.hpp>
#include <rtuwire/port/chrono.hpp>
#include <rtuwire/port/descriptor.hpp>
#include <rtuwire/port/host_lookup.hpp>
#include <rtuwire/port/platform.hpp>
#include <rtuwire/port/tcp_stream.hpp>
#include <rtuwire/wire/errc.hpp>

namespace rtuwire {
inline namespace RTUWIRE_BUILD {

/// Listens at one address. Can be moved; its destructor ends that, and no connection that was handed out.
class tcp_acceptor {
public:
    /// Listens at the first address of a host; port 0 is any that is free, and `device` tells which. So many connections may wait
    /// to be accepted. Errors, with a `failure()`: `device_not_found` (no such address here), `device_in_use`,
    /// `device_access_denied`, `timed_out`, `device_failed`.
    result<void> open(std::string const& host, std::uint16_t port, int most_waiting = 8)
    {
        close();
        device_ = name_of(host, std::to_string(port));
        auto const lookup = std::make_shared<detail::host_lookup>(host, port);
        if (auto const found = lookup->run(steady_now() + milliseconds(3'000)); not found) {
            return failed(found.error(), "no such host (" + lookup->why() + ")");
        }
        addrinfo const& address = *lookup->first();
        line_ = detail::socket_for(address);
        if (not line_.is_open()) {
            return failed(errc::device_failed, detail::system_text(errno));
        }
        detail::set_option(line_.number(), SOL_SOCKET, detail::listening_option, 1);
        auto const socket = detail::socket_of(line_.number());
        if (::bind(socket, address.ai_addr, static_cast<socklen_t>(address.ai_addrlen)) != 0 or
            ::listen(socket, most_waiting) != 0) {
            int const why = detail::socket_error();
            line_.close();
            return failed(listen_error(why), detail::system_text(why));
        }
        device_ = own_name();
        return {};
    }

    void close() noexcept { line_.close(); }

    /// The system's number of the socket, in non-blocking mode, for `poll`: it can be read once a connection waits; -1 where none
    /// is open.
    [[nodiscard]] int descriptor_number() const noexcept { return line_.number(); }

    /// Where it listens, by numbers: "127.0.0.1:1502".
    [[nodiscard]] std::string const& device() const noexcept { return device_; }

    /// Why it does not listen, in words, beginning with host and port; empty before.
    [[nodiscard]] std::string const& failure() const noexcept { return failure_; }

    /// A connection that waits, whose `device()` is where it comes from: "192.168.1.7:50123". Nothing where none waits, and where
    /// the system has no room for it. Never becomes standard input, output or error output.
    [[nodiscard]] std::optional<tcp_stream> accept() const
    {
        detail::standard_places const kept;
        sockaddr_storage from{};
        socklen_t size = sizeof from;
        detail::descriptor made{
            detail::number_of(::accept(detail::socket_of(line_.number()), reinterpret_cast<sockaddr*>(&from), &size))};
        if (not detail::standard_places::is_above(made.number()) or not detail::set_up_socket(made.number())) {
            return std::nullopt;
        }
        detail::set_up_connection(made.number());
        return tcp_stream{std::move(made), name_of(from, size)};
    }

private:
    static errc listen_error(int system_error) noexcept
    {
        return system_error == EADDRINUSE      ? errc::device_in_use
               : system_error == EADDRNOTAVAIL ? errc::device_not_found
                                               : detail::device_error(system_error);
    }

    static std::string name_of(std::string const& host, std::string const& port)
    {
        return (host.find(':') != host.npos ? "[" + host + "]:" : host + ":") + port;
    }

    static std::string name_of(sockaddr_storage const& address, socklen_t size)
    {
        std::array<char, NI_MAXHOST> host{};
        std::array<char, NI_MAXSERV> port{};
        bool const is_known = ::getnameinfo(reinterpret_cast<sockaddr const*>(&address), size, host.data(),
                                            static_cast<socklen_t>(host.size()), port.data(),
                                            static_cast<socklen_t>(port.size()), NI_NUMERICHOST | NI_NUMERICSERV) == 0;
        return is_known ? name_of(host.data(), port.data()) : std::string{};
    }

    std::string own_name() const
    {
        sockaddr_storage own{};
        socklen_t size = sizeof own;
        return ::getsockname(detail::socket_of(line_.number()), reinterpret_cast<sockaddr*>(&own), &size) == 0
                   ? name_of(own, size)
                   : device_;
    }

    result<void> failed(errc error, std::string const& why)
    {
        failure_ = device_ + ": cannot listen there: " + why;
        return error;
    }

    detail::descriptor line_{};
    std::string device_{};
    std::string failure_{};
};

} // namespace RTUWIRE_BUILD
} // namespace rtuwire
