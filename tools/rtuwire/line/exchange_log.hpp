// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// What the program itself says on a line and hears there: each frame on the standard error (-v), and in a file for Wireshark
// (--trace).
#pragma once

#include <rtuwire/trace.hpp>

#include "choices.hpp"
#include "port/any_port.hpp"

namespace tool {

struct line_setting;

class exchange_log {
public:
    /// As the choices say. All lines of a run have one file, which begins with the first of them; ends where it cannot be
    /// written.
    static exchange_log of(line_choices const& chosen, line_setting const& how, any_port const& port);

    /// A frame has passed. A file that can take no more is told of once, and left.
    void take(rtuwire::traced_frame const& frame) noexcept;

private:
    bool is_shown_{false};
};

} // namespace tool
