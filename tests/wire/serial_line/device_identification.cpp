// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Function 43 type 14: which access codes may be asked, and pages that are cut, stretched or lie
// about their objects.
#include <rtuwire/wire/serial_line/device_identification.hpp>

#include <array>

#include "support/encode_space.hpp"
#include "support/proof.hpp"

#include <rtuwire/core/hex.hpp>

using namespace rtuwire;
using namespace rtuwire::detail;

namespace {

constexpr auto page_bytes = "2B 0E 01 02 00 00 03 00 02 41 42 01 01 43 02 00"_hex;

constexpr bool asks_in_four_ways()
{
    for (std::uint32_t code = 0; code <= 0xFF; ++code) {
        read_device_identification const ask{static_cast<identification_access>(code), 0x80};
        bool const is_right = code >= 1 and code <= 4 ? test::survives(ask, [&](auto const& r) { return r == ask; })
                                                      : test::is_refused(ask, errc::malformed, 16);
        if (not is_right) {
            return false;
        }
    }
    return test::needs_room(read_device_identification{}, 7);
}
PROOF("identification is asked for with an access code of 1 to 4", asks_in_four_ways)

constexpr bool asks_in_four_bytes()
{
    constexpr auto bytes = "2B 0E 01 00 00 00"_hex;
    for (std::size_t size = 0; size <= bytes.size(); ++size) {
        test::exact_bytes const pdu{byte_view{bytes}.first(size)};
        errc const expected = size == 0 ? errc::wrong_function : size == 4 ? errc::none : errc::wrong_length;
        if (read_device_identification::decode(pdu.view()).error() != expected) {
            return false;
        }
    }
    return true;
}
PROOF("identification is asked for in four bytes", asks_in_four_bytes)

constexpr bool is_read_whole_only()
{
    for (std::size_t size = 0; size <= page_bytes.size(); ++size) {
        test::exact_bytes const pdu{byte_view{page_bytes}.first(size)};
        errc const expected = size == 0                  ? errc::wrong_function
                              : size < 7                 ? errc::wrong_length
                              : size < page_bytes.size() ? errc::malformed
                                                         : errc::none;
        if (device_identification::decode(pdu.view()).error() != expected) {
            return false;
        }
    }
    return true;
}
PROOF("a page that is cut anywhere is refused", is_read_whole_only)

/// Whether a page is refused as soon as its number of objects or the length of one of them is
/// another value below a limit.
constexpr bool believes_no_other(std::uint32_t limit)
{
    for (std::size_t const at : {6U, 8U, 12U, 15U}) {
        for (std::uint32_t value = 0; value < limit; ++value) {
            test::exact_bytes pdu{page_bytes};
            pdu.span()[at] = to_byte(value);
            errc const expected = pdu.span()[at] == page_bytes[at] ? errc::none : errc::malformed;
            if (device_identification::decode(pdu.view()).error() != expected) {
                return false;
            }
        }
    }
    return true;
}
constexpr bool believes_no_other_small_number() { return believes_no_other(24); }
PROOF("a page with another number of objects or another length is refused", believes_no_other_small_number)

constexpr bool says_more_in_two_ways()
{
    for (std::uint32_t value = 0; value <= 0xFF; ++value) {
        test::exact_bytes pdu{page_bytes};
        pdu.span()[4] = to_byte(value);
        auto const read = device_identification::decode(pdu.view());
        bool const is_known = value == 0x00 or value == 0xFF;
        if (read.has_value() != is_known or (read and read->more_follows != (value == 0xFF))) {
            return false;
        }
    }
    return true;
}
PROOF("more follows is 00 or FF", says_more_in_two_ways)

constexpr bool keeps_its_fields_apart()
{
    constexpr auto bytes = "2B 0E 02 83 FF 04 01 03 02 48 69"_hex;
    test::exact_bytes const pdu{bytes};
    auto const read = device_identification::decode(pdu.view());
    using test::is;
    return is(read.has_value(), "it decodes") and is(read->access == identification_access::regular, "access") and
           is(read->conformity == 0x83, "conformity") and is(read->more_follows, "more follows") and
           is(read->next_object == 4, "next object") and is(read->count == 1, "count") and
           is(same_bytes(*read->find(3), "48 69"_hex), "the object that is there") and
           is(not read->find(4), "the object that is not");
}
PROOF("a page's fields are not taken for each other", keeps_its_fields_apart)

constexpr bool is_written_well_formed_only()
{
    constexpr auto list = "00 01 41 02 00"_hex;
    device_identification const page{identification_access::basic, 1, false, 0, 2, list};
    device_identification too_many = page;
    too_many.count = 3;
    device_identification none = page;
    none.count = 0;
    return test::needs_room(page, 15) and test::is_refused(too_many, errc::malformed) and
           test::is_refused(none, errc::malformed) and
           test::survives(page, [&](auto const& r) { return same_bytes(r.list, list); });
}
constexpr bool says_that_more_follows()
{
    constexpr auto list = "00 01 41"_hex;
    device_identification const page{identification_access::basic, 1, true, 1, 1, list};
    device_identification::object const of_another_page{7, list};
    return test::survives(page, [](auto const& r) { return r.more_follows; }) and not page.after(of_another_page);
}
PROOF("a page says that more follows", says_that_more_follows)
PROOF("a page is written only when its objects come out even", is_written_well_formed_only)

/// A page that was not decoded: its list ends within its only object.
constexpr auto half_an_object = "00 03 41"_hex;
constexpr device_identification by_hand{identification_access::basic, 1, false, 0, 1, half_an_object};
STATIC_CHECK(not by_hand.first());
STATIC_CHECK(by_hand.check() == errc::malformed);

} // namespace

TEST_CASE("a page with any other number of objects or any other length is refused") { CHECK(believes_no_other(256)); }

TEST_CASE("a page holds one object of up to 244 bytes")
{
    std::array<std::byte, 256> list{};
    for (std::size_t length = 0; length <= 250; ++length) {
        CAPTURE(length);
        list[1] = to_byte(static_cast<std::uint32_t>(length));
        device_identification const page{identification_access::single,    0x81, false, 0, 1,
                                         byte_view{list}.first(2 + length)};
        if (length <= 244) {
            CHECK(test::survives(page, [&](auto const& read) {
                return read.find(0)->size() == length and not read.after(*read.first());
            }));
        } else {
            CHECK(test::is_refused(page, errc::frame_too_long, 300));
        }
    }
}

TEST_CASE("objects are found only where their numbers rise")
{
    for (std::uint32_t first = 0; first <= 0xFF; ++first) {
        for (std::uint32_t second = 0; second <= 0xFF; ++second) {
            std::array<std::byte, 11> pdu = "2B 0E 03 83 00 00 02 00 00 00 00"_hex;
            pdu[7] = to_byte(first);
            pdu[9] = to_byte(second);
            auto const read = device_identification::decode(pdu);
            if (read.has_value() != (first < second)) {
                FAIL("objects " << first << " and " << second);
            }
        }
    }
}
