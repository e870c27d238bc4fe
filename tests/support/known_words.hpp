// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Drives whose control words somebody has read to be those of the drive profile, for what runs without a client.
#pragma once

#include <cstdint>

#include <rtuwire/altivar/device/drive_layout.hpp>
#include <rtuwire/ask/commander.hpp>
#include <rtuwire/client/orders.hpp>

namespace rtuwire::test {

using namespace detail;

/// Somebody who has just read it.
struct reader_of_meaning : commander {
    explicit constexpr reader_of_meaning(unit_id unit) : commander{unit} { note_meaning(altivar::later_control_word); }
};

/// A unit of this client.
template <std::size_t Units> constexpr void confirm_words(orders<Units>& known, unit_id unit, instant now)
{
    reader_of_meaning who{unit};
    known.note_start(now);
    static_cast<void>(known.take_note_of(who, now));
}

/// The unit of a conversation that has no client.
template <typename Conversation> constexpr Conversation with_known_words(Conversation told)
{
    orders<1> known;
    confirm_words(known, told.unit(), instant{0});
    known.tell(told);
    return told;
}

} // namespace rtuwire::test
