// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Any other function: every code, every size.
#include <rtuwire/wire/raw.hpp>

#include <array>

#include "support/encode_space.hpp"
#include "support/proof.hpp"
#include "support/random.hpp"

#include <rtuwire/core/hex.hpp>

using namespace rtuwire;
using namespace rtuwire::detail;

namespace {

constexpr bool has_a_code_of_1_to_127()
{
    constexpr auto data = "01 02 03"_hex;
    for (std::uint32_t number = 0; number <= 0xFF; ++number) {
        raw_pdu const some{static_cast<function_code>(number), data};
        bool const is_right = number >= 1 and number <= 127
                                  ? test::survives(some, [&](auto const& r) { return r == some; })
                                  : test::is_refused(some, errc::invalid_function, 16);
        test::exact_bytes pdu{1};
        pdu.span()[0] = to_byte(number);
        bool const is_read = raw_pdu<>::decode(pdu.view()).has_value();
        if (not is_right or is_read != (number >= 1 and number <= 127)) {
            return false;
        }
    }
    return true;
}
PROOF("a raw function has a code of 1 to 127", has_a_code_of_1_to_127)

constexpr bool needs_its_room()
{
    constexpr auto data = "04 18"_hex;
    return test::needs_room(raw_pdu{static_cast<function_code>(24), data}, 6) and
           raw_pdu<>::decode({}) == errc::wrong_length;
}
PROOF("a raw frame needs all of its bytes", needs_its_room)

} // namespace

TEST_CASE("a raw function carries up to 252 bytes")
{
    std::array<std::byte, 254> data{};
    test::random{41}.fill(data);
    for (std::size_t size = 0; size <= data.size(); ++size) {
        CAPTURE(size);
        raw_pdu const some{static_cast<function_code>(0x41), byte_view{data}.first(size)};
        if (size <= 252) {
            CHECK(test::survives(some, [&](auto const& read) { return read == some; }));
        } else {
            CHECK(test::is_refused(some, errc::frame_too_long, 300));
        }
    }
}
