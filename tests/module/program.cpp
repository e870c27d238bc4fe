// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// What a user of the module writes: a client's read, values with their unit, a table of their own, a simulated drive and
// a start. With -DBY_HEADER the same program takes the headers.
#include <array>
#include <cstdint>
#include <cstdio>

#ifdef BY_HEADER
#include <rtuwire/rtuwire.hpp>
#else
import rtuwire;
#endif

using namespace rtuwire;
using namespace rtuwire::altivar;

// A device of the program's own: an enumeration with names, and two registers.
enum class valve : std::uint16_t { shut = 0, open = 1 };

template <>
inline constexpr auto rtuwire::enumerators<valve> = std::to_array<rtuwire::named_value>({{.value = 0, .name = "SHUT"},
                                                                                         {.value = 1, .name = "OPEN"}});

namespace {

int failures = 0;

void expect(char const* what, bool holds)
{
    if (not holds) {
        std::printf("not so: %s\n", what);
        ++failures;
    }
}

void reads_and_writes()
{
    word_bank<16> registers;
    static_cast<void>(registers.set(3, 1500));
    sim::bench bench{line_timing{19'200, character_format::even_8_1}, bank_at{unit_id{7}, registers}};
    single_request ask{unit_id{7}, read_holding_registers{.start = 3, .count = 1}};
    auto const outcome = bench.run(ask);
    auto const response = outcome ? outcome->to<read_holding_registers>() : outcome.error();
    expect("a client reads 1500", response and response->registers[0] == 1500);
}

void values()
{
    expect("a golden frame",
           encode(unit_id{2}, read_holding_registers{.start = 3102, .count = 4}) == "02 03 0C 1E 00 04 27 6C"_hex);
    decihertz const speed = 50_Hz;
    expect("amounts compare, add and multiply",
           speed > 49_Hz and speed + 1_Hz == 51_Hz and speed * 2 == 100_Hz and -speed == -50_Hz and speed != 5_Hz);
    expect("times", milliseconds(20) + milliseconds(5) == milliseconds(25));
    expect("texts", text_of(signed_decihertz{-52}) == literal{"-5.2 Hz"} and name(errc::timed_out).size() > 0);
    expect("the version", version >= 100);
}

void a_drive()
{
    constexpr station<atv320::device> drive{unit_id{7}};
    sim::bench bench{line_timing{19'200, character_format::even_8_1}, drive};
    expect("a setting for all", bool{bench.run(broadcast_setting<atv320::device, atv320::tto>(3_s))});
    start go{drive, 50_Hz};
    reason const how = bench.run(go);
    expect("a start", how.kind == outcome_kind::succeeded);
    auto const seen = bench.run(read<atv320::rfr>(drive));
    expect("it turns", seen and *seen > 0_Hz);
    poller<read_plan<atv320::device, atv320::eta, atv320::rfr>> panel{drive};
    expect("a poller", bool{bench.run(panel)} and panel.latest().get<atv320::eta>().has(status_bit::operation_enabled));
    stop rest{drive, stop_by::ramp};
    expect("a stop", bench.run(rest).kind == outcome_kind::succeeded and bench.drive().motor().is_at_rest());
}

inline constexpr reg<valve> inlet{.code = "INLET", .address = 100};
inline constexpr reg<float32<kilowatt_hours, word_order::low_first>> energy{.code = "ENERGY", .address = 102};

void a_table_of_its_own()
{
    bank<inlet, energy> registers;
    registers.set<inlet>(valve::open);
    expect("an enumeration",
           registers.get<inlet>() == valve::open and text_of(registers.get<inlet>()) == literal{"OPEN"});
}

} // namespace

int main()
{
    reads_and_writes();
    values();
    a_drive();
    a_table_of_its_own();
    std::printf("%d not so\n", failures);
    return failures == 0 ? 0 : 1;
}
