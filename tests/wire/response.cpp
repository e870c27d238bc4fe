// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A response is held against the whole request.
#include <rtuwire/wire/response.hpp>

#include <array>

#include "support/exact.hpp"
#include "support/proof.hpp"
#include "support/random.hpp"
#include "support/verdict.hpp"

#include <rtuwire/core/hex.hpp>
#include <rtuwire/wire/registers.hpp>
#include <rtuwire/wire/serial_line/device_identification.hpp>
#include <rtuwire/wire/serial_line/diagnostics.hpp>
#include <rtuwire/wire/serial_line/fifo_queue.hpp>
#include <rtuwire/wire/serial_line/file_records.hpp>
#include <rtuwire/wire/serial_line/unit_report.hpp>

using namespace rtuwire;
using namespace rtuwire::detail;
using rtuwire::test::verdict;

namespace {

constexpr auto read = "02 03 0C 81 00 01 D7 41"_hex;
STATIC_CHECK(verdict(read, "03 02 12 34"_hex) == errc::none);
STATIC_CHECK(verdict(read, "03 02 12 34"_hex, 3) == errc::wrong_unit);
STATIC_CHECK(verdict(read, "03 04 12 34 56 78"_hex) == errc::wrong_length);
STATIC_CHECK(verdict(read, "03 02 12"_hex) == errc::wrong_length);
STATIC_CHECK(verdict(read, "03 04 12 34"_hex) == errc::wrong_length);
STATIC_CHECK(verdict(read, "03"_hex) == errc::wrong_length);
STATIC_CHECK(verdict(read, "04 02 12 34"_hex) == errc::wrong_function);
STATIC_CHECK(verdict(read, "83 02"_hex) == errc::illegal_data_address);
STATIC_CHECK(verdict(read, "83 7F"_hex) == static_cast<errc>(0x7F));
STATIC_CHECK(verdict(read, "83 00"_hex) == errc::unlisted_exception);
STATIC_CHECK(verdict(read, "83"_hex) == errc::wrong_length);
STATIC_CHECK(verdict(read, "86 02"_hex) == errc::wrong_function);

constexpr auto write = "02 06 21 35 00 0F D3 CF"_hex;
STATIC_CHECK(verdict(write, "06 21 35 00 0F"_hex) == errc::none);
STATIC_CHECK(verdict(write, "06 21 35 00 0E"_hex) == errc::response_mismatch);
STATIC_CHECK(verdict(write, "06 21 36 00 0F"_hex) == errc::response_mismatch);
STATIC_CHECK(verdict(write, "06 21 35 00"_hex) == errc::wrong_length);

constexpr auto block = "02 10 23 29 00 02 04 00 14 00 1E 73 A4"_hex;
STATIC_CHECK(verdict(block, "10 23 29 00 02"_hex) == errc::none);
STATIC_CHECK(verdict(block, "10 23 29 00 01"_hex) == errc::response_mismatch);
STATIC_CHECK(verdict(block, "10 23 28 00 02"_hex) == errc::response_mismatch);
STATIC_CHECK(verdict(block, "10 23 29 00 02 04"_hex) == errc::wrong_length);

constexpr auto exchange = "02 17 31 C5 00 03 31 D9 00 03 06 00 0F 05 DC 00 00 32 63"_hex;
STATIC_CHECK(verdict(exchange, "17 06 02 37 05 DC 00 00"_hex) == errc::none);
STATIC_CHECK(verdict(exchange, "17 04 02 37 05 DC"_hex) == errc::wrong_length);

constexpr auto loop = "02 08 00 00 A5 37 DA BE"_hex;
STATIC_CHECK(verdict(loop, "08 00 00 A5 37"_hex) == errc::none);
STATIC_CHECK(verdict(loop, "08 00 00 A5 36"_hex) == errc::response_mismatch);
STATIC_CHECK(verdict(loop, "08 00 0B A5 37"_hex) == errc::response_mismatch);
STATIC_CHECK(verdict(loop, "08 00 00"_hex) == errc::wrong_length);
constexpr auto count = "02 08 00 0B 00 00 00 00"_hex;
STATIC_CHECK(verdict(count, "08 00 0B 12 34"_hex) == errc::none);
constexpr auto restart = "02 08 00 01 FF 00 00 00"_hex;
STATIC_CHECK(verdict(restart, "08 00 01 FF 00"_hex) == errc::none);
STATIC_CHECK(verdict(restart, "08 00 01 00 00"_hex) == errc::response_mismatch);

constexpr auto identify = "02 2B 0E 01 00 34 77"_hex;
STATIC_CHECK(verdict(identify, "2B 0E 01 01 00 00 01 00 01 41"_hex) == errc::none);
STATIC_CHECK(verdict(identify, "2B 0E 02 01 00 00 01 00 01 41"_hex) == errc::response_mismatch);
STATIC_CHECK(verdict(identify, "2B 0E 01 01 00 00 02 00 01 41"_hex) == errc::malformed);

STATIC_CHECK(verdict(identify, "2B 0D 01 01 00 00 01 00 01 41"_hex) == errc::malformed);
STATIC_CHECK(verdict(identify, "2B 0E 01 01 00 00"_hex) == errc::wrong_length);
STATIC_CHECK(verdict(identify, "AB 01"_hex) == errc::illegal_function);
// A stream may start elsewhere than it was asked to; a single object is that object or nothing.
constexpr auto identify_rest = "02 2B 0E 01 02 00 00"_hex;
STATIC_CHECK(verdict(identify_rest, "2B 0E 01 01 00 00 01 00 01 41"_hex) == errc::none);
constexpr auto single = "02 2B 0E 04 01 00 00"_hex;
STATIC_CHECK(verdict(single, "2B 0E 04 81 00 00 01 01 01 41"_hex) == errc::none);
STATIC_CHECK(verdict(single, "2B 0E 04 81 00 00 01 00 01 41"_hex) == errc::response_mismatch);
STATIC_CHECK(verdict(single, "2B 0E 04 81 00 00 02 01 01 41 02 00"_hex) == errc::response_mismatch);

// A raw request may be shorter than its function allows.
STATIC_CHECK(verdict("02 03 00 00"_hex, "03 02 12 34"_hex) == errc::none);
STATIC_CHECK(verdict("02 2B 00 00"_hex, "2B 01"_hex) == errc::none);
STATIC_CHECK(verdict("02 03 00 00 00 00 00"_hex, "03 00"_hex) == errc::none);

/// Whether no response of another unit or function is accepted, and nothing is read outside, whatever
/// the sizes of a request of this function and of the response.
constexpr bool is_safe_for(std::uint8_t code)
{
    for (std::size_t size = 4; size <= 9; ++size) {
        test::exact_bytes request{size};
        request.span()[0] = std::byte{2};
        request.span()[1] = to_byte(code);
        for (std::size_t response_size = 1; response_size <= 6; ++response_size) {
            test::exact_bytes said{response_size};
            std::array<std::uint32_t, 3> const response_codes{code, code | 0x80U, code ^ 1U};
            for (std::uint32_t const response_code : response_codes) {
                said.span()[0] = to_byte(response_code);
                errc const here = verdict(request.view(), said.view());
                errc const other_unit = verdict(request.view(), said.view(), 3);
                // Without the room that a frame leaves behind its PDU.
                bool const is_exact = response_code != code or here == errc::line_echo or
                                      check_fields(pdu_of(request.view()), said.view()) == here;
                bool const is_other = response_code == (code ^ 1U);
                bool const is_refusal = response_code == (code | 0x80U);
                if (not is_exact or other_unit != errc::wrong_unit or (is_other and here != errc::wrong_function) or
                    (is_refusal and here != (response_size == 2 ? errc::unlisted_exception : errc::wrong_length))) {
                    return false;
                }
            }
        }
    }
    return true;
}

constexpr bool is_safe_for_short_requests()
{
    constexpr std::array<std::uint8_t, 7> codes{3, 6, 8, 16, 23, 43, 0x41};
    for (std::uint8_t const code : codes) {
        if (not is_safe_for(code)) {
            return false;
        }
    }
    return true;
}
PROOF("a request shorter than its function allows is held against its unit and function", is_safe_for_short_requests)

STATIC_CHECK(response_size(read) == 7 and response_size(write) == 8 and response_size(block) == 8);
STATIC_CHECK(response_size(exchange) == 11 and response_size(loop) == 8);
STATIC_CHECK(response_size(identify) == 256);
STATIC_CHECK(response_size("02 03 00 00"_hex) == 256);
// Only pages of identification tell their end; what else function 43 carries ends by silence.
STATIC_CHECK(longest_response(identify) == length_hint{256, true});
constexpr auto other_type = "02 2B 0D 0E 00 00 00"_hex;
STATIC_CHECK(longest_response(other_type) == length_hint{256, false});
STATIC_CHECK(response_size("02 03 00 00 FF FF 00 00"_hex) == 256);

/// One of few requests, so that pairs of them are often nearly alike.
struct request {
    std::uint32_t unit, kind, start, count, value;

    explicit constexpr request(test::random& random)
        : unit{1 + random.below(2)}, kind{random.below(5)}, start{random.below(2)}, count{1 + random.below(2)},
          value{random.below(2)}
    {}

    /// Whether a response to the other one tells nothing that this one does not ask for.
    [[nodiscard]] constexpr bool is_answered_like(request const& other) const
    {
        if (unit != other.unit or kind != other.kind) {
            return false;
        }
        switch (kind) {
        case 0:
        case 1: return count == other.count;
        case 2: return start == other.start and count == other.count;
        default: return start == other.start and value == other.value;
        }
    }
};

/// Asks `asked`, answers `answered`, and returns the verdict.
errc verdict_on(request const& asked, request const& answered)
{
    constexpr register_block<2> words{0x0000, 0x0001};
    auto const some = [&](request const& from) { return register_view{words.view().bytes().first(2 * from.count)}; };
    std::array<std::byte, 256> request_bytes{};
    std::array<std::byte, 256> response_bytes{};
    auto const unit = [](request const& from) { return *unit_id::checked(from.unit); };
    auto const say = [&](byte_span place, request const& from, auto const& value) {
        return *encode_into(place, unit(from), value);
    };
    auto const u16 = [](std::uint32_t number) { return static_cast<std::uint16_t>(number); };
    auto const both = [&](byte_span place, request const& q, bool is_response) -> byte_view {
        switch (q.kind) {
        case 0:
            return is_response ? say(place, q, read_holding_registers_response{some(q)})
                               : say(place, q, read_holding_registers{u16(q.start), u16(q.count)});
        case 1:
            return is_response ? say(place, q, read_write_multiple_registers_response{some(q)})
                               : say(place, q, read_write_multiple_registers{u16(q.start), u16(q.count), 9, some(q)});
        case 2:
            return is_response ? say(place, q, write_multiple_registers_response{u16(q.start), u16(q.count)})
                               : say(place, q, write_multiple_registers{u16(q.start), some(q)});
        case 3: return say(place, q, write_single_register{u16(q.start), u16(q.value)});
        default: {
            register_block const data{u16(q.start), u16(q.value)};
            return say(place, q, diagnostics{subfunction::return_query_data, data});
        }
        }
    };
    byte_view const frame = both(request_bytes, asked, false);
    auto const response = decode_adu(both(response_bytes, answered, true));
    return response ? check_response(frame, *response) : response.error();
}

} // namespace

TEST_CASE("so it is whatever the function")
{
    for (std::uint8_t code = 1; code < 0x80; ++code) {
        CAPTURE(unsigned{code});
        CHECK(is_safe_for(code));
    }
}

TEST_CASE("a response to another request is never accepted, and the right one always")
{
    test::random random{21};
    unsigned accepted = 0;
    unsigned wrong = 0;
    for (unsigned round = 0; round < 20'000; ++round) {
        request const asked{random};
        request const answered{random};
        bool const is_accepted = verdict_on(asked, answered) == errc::none;
        accepted += is_accepted ? 1U : 0U;
        wrong += is_accepted != asked.is_answered_like(answered) ? 1U : 0U;
        wrong += verdict_on(asked, asked) != errc::none ? 1U : 0U;
    }
    CHECK(wrong == 0);
    CHECK(accepted > 500);
}

// Frames of field_cases W11 to W13, and one of each that is as it should be: sizes are the specification's.
TEST_CASE("how many octets were due is told of a response and of a refusal apart")
{
    constexpr auto read_one = "01 03 00 00 00 01 84 0A"_hex;
    constexpr auto read_four = "01 03 00 00 00 04 44 09"_hex;
    CHECK(due_size(read_one, "01 83 02 00 F1 50"_hex) == 5);
    CHECK(due_size(read_one, "01 83 02 C0 F1"_hex) == 5);
    CHECK(due_size(read_four, "01 03 00 00 00 00 00 00 00 00 35 32"_hex) == 13);
    CHECK(due_size(read_four, "01 03 02 00 07 F9 86"_hex) == 13); // as its request asks, whatever it says itself
    CHECK(due_size("02 06 00 00 00 00 89 F9"_hex, "02 06 00 00 00 00 06 B8 A4"_hex) == 8);
    CHECK(due_size("20 11 D8 7C"_hex, "20 11 10 FF 68"_hex) == 21); // the byte count is what tells it
    CHECK(due_size(read_one, "01"_hex) == 7);
}
