// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// The smallest server: a frame in, a frame out, in one place. For firmware that has whole frames already, from a
// receiver that detects the line's silence and a DMA channel. Telling other units' responses from requests, and
// dropping late responses, is done in server.hpp.
#pragma once

#include <rtuwire/core/version.hpp>
#include <rtuwire/server/respond.hpp>
#include <rtuwire/wire/adu.hpp>
#include <rtuwire/wire/unit_id.hpp>

namespace rtuwire {
inline namespace RTUWIRE_BUILD {

/// Answers the request in the first `size` bytes of `place`, which has at least 256. The response is written over it;
/// empty where none is due: another unit, a broadcast, a damaged frame. A request to this unit cannot be told here
/// from another unit's response that looks like it.
template <typename Functions = detail::register_functions, typename Bank, typename Diagnostics>
[[nodiscard]] constexpr byte_span response_frame(byte_span place, std::size_t size, unit_id unit, Bank& bank,
                                                 server_profile const& profile, Diagnostics& line) noexcept
{
    bool const is_broadcast = detail::to_u8(place[0]) == 0;
    bool const is_meant = is_broadcast or detail::to_u8(place[0]) == unit.byte();
    if (not is_meant or check_frame(place.first(size)) != errc::none) {
        return {};
    }
    detail::request_head const asked{static_cast<function_code>(detail::to_u8(place[1])), is_broadcast};
    if (not asked.has_effect<Functions>() or detail::to_u8(asked.function) >= detail::exception_bit) {
        return {};
    }
    detail::pdu_buffer pdu{place.subspan(1).first<max_pdu_size>(), size - detail::adu_overhead};
    static_cast<void>(detail::execute<Functions>(asked.function, pdu, bank, profile, line));
    return is_broadcast or pdu.size == 0 ? byte_span{} : detail::append_crc(place, pdu.size);
}

} // namespace RTUWIRE_BUILD
} // namespace rtuwire
