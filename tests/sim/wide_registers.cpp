// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A typed bank with wide registers of all kinds, over a simulated line: what it refuses, and that no value is ever put
// together from two moments. Sums and counts of the test are plain words: they know nothing of forms and plans.
#include <rtuwire/sim/bench.hpp>

#include <bit>
#include <cstdint>

#include "support/catch.hpp"
#include "support/proof.hpp"

#include <rtuwire/ask/access.hpp>
#include <rtuwire/ask/poller.hpp>
#include <rtuwire/ask/single_request.hpp>
#include <rtuwire/core/hex.hpp>
#include <rtuwire/server/hooks.hpp>
#include <rtuwire/server/typed_bank.hpp>
#include <rtuwire/table/form/ascii.hpp>
#include <rtuwire/table/form/floating.hpp>
#include <rtuwire/table/form/packed.hpp>
#include <rtuwire/table/form/whole.hpp>

using namespace rtuwire;
using namespace rtuwire::detail;

namespace meter {

enum class tariff : std::uint16_t { day = 1, night = 2 };

} // namespace meter

template <>
inline constexpr auto rtuwire::enumerators<meter::tariff> = rtuwire::detail::name_list({{1, "day"}, {2, "night"}});

namespace meter {

constexpr reg<float32<kilowatt_hours, word_order::low_first>> limit{
    .code = "LIM", .address = 40, .min = -5, .max = 1000, .factory = 100};
constexpr reg<unsigned32<watt_hours>> budget{.code = "BUD", .address = 42, .max = 70'000, .factory = 65'537};
constexpr reg<known<tariff>> in_force{.code = "TAR", .address = 44, .factory = 1};
constexpr reg<ascii<4>> place{.code = "PLC", .address = 45};
constexpr reg<count16> serial{.code = "SER", .address = 47, .mode = access::read_only, .factory = 7};
constexpr input_reg<unsigned32<>> low{.code = "LOW", .address = 40};
constexpr input_reg<unsigned32<count16, word_order::low_first_bytes_swapped>> high{.code = "HIGH", .address = 60};
constexpr input_reg<signed_count16> scale{.code = "SF", .address = 80};
constexpr input_reg<scaled_by<volts, scale>> voltage{.code = "U", .address = 79};
constexpr coil relay{.code = "K1", .address = 1};
constexpr coil lamp{.code = "H1", .address = 2, .mode = access::read_only, .factory = 1};
constexpr discrete_input door{.code = "S1", .address = 1};

struct device {
    static constexpr literal name{"meter"};
    static constexpr function_set functions = all_functions;
    static constexpr device_limits limits{.read = 30};
    static constexpr unit_range units{};
    static constexpr std::array<address_range, 0> readable{};
    using registers = table<limit, budget, in_force, place, serial, low, high, scale, voltage, relay, lamp, door>;
};

using registers =
    bank<limit, budget, in_force, place, serial, low, high, scale, restepped<decivolts, voltage>, relay, lamp, door>;

} // namespace meter

namespace {

STATIC_CHECK(register_bank<meter::registers>);

/// What a bank answers, as a server of all functions.
template <std::size_t Asked, std::size_t Answered>
bool answers(std::array<std::byte, Asked> const& request, std::array<std::byte, Answered> const& expected)
{
    using functions = function_list<read_coils, read_discrete_inputs, read_holding_registers, read_input_registers,
                                    write_single_coil, write_single_register, write_multiple_coils<>,
                                    write_multiple_registers<>, mask_write_register, read_write_multiple_registers<>>;
    meter::registers bank;
    std::array<std::byte, max_pdu_size> place{};
    return same_bytes(respond<functions>(request, bank, server_profile{}, place), expected);
}

} // namespace

TEST_CASE("half of a wide register is neither read nor written")
{
    // Delivered: 100 as a float is 42C80000, low word first; 65537; day.
    CHECK(answers("03 00 28 00 05"_hex, "03 0A 00 00 42 C8 00 01 00 01 00 01"_hex));
    CHECK(answers("03 00 28 00 01"_hex, "83 02"_hex));
    CHECK(answers("03 00 29 00 01"_hex, "83 02"_hex));
    CHECK(answers("03 00 29 00 03"_hex, "83 02"_hex));
    CHECK(answers("03 00 28 00 03"_hex, "83 02"_hex));
    CHECK(answers("03 00 2A 00 02"_hex, "03 04 00 01 00 01"_hex));
    CHECK(answers("06 00 2A 00 01"_hex, "86 02"_hex));
    CHECK(answers("06 00 2B 00 01"_hex, "86 02"_hex));
    CHECK(answers("10 00 2A 00 01 02 00 01"_hex, "90 02"_hex));
    CHECK(answers("10 00 2B 00 02 04 00 01 00 01"_hex, "90 02"_hex));
    CHECK(answers("10 00 29 00 03 06 00 00 00 00 00 01"_hex, "90 02"_hex));
    CHECK(answers("16 00 2A FF FF 00 00"_hex, "96 02"_hex));
    CHECK(answers("17 00 28 00 01 00 2A 00 02 04 00 00 00 01"_hex, "97 02"_hex));
}

TEST_CASE("limits hold for the whole value")
{
    CHECK(answers("10 00 2A 00 02 04 00 01 11 70"_hex, "10 00 2A 00 02"_hex)); // 70000
    CHECK(answers("10 00 2A 00 02 04 00 01 11 71"_hex, "90 03"_hex));
    CHECK(answers("10 00 2A 00 02 04 00 00 FF FF"_hex, "10 00 2A 00 02"_hex)); // a low word above that of the limit
    CHECK(answers("10 00 28 00 02 04 00 00 44 7A"_hex, "10 00 28 00 02"_hex)); // 1000.0
    CHECK(answers("10 00 28 00 02 04 00 01 44 7A"_hex, "90 03"_hex));          // the next number
    CHECK(answers("10 00 28 00 02 04 00 00 C0 A0"_hex, "10 00 28 00 02"_hex)); // -5
    CHECK(answers("10 00 28 00 02 04 00 01 C0 A0"_hex, "90 03"_hex));
    CHECK(answers("10 00 28 00 02 04 00 00 7F C0"_hex, "90 03"_hex)); // not a number
    CHECK(answers("06 00 2C 00 02"_hex, "06 00 2C 00 02"_hex));
    CHECK(answers("06 00 2C 00 03"_hex, "86 03"_hex));                      // no tariff
    CHECK(answers("10 00 2D 00 03 06 41 42 43 44 00 01"_hex, "90 02"_hex)); // the serial number is read-only
    CHECK(answers("06 00 00 00 00"_hex, "86 02"_hex));
}

TEST_CASE("each kind has addresses of its own")
{
    CHECK(answers("04 00 28 00 02"_hex, "04 04 00 00 00 00"_hex));
    CHECK(answers("04 00 29 00 01"_hex, "84 02"_hex));
    CHECK(answers("04 00 2A 00 02"_hex, "84 02"_hex)); // a holding register stands there
    CHECK(answers("01 00 01 00 02"_hex, "01 01 02"_hex));
    CHECK(answers("01 00 01 00 03"_hex, "81 02"_hex));
    CHECK(answers("02 00 01 00 01"_hex, "02 01 00"_hex));
    CHECK(answers("02 00 02 00 01"_hex, "82 02"_hex));
    CHECK(answers("05 00 01 FF 00"_hex, "05 00 01 FF 00"_hex));
    CHECK(answers("05 00 02 00 00"_hex, "85 02"_hex)); // a coil that only the device switches
    CHECK(answers("0F 00 01 00 02 01 03"_hex, "8F 02"_hex));
}

TEST_CASE("registers of all kinds are read and written over a line")
{
    constexpr station<meter::device> unit{unit_id{3}};
    meter::registers bank;
    sim::bench bench{line_timing{19'200, character_format::even_8_1}, bank_at{unit.unit(), bank}};
    bank.set<restepped<decivolts, meter::voltage>>(decivolts{2304});
    bank.set<meter::scale>(signed_count16{-1});
    bank.set<meter::door>(true);
    CHECK(bench.run(read<meter::voltage>(unit)) == 230.4_V);
    CHECK(bench.run(read<meter::door>(unit)) == true);
    CHECK(bench.run(read<meter::limit>(unit)) == 100_kWh);
    CHECK(bench.run(write<meter::limit>(unit, 0.25_kWh)));
    CHECK(bank.take_written<meter::limit>());
    CHECK_FALSE(bank.take_written<meter::limit>());
    CHECK(bank.get<meter::limit>() == 0.25_kWh);
    CHECK(bench.run(write<meter::place>(unit, "HALL")));
    CHECK(bank.get<meter::place>() == "HALL");
    CHECK(bench.run(write<meter::relay>(unit, true)));
    CHECK((bank.get<meter::relay>() and bank.take_written<meter::relay>()));
    CHECK(bench.run(write<meter::relay>(unit, false)));
    CHECK_FALSE(bank.get<meter::relay>());
    CHECK(bench.run(read<meter::lamp>(unit)) == true);
}

TEST_CASE("hooks at a wide register get the whole value")
{
    constexpr station<meter::device> unit{unit_id{3}};
    meter::registers bank;
    int told = 0;
    auto hooked = with_hooks(bank)
                      .check<meter::limit>([](real<kilowatt_hours> wanted) {
                          return wanted > 500_kWh ? errc::server_device_failure : errc::none;
                      })
                      .on_write<meter::limit>([&](real<kilowatt_hours> now) { told += now == 0.25_kWh ? 1 : 100; });
    sim::bench bench{line_timing{19'200, character_format::even_8_1}, bank_at{unit.unit(), hooked}};
    CHECK(bench.run(write<meter::limit>(unit, 501_kWh)).error() == errc::server_device_failure);
    CHECK(bank.get<meter::limit>() == 100_kWh);
    CHECK(bench.run(write<meter::limit>(unit, 0.25_kWh)));
    CHECK(told == 1);
}

namespace {

/// The n-th of the numbers that a counter shows: both halves are n, so that halves of two moments differ.
constexpr std::uint32_t nth(std::uint32_t n) { return n << 16U | n; }
constexpr bool is_all_there(std::uint32_t count) { return count >> 16U == (count & 0xFFFFU); }

} // namespace

TEST_CASE("a value that changes between requests and during faults is never mixed")
{
    constexpr station<meter::device> unit{unit_id{3}};
    meter::registers bank;
    sim::bench bench{line_timing{19'200, character_format::even_8_1}, bank_at{unit.unit(), bank}};
    bench.wire().set_faults({.bit_errors = 500, .lost = 30'000, .repeated = 30'000});
    using plan = read_plan<meter::device, meter::low, meter::high, meter::budget>;
    poller<plan> panel{unit};
    std::uint32_t n = 0;
    unsigned whole = 0;
    unsigned failed = 0;
    for (int round = 0; round < 400; ++round) {
        panel.again();
        // The unit counts on in every pass of the line, between the bytes of a request and of its response, too.
        bench.run_until([&] { return panel.settled(); }, milliseconds(60'000), panel,
                        [&](instant) {
                            n = (n + 1) & 0xFFFFU;
                            bank.set<meter::low>(quantity<dimensionless, std::uint32_t>{nth(n)});
                            bank.set<meter::high>(quantity<dimensionless, std::uint32_t>{nth(n)});
                            bank.set<meter::budget>(
                                quantity<electrical_energy, std::uint32_t, std::milli>{nth(n & 1U)});
                        });
        auto const& now = panel.latest();
        REQUIRE(is_all_there(now.get<meter::low>().count()));
        REQUIRE(is_all_there(now.get<meter::high>().count()));
        REQUIRE(is_all_there(now.get<meter::budget>().count()));
        whole += panel.outcome() ? 1U : 0U;
        failed += panel.outcome() ? 0U : 1U;
    }
    CHECK(whole > 100);
    CHECK(failed > 0);
}

TEST_CASE("the same counter, read by two requests, is mixed: the check above would see it")
{
    constexpr std::uint16_t first = 40;
    word_bank<2> words{first};
    sim::bench bench{line_timing{19'200, character_format::even_8_1}, bank_at{unit_id{3}, words}};
    single_request upper{unit_id{3}, read_holding_registers{.start = first, .count = 1}};
    single_request lower{unit_id{3}, read_holding_registers{.start = first + 1, .count = 1}};
    std::uint16_t n = 0;
    unsigned mixed = 0;
    auto const count_on = [&](instant) {
        ++n;
        REQUIRE(words.set(first, n));
        REQUIRE(words.set(first + 1, n));
    };
    for (int round = 0; round < 20; ++round) {
        upper.again();
        bench.run_until([&] { return upper.settled(); }, milliseconds(1'000), upper, count_on);
        lower.again();
        bench.run_until([&] { return lower.settled(); }, milliseconds(1'000), lower, count_on);
        auto const high = upper.outcome()->to<read_holding_registers>();
        auto const low = lower.outcome()->to<read_holding_registers>();
        mixed += high->registers[0] != low->registers[0] ? 1U : 0U;
    }
    CHECK(mixed > 0);
}
