// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
#include "chaos/line_end.hpp"

#include <algorithm>

#include "exit_status.hpp"
#include "line/usual_settings.hpp"

namespace tool {

namespace {

/// A write to a pseudo-terminal is one, whatever else the machine does.
constexpr rtuwire::duration pty_silence = rtuwire::milliseconds(20);
constexpr rtuwire::duration write_limit = rtuwire::milliseconds(500);

} // namespace

line_end::line_end(side whose, std::string const& word, line_choices const& chosen)
{
    std::string const option = whose == side::client ? "--from" : "--to";
    if (word == "pty") {
        auto& made = port_.emplace<own_terminal>();
        if (not made.open()) {
            std::string const listening = whose == side::client ? ", or tcp://127.0.0.1:4001 to listen there" : "";
            throw ended{exit_status::port, option + " pty: " + no_terminal_text(option + " COM3" + listening)};
        }
        device_ = made.path();
        return;
    }
    port_choice const which = read_port_word(word);
    auto const* const address = which.refused ? nullptr : std::get_if<tcp_address>(&which.port);
    if (address != nullptr and whose == side::client) {
        listen(option, *address);
        return;
    }
    line_choices one = chosen;
    one.port = word;
    if (is_modbus_tcp(one)) {
        refuse_word(option + ' ' + word +
                    ": Modbus TCP has no line, whose faults these are: its messages have numbers, and no CRC");
    }
    try {
        device_ = port_.emplace<any_port>(open_port(one, setting_in(one))).device();
    } catch (ended const& why) {
        throw ended{why.status, option + ": " + why.what()};
    }
}

void line_end::listen(std::string const& option, tcp_address const& where)
{
    device_ = where.host + ':' + std::to_string(where.port);
    if (std::string const why = port_.emplace<tcp_listener>().listen(where); not why.empty()) {
        throw ended{exit_status::port, option + ": " + device_ + ": cannot listen there: " + why};
    }
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
    rtuwire::instant const until = rtuwire::steady_now() + write_limit;
    if (auto* const listener = std::get_if<tcp_listener>(&port_)) {
        listener->write(bytes, until);
        return;
    }
    auto* const made = std::get_if<own_terminal>(&port_);
    auto const done = made != nullptr ? made->write(bytes, until) : std::get<any_port>(port_).write(bytes, until);
    if (not done and done != rtuwire::errc::transmit_stalled) {
        fail();
    }
}

rtuwire::byte_view line_end::read(rtuwire::byte_span place)
{
    rtuwire::instant const now = rtuwire::steady_now();
    if (auto* const listener = std::get_if<tcp_listener>(&port_)) {
        return listener->read(place, now);
    }
    auto* const made = std::get_if<own_terminal>(&port_);
    auto const bytes = made != nullptr ? made->read(place, now) : std::get<any_port>(port_).read(place, now);
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
