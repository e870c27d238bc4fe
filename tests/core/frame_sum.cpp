// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// The two ways to sum a frame, over each single damage.
#include <rtuwire/core/crc16.hpp>

#include <array>
#include <cstddef>

#include "support/catch.hpp"

#include <rtuwire/core/hex.hpp>

using namespace rtuwire;
using namespace rtuwire::detail;

namespace {

constexpr auto whole = "02 03 0C 1E 00 04 27 6C"_hex; // a manual's example

template <crc_form Form> bool accepts(byte_view frame)
{
    frame_sum<Form> sum;
    sum.begin();
    for (std::byte const each : frame) {
        sum.add(each);
    }
    return sum.is_right(frame);
}

/// The same of a frame that arrives in pieces, which the sum copies.
template <crc_form Form> bool accepts_pieces(byte_view frame)
{
    std::array<std::byte, 8> copied{};
    frame_sum<Form> sum;
    sum.begin();
    sum.copy(frame.data(), 3, copied.data());
    sum.copy(frame.data() + 3, 0, copied.data() + 3);
    sum.copy(frame.data() + 3, 5, copied.data() + 3);
    return sum.is_right(copied);
}

} // namespace

TEMPLATE_TEST_CASE_SIG("a frame is right as it stands, and with no bit changed", "", ((crc_form Form), Form),
                       crc_form::bitwise, crc_form::nibble_table, crc_form::byte_table, crc_form::host)
{
    CHECK(accepts<Form>(whole));
    CHECK(accepts_pieces<Form>(whole));
    for (std::size_t bit = 0; bit < 8 * whole.size(); ++bit) {
        auto damaged = whole;
        damaged[bit / 8] ^= static_cast<std::byte>(1U << bit % 8);
        CHECK_FALSE(accepts<Form>(damaged));
        CHECK_FALSE(accepts_pieces<Form>(damaged));
    }
}

TEST_CASE("a frame that begins anew is not right because the last one was")
{
    frame_sum<crc_form::host> sum;
    sum.begin();
    sum.note_right();
    CHECK(sum.is_right(byte_view{whole}.first(7)));
    sum.begin();
    CHECK_FALSE(sum.is_right(byte_view{whole}.first(7)));
}
