// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Function 08 by the specification's table of sub-functions (AP 6.8.1): which responses repeat the data of their
// request.
#include <rtuwire/wire/response.hpp>

#include <array>

#include "client_line.hpp"

#include "support/catch.hpp"

#include <rtuwire/serial_line.hpp>

using namespace rtuwire;
using namespace rtuwire::detail;
using namespace rtuwire::test;

namespace {

struct row {
    unsigned subfunction;
    unsigned asked;
    bool is_echoed;
};
constexpr std::array<row, 14> rows{row{0x00, 0xA537, true},  row{0x01, 0x0000, true},  row{0x01, 0xFF00, true},
                                   row{0x02, 0x0000, false}, row{0x03, 0x0D00, true},  row{0x0A, 0x0000, true},
                                   row{0x0B, 0x0000, false}, row{0x0C, 0x0000, false}, row{0x0D, 0x0000, false},
                                   row{0x0E, 0x0000, false}, row{0x0F, 0x0000, false}, row{0x10, 0x0000, false},
                                   row{0x12, 0x0000, false}, row{0x14, 0x0000, true}};

frame_bytes diagnosis(unsigned subfunction, unsigned data)
{
    return framed({1, 8, subfunction >> 8U, subfunction & 0xFFU, data >> 8U, data & 0xFFU});
}

/// What a client makes of this response.
errc outcome_of(frame_bytes const& asked, frame_bytes const& said)
{
    constexpr client_options once{.response_timeout = milliseconds(100), .retries = 0};
    scripted_line<client> line{client{office_line, once}, office_line};
    series conversation{[&](unsigned) { return asked; }, 1};
    line.heard = [&](frame_bytes const&) { line.say(5'000, said); };
    line.run(1'000'000, [&](instant now) { line.link.converse(conversation, now); });
    CHECK(conversation.number == 1);
    return conversation.last;
}

} // namespace

TEST_CASE("defect: (j) data that a response of function 08 repeats are held against the request")
{
    for (row const& each : rows) {
        INFO("sub-function " << each.subfunction << ", data " << each.asked);
        frame_bytes const asked = diagnosis(each.subfunction, each.asked);
        CHECK(outcome_of(asked, asked) == errc::none);
        for (unsigned const other : {0x1234U, each.asked ^ 0x0001U, each.asked ^ 0x8000U}) {
            errc const found = outcome_of(asked, diagnosis(each.subfunction, other));
            CHECK(found == (each.is_echoed ? errc::response_mismatch : errc::none));
        }
    }
}
