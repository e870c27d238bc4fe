// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// One request: the room for its response, and what a request says of its response that a client does not compare.
#include <rtuwire/ask/single_request.hpp>

#include "support/proof.hpp"

#include <rtuwire/core/hex.hpp>
#include <rtuwire/serial_line.hpp>
#include <rtuwire/wire/functions.hpp>
#include <rtuwire/wire/raw.hpp>

using namespace rtuwire;
using namespace rtuwire::detail;

namespace {

constexpr unit_id one{1};

// The room for a response is that of the longest one.
STATIC_CHECK(largest_response<write_single_coil> == 5 and largest_response<write_single_register> == 5);
STATIC_CHECK(largest_response<write_multiple_coils<>> == 5 and largest_response<write_multiple_registers<>> == 5);
STATIC_CHECK(largest_response<read_exception_status> == 2 and largest_response<get_comm_event_counter> == 5);
STATIC_CHECK(largest_response<mask_write_register> == 7 and largest_response<get_comm_event_log> == 72);
STATIC_CHECK(largest_response<read_fifo_queue> == 67 and largest_response<read_file_record<>> == 247);
STATIC_CHECK(largest_response<read_coils> == 252 and largest_response<read_input_registers> == 252);
STATIC_CHECK(largest_response<report_server_id> == 253 and largest_response<raw_pdu<>> == 253);

/// Whether the conversation of a request accepts this response, which its client has accepted.
template <typename Request, std::size_t Size>
constexpr errc taken(Request const& request, std::array<std::byte, Size> const& told)
{
    single_request ask{one, request};
    ask.accept(response{told});
    return ask.settled() ? ask.outcome().error() : errc::busy;
}

// Function 20 compares the runs with those that were asked.
constexpr read_file_record two_runs{file_run{.file = 4, .record = 1, .count = 2}, file_run{3, 9, 1}};
STATIC_CHECK(taken(two_runs, "14 0A 05 06 0D FE 00 20 03 06 33 CD"_hex) == errc::none);
STATIC_CHECK(taken(two_runs, "14 0A 03 06 33 CD 05 06 0D FE 00 20"_hex) == errc::response_mismatch);
STATIC_CHECK(taken(two_runs, "14 06 05 06 0D FE 00 20"_hex) == errc::response_mismatch);
STATIC_CHECK(taken(two_runs, "14 0C 05 06 0D FE 00 20 05 06 33 CD 00 40"_hex) == errc::response_mismatch);
STATIC_CHECK(taken(two_runs, "14 0A 05 07 0D FE 00 20 03 06 33 CD"_hex) == errc::response_mismatch);
STATIC_CHECK(taken(two_runs, "14 0E 05 06 0D FE 00 20 03 06 33 CD 03 06 00 00"_hex) == errc::wrong_length);
STATIC_CHECK(taken(two_runs, "14 0B 05 06 0D FE 00 20 03 06 33 CD"_hex) == errc::wrong_length);
STATIC_CHECK(taken(two_runs, "14 0E 06 00 04 00 01 00 02 06 00 03 00 09 00 01"_hex) == errc::response_mismatch);

constexpr bool keeps_what_went_wrong()
{
    single_request ask{one, two_runs};
    ask.accept(errc::timed_out);
    bool const is_late = ask.outcome() == errc::timed_out;
    ask.again();
    ask.accept(response{"14 02 01 06"_hex});
    return is_late and ask.settled() and ask.outcome() == errc::response_mismatch;
}
PROOF("an outcome without a response is that, and a wrong response is none", keeps_what_went_wrong)

// The others take what their client has accepted.
STATIC_CHECK(taken(read_exception_status{}, "07 6D"_hex) == errc::none);
STATIC_CHECK(taken(read_exception_status{}, "07 6D 00"_hex) == errc::wrong_length);

/// A function of one's own, whose response begins with the number that was asked.
struct own_request {
    static constexpr std::size_t max_size = 2;
    std::uint8_t number;
    [[nodiscard]] constexpr errc check() const { return errc::none; }
    [[nodiscard]] constexpr std::size_t size() const { return 2; }
    constexpr void write(byte_writer& out) const
    {
        out.u8(0x41);
        out.u8(number);
    }
    static constexpr errc check_response(byte_view asked, byte_view told)
    {
        return told.size() > 1 and told[1] == asked[1] ? errc::none : errc::response_mismatch;
    }
};
STATIC_CHECK(largest_response<own_request> == max_pdu_size);
STATIC_CHECK(taken(own_request{7}, "41 07 12"_hex) == errc::none);
STATIC_CHECK(taken(own_request{7}, "41 08 12"_hex) == errc::response_mismatch);

} // namespace
