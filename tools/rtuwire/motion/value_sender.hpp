// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Values on their way into a unit: by which function, and as which bytes.
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include <rtuwire/frames.hpp>

#include "line/open_line.hpp"
#include "line/unit_address.hpp"
#include "words/value_words.hpp"

namespace tool {

using value_list = std::vector<value_to_write>;

/// What function 16 or 15 sends of values.
[[nodiscard]] std::vector<std::byte> bytes_of(value_list const& values);

/// By function 16, of coils by 15.
template <typename Send> auto by_one_request(value_list const& values, Send send)
{
    std::uint16_t const address = values[0].where.address;
    std::vector<std::byte> const bytes = bytes_of(values);
    return values[0].where.is_single_bit()
               ? send(rtuwire::write_multiple_coils<>{address, rtuwire::bit_view{bytes, values.size()}})
               : send(rtuwire::write_multiple_registers<>{address, rtuwire::register_view{bytes}});
}

/// Refuses values in whose one request another frame stands: of several registers or coils they may hold a whole one; so may
/// one of whatever the unit takes by function 16 only.
void refuse_frame_within(unit_address unit, value_list const& values);

/// Whether the unit itself says that it did not write. What a gateway says tells nothing of the unit.
[[nodiscard]] bool is_refusal_to_write(rtuwire::errc why);

/// How values are sent.
struct value_sender {
    open_line& line;
    unit_address unit;
    bool is_drive{false};
    bool may_repeat{false};  ///< where nobody wants a repetition, busy units are asked once, too
    bool may_rewrite{false}; ///< bits of a unit without function 22: all of the register as it was just read

    /// By function 05 or 06, of several registers by 16, of several coils by 15, of bits by 22. A device that lacks 05 or 06 is
    /// written by 15 or 16, which is noted.
    rtuwire::errc send(value_list const& values, std::string& note);

private:
    template <typename Request> rtuwire::errc sent(Request const& request);
    rtuwire::errc send_all(value_list const& values);
    rtuwire::errc send_bits(value_to_write const& value, std::string& note);
};

} // namespace tool
