// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
#include "chaos/line_end.hpp"

#include <algorithm>

#include "exit_status.hpp"
#include "line/usual_settings.hpp"

namespace tool {

namespace {

using rtuwire::pseudo_terminal;

/// A write to a pseudo-terminal is one, whatever else the machine does.
constexpr rtuwire::duration pty_silence = rtuwire::milliseconds(20);
constexpr rtuwire::duration write_limit = rtuwire::milliseconds(500);

} // namespace

line_end::line_end(std::string const& option, std::string const& word, line_choices const& chosen)
{
    if (word == "pty") {
        if (not port_.emplace<pseudo_terminal>().open()) {
            throw ended{exit_status::port, option + " pty: no pseudo-terminal to be had"};
        }
        return;
    }
    line_choices one = chosen;
    one.port = word;
    if (is_modbus_tcp(one)) {
        refuse_word(option + ' ' + word +
                    ": Modbus TCP has no line, whose faults these are: its messages have numbers, and no CRC");
    }
    try {
        port_.emplace<any_port>(open_port(one, setting_in(one)));
    } catch (ended const& why) {
        throw ended{why.status, option + ": " + why.what()};
    }
}

std::string line_end::device() const
{
    auto const* const made = std::get_if<pseudo_terminal>(&port_);
    return made != nullptr ? made->path() : std::get<any_port>(port_).device();
}

int line_end::descriptor_number() const
{
    return std::visit([](auto const& port) { return port.descriptor_number(); }, port_);
}

rtuwire::duration line_end::silence() const
{
    auto const* const opened = std::get_if<any_port>(&port_);
    return opened == nullptr ? pty_silence : std::max(pty_silence, opened->timing().frame_end());
}

void line_end::write(rtuwire::byte_view bytes)
{
    auto const done =
        std::visit([&](auto& port) { return port.write(bytes, rtuwire::steady_now() + write_limit); }, port_);
    if (not done and done != rtuwire::errc::transmit_stalled) {
        fail();
    }
}

rtuwire::byte_view line_end::read(rtuwire::byte_span place)
{
    auto const bytes = std::visit([&](auto& port) { return port.read(place, rtuwire::steady_now()); }, port_);
    if (not bytes) {
        fail();
    }
    return *bytes;
}

void line_end::fail() const
{
    auto const* const opened = std::get_if<any_port>(&port_);
    throw ended{exit_status::port, opened != nullptr ? opened->failure() : device() + ": the pseudo-terminal failed"};
}

} // namespace tool
