// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// One end of a line between two: a port as every command opens it, or a pseudo-terminal that is made for it.
#pragma once

#include <string>
#include <variant>

#include "line/open_line.hpp"

namespace tool {

class line_end {
public:
    /// Opens what `word` names; `option` says it in a message: "--from".
    line_end(std::string const& option, std::string const& word, line_choices const& chosen);

    /// "/dev/pts/5", "host:4001".
    [[nodiscard]] std::string device() const;
    [[nodiscard]] int descriptor_number() const;
    /// How long a silence ends what has no length.
    [[nodiscard]] rtuwire::duration silence() const;
    /// Sends what is taken soon: nobody may read there. Ends the command where the port fails.
    void write(rtuwire::byte_view bytes);
    /// What is there now.
    [[nodiscard]] rtuwire::byte_view read(rtuwire::byte_span place);

private:
    [[noreturn]] void fail() const;

    std::variant<any_port, rtuwire::pseudo_terminal> port_{};
};

} // namespace tool
