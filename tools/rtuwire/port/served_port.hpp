// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// The server's end of a line: a pseudo-terminal of its own, a serial device, or TCP, on which it listens.
#pragma once

#include <string>
#include <variant>

#include <rtuwire/port.hpp>

#include "port/own_terminal.hpp"
#include "port/port_word.hpp"

namespace tool {

/// Waits for a client at a TCP port, and serves the one that came last.
class tcp_listener {
public:
    /// Why it cannot, beginning with host and port; empty where it listens.
    std::string listen(tcp_address const& where);
    /// Where it listens: "127.0.0.1:4001".
    std::string const& device() const noexcept { return listening_.device(); }
    /// Lets the client go.
    void hang_up() noexcept { client_.close(); }

    /// For `poll`: of its client, or of who may come where there is none.
    int descriptor_number() const noexcept
    {
        return client_.is_open() ? client_.descriptor_number() : listening_.descriptor_number();
    }

    void write(rtuwire::byte_view bytes, rtuwire::instant until);
    rtuwire::byte_span read(rtuwire::byte_span place, rtuwire::instant until);

private:
    void accept_one();

    rtuwire::tcp_acceptor listening_{};
    rtuwire::tcp_stream client_{};
};

class served_port {
public:
    /// An empty word is a pseudo-terminal. Ends where it cannot be opened.
    served_port(std::string const& word, rtuwire::serial_settings const& settings);

    /// What a client opens. Of a serial device that is its other end, whose name nobody knows here.
    std::string const& name() const { return name_; }
    bool is_device() const { return std::holds_alternative<rtuwire::host_serial>(port_); }
    /// Whether bytes take the time there that they take on a wire: not between pseudo-terminals, which are devices, too.
    bool has_wire() const { return has_wire_; }
    bool is_network() const { return std::holds_alternative<tcp_listener>(port_); }

    /// For the next client: nothing of what the one before left unread reaches it. A pseudo-terminal has a new name then.
    void renew();

    /// Bytes that nobody takes are lost, as on a wire: false. Ends where the port fails.
    [[nodiscard]] bool write(rtuwire::byte_view bytes, rtuwire::instant until);
    /// What came until then; empty where nothing did.
    rtuwire::byte_span read(rtuwire::byte_span place, rtuwire::instant until);

private:
    void open_pseudo_terminal();

    std::variant<own_terminal, rtuwire::host_serial, tcp_listener> port_{};
    std::string name_{};
    bool has_wire_{false};
};

} // namespace tool
