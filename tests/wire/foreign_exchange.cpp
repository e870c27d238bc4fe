// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// What may be the response that is expected, and what may be a request in its place.
#include <rtuwire/wire/functions.hpp>

#include "support/proof.hpp"

#include <rtuwire/core/hex.hpp>

using namespace rtuwire;
using namespace rtuwire::detail;

namespace {

using exchange = foreign_exchange<direction::request>;

constexpr exchange after(std::uint8_t unit, std::uint8_t function)
{
    exchange made;
    made.expect(unit, function);
    return made;
}

constexpr auto head_2_3 = "02 03"_hex;
constexpr auto head_2_83 = "02 83"_hex;
constexpr auto head_2_4 = "02 04"_hex;
constexpr auto head_3_3 = "03 03"_hex;
STATIC_CHECK(after(2, 3).is_expected(head_2_3) and after(2, 3).is_expected(head_2_83));
STATIC_CHECK(not after(2, 3).is_expected(head_2_4) and not after(2, 3).is_expected(head_3_3));
STATIC_CHECK(not after(2, 0x80).is_expected(head_2_3) and not after(2, 0x83).is_expected(head_2_83));
constexpr auto head_0_0 = "00 00"_hex;
STATIC_CHECK(not exchange{}.is_expected(head_0_0));

/// Whether a frame of a function with this fifth byte may be a request.
constexpr bool may_ask(std::uint8_t function, std::uint8_t fifth)
{
    std::array<std::byte, 8> const frame{std::byte{2}, std::byte{function}, {}, {}, std::byte{fifth}};
    return after(2, function).may_be_request(frame);
}
STATIC_CHECK(may_ask(1, 7) and not may_ask(1, 8) and may_ask(2, 7) and not may_ask(2, 8));
STATIC_CHECK(may_ask(3, 0) and not may_ask(3, 1) and may_ask(4, 0) and not may_ask(4, 1));
STATIC_CHECK(may_ask(5, 255) and may_ask(16, 255));
constexpr auto four_bytes = "02 03 00 00"_hex;
STATIC_CHECK(after(2, 3).may_be_request(four_bytes));

/// What is told of a frame that is due after a request of unit 2 to read one register.
constexpr end_hint told_of(byte_view so_far) { return after(2, 3).apply(so_far); }
constexpr auto response = "02 03 02 12 00 F0 E4"_hex;
constexpr bool takes_a_response_for_one()
{
    // At seven bytes the response ends; with its fifth byte 00 a request would end one byte later.
    end_hint const whole = told_of(response);
    end_hint const part = told_of(byte_view{response}.first(6));
    end_hint const begun = told_of(byte_view{response}.first(3));
    using test::is;
    return is(whole.is_here, "the whole frame has its end") and is(whole.is_response, "it is a response") and
           is(whole.is_open, "by the other rule a byte more") and
           is(whole.next == 8, "so it is asked again at eight") and is(not part.is_here, "six bytes have no end") and
           is(part.next == 7, "after six bytes, seven are asked for") and
           is(not begun.is_here, "three bytes have no end") and is(begun.next == 7, "after three bytes, seven as well");
}
PROOF("where the response ends and a request might go on, it ends as the response", takes_a_response_for_one)

constexpr bool ends()
{
    exchange it = after(2, 3);
    bool ok = not it.is_response();
    it.end_frame(true);
    ok = ok and it.is_response() and not it.takes(std::byte{1}) and it.is_response();
    ok = ok and it.takes(std::byte{0}) and not it.is_response() and it.takes(std::byte{0});
    it.begin_frame();
    return ok and not it.is_response();
}
PROOF("a byte 00 turns a response into a request, or a request into a response", ends)

} // namespace
