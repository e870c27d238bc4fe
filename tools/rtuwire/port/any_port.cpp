// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
#include "port/any_port.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <utility>

#include "../support/platform.hpp"
#include "port/device_holder.hpp"
#include "port/inner_line.hpp"
#include "port/nearest_device.hpp"

namespace tool {

using rtuwire::errc;
using rtuwire::host_serial;
using rtuwire::line_timing;
using rtuwire::mbap_stream;
using rtuwire::result;
using rtuwire::serial_settings;
using rtuwire::tcp_stream;

namespace {

std::string words_of_holder(device_holder const& who)
{
    return who.name.empty() ? std::string{}
                            : "held by " + who.name + ": two programs cannot share a port; end that first" +
                                  (who.is_start ? " (Ctrl-C ends start, whose motor stops with it)" : "");
}

} // namespace

result<void> any_port::open(port_description const& described, serial_settings const& settings)
{
    close();
    own_failure_.clear();
    heard_ = 0;
    has_sent_ = is_gone_ = false;
    return std::visit([&](auto const& chosen) { return open_one(chosen, settings); }, described);
}

result<void> any_port::open_one(serial_device const& chosen, serial_settings const& settings)
{
    auto& port = port_.emplace<host_serial>();
    auto const opened = port.open(chosen.path, settings);
    timing_ = port.timing();
    if (std::string const nearest = opened == errc::device_not_found ? nearest_device(chosen.path) : "";
        not nearest.empty()) {
        own_failure_ = port.failure() + "; did you mean " + nearest + "?";
    }
    std::string const more = opened == errc::device_in_use          ? words_of_holder(holder_of(chosen.path))
                             : opened == errc::device_access_denied ? words_of_group(chosen.path)
                                                                    : std::string{};
    if (not more.empty()) {
        own_failure_ = port.failure() + "; " + more;
    }
    return opened;
}

result<void> any_port::open_one(tcp_address const& chosen, serial_settings const& settings)
{
    // Not every serial device server keeps the silence between frames, and what the network varies by eats some of it.
    line_timing const wire{settings.bits_per_second, settings.format};
    timing_ = line_timing::without_wire().with_silence(wire.t3_5() + rtuwire::milliseconds(3));
    return port_.emplace<tcp_stream>().open(chosen.host, chosen.port);
}

result<void> any_port::open_one(mbap_address const& chosen, serial_settings const&)
{
    timing_ = rtuwire::mbap_stream::timing();
    return port_.emplace<mbap_stream>().open(chosen.host, chosen.port);
}

result<void> any_port::open_one(simulated_drives_choice const& chosen, serial_settings const&)
{
    timing_ = line_timing::without_wire();
    if (not drives_.start(chosen)) {
        own_failure_ = "sim: " + drives_.failure();
        return errc::device_failed;
    }
    return open_end(port_.emplace<client_end>(), drives_.device());
}

result<void> any_port::open_one(capture_file const& chosen, serial_settings const&)
{
    own_failure_ = chosen.path + ": a capture file, in which nobody answers";
    return errc::device_not_serial;
}

void any_port::keep_pause(rtuwire::duration silence) noexcept
{
    timing_ = silence > timing_.silence() ? timing_.with_silence(silence) : timing_;
}

void any_port::close() noexcept
{
    std::visit([](auto& port) { port.close(); }, port_);
    drives_.stop();
}

bool any_port::is_open() const noexcept
{
    return std::visit([](auto const& port) { return port.is_open(); }, port_);
}

int any_port::descriptor_number() const noexcept
{
    return std::visit([](auto const& port) { return number_of(port); }, port_);
}

std::string const& any_port::device() const noexcept
{
    return std::visit([](auto const& port) -> std::string const& { return port.device(); }, port_);
}

std::string const& any_port::failure() const noexcept
{
    return not own_failure_.empty()
               ? own_failure_
               : std::visit([](auto const& port) -> std::string const& { return port.failure(); }, port_);
}

result<void> any_port::write(rtuwire::byte_view bytes, rtuwire::instant until)
{
    if (attendant_ != nullptr and (attendant_->is_over() or not attendant_->may_send())) {
        has_taken_last_ = false;
        return errc::cancelled;
    }
    auto const written = std::visit([&](auto& port) { return port.write(bytes, until); }, port_);
    asked_ = bytes.empty() ? asked_ : std::to_integer<std::uint8_t>(bytes.front());
    has_taken_last_ = written and not is_gone_;
    has_sent_ = has_sent_ or written;
    note_failure(written.error());
    return written;
}

result<rtuwire::byte_span> any_port::read(rtuwire::byte_span place, rtuwire::instant until)
{
    auto const bytes = attendant_ != nullptr and is_open()
                           ? read_attended(place, until)
                           : std::visit([&](auto& port) { return port.read(place, until); }, port_);
    heard_ += bytes ? bytes->size() : 0;
    note_failure(bytes.error());
    return bytes;
}

/// What the port has already is read first: it may be in no descriptor any more.
result<rtuwire::byte_span> any_port::read_attended(rtuwire::byte_span place, rtuwire::instant until)
{
    auto const read_now = [&] { return std::visit([&](auto& port) { return port.read(place, now()); }, port_); };
    auto const bytes = read_now();
    has_receive_error_ = has_receive_error_ or take_receive_error();
    if (not bytes or not bytes->empty() or has_receive_error_) {
        return bytes;
    }
    attendant_->wait(descriptor_number(), until);
    if (attendant_->is_over()) {
        return errc::cancelled;
    }
    return read_now();
}

/// A server that is spoken to in the other of both protocols closes the connection, or answers what is none of this one.
void any_port::note_failure(rtuwire::errc why)
{
    is_gone_ = is_gone_ or why == errc::device_vanished;
    auto const* const numbered = std::get_if<mbap_stream>(&port_);
    bool const has_begun = numbered != nullptr and not numbered->begun().empty();
    bool const is_protocol = (why == errc::device_vanished and not has_begun) or why == errc::device_failed;
    if (is_protocol and has_sent_ and heard_ == 0 and own_failure_.empty()) {
        std::string const other = other_protocol();
        own_failure_ = other.empty() ? other : failure() + other;
    }
}

/// Where nothing that could be read has come; empty where a port has no other.
std::string any_port::other_protocol() const
{
    if (is_simulated()) {
        return {};
    }
    if (std::holds_alternative<mbap_stream>(port_)) {
        return "; Modbus TCP was sent: what takes RTU frames over TCP is tcp://" + device();
    }
    std::string_view constexpr usual = ":502";
    bool const is_usual = device().ends_with(usual);
    std::string const where = device().substr(0, device().size() - (is_usual ? usual.size() : 0));
    return std::holds_alternative<tcp_stream>(port_)
               ? "; RTU frames with a CRC were sent: " +
                     std::string{is_usual ? "port 502 is as a rule Modbus TCP, " : "a server of Modbus TCP is "} +
                     "mbap://" + where
               : "";
}

bool any_port::is_absent(std::uint8_t unit) const noexcept
{
    return is_simulated() and not std::ranges::binary_search(drives_.units(), unit);
}

/// Who is on a simulated line, where somebody else was asked.
std::string any_port::other_units(option_form form) const
{
    if (asked_ == 0 or not is_absent(asked_)) {
        return {};
    }
    std::string all;
    for (std::uint8_t const each : drives_.units()) {
        all += (all.empty() ? "" : " and ") + std::to_string(each);
    }
    return "; this simulated line has no unit " + std::to_string(asked_) + ", only " + all +
           advice(": say ", option_words(form, line_option::unit, std::to_string(drives_.units().front())));
}

namespace {

/// What names this unit; empty where nothing does.
std::string asked_by(std::uint8_t unit, option_form form)
{
    bool const is_usual = unit >= 1 and unit <= 247;
    std::string const any = is_usual ? "" : option_words(form, line_option::any_unit);
    return is_usual or not any.empty()
               ? any + (is_usual ? "" : " ") + option_words(form, line_option::unit, std::to_string(unit))
               : std::string{};
}

} // namespace

std::string any_port::words_of_silence(option_form form) const
{
    if (is_simulated()) {
        return other_units(form);
    }
    auto const* const numbered = std::get_if<mbap_stream>(&port_);
    if (numbered == nullptr or numbered->dropped() == rtuwire::mbap_dropped{}) {
        return heard_ == 0 ? other_protocol() : "";
    }
    auto const& dropped = numbered->dropped();
    std::string text;
    if (dropped.late > 0) {
        text += "; answers come too late and were dropped by their number, the last after " +
                longer_timeout(dropped.latest.microseconds / 1e6, form);
    }
    if (dropped.other_unit > 0) {
        text += "; an answer with its number came of unit " + std::to_string(dropped.unit) + " and was dropped" +
                advice(": a device that has only this one is asked by ", asked_by(dropped.unit, form));
    }
    return text;
}

rtuwire::byte_view any_port::as_sent(rtuwire::byte_view frame, rtuwire::byte_span place) const noexcept
{
    constexpr std::uint16_t number = 0xFFFF; // nobody waits for a response to it
    return std::holds_alternative<mbap_stream>(port_) ? mbap_stream::message_of(frame, number, place) : frame;
}

bool any_port::take_receive_error() noexcept
{
    auto* const device = std::get_if<host_serial>(&port_);
    if (std::exchange(has_receive_error_, false)) {
        return true;
    }
    bool const is_damaged = device != nullptr and device->take_receive_error();
    heard_ += is_damaged ? 1U : 0U;
    return is_damaged;
}

} // namespace tool
