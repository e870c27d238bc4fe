// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Function 07: every value, every size.
#include <rtuwire/wire/serial_line/unit_report.hpp>

#include "support/pdu_facts.hpp"
#include "support/proof.hpp"

#include <rtuwire/core/hex.hpp>

using namespace rtuwire;

namespace {

constexpr bool has_one_byte_and_is_told_two()
{
    using test::is;
    return is(test::goes_there_and_back(read_exception_status{}), "request") and
           is(test::has_size<read_exception_status>("07 00 00"_hex, 1), "sizes of a request") and
           is(test::has_size<read_exception_status_response>("07 6D 00 00"_hex, 2), "sizes of a response") and
           is(read_exception_status_response::decode("07 6D"_hex) == read_exception_status_response{0x6D},
              "as printed") and
           is(read_exception_status_response::decode("08 6D"_hex) == errc::wrong_function, "another function");
}
PROOF("function 07 is one byte, and is told two", has_one_byte_and_is_told_two)

constexpr bool tells_any_outputs()
{
    for (unsigned outputs = 0; outputs <= 0xFF; ++outputs) {
        if (not test::goes_there_and_back(read_exception_status_response{static_cast<std::uint8_t>(outputs)})) {
            return false;
        }
    }
    return true;
}
PROOF("function 07 is told any eight outputs", tells_any_outputs)

} // namespace
