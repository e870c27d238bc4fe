// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// The smallest server: a frame in, a frame out, in one place. For firmware that has whole frames already,
// from a receiver that tells of the line's silence and a DMA channel. What keeps other units' answers
// apart from requests, and an answer from being late, is in server.hpp.
#pragma once

#include <rtuwire/core/version.hpp>
#include <rtuwire/server/respond.hpp>
#include <rtuwire/wire/adu.hpp>
#include <rtuwire/wire/unit_id.hpp>

namespace rtuwire::inline RTUWIRE_BUILD {

/// Answers the request that lies in the first `size` octets of `place`, which has at least 256. The
/// answer is written in its place; empty where none is due: for another unit, to everyone, damaged.
/// A request of our unit that another one's answer looks like cannot be told from it here.
template <register_bank Bank, typename Diagnostics>
[[nodiscard]] constexpr byte_span answer_frame(byte_span place, std::size_t size, unit_id unit,
                                               Bank& bank, server_profile const& profile,
                                               Diagnostics& line) noexcept
{
    bool const is_broadcast = to_u8(place[0]) == 0;
    bool const is_meant = is_broadcast or to_u8(place[0]) == unit.octet();
    if (not is_meant or check_frame(place.first(size)) != errc::none) {
        return {};
    }
    pdu_place pdu{place.subspan(1).first<max_pdu_size>(), size - adu_overhead};
    if (is_broadcast and not may_be_broadcast(pdu.view())) {
        return {};
    }
    respond_in_place(pdu, bank, profile, line);
    return is_broadcast or pdu.size == 0 ? byte_span{} : seal(place, pdu.size);
}

} // namespace rtuwire
