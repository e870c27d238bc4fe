// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// One end of a line between two: a port as every command opens it, a pseudo-terminal that is made for it, or TCP on which it
// listens.
#pragma once

#include <string>
#include <variant>

#include "line/open_line.hpp"
#include "port/served_port.hpp"

namespace tool {

class line_end {
public:
    enum class side { client, server };

    /// Opens what `word` names. A client that asks over TCP connects, so that it is listened there.
    line_end(side whose, std::string const& word, line_choices const& chosen);

    /// "/dev/pts/5", "host:4001".
    [[nodiscard]] std::string const& device() const { return device_; }
    [[nodiscard]] int descriptor_number() const;
    /// How long a silence ends what has no length.
    [[nodiscard]] rtuwire::duration silence() const;
    /// Sends what is taken soon: nobody may read there. Ends the command where the port fails.
    void write(rtuwire::byte_view bytes);
    /// What is there now.
    [[nodiscard]] rtuwire::byte_view read(rtuwire::byte_span place);

private:
    [[noreturn]] void fail() const;
    void listen(std::string const& option, tcp_address const& where);

    std::variant<any_port, own_terminal, tcp_listener> port_{};
    std::string device_{};
};

} // namespace tool
