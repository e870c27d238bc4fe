// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Function 20: runs of records, their limits, and every size.
#include <rtuwire/wire/serial_line/file_records.hpp>

#include "support/golden.hpp"
#include "support/pdu_facts.hpp"
#include "support/proof.hpp"

#include <rtuwire/core/hex.hpp>

using namespace rtuwire;
using namespace rtuwire::detail;

namespace {

constexpr auto asked = "14 0E 06 00 04 00 01 00 02 06 00 03 00 09 00 02"_hex;
constexpr read_file_record printed{file_run{.file = 4, .record = 1, .count = 2}, file_run{3, 9, 2}};
STATIC_CHECK(test::encodes(unit_id{1}, printed, "01 14 0E 06 00 04 00 01 00 02 06 00 03 00 09 00 02 F4 FD"_hex));

constexpr bool is_as_printed()
{
    constexpr auto bytes = "14 0C 05 06 0D FE 00 20 05 06 33 CD 00 40"_hex;
    auto const request = read_file_record<>::decode(asked);
    auto const told = read_file_record_response::decode(bytes);
    using test::is;
    return is(request and request->runs.size() == 2, "runs") and
           is(request->runs[0] == file_run{4, 1, 2} and request->runs[1] == file_run{3, 9, 2}, "each run") and
           is(told and told->run(0) and told->run(1) and not told->run(2), "runs of records") and
           is((*told->run(0))[0] == 0x0DFE and (*told->run(0))[1] == 0x0020, "records of the first") and
           is((*told->run(1))[0] == 0x33CD and (*told->run(1))[1] == 0x0040, "records of the second") and
           is(test::needs_room(*told, 17) and test::needs_room(printed, 19), "room");
}
PROOF("function 20 is read as it is printed", is_as_printed)

constexpr errc verdict(file_run run) { return read_file_record{run}.check(); }

// Files are numbered from 1, records from 0 to 9999.
STATIC_CHECK(verdict({1, 0, 1}) == errc::none and verdict({0xFFFF, 9999, 1}) == errc::none);
STATIC_CHECK(verdict({1, 9998, 2}) == errc::none and verdict({1, 9998, 3}) == errc::invalid_address_range);
STATIC_CHECK(verdict({1, 10'000, 1}) == errc::invalid_address_range);
STATIC_CHECK(verdict({1, 0xFFFF, 0xFFFF}) == errc::invalid_address_range);
STATIC_CHECK(verdict({0, 0, 1}) == errc::invalid_address_range and verdict({1, 0, 0}) == errc::invalid_quantity);
// A response has 245 bytes at most behind its byte count: two for each run, and two for each record.
STATIC_CHECK(verdict({1, 0, 121}) == errc::none and verdict({1, 0, 122}) == errc::invalid_quantity);
STATIC_CHECK(read_file_record{file_run{1, 0, 60}, file_run{1, 0, 60}}.check() == errc::none);
STATIC_CHECK(read_file_record{file_run{1, 0, 60}, file_run{1, 0, 61}}.check() == errc::invalid_quantity);

/// Any number of runs, all of one record.
struct many_runs {
    std::size_t count;
    [[nodiscard]] constexpr std::size_t size() const { return count; }
    constexpr file_run operator[](std::size_t index) const { return {1, static_cast<std::uint16_t>(index), 1}; }
};

constexpr errc told(byte_view pdu) { return read_file_record_response::decode(pdu).error(); }
STATIC_CHECK(told("14 00"_hex) == errc::malformed and told("14 01 00"_hex) == errc::malformed);
STATIC_CHECK(told("14 04 03 06 12 34"_hex) == errc::none and told("15 04 03 06 12 34"_hex) == errc::wrong_function);
STATIC_CHECK(told("14 04 03 07 12 34"_hex) == errc::malformed);       // another reference
STATIC_CHECK(told("14 04 05 06 12 34"_hex) == errc::malformed);       // a run beyond the end
STATIC_CHECK(told("14 05 04 06 12 34 56"_hex) == errc::malformed);    // half a record
STATIC_CHECK(told("14 06 03 06 12 34 01 06"_hex) == errc::malformed); // a run without records
STATIC_CHECK(told("14 06 01 06 03 06 12 34"_hex) == errc::malformed); // a run without records before a whole one
STATIC_CHECK(told("14 05 05 06 12 34 56"_hex) == errc::malformed);    // a run whose last byte is missing
STATIC_CHECK(told("14 04 03 06 12"_hex) == errc::wrong_length and told("14"_hex) == errc::wrong_length);

/// What a response is to the request of two runs.
constexpr errc answer(byte_view pdu) { return detail::function_row<read_file_record<>>::check_response(asked, pdu); }
STATIC_CHECK(answer("14 0C 05 06 0D FE 00 20 05 06 33 CD 00 40"_hex) == errc::none);
STATIC_CHECK(answer("14 0B 05 06 0D FE 00 20 05 06 33 CD 00"_hex) == errc::response_mismatch);
STATIC_CHECK(answer("14 0A 05 06 0D FE 00 20 05 06 33 CD"_hex) == errc::response_mismatch);
STATIC_CHECK(answer("14 06 05 06 0D FE 00 20"_hex) == errc::response_mismatch);
STATIC_CHECK(answer("14"_hex) == errc::response_mismatch);

} // namespace

TEST_CASE("function 20 asks for 1 to 35 runs")
{
    for (std::size_t count = 0; count <= 40; ++count) {
        CAPTURE(count);
        read_file_record<many_runs> const ask{many_runs{count}};
        CHECK((count >= 1 and count <= 35 ? test::needs_room(ask, 5 + 7 * count)
                                          : test::is_refused(ask, errc::invalid_quantity)));
    }
    CHECK(read_file_record{std::array<file_run, 2>{{{1, 0, 121}, {1, 0, 1}}}}.check() == errc::invalid_quantity);
}

TEST_CASE("a request of function 20 is read only in whole runs, each with its reference")
{
    for (std::size_t size = 0; size <= asked.size(); ++size) {
        for (std::uint32_t byte_count = 0; byte_count <= 255; ++byte_count) {
            auto bytes = asked;
            bytes[1] = to_byte(byte_count);
            test::exact_bytes const part{byte_view{bytes}.first(size)};
            bool const agrees = size >= 2 and size == 2 + byte_count and byte_count % 7 == 0;
            errc const expected = size == 0         ? errc::wrong_function
                                  : not agrees      ? errc::wrong_length
                                  : byte_count == 0 ? errc::invalid_quantity
                                                    : errc::none;
            if (read_file_record<>::decode(part.view()).error() != expected) {
                FAIL(size << " bytes, byte count " << byte_count);
            }
        }
    }
    for (std::size_t const at : {2U, 9U}) {
        auto bytes = asked;
        bytes[at] = std::byte{7};
        CHECK(read_file_record<>::decode(bytes).error() == errc::malformed);
    }
}

TEST_CASE("a request of function 20 has as many runs as its byte count says, up to 35")
{
    for (std::size_t count = 0; count <= 36; ++count) {
        CAPTURE(count);
        std::array<std::byte, 2 + 36 * 7> bytes{};
        byte_writer out{bytes};
        out.u8(0x14);
        out.u8(static_cast<std::uint32_t>(7 * count));
        for (std::size_t i = 0; i < count; ++i) {
            write_run(out, {1, static_cast<std::uint16_t>(i), 1});
        }
        test::exact_bytes const pdu{byte_view{bytes}.first(out.size())};
        auto const read = read_file_record<>::decode(pdu.view());
        CHECK(read.error() == (count >= 1 and count <= 35 ? errc::none : errc::invalid_quantity));
        CHECK((not read or (read->runs.size() == count and read->runs[count - 1].record == count - 1)));
    }
}

TEST_CASE("a response of function 20 has at most 245 bytes behind its byte count")
{
    for (std::uint32_t records = 1; records <= 125; ++records) {
        CAPTURE(records);
        test::sample some{20};
        some.bytes[0] = to_byte(2 * records + 1);
        some.bytes[1] = std::byte{6};
        read_file_record_response const one_run{some.first(2 + 2 * records)};
        CHECK((records <= 121
                   ? test::survives(one_run, [&](auto const& read) { return same_bytes(read.data, one_run.data); })
                   : test::is_refused(one_run, errc::malformed)));
    }
}
