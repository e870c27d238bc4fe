// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A queue that overflowed and told so goes on, however long nothing comes: also where the clock has gone more than
// half way round meanwhile.
#include <vector>

#include "support/catch.hpp"

#include <rtuwire/core/bytes.hpp>
#include <rtuwire/rtu/interrupt_queue.hpp>

using namespace rtuwire;

namespace {

/// Counts what it is given.
struct counter {
    unsigned bytes{0}, errors{0}, ends{0};

    void receive(byte_view received, instant) { bytes += static_cast<unsigned>(received.size()); }
    void receive_error(instant) { ++errors; }
    void sent(instant) { ++ends; }
};

constexpr std::uint32_t minute = 60'000'000;

} // namespace

TEST_CASE("defect: H4 a queue that dropped bytes gives what comes any number of minutes later")
{
    for (std::uint32_t const pause : {0U, 1U, 34U, 36U, 40U, 60U, 71U}) {
        INFO(pause << " minutes");
        interrupt_queue<8> line;
        counter engine;
        for (std::uint32_t i = 0; i < 20; ++i) {
            line.receive(std::byte{1}, instant{1'000 + i});
        }
        line.deliver_to(engine, instant{2'000});
        REQUIRE(line.is_empty());
        CHECK(engine.errors == 1);
        unsigned const before = engine.bytes;

        instant const later{2'000 + pause * minute};
        line.sent(later);
        line.receive(std::byte{2}, later);
        line.deliver_to(engine, later);
        CHECK(engine.ends == 1);
        CHECK(engine.bytes == before + 1);
        CHECK(engine.errors == 1); // told once
        CHECK(line.overflows() == 1);
        CHECK(line.is_empty());
    }
}
