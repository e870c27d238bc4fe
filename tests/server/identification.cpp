// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A server's identification: categories, single objects, pages.
#include <rtuwire/server/identification.hpp>

#include <array>

#include "support/proof.hpp"

#include <rtuwire/core/hex.hpp>

using namespace rtuwire;
using namespace rtuwire::detail;

namespace {

constexpr device_object drive[] = {
    {vendor_name, "Schneider Electric"}, {product_code, "ATV310H037N4"}, {major_minor_revision, "0201"}};

struct response {
    std::array<std::byte, max_pdu_size> place{};
    errc wrong{errc::busy};
    std::size_t size{0};

    constexpr byte_view bytes() const { return byte_view{place}.first(size); }
};

constexpr response response_to(device_objects const& objects, byte_view request)
{
    response given;
    byte_writer{given.place}.bytes(request);
    pdu_buffer pdu{given.place, request.size()};
    given.wrong = write_identification(pdu, objects);
    given.size = given.wrong == errc::none ? pdu.size : 0;
    return given;
}

constexpr response ask(device_objects const& objects, identification_access access, std::uint8_t object = 0)
{
    std::array<std::byte, read_device_identification::max_size> bytes{};
    byte_writer request{bytes};
    read_device_identification{access, object}.write(request);
    return response_to(objects, bytes);
}

constexpr bool manual_example()
{
    auto const given = ask(identity_of<drive>, identification_access::basic);
    constexpr auto head = "2B 0E 01 81 00 00 03 00 12 53 63 68 6E 65"_hex;
    auto const page = device_identification::decode(given.bytes());
    return given.size == std::size_t{47} and same_bytes(given.bytes().first(head.size()), head) and page and
           page->find(product_code)->size() == 12 and not page->more_follows;
}
PROOF("three objects of a drive are one page", manual_example)

constexpr bool single_objects()
{
    auto const one = ask(identity_of<drive>, identification_access::single, major_minor_revision);
    auto const none = ask(identity_of<drive>, identification_access::single, 7);
    return same_bytes(one.bytes(), "2B 0E 04 81 00 00 01 02 04 30 32 30 31"_hex) and
           none.wrong == errc::illegal_data_address;
}
PROOF("a single object is given alone, an unknown one is exception 02", single_objects)

constexpr errc refusal_of(byte_view request) { return response_to(identity_of<drive>, request).wrong; }
STATIC_CHECK(refusal_of("2B"_hex) == errc::illegal_data_value);
STATIC_CHECK(refusal_of("2B 0D"_hex) == errc::illegal_function);
STATIC_CHECK(refusal_of("2B 0E 01"_hex) == errc::illegal_data_value);
STATIC_CHECK(refusal_of("2B 0E 00 00"_hex) == errc::illegal_data_value);
STATIC_CHECK(refusal_of("2B 0E 05 00"_hex) == errc::illegal_data_value);
STATIC_CHECK(refusal_of("2B 0E 04 00"_hex) == errc::none);
STATIC_CHECK(ask(identity_of<drive>, identification_access::single, vendor_name).size == 7 + 2 + 18);

constexpr bool unknown_start()
{
    auto const whole = ask(identity_of<drive>, identification_access::basic, 0);
    auto const other = ask(identity_of<drive>, identification_access::basic, 9);
    auto const later = ask(identity_of<drive>, identification_access::basic, 2);
    return same_bytes(whole.bytes(), other.bytes()) and later.size == std::size_t{13};
}
PROOF("a stream starts where it is asked to, or at the first object", unknown_start)

constexpr device_object categories[] = {{0, "v"}, {1, "p"}, {2, "r"}, {4, "name"}, {0x80, "x"}};
STATIC_CHECK(device_objects{}.conformity() == 0x81);
STATIC_CHECK(ask({}, identification_access::basic).wrong == errc::illegal_function);
STATIC_CHECK(identity_of<drive>.conformity() == 0x81);
STATIC_CHECK(identity_of<categories>.conformity() == 0x83);
STATIC_CHECK(conformity_of(0x03) == 0x82);
STATIC_CHECK(conformity_of(0x7F) == 0x82);
STATIC_CHECK(conformity_of(0x80) == 0x83);

/// Objects as they leave.
constexpr auto written = "00 02 76 65 01 00 02 01 72"_hex;
STATIC_CHECK(device_objects::from(written).has_value());
STATIC_CHECK(device_objects::from(byte_view{written}.first(4)).has_value());
STATIC_CHECK(device_objects::from({}) == errc::malformed);
STATIC_CHECK(device_objects::from(byte_view{written}.first(5)) == errc::malformed);
STATIC_CHECK(device_objects::from(byte_view{written}.first(8)) == errc::malformed);
STATIC_CHECK(device_objects::from(byte_view{written}.subspan(4)) == errc::malformed);
STATIC_CHECK(device_objects::from("00 00 02 00 02 00"_hex) == errc::malformed);
STATIC_CHECK(device_objects::from("00 00 02 00 01 00"_hex) == errc::malformed);

constexpr bool known_at_run_time()
{
    auto const objects = device_objects::from(written);
    auto const given = ask(*objects, identification_access::basic);
    return same_bytes(given.bytes(), "2B 0E 01 81 00 00 03 00 02 76 65 01 00 02 01 72"_hex);
}
PROOF("objects that are known only at run time leave as they stand", known_at_run_time)

constexpr std::uint8_t count_in(identification_access access)
{
    auto const given = ask(identity_of<categories>, access);
    return to_u8(given.place[6]);
}
STATIC_CHECK(count_in(identification_access::basic) == 3);
STATIC_CHECK(count_in(identification_access::regular) == 4);
STATIC_CHECK(count_in(identification_access::extended) == 5);

constexpr literal long_text{"0123456789012345678901234567890123456789012345678901234567890123456789"
                            "01234567890123456789"};
constexpr device_object many[] = {{0, long_text}, {1, long_text}, {2, long_text}, {3, "url"}};

constexpr bool pages()
{
    unsigned seen = 0;
    std::uint8_t next = 0;
    for (unsigned round = 0; round < 5; ++round) {
        auto const given = ask(identity_of<many>, identification_access::regular, next);
        auto const page = device_identification::decode(given.bytes());
        if (not page or given.bytes().size() > max_pdu_size) {
            return false;
        }
        for (auto at = page->first(); at; at = page->after(*at)) {
            if (at->id != seen++) {
                return false;
            }
        }
        if (not page->more_follows) {
            return seen == 4 and round == 1 and page->next_object == 0;
        }
        next = page->next_object;
    }
    return false;
}
PROOF("objects that do not fit follow on the next page", pages)

/// The longest text of an object.
constexpr char longest[device_objects::max_text_size + 1]{'0'};
constexpr device_object largest[] = {{0, longest}, {1, "p"}};

constexpr bool refuses_what_no_page_holds()
{
    std::array<std::byte, 300> bytes{};
    bytes[1] = to_byte(device_objects::max_text_size);
    bool const fits = device_objects::from(byte_view{bytes}.first(2 + 244)).has_value();
    bytes[1] = to_byte(device_objects::max_text_size + 1);
    return fits and device_objects::from(byte_view{bytes}.first(2 + 245)) == errc::malformed;
}
PROOF("a text longer than a page is refused before it is served", refuses_what_no_page_holds)

constexpr bool fills_a_page()
{
    auto const given = ask(identity_of<largest>, identification_access::basic);
    return given.size == max_pdu_size and to_u8(given.place[4]) == 0xFF and to_u8(given.place[5]) == 1 and
           to_u8(given.place[6]) == 1 and to_u8(given.place[8]) == 244;
}
PROOF("an object of 244 characters fills a page", fills_a_page)

} // namespace

TEST_CASE("the conformity is that of the highest object, whatever the texts' sizes")
{
    CHECK(device_objects::from("00 02 41 42 01 01 43 02 03 44 45 46"_hex)->conformity() == 0x81);
    CHECK(device_objects::from("00 01 41 01 01 42 02 01 43 03 01 44"_hex)->conformity() == 0x82);
    CHECK(device_objects::from("00 01 41 01 01 42 02 01 43 06 02 44 45"_hex)->conformity() == 0x82);
    CHECK(device_objects::from("00 01 41 01 01 42 02 01 43 80 01 44"_hex)->conformity() == 0x83);
}
