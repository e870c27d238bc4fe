// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// What a host's system buffered while nobody read is older than the request, however much it is: a blocking client takes
// none of it for a response.
#include "client_line.hpp"

#include "support/catch.hpp"

#include <deque>

#include <rtuwire/client/blocking.hpp>
#include <rtuwire/wire/registers.hpp>

using namespace rtuwire;
using namespace rtuwire::detail;
using namespace rtuwire::test;

namespace {

constexpr unsigned cmd = 8501;

/// A gateway: what it has buffered comes at once, in reads of any size. The unit behind it refuses each write, 30 ms after
/// it. Its clock stands still but for reads and waits.
struct gateway {
    std::uint32_t clock{1'000'000};
    std::deque<std::byte> buffered{};
    frame_bytes refusal{};
    std::uint32_t refused_at{0};
    bool babbles{false};

    instant now() const { return instant{clock}; }
    result<void> write(byte_view, instant)
    {
        refusal = framed({7, 0x86, 4});
        refused_at = clock + 30'000;
        return {};
    }
    result<byte_span> read(byte_span place, instant until)
    {
        clock += 50;
        if (babbles) {
            buffered.resize(place.size(), std::byte{0xFF});
        }
        if (buffered.empty() and not refusal.empty() and reached(until, instant{refused_at})) {
            clock = refused_at > clock ? refused_at : clock;
            buffered.assign(refusal.begin(), refusal.end());
            refusal.clear();
        }
        if (buffered.empty() and not reached(now(), until)) {
            clock = until.microseconds;
        }
        std::size_t count = 0;
        for (; count < place.size() and not buffered.empty(); ++count) {
            place[count] = buffered.front();
            buffered.pop_front();
        }
        return place.first(count);
    }
};

constexpr client_options brief{.response_timeout = milliseconds(100), .retries = 0};

} // namespace

TEST_CASE("defect: D24 an old echo does not confirm a write, however much the system buffered before it")
{
    for (auto const& line : {line_timing::without_wire(), office_line}) {
        for (std::size_t const writes : {0U, 1U, 31U, 32U, 33U, 64U, 1'000U}) {
            INFO(writes << " old echoes of 8 bytes");
            gateway port;
            frame_bytes const old = write_of(7, cmd, 0);
            for (std::size_t i = 0; i < writes; ++i) {
                port.buffered.insert(port.buffered.end(), old.begin(), old.end());
            }
            blocking_client client{port, line, brief};
            CHECK(client.ask(unit_id{7}, write_single_register{cmd, 0}).error() == errc::server_device_failure);
        }
    }
}

TEST_CASE("defect: D24 a gateway that never stops sending ends a request as a jam, without the request")
{
    gateway port;
    port.babbles = true;
    blocking_client client{port, line_timing::without_wire(), brief};
    CHECK(client.ask(unit_id{7}, write_single_register{cmd, 0}).error() == errc::bus_jam);
    CHECK(port.refused_at == 0);
    CHECK(port.clock < 1'000'000 + 2 * 100'000);
    // What comes to rest is used again.
    port.babbles = false;
    CHECK(client.ask(unit_id{7}, write_single_register{cmd, 0}).error() == errc::server_device_failure);
}
