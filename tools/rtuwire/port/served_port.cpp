// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
#include "port/served_port.hpp"

#include <array>
#include <chrono>
#include <span>
#include <utility>

#include "../support/platform.hpp"
#include "exit_status.hpp"

namespace tool {

std::string tcp_listener::listen(tcp_address const& where)
{
    constexpr int most_waiting = 4;
    return listening_.open(where.host, where.port, most_waiting) ? std::string{} : listening_.failure();
}

void tcp_listener::accept_one()
{
    if (auto next = listening_.accept()) {
        client_ = std::move(*next);
    }
}

void tcp_listener::write(rtuwire::byte_view bytes, rtuwire::instant)
{
    if (client_.is_open()) {
        static_cast<void>(send_at_once(client_.descriptor_number(), bytes)); // one that is gone reads nothing
    }
}

rtuwire::byte_span tcp_listener::read(rtuwire::byte_span place, rtuwire::instant until)
{
    rtuwire::duration const left = until - rtuwire::steady_now();
    std::array watched{watched_port(listening_.descriptor_number(), POLLIN),
                       watched_port(client_.descriptor_number(), POLLIN)};
    bool const is_over = reached(rtuwire::steady_now(), until);
    std::chrono::milliseconds const limit{is_over ? 0 : left.microseconds / 1'000U};
    if (poll_ports(std::span{watched}.first(client_.is_open() ? 2 : 1), limit) <= 0) {
        return place.first(0);
    }
    if (client_.is_open() and watched[1].revents != 0) {
        auto const came = receive_at_once(client_.descriptor_number(), place);
        if (came.value_or(0) > 0) {
            return place.first(*came);
        }
        hang_up();
    }
    if (watched[0].revents != 0) {
        accept_one();
    }
    return place.first(0);
}

served_port::served_port(std::string const& word, rtuwire::serial_settings const& settings)
{
    if (word.empty()) {
        open_pseudo_terminal();
        return;
    }
    port_choice const which = read_port_word(word);
    if (which.refused) {
        refuse_word(which.refused->sentence);
    }
    name_ = word;
    if (auto const* const device = std::get_if<serial_device>(&which.port)) {
        auto& port = port_.emplace<rtuwire::host_serial>();
        if (not port.open(device->path, settings)) {
            throw ended{exit_status::port, port.failure()};
        }
        has_wire_ = not is_pseudo_terminal(device->path);
    } else if (auto const* const address = std::get_if<tcp_address>(&which.port)) {
        name_ = word.substr(word.find("//") + 2);
        if (std::string const why = port_.emplace<tcp_listener>().listen(*address); not why.empty()) {
            throw ended{exit_status::port, "tcp://" + why};
        }
    } else {
        refuse_word("--port " + word + ": a client is served on a serial device, such as " + example_port +
                    ", at an address " +
                    "to listen on, such as tcp://127.0.0.1:4001, or on a pseudo-terminal where no port is given");
    }
}

void served_port::open_pseudo_terminal()
{
    auto& port = port_.emplace<own_terminal>();
    if (not port.open()) {
        throw ended{exit_status::port, no_terminal_text("-p COM3, or -p tcp://127.0.0.1:4001 to listen there")};
    }
    name_ = port.path();
    set_unusual_rate(name_);
}

void served_port::renew()
{
    if (auto* const listener = std::get_if<tcp_listener>(&port_)) {
        listener->hang_up();
    } else if (not is_device()) {
        open_pseudo_terminal();
    }
}

bool served_port::write(rtuwire::byte_view bytes, rtuwire::instant until)
{
    if (auto* const device = std::get_if<rtuwire::host_serial>(&port_)) {
        if (not device->write(bytes, until)) {
            throw ended{exit_status::port, device->failure()};
        }
    } else if (auto* const terminal = std::get_if<own_terminal>(&port_)) {
        return terminal->write(bytes, until).has_value(); // full where nobody reads
    } else {
        std::get<tcp_listener>(port_).write(bytes, until);
    }
    return true;
}

rtuwire::byte_span served_port::read(rtuwire::byte_span place, rtuwire::instant until)
{
    if (auto* const listener = std::get_if<tcp_listener>(&port_)) {
        return listener->read(place, until);
    }
    if (auto* const device = std::get_if<rtuwire::host_serial>(&port_)) {
        auto const came = device->read(place, until);
        if (not came) {
            throw ended{exit_status::port, device->failure()};
        }
        static_cast<void>(device->take_receive_error()); // its frame's CRC tells
        return *came;
    }
    auto const came = std::get<own_terminal>(port_).read(place, until);
    if (not came) {
        throw ended{exit_status::port, name_ + ": the pseudo-terminal failed"};
    }
    return *came;
}

} // namespace tool
