// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A client asks every public function of a simulated unit, and gets what the unit's bank holds.
#include <rtuwire/sim/bench.hpp>

#include "support/catch.hpp"
#include "support/whole_bank.hpp"

#include <rtuwire/ask/single_request.hpp>
#include <rtuwire/wire/functions.hpp>

using namespace rtuwire;
using namespace rtuwire::detail;

namespace {

constexpr line_timing timing{19'200, character_format::even_8_1};
constexpr unit_id three{3};
constexpr device_object objects[] = {{vendor_name, "vendor"}, {product_code, "code"}, {major_minor_revision, "0100"}};
constexpr server_profile named{.identity = identity_of<objects>};

test::whole_bank filled_bank()
{
    test::whole_bank bank;
    static_cast<void>(bank.words.set(3, 1'500));
    static_cast<void>(bank.switched.set(9, true));
    static_cast<void>(bank.contacts.set(31, true));
    static_cast<void>(bank.measured.set(7, 0xBEEF));
    bank.queue = {440, 4'740};
    bank.queued = 2;
    bank.files[1] = {10, 11, 12, 13, 14, 15, 16, 17};
    return bank;
}

/// A unit with everything, and the conversation with it. A response is a view of its request's memory.
struct whole_unit {
    test::whole_bank bank = filled_bank();
    sim::bench<host_client, detail::bank_unit<test::whole_bank>> bench{timing, bank_at{three, bank, named}};

    template <typename Request> void ask(single_request<Request>& request, auto const& judge)
    {
        INFO("function " << unsigned{to_u8(Request::code)});
        auto const outcome = bench.run(request);
        REQUIRE(outcome);
        auto const told = outcome->template to<Request>();
        REQUIRE(told);
        CHECK(judge(*told));
    }
    template <typename Request> void ask(Request const& request, auto const& judge)
    {
        single_request conversation{three, request};
        ask(conversation, judge);
    }
};

constexpr register_block<2> words{0x1234, 0x5678};
constexpr bit_block three_on{true, false, true};
constexpr auto is_anything = [](auto const&) { return true; };

} // namespace

TEST_CASE("what a unit holds is read")
{
    whole_unit unit;
    unit.ask(read_coils{8, 3},
             [](auto const& told) { return told.coils.size() == 8 and told.coils[1] and not told.coils[0]; });
    unit.ask(read_discrete_inputs{20, 12},
             [](auto const& told) { return told.inputs.size() == 16 and told.inputs[11]; });
    unit.ask(read_holding_registers{3, 1}, [](auto const& told) { return told.registers[0] == 1'500; });
    unit.ask(read_input_registers{6, 2}, [](auto const& told) { return told.registers[1] == 0xBEEF; });
    unit.ask(read_exception_status{}, [](auto const& told) { return told.outputs == 0x6D; });
    unit.ask(report_server_id{},
             [](auto const& told) { return told.data.size() == 3 and told.data[1] == std::byte{0xFF}; });
    unit.ask(read_file_record{file_run{.file = 2, .record = 1, .count = 2}, file_run{2, 7, 1}},
             [](auto const& told) { return (*told.run(0))[1] == 12 and (*told.run(1))[0] == 17 and not told.run(2); });
    unit.ask(read_fifo_queue{100},
             [](auto const& told) { return told.registers.size() == 2 and told.registers[1] == 4'740; });
    unit.ask(read_device_identification{},
             [](auto const& told) { return told.count == 3 and told.find(product_code)->size() == 4; });
    unit.ask(diagnostics{subfunction::return_query_data, words},
             [](auto const& told) { return told.data[1] == 0x5678; });
    unit.ask(get_comm_event_counter{}, [](auto const& told) { return told.events == 10; });
    unit.ask(get_comm_event_log{},
             [](auto const& told) { return told.events == 10 and told.messages == 12 and told.log.empty(); });
}

TEST_CASE("what is written is what a unit holds")
{
    whole_unit unit;
    unit.ask(write_single_coil{40, true}, is_anything);
    CHECK(unit.bank.switched.get(40));
    unit.ask(write_multiple_coils{50, three_on}, is_anything);
    CHECK((unit.bank.switched.get(50) and not unit.bank.switched.get(51) and unit.bank.switched.get(52)));
    unit.ask(write_single_register{0, 7}, is_anything);
    CHECK(unit.bank.words.get(0) == 7);
    unit.ask(write_multiple_registers{1, words}, is_anything);
    CHECK(unit.bank.words.get(2) == 0x5678);
    unit.ask(mask_write_register{2, 0xFF00, 0x0099}, is_anything);
    CHECK(unit.bank.words.get(2) == 0x5699);
    unit.ask(write_file_record{1, 6, words}, is_anything);
    CHECK(unit.bank.files[0][7] == 0x5678);
    unit.ask(read_write_multiple_registers{2, 3, 4, words}, [](auto const& told) {
        return told.registers[0] == 0x5699 and told.registers[1] == 1'500 and told.registers[2] == 0x1234;
    });
}

TEST_CASE("a unit has the functions that its bank has something for")
{
    word_bank<4> registers;
    sim::bench bench{timing, bank_at{three, registers}};
    CHECK(bench.run(single_request{three, read_coils{0, 1}}) == errc::illegal_function);
    CHECK(bench.run(single_request{three, read_fifo_queue{0}}) == errc::illegal_function);
    CHECK(bench.run(single_request{three, read_device_identification{}}) == errc::illegal_function);
    CHECK(bench.run(single_request{three, mask_write_register{0, 0, 7}}));
    CHECK(registers.get(0) == 7);
    CHECK(bench.run(single_request{broadcast, mask_write_register{1, 0, 8}}));
    CHECK(registers.get(1) == 8);
    CHECK(bench.run(single_request{three, get_comm_event_counter{}}));
}
