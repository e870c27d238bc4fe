// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
#include "frame/decode.hpp"

#include <algorithm>

#include "frame/damage.hpp"
#include "frame/frame_fit.hpp"
#include "frame/frame_layouts.hpp"
#include "frame/hex_text.hpp"

namespace tool {

namespace {

using rtuwire::byte_view;
using rtuwire::errc;
using rtuwire::frame_role;

constexpr std::size_t crc_size = 2;
constexpr frame_role roles[]{frame_role::request, frame_role::response};

std::string unit_text(std::byte unit)
{
    auto const number = std::to_integer<unsigned>(unit);
    return std::to_string(number) + (number == 0 ? ", broadcast" : number > 247 ? ", reserved" : "");
}

std::string crc_text(byte_view frame)
{
    if (rtuwire::crc16(frame) == 0) {
        return "right";
    }
    unsigned const crc = rtuwire::crc16(frame.first(frame.size() - crc_size));
    std::byte const right[]{static_cast<std::byte>(crc & 0xFFU), static_cast<std::byte>(crc >> 8U)};
    bool const is_swapped = right[0] == frame.back() and right[1] == frame[frame.size() - crc_size];
    return "wrong, right is " + hex_of(right) + (is_swapped ? " (swapped)" : "");
}

std::string length_flaw(std::size_t size, std::size_t needed)
{
    std::string const there = std::to_string(size) + (size == 1 ? " byte" : " bytes") + ", where its fields say ";
    return there + (needed > size ? "at least " : "") + std::to_string(needed);
}

/// The size that all frames of a function have, where there is one, of a frame with a CRC; else 0.
std::size_t size_of_function(frame_role role, byte_view bytes, bool has_crc)
{
    constexpr std::size_t two_words = 8;
    auto const code = has_crc ? std::to_integer<unsigned>(bytes[1]) : 0;
    bool const is_single_write = code == 5 or code == 6;
    bool const is_read = role == frame_role::request and code >= 1 and code <= 4;
    return is_single_write or is_read ? two_words : 0;
}

char const* word_for(frame_role role) { return role == frame_role::request ? "request" : "response"; }

/// Whether requests of this function have a first address and a quantity in front.
bool reads_a_run(std::byte function)
{
    auto const code = std::to_integer<unsigned>(function);
    return (code >= 1 and code <= 4) or code == 23;
}

} // namespace

void frame_decoder::remember(byte_view frame)
{
    asked_.reset();
    byte_view const pdu = frame.subspan(1, frame.size() - 1 - crc_size);
    if (reads_a_run(pdu[0]) and flaw_of(pdu, frame_role::request) == errc::none) {
        asked_ = {frame[0], pdu[0], {word_at(pdu, 1), word_at(pdu, 3)}};
    }
}

void frame_decoder::expect_answer_to(byte_view request)
{
    asked_.reset();
    if (request.size() >= rtuwire::min_adu_size) {
        remember(request);
    }
}

bool frame_decoder::is_answer(byte_view frame) const
{
    if (not asked_ or frame.size() < rtuwire::min_adu_size or frame[0] != asked_->unit or
        frame[1] != asked_->function) {
        return false;
    }
    bool const is_bits = std::to_integer<unsigned>(asked_->function) <= 2;
    std::size_t const bytes = is_bits ? (asked_->run.count + 7U) / 8U : std::size_t{2} * asked_->run.count;
    return std::to_integer<std::size_t>(frame[2]) == bytes and
           flaw_of(frame.subspan(1, frame.size() - 1 - crc_size), frame_role::response) == errc::none;
}

frame_reading frame_decoder::read(byte_view bytes, frame_role role, std::size_t tail, std::size_t& size) const
{
    frame_reading reading{.as = word_for(role)};
    bool const is_known = role == frame_role::response and is_answer(bytes);
    field_reader fields{bytes.subspan(1, bytes.size() - 1 - tail), units_.of(std::to_integer<std::uint8_t>(bytes[0]))};
    read_fields(fields, role, is_known ? std::optional{asked_->run} : std::nullopt);
    size = 1 + fields.size() + crc_size;
    reading.fields.push_back({0, 1, "unit", unit_text(bytes[0])});
    for (frame_field& each : fields.take_fields()) {
        reading.fields.push_back(std::move(each));
    }
    if (tail == crc_size) {
        reading.fields.push_back({bytes.size() - crc_size, crc_size, "CRC", crc_text(bytes)});
    }
    return reading;
}

/// Those without a flaw; else those whose length is right; else both, as far as they go.
void frame_decoder::add_readings(decoded_frame& frame, byte_view bytes) const
{
    bool const may_be_whole = bytes.size() >= rtuwire::min_adu_size and bytes.size() <= rtuwire::max_adu_size;
    byte_view const pdu = may_be_whole ? bytes.subspan(1, bytes.size() - 1 - crc_size) : byte_view{};
    std::size_t size = 0;
    for (frame_role const role : roles) {
        if (may_be_whole and flaw_of(pdu, role) == errc::none) {
            frame.readings.push_back(read(bytes, role, crc_size, size));
        }
    }
    for (frame_role const role : roles) {
        errc const flaw = frame.readings.empty() and may_be_whole ? flaw_of(pdu, role) : errc::none;
        if (flaw != errc::none) {
            frame_reading reading = read(bytes, role, crc_size, size);
            if (size == bytes.size() and flaw != errc::invalid_function) {
                reading.flaw = name(flaw);
                frame.readings.push_back(std::move(reading));
                break;
            }
        }
    }
    frame.is_whole = not frame.readings.empty();
    for (frame_role const role : roles) {
        if (not frame.is_whole) {
            frame_reading reading = read(bytes, role, frame.has_right_crc ? crc_size : 0, size);
            reading.flaw =
                length_flaw(bytes.size(), (std::max)(size, size_of_function(role, bytes, frame.has_right_crc)));
            frame.readings.push_back(std::move(reading));
        }
    }
}

decoded_frame frame_decoder::explain_other_protocol(byte_view bytes, frame_piece const& piece) const
{
    auto const message = tcp_message_in(bytes);
    std::size_t const header = message ? bytes.size() - message->frame.size() : 0;
    byte_view const rest = bytes.subspan(header);
    std::size_t const check = message ? 0 : 1;
    decoded_frame frame{piece.offset, {bytes.begin(), bytes.end()}, false, true};
    for (frame_role const role : roles) {
        if (flaw_of(rest.subspan(1, rest.size() - 1 - check), role) != errc::none) {
            continue;
        }
        std::size_t size = 0;
        frame_reading reading = read(rest, role, check, size);
        std::vector<frame_field> fields;
        if (message) {
            fields.push_back({0, 2, "transaction", std::to_string(message->transaction)});
            fields.push_back({2, 2, "protocol", "0, Modbus TCP: no CRC"});
            fields.push_back({4, 2, "length", std::to_string(rest.size())});
        }
        for (frame_field& each : reading.fields) {
            each.offset += header;
            fields.push_back(std::move(each));
        }
        if (not message) {
            fields.push_back({bytes.size() - 1, 1, "LRC", "right"});
        }
        reading.fields = std::move(fields);
        reading.as = (message ? "Modbus TCP " : "Modbus ASCII ") + reading.as;
        frame.readings.push_back(std::move(reading));
    }
    return frame;
}

decoded_frame frame_decoder::explain(byte_view bytes, frame_piece const& piece)
{
    bool const has_right_crc = rtuwire::check_frame(bytes) == errc::none;
    decoded_frame frame{piece.offset, {bytes.begin(), bytes.end()}, has_right_crc, false};
    add_readings(frame, bytes);
    bool const is_both = frame.readings.size() == 2;
    if (is_both and frame.readings[0].fields == frame.readings[1].fields and
        frame.readings[0].flaw == frame.readings[1].flaw) {
        frame.readings.pop_back();
        frame.readings[0].as = "request or response";
    } else if (is_both and frame.is_good() and is_answer(bytes)) {
        frame.readings.erase(frame.readings.begin());
    }
    asked_.reset();
    if (frame.is_good()) {
        remember(bytes);
    }
    frame.is_damaged = not has_right_crc;
    return frame;
}

std::vector<decoded_frame> frame_decoder::decode(byte_view run)
{
    std::vector<decoded_frame> frames;
    if (tcp_message_in(run) or is_ascii_message(run)) { // as a whole: its parts are no frames
        frames.push_back(explain_other_protocol(run, {0, run.size()}));
        return frames;
    }
    for (frame_piece const& piece : split_frames(run)) {
        frames.push_back(explain(run.subspan(piece.offset, piece.size), piece));
    }
    return frames;
}

decoded_frame frame_decoder::decode_as(byte_view frame, frame_role role)
{
    decoded_frame known = explain(frame, {0, frame.size()});
    std::string const as = word_for(role);
    if (std::ranges::count(known.readings, as, &frame_reading::as) > 0) {
        std::erase_if(known.readings, [&as](frame_reading const& each) { return each.as != as; });
    }
    known.readings.front().as = as;
    return known;
}

} // namespace tool
