// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
#include "frame/frame_split.hpp"

#include <algorithm>

#include "frame/frame_fit.hpp"
#include "frame/frame_layouts.hpp"

namespace tool {

namespace {

using rtuwire::byte_view;

/// The PDU of a frame of 4 bytes or more.
byte_view pdu_in(byte_view frame) { return frame.subspan(1, frame.size() - 3); }

bool is_frame(byte_view bytes)
{
    return rtuwire::check_frame(bytes) == rtuwire::errc::none and is_known_pdu(pdu_in(bytes));
}

/// Of a function whose fields are not known, any length is.
bool is_as_long_as_its_fields(byte_view pdu)
{
    for (auto const role : {rtuwire::frame_role::request, rtuwire::frame_role::response}) {
        field_reader fields{pdu, nullptr};
        read_fields(fields, role, std::nullopt);
        if (not fields.is_short() and fields.size() == pdu.size()) {
            return true;
        }
    }
    return false;
}

/// The size of the shortest undamaged frame at the start for which `fits` holds; 0 where there is none.
template <typename Fits> std::size_t shortest(byte_view bytes, Fits fits)
{
    rtuwire::running_crc16<> crc;
    std::size_t const most = (std::min)(bytes.size(), std::size_t{rtuwire::max_adu_size});
    for (std::size_t size = 1; size <= most; ++size) {
        crc.add(bytes[size - 1]);
        if (size >= rtuwire::min_adu_size and crc.value() == 0 and fits(pdu_in(bytes.first(size)))) {
            return size;
        }
    }
    return 0;
}

/// By chance a CRC is right once in 65536 times. What is known to be a frame goes first, and the whole before a part.
std::size_t size_of_first(byte_view bytes)
{
    if (is_frame(bytes)) {
        return bytes.size();
    }
    if (std::size_t const known = shortest(bytes, is_known_pdu); known != 0) {
        return known;
    }
    if (rtuwire::check_frame(bytes) == rtuwire::errc::none) {
        return bytes.size();
    }
    return shortest(bytes, is_as_long_as_its_fields);
}

std::size_t next_frame(byte_view run, std::size_t after)
{
    for (std::size_t at = after; at < run.size(); ++at) {
        if (shortest(run.subspan(at), is_known_pdu) != 0) {
            return at;
        }
    }
    return run.size();
}

} // namespace

std::vector<frame_piece> split_frames(byte_view run)
{
    std::vector<frame_piece> pieces;
    for (std::size_t at = 0; at < run.size();) {
        std::size_t const good = size_of_first(run.subspan(at));
        std::size_t const size = good != 0 ? good : next_frame(run, at + 1) - at;
        pieces.push_back({at, size});
        at += size;
    }
    return pieces;
}

} // namespace tool
