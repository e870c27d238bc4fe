// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// The smallest server: a frame in, a frame out, in one place. For firmware that has whole frames already,
// from a receiver that tells of the line's silence and a DMA channel. What keeps other units' answers
// apart from requests, and an answer from being late, is in server.hpp.
#pragma once

#include <rtuwire/server/respond.hpp>
#include <rtuwire/wire/adu.hpp>
#include <rtuwire/wire/unit_id.hpp>

namespace rtuwire {

/// Answers the request that lies in the first `size` octets of `place`, which has at least 256. The
/// answer is written in its place; empty where none is due: for another unit, to everyone, damaged.
/// A request of our unit that another one's answer looks like cannot be told from it here.
template <register_bank Bank, typename Diagnostics>
[[nodiscard]] constexpr byte_span answer_frame(byte_span place, std::size_t size, unit_id unit,
                                               Bank& bank, server_profile const& profile,
                                               Diagnostics& line) noexcept
{
    auto const asked = decode_adu(place.first(size));
    if (not asked or (asked->unit != unit.octet() and asked->unit != 0)) {
        return {};
    }
    bool const is_broadcast = asked->unit == 0;
    if (is_broadcast and not may_be_broadcast(asked->pdu)) {
        return {};
    }
    byte_view const answer = respond(asked->pdu, bank, profile, place.subspan(1), line);
    return is_broadcast or answer.empty() ? byte_span{} : seal(place, answer.size());
}

} // namespace rtuwire
