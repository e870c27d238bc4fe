// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
#include "serve/client_requests.hpp"

#include <algorithm>
#include <utility>

#include "frame/frame_fit.hpp"

namespace tool {

namespace {

served_request request_in(std::uint16_t number, rtuwire::byte_view unit_and_pdu, serve_time now)
{
    return {.number = number,
            .unit = std::to_integer<std::uint8_t>(unit_and_pdu[0]),
            .pdu = {unit_and_pdu.begin() + 1, unit_and_pdu.end()},
            .came = now};
}

/// Whether they are requests as RTU frames, one behind the other to the end.
bool are_frames(rtuwire::byte_view bytes)
{
    while (not bytes.empty()) {
        std::size_t const size = frame_at_begin(bytes, rtuwire::frame_role::request);
        if (size == 0) {
            return false;
        }
        bytes = bytes.subspan(size);
    }
    return true;
}

/// How many bytes a request has that begins so, its unit and its CRC with it, as far as they tell; 0 where they never do.
std::size_t size_so_far(rtuwire::byte_view frame)
{
    using enum rtuwire::function_code;
    auto const counted = [frame](std::size_t place, std::size_t others) {
        return frame.size() <= place ? place + 1 : others + std::to_integer<std::size_t>(frame[place]);
    };
    if (frame.size() < 2) {
        return 2;
    }
    switch (static_cast<rtuwire::function_code>(frame[1])) {
    case read_coils:
    case read_discrete_inputs:
    case read_holding_registers:
    case read_input_registers:
    case write_single_coil:
    case write_single_register:
    case diagnostics: return 8;
    case read_exception_status:
    case get_comm_event_counter:
    case get_comm_event_log:
    case report_server_id: return 4;
    case write_multiple_coils:
    case write_multiple_registers: return counted(6, 9);
    case read_file_record:
    case write_file_record: return counted(2, 5);
    case mask_write_register: return 10;
    case read_write_multiple_registers: return counted(10, 13);
    case read_fifo_queue: return 6;
    case encapsulated_interface: return 7;
    default: return 0;
    }
}

/// Whether they begin with a message of Modbus TCP, and go on with others.
bool begin_with_messages(rtuwire::byte_view bytes)
{
    rtuwire::mbap_cutter messages;
    bool has_whole = false;
    while (not bytes.empty() and messages.fault() == rtuwire::mbap_fault::none) {
        rtuwire::byte_span const room = messages.room();
        std::size_t const count = std::min(room.size(), bytes.size());
        std::copy_n(bytes.begin(), count, room.begin());
        messages.add(count);
        bytes = bytes.subspan(count);
        for (; messages.first(); messages.drop_first()) {
            has_whole = true;
        }
    }
    return has_whole and messages.fault() == rtuwire::mbap_fault::none;
}

} // namespace

rtuwire::byte_span client_requests::room()
{
    return is_rtu_ ? rtuwire::byte_span{bytes_}.subspan(size_) : messages_.room();
}

void client_requests::add(std::size_t count, serve_time now)
{
    if (is_rtu_) {
        resumed_at_ = size_ > 0 and now - latest_ >= silence ? size_ : resumed_at_;
        waits_for_rest_ = false;
        size_ += count;
    } else {
        messages_.add(count);
        begins_as_frame_ = begins_as_frame_ or
                           (not has_taken_ and frame_at_begin(messages_.bytes(), rtuwire::frame_role::request) > 0);
    }
    latest_ = now;
    begun_ = begun_ ? begun_ : std::optional{now};
}

std::optional<served_request> client_requests::take(serve_time now)
{
    auto const request = is_rtu_ ? take_frame(now) : take_message(now);
    bool const has_rest = is_rtu_ ? size_ > 0 : not messages_.bytes().empty();
    has_taken_ = has_taken_ or request;
    is_other_ = is_other_ or (begins_as_frame_ and not has_taken_);
    if (request) {
        begun_ = has_rest ? std::optional{now} : std::nullopt;
    } else if (not has_rest and not is_rtu_) {
        begun_.reset();
    }
    return request;
}

std::optional<served_request> client_requests::take_message(serve_time now)
{
    auto const message = messages_.first();
    if (not message) {
        return std::nullopt;
    }
    served_request request = request_in(message->number, message->body, now);
    constexpr std::size_t header_size = 6;
    is_other_ = is_other_ or are_frames(messages_.bytes().first(header_size + message->body.size()));
    messages_.drop_first();
    return request;
}

std::optional<served_request> client_requests::take_frame(serve_time now)
{
    std::size_t size = frame_at_begin(rtuwire::byte_view{bytes_}.first(size_), rtuwire::frame_role::request);
    if (resumed_at_ > 0 and size == 0 and
        frame_at_begin(rest().subspan(resumed_at_), rtuwire::frame_role::request) > 0) {
        dropped_ += resumed_at_; // its client has begun anew
        drop(resumed_at_);
        return take_frame(now);
    }
    bool const is_silent = size_ > 0 and now - latest_ >= silence;
    bool const is_too_long = size_ >= rtuwire::max_adu_size;
    waits_for_rest_ = size == 0 and is_silent and not is_too_long and has_half();
    if (size == 0 and not waits_for_rest_ and (is_silent or is_too_long)) {
        // Of a function that is not public the silence ends it.
        bool const is_frame = is_silent and size_ >= rtuwire::min_adu_size and size_ <= rtuwire::max_adu_size and
                              rtuwire::crc16(rtuwire::byte_view{bytes_}.first(size_)) == 0;
        size = is_frame ? size_ : 0;
        if (not is_frame) {
            is_other_ = is_other_ or begin_with_messages(rest());
            dropped_ += size_;
            drop(size_);
        }
    }
    if (size == 0) {
        return std::nullopt;
    }
    served_request request = request_in(0, rtuwire::byte_view{bytes_}.first(size - 2), now);
    drop(size);
    return request;
}

void client_requests::drop(std::size_t count)
{
    std::copy(bytes_.begin() + static_cast<std::ptrdiff_t>(count), bytes_.begin() + static_cast<std::ptrdiff_t>(size_),
              bytes_.begin());
    size_ -= count;
    resumed_at_ -= std::min(resumed_at_, count);
}

/// Whether its function says that more is to come of the frame; it is none where it is a message of Modbus TCP.
bool client_requests::has_half() const { return size_so_far(rest()) > size_ and not begin_with_messages(rest()); }

bool client_requests::is_broken() const { return not is_rtu_ and messages_.fault() != rtuwire::mbap_fault::none; }

rtuwire::byte_view client_requests::rest() const
{
    return is_rtu_ ? rtuwire::byte_view{bytes_}.first(size_) : messages_.bytes();
}

std::size_t client_requests::take_dropped() { return std::exchange(dropped_, 0); }

std::optional<serve_time> client_requests::part_ends() const
{
    return begun_ ? std::optional{*begun_ + longest_part} : std::nullopt;
}

std::optional<serve_time> client_requests::silence_ends() const
{
    return is_rtu_ and size_ > 0 and not waits_for_rest_ ? std::optional{latest_ + silence} : std::nullopt;
}

std::vector<std::byte> client_requests::answer(served_request const& to, rtuwire::byte_view pdu) const
{
    std::vector<std::byte> frame = frame_of(std::byte{to.unit}, pdu);
    if (is_rtu_) {
        return frame;
    }
    std::array<std::byte, rtuwire::max_mbap_size> place{};
    auto const message = rtuwire::write_mbap(place, {to.number, rtuwire::byte_view{frame}.first(frame.size() - 2)});
    return message ? std::vector<std::byte>{message->begin(), message->end()} : std::vector<std::byte>{};
}

} // namespace tool
