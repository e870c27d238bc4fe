// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Where a frame lies in its receiver's memory: at the start, or behind what is kept in front of it.
#include <rtuwire/rtu/framer.hpp>

#include <type_traits>

#include "support/proof.hpp"

#include <rtuwire/rtu/line.hpp>

using namespace rtuwire;
using namespace rtuwire::detail;

namespace {

/// The largest frame that there is room for behind so many bytes.
template <std::size_t Front, std::size_t Longest = max_adu_size> constexpr std::size_t room_behind(std::size_t kept)
{
    frame_place<Front, Longest> place;
    place.leave_room_for(kept);
    return place.memory - place.begin();
}

STATIC_CHECK(room_behind<10>(0) == 256 and room_behind<10>(10) == 256);
STATIC_CHECK(room_behind<10>(12) == 254 and room_behind<10>(256) == 10);
STATIC_CHECK(room_behind<1>(1) == 256 and room_behind<1>(2) == 255);
STATIC_CHECK(room_behind<256>(256) == 256);
STATIC_CHECK(room_behind<8, 64>(8) == 64 and room_behind<8, 64>(20) == 52 and room_behind<8, 64>(72) == 0);

// Without anything in front, there is nothing to note.
STATIC_CHECK(frame_place<0>::begin() == 0 and frame_place<0>::memory == 256);
STATIC_CHECK(std::is_empty_v<frame_place<0>>);

template <typename Receiver>
concept keeps_a_front = requires(Receiver receiver)
{
    receiver.receive_behind(1);
};
template <std::size_t Front>
using receiver_behind = framer_state<direction::response, frame_place<Front>, stored<line_timing>>;
STATIC_CHECK(keeps_a_front<receiver_behind<1>>and keeps_a_front<receiver_behind<256>>);
STATIC_CHECK(not keeps_a_front<receiver_behind<0>>);

} // namespace
