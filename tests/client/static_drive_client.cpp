// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A client of drives whose times are constants holds the units that owe a response as others do.
#include <rtuwire/client/client.hpp>

#include "support/manual_unit.hpp"
#include "support/proof.hpp"

using namespace rtuwire;

namespace {

constexpr client_options options{
    .response_timeout = milliseconds(60), .late_response = milliseconds(500), .retries = 0};

constexpr auto read_of_2 = "02 03 0C 81 00 01 D7 41"_hex;
constexpr auto read_of_3 = "03 03 0C 81 00 01 D6 90"_hex;

/// Lets time pass until the request under way has an outcome. When that is.
template <typename Client> instant end_of_request(Client& link, instant now)
{
    for (unsigned i = 0; i < 500 and not link.poll_outcome(); ++i) {
        now = now + milliseconds(1);
        link.advance(now);
        if (byte_view const frame = link.poll_transmit(); not frame.empty()) {
            now = now + test::line.characters(frame.size());
            link.sent(now);
        }
    }
    return now;
}

/// Two units are asked and stay silent; then a third is asked. How long until its request leaves.
template <typename Client> duration wait_behind_two_silent_units(Client& link)
{
    instant now{0xFFFF'FFFFU - 100'000U};
    link.advance(now);
    now = now + milliseconds(100);
    link.advance(now);
    CHECK(link.start(request_frame{test::read_eta}, now));
    now = end_of_request(link, now);
    CHECK(link.start(request_frame{read_of_2}, now));
    now = end_of_request(link, now);
    instant const start = now;
    CHECK(link.start(request_frame{read_of_3}, now));
    while (link.poll_transmit().empty() and now - start < milliseconds(5'000)) {
        now = now + milliseconds(1);
        link.advance(now);
    }
    return now - start;
}

} // namespace

TEST_CASE("behind two silent units, a third waits as long for a fixed client of drives as for any other")
{
    test::asking<drive_client<>> told{test::line, options};
    test::asking<static_drive_client<test::line, 1, options>> fixed{};
    duration const expected = wait_behind_two_silent_units(told);
    CHECK(expected > milliseconds(400));
    CHECK(wait_behind_two_silent_units(fixed) == expected);
}
