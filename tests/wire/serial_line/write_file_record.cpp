// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Function 21: one run and several, their limits, and every size.
#include <rtuwire/wire/serial_line/file_records.hpp>

#include "support/golden.hpp"
#include "support/pdu_facts.hpp"
#include "support/proof.hpp"

#include <rtuwire/core/hex.hpp>

using namespace rtuwire;
using namespace rtuwire::detail;

namespace {

constexpr register_block records{0x06AF, 0x04BE, 0x100D};
constexpr write_file_record printed{4, 7, records};
STATIC_CHECK(test::encodes(unit_id{1}, printed, "01 15 0D 06 00 04 00 07 00 03 06 AF 04 BE 10 0D D6 0B"_hex));

constexpr bool reads_several_runs()
{
    constexpr auto bytes = "15 14 06 00 04 00 07 00 02 06 AF 04 BE 06 00 03 00 09 00 01 10 0D"_hex;
    auto const read = write_file_record<>::decode(bytes);
    using test::is;
    return is(read and read->run(0) and read->run(1) and not read->run(2), "runs") and
           is(read->run(0)->run == file_run{4, 7, 2} and read->run(1)->run == file_run{3, 9, 1}, "heads") and
           is(read->run(0)->values[1] == 0x04BE and read->run(1)->values[0] == 0x100D, "records") and
           is(test::needs_room(*read, 25) and test::needs_room(printed, 18), "room");
}
PROOF("function 21 is read with several runs", reads_several_runs)

constexpr errc told(byte_view pdu) { return file_writes::decode(pdu).error(); }
STATIC_CHECK(told("15 09 06 00 04 00 07 00 01 06 AF"_hex) == errc::none);
STATIC_CHECK(told("14 09 06 00 04 00 07 00 01 06 AF"_hex) == errc::wrong_function);
STATIC_CHECK(told("15 09 07 00 04 00 07 00 01 06 AF"_hex) == errc::malformed);    // another reference
STATIC_CHECK(told("15 09 06 00 04 00 07 00 02 06 AF"_hex) == errc::wrong_length); // more records than bytes
STATIC_CHECK(told("15 09 06 00 04 00 07 FF FF 06 AF"_hex) == errc::wrong_length);
STATIC_CHECK(told("15 0A 06 00 04 00 07 00 01 06 AF 06"_hex) == errc::wrong_length); // the beginning of a run
STATIC_CHECK(told("15 09 06 00 00 00 07 00 01 06 AF"_hex) == errc::invalid_address_range);
STATIC_CHECK(told("15 07 06 00 04 00 07 00 00"_hex) == errc::invalid_quantity);
STATIC_CHECK(told("15 09 06 00 04 27 10 00 01 06 AF"_hex) == errc::invalid_address_range);
STATIC_CHECK(told("15 09 06 00 04 27 0F 00 01 06 AF"_hex) == errc::none);
STATIC_CHECK(told("15 0B 06 00 04 27 0F 00 02 06 AF 00 00"_hex) == errc::invalid_address_range);
STATIC_CHECK(told("15 00"_hex) == errc::invalid_quantity and told("15"_hex) == errc::wrong_length);
STATIC_CHECK(told("15 08 06 00 04 00 07 00 01 06 AF"_hex) == errc::wrong_length);
// Of several runs, each one.
STATIC_CHECK(told("15 12 06 00 04 00 07 00 01 06 AF 06 00 00 00 07 00 01 06 AF"_hex) == errc::invalid_address_range);

constexpr bool is_refused_outside()
{
    using test::is;
    return is(test::is_refused(write_file_record{0, 7, records}, errc::invalid_address_range), "file 0") and
           is(test::is_refused(write_file_record{4, 9998, records}, errc::invalid_address_range),
              "past record 9999") and
           is(write_file_record{0xFFFF, 9997, records}.check() == errc::none, "the last records");
}
PROOF("function 21 writes records 0 to 9999 of files from 1", is_refused_outside)

} // namespace

TEST_CASE("runs of function 21 have at most 251 bytes")
{
    std::array<std::byte, 7 + 2 * 123> bytes{std::byte{6}, {}, std::byte{4}};
    for (std::uint32_t const count : {121U, 122U, 123U}) {
        bytes[6] = to_byte(count);
        file_writes const whole{byte_view{bytes}.first(7U + 2U * count)};
        CHECK((whole.check() == (count <= 122 ? errc::none : errc::invalid_quantity)));
    }
}

TEST_CASE("function 21 writes 1 to 122 records in one run")
{
    test::sample const some{21};
    for (std::size_t count = 0; count <= 124; ++count) {
        CAPTURE(count);
        write_file_record const tell{4, 7, register_view{some.first(2 * count)}};
        auto const is_same = [&](file_writes const& read) {
            return read.run(0)->values == tell.values and read.run(0)->run.count == count and not read.run(1);
        };
        CHECK((count >= 1 and count <= 122 ? test::survives(tell, is_same)
                                           : test::is_refused(tell, errc::invalid_quantity)));
    }
}

TEST_CASE("a request of function 21 is read only in whole runs that fill it")
{
    constexpr auto whole = "15 14 06 00 04 00 07 00 02 06 AF 04 BE 06 00 03 00 09 00 01 10 0D"_hex;
    for (std::size_t size = 2; size <= whole.size(); ++size) {
        CAPTURE(size);
        test::exact_bytes part{byte_view{whole}.first(size)};
        CHECK(file_writes::decode(part.view()).error() == (size == whole.size() ? errc::none : errc::wrong_length));
        part.span()[1] = to_byte(static_cast<std::uint32_t>(size - 2));
        CHECK(file_writes::decode(part.view()).error() == (size == 13 or size == whole.size() ? errc::none
                                                           : size == 2                        ? errc::invalid_quantity
                                                                                              : errc::wrong_length));
    }
}
