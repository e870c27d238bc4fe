// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
#include "frame/frame_fit.hpp"

#include <algorithm>

#include <rtuwire/serial_line.hpp>

namespace tool {

namespace {

using rtuwire::byte_view;
using rtuwire::errc;
using rtuwire::frame_role;

template <typename... Functions>
errc flaw_by(rtuwire::function_list<Functions...>, byte_view pdu, frame_role role, rtuwire::function_code code)
{
    errc found = errc::none;
    auto const look = [&]<typename Function>() {
        if (Function::code == code) {
            found =
                role == frame_role::request ? Function::decode(pdu).error() : Function::response::decode(pdu).error();
        }
    };
    (look.template operator()<Functions>(), ...);
    return found;
}

bool is_exception_code(byte_view pdu) { return (std::to_integer<unsigned>(pdu[0]) & 0x80U) != 0; }

} // namespace

std::vector<std::byte> frame_of(std::byte unit, byte_view pdu)
{
    std::vector<std::byte> frame{unit};
    for (std::byte const each : pdu) { // GCC 12 takes an insert behind the first byte for one beyond the end
        frame.push_back(each);
    }
    unsigned const crc = rtuwire::crc16(frame);
    frame.push_back(static_cast<std::byte>(crc & 0xFFU));
    frame.push_back(static_cast<std::byte>(crc >> 8U));
    return frame;
}

bool has_known_fields(byte_view pdu)
{
    constexpr auto identification = std::byte{14}; // the type of function 43 that the library knows
    auto const code = static_cast<rtuwire::function_code>(pdu[0]);
    bool const is_other_type =
        code == rtuwire::function_code::encapsulated_interface and pdu.size() > 1 and pdu[1] != identification;
    return is_exception_code(pdu) or (rtuwire::all_functions.contains(code) and not is_other_type);
}

errc flaw_of(byte_view pdu, frame_role role)
{
    if (is_exception_code(pdu)) {
        return role == frame_role::request ? errc::invalid_function : rtuwire::exception_response::decode(pdu).error();
    }
    if (not has_known_fields(pdu)) {
        return rtuwire::raw_pdu<>::decode(pdu).error();
    }
    return flaw_by(rtuwire::public_functions{}, pdu, role, static_cast<rtuwire::function_code>(pdu[0]));
}

errc flaw_of_response(byte_view request, byte_view response)
{
    constexpr std::size_t code_of_access = 2;
    errc const flaw = flaw_of(response, frame_role::response);
    bool const is_of_another = flaw == errc::none and has_known_fields(request) and has_known_fields(response) and
                               request[0] == std::byte{43} and request.size() > code_of_access and
                               response[code_of_access] != request[code_of_access];
    return is_of_another ? errc::response_mismatch : flaw;
}

bool is_known_pdu(byte_view pdu)
{
    return has_known_fields(pdu) and
           (flaw_of(pdu, frame_role::request) == errc::none or flaw_of(pdu, frame_role::response) == errc::none);
}

std::size_t frame_at_begin(rtuwire::byte_view bytes, rtuwire::frame_role role)
{
    rtuwire::running_crc16<> crc;
    for (std::size_t size = 1; size <= std::min(bytes.size(), rtuwire::max_adu_size); ++size) {
        crc.add(bytes[size - 1]);
        if (size >= rtuwire::min_adu_size and crc.value() == 0) {
            rtuwire::byte_view const pdu = bytes.subspan(1, size - 3);
            if (has_known_fields(pdu) and flaw_of(pdu, role) == rtuwire::errc::none) {
                return size;
            }
        }
    }
    return 0;
}

} // namespace tool
