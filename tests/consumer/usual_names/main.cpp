// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A user's program whose global variables have usual names. It is compiled with -Wshadow -Werror: GCC looks again at what
// constructors, lambdas and local variables of templates are called where a program uses them, and so after its globals.
// Its classes are named after machines: with `using namespace rtuwire` they must not be ambiguous.
#include <array>

#include <rtuwire/altivar/atv28.hpp>
#include <rtuwire/altivar/atv320.hpp>
#include <rtuwire/port.hpp>
#include <rtuwire/rtuwire.hpp>

extern int address, amount, bits, code, count, data, device, error, first, from, limit, line, mode, motor, node, now,
    options, other, panel, port, profile, registers, request, source, speed, state, sum, timing, to, unit, value, word,
    words;

struct compressor;
struct conveyor;
struct crane;
struct machine;
struct mixer;
struct plant;
struct pump;
struct valve;

namespace {

using namespace rtuwire;
using namespace rtuwire::altivar;

using machines = void(compressor&, conveyor&, crane&, machine&, mixer&, plant&, pump&, valve&);

constexpr station<atv320::device> press{unit_id{7}};
constexpr station<atv28::device> fan{unit_id{8}};

namespace meter {
inline constexpr reg<float32<kilowatt_hours, word_order::low_first>> energy{.code = "ENERGY", .address = 40};
inline constexpr reg<unsigned32<watt_hours>> budget{.code = "BUDGET", .address = 42};
inline constexpr reg<count16> pulses{.code = "PULSES", .address = 44};
inline constexpr coil relay{.code = "K1", .address = 40};
struct the_device {
    static constexpr literal name = "meter";
    static constexpr function_set functions = all_functions;
    static constexpr device_limits limits{};
    static constexpr unit_range units{};
    static constexpr std::array<address_range, 0> readable{};
    using registers = table<energy, budget, pulses, relay>;
};
} // namespace meter

constexpr station<meter::the_device> counter{unit_id{9}};
constexpr line_timing times{19'200, character_format::even_8_1};
constexpr device_object objects[] = {{vendor_name, "A"}, {product_code, "B"}, {major_minor_revision, "C"}};
constexpr server_profile named{.identity = identity_of<objects>};

/// Both ends of a line: banks, servers, requests and plans of every kind.
int ask_a_meter()
{
    bank<meter::energy, meter::budget, meter::pulses, meter::relay> typed;
    word_bank<4> plain{100};
    typed.set<meter::energy>(real<kilowatt_hours>{12.5F});
    using functions = function_list<read_coils, read_holding_registers, write_multiple_registers<>,
                                    read_write_multiple_registers<>, read_device_identification>;
    auto units =
        server::with<functions>::for_units(times, bank_at{unit_id{9}, typed}, bank_at{unit_id{10}, plain, named});
    sim::bench bench{times, units};
    auto const shown = bench.run(read<meter::energy>(counter));
    auto const written = bench.run(write<meter::budget>(counter, checked((shown ? 2 : 3) * 1_kWh)));
    auto const both = bench.run(write_all<meter::budget, meter::pulses>(counter, checked(5_kWh), checked(1_raw)));
    auto const moved = bench.run(exchange<contiguous<meter::energy, meter::budget>, meter::pulses>(counter, 1_raw));
    single_request own{unit_id{10}, raw_pdu{function_code{65}, std::array{std::byte{1}}}};
    auto const refused = bench.run(own);
    poller<read_plan<meter::the_device, meter::energy, meter::budget, meter::relay>> every{counter};
    auto const round = bench.run(every);
    return shown and text_of(*shown).size() > 0 and written and both and moved and not refused and round ? 0 : 1;
}

/// Orders, stops and set-up of drives.
int run_a_motor()
{
    sim::bench bench{bus<2>{times}, press, fan};
    start go{press, 50_Hz};
    stop rest{press};
    watch eye{press};
    cyclic loop{press};
    reset_fault clear{press};
    set_channel by_line{press, channel_settings<atv320::device>::by_modbus()};
    check_supervision safe{press};
    identify who{press};
    recall_from_eeprom back{fan};
    bench.run(go, clear);
    bench.run(rest, by_line);
    bench.run(safe, who);
    bench.step(milliseconds(1), loop, eye);
    bench.step(milliseconds(1), back);
    return rest.settled() ? 0 : 1;
}

/// On a host, and behind interrupts.
int use_a_port()
{
    posix_serial closed;
    blocking_client asks{closed, times};
    server answers{unit_id{1}, times};
    word_bank<4> plain;
    interrupt_queue<> events;
    client link{times};
    events.receive_error(instant{0});
    events.deliver_to(link, instant{0});
    auto const refused = asks.ask(unit_id{1}, read_holding_registers{.start = 0, .count = 1});
    return refused or serve_once(answers, closed, plain, milliseconds(1)) ? 1 : 0;
}

} // namespace

int main() { return ask_a_meter() + run_a_motor() + use_a_port(); }
