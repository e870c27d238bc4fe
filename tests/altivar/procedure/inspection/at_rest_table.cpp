// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// The tables of the check that a drive is at rest: each register and each answer, as they stand beside the code.
#include <rtuwire/altivar/procedure/inspection/at_rest.hpp>

#include "altivar/procedure/status_words.hpp"
#include "altivar/procedure/step_table.hpp"
#include "support/catch.hpp"

#include <rtuwire/altivar/atv28.hpp>
#include <rtuwire/altivar/atv310.hpp>
#include <rtuwire/altivar/atv320.hpp>

using namespace rtuwire;
using namespace rtuwire::altivar;
using namespace rtuwire::test;
using kind = outcome_kind;

namespace {

constexpr auto const& layout = atv320::device::layout;
constexpr auto const& blind = atv310::device::layout; // has no register of its inputs

constexpr cell eta = reads(3201), lft = reads(7121), tcc = reads(11101), inputs = reads(5202);
constexpr cell x = never;
constexpr cell rests = ends(kind::succeeded), silent = ends(kind::silent), refused = ends(kind::refused);
constexpr cell aborted = ends(kind::aborted), fault = ends(kind::in_fault), closed = ends(kind::run_input_closed);
constexpr cell running = ends(kind::refused_while_running), lacking = ends(kind::unknown_register);

constexpr terminal_options none{.run_inputs = 0}, third{.run_inputs = 0x0004}, trusting{.accept_unseen_inputs = true};
constexpr at_rest_procedure plain{layout, {}};
constexpr at_rest_procedure in_fault{layout, {}, {.accepts_fault = true}};
constexpr at_rest_procedure two_wire{layout, {}, {.ends_three_wire = true}};
constexpr at_rest_procedure both{layout, {}, {.accepts_fault = true, .ends_three_wire = true}};
constexpr at_rest_procedure without{layout, none}, without_in_fault{layout, none, {.accepts_fault = true}};
constexpr at_rest_procedure by_third{layout, third}, with_trust{layout, trusting};
constexpr at_rest_procedure unseen{blind, {}}, unseen_in_fault{blind, {}, {.accepts_fault = true}};
constexpr at_rest_procedure trusted{blind, trusting}, unseen_without{blind, none};

/// A check by its options, and its cells at the look.
struct look_row {
    char const* name;
    at_rest_procedure it;
    std::array<cell, 12> cells;
};

// clang-format off
constexpr std::array<look_row, 10> look_rows{{
    // the check
    //   1, 2, 3, 4, 5, 6, 7, 8
    //   no state, no response, refused, limit over
    {"plain", plain,
     {aborted, tcc, tcc, tcc, running, running, lft, lft,
      aborted, silent, refused, aborted}},
    {"a fault is accepted", in_fault,
     {aborted, tcc, tcc, tcc, running, running, lft, tcc,
      aborted, silent, refused, aborted}},
    {"three-wire control may end", two_wire,
     {aborted, inputs, inputs, inputs, running, running, lft, lft,
      aborted, silent, refused, aborted}},
    {"both", both,
     {aborted, inputs, inputs, inputs, running, running, lft, inputs,
      aborted, silent, refused, aborted}},
    {"no run inputs", without,
     {aborted, rests, rests, rests, running, running, lft, lft,
      aborted, silent, refused, aborted}},
    {"no run inputs, a fault is accepted", without_in_fault,
     {aborted, rests, rests, rests, running, running, lft, rests,
      aborted, silent, refused, aborted}},
    {"inputs that cannot be read", unseen,
     {aborted, lacking, lacking, lacking, running, running, lft, lft,
      aborted, silent, refused, aborted}},
    {"the same, a fault is accepted", unseen_in_fault,
     {aborted, lacking, lacking, lacking, running, running, lft, lacking,
      aborted, silent, refused, aborted}},
    {"inputs that cannot be read are accepted", trusted,
     {aborted, rests, rests, rests, running, running, lft, lft,
      aborted, silent, refused, aborted}},
    {"inputs that cannot be read, none of them runs", unseen_without,
     {aborted, rests, rests, rests, running, running, lft, lft,
      aborted, silent, refused, aborted}},
}};
// clang-format on

constexpr event missing = failed(errc::illegal_data_address), disabled = word(disabled_word);

constexpr std::array<answer, 10> others{{
    {"0", word(0)},
    {"1", word(1)},
    {"2", word(2)},
    {"3", word(3)},
    {"4", word(4)},
    {"LI1 among others", word(0x0031)},
    {"no response", failed(errc::timed_out)},
    {"no such register", missing},
    {"refused otherwise", failed(errc::server_device_failure)},
    {"limit over", late},
}};
constexpr stage_row<10> status_row{"the status", {begun}, {x, x, x, x, x, x, silent, refused, refused, aborted}};
constexpr stage_row<10> fault_row{"the fault",
                                  {begun, word(fault_word)},
                                  {fault, fault, fault, fault, fault, fault, silent, refused, refused, aborted}};
constexpr stage_row<10> wiring_row{
    "TCC", {begun, disabled}, {inputs, rests, inputs, inputs, inputs, inputs, silent, inputs, refused, aborted}};

constexpr std::array<stage_row<10>, 5> plain_rows{{
    status_row,
    fault_row,
    wiring_row,
    {"the inputs",
     {begun, disabled, word(0)},
     {rests, closed, closed, closed, rests, closed, silent, lacking, refused, aborted}},
    {"the inputs, TCC not known",
     {begun, disabled, missing},
     {rests, closed, closed, closed, rests, closed, silent, lacking, refused, aborted}},
}};
constexpr std::array<stage_row<10>, 3> two_wire_rows{{
    status_row,
    fault_row,
    {"the inputs",
     {begun, disabled},
     {rests, closed, closed, closed, rests, closed, silent, lacking, refused, aborted}},
}};
constexpr std::array<stage_row<10>, 4> third_rows{{
    status_row,
    fault_row,
    wiring_row,
    {"the inputs",
     {begun, disabled, word(0)},
     {rests, rests, rests, rests, closed, rests, silent, lacking, refused, aborted}},
}};
constexpr std::array<stage_row<10>, 4> trusting_rows{{
    status_row,
    fault_row,
    wiring_row,
    {"the inputs",
     {begun, disabled, word(0)},
     {rests, closed, closed, closed, rests, closed, silent, rests, refused, aborted}},
}};

} // namespace

TEST_CASE("a check that a drive is at rest does at its look what its table says")
{
    for (look_row const& row : look_rows) {
        std::array<stage_row<12>, 1> const rows{{{row.name, {begun}, row.cells}}};
        check_table(row.it, looks, rows);
    }
}

TEST_CASE("a check that a drive is at rest does at each register, at each answer, what its table says")
{
    check_table(plain, others, plain_rows);
    check_table(two_wire, others, two_wire_rows);
    check_table(by_third, others, third_rows);
    check_table(with_trust, others, trusting_rows);
    CHECK(does(plain, begun, eta));
    CHECK(does(unseen, begun, eta));
}

TEST_CASE("a check that a drive is at rest names the register that it read last, and its word")
{
    at_rest_procedure const at_input = led(plain, {begun, disabled, word(0), word(0x0031)});
    CHECK(at_input.address() == 5202);
    CHECK(at_input.word() == 0x0031);
    at_rest_procedure const at_status = led(plain, {begun, word(enabled_word)});
    CHECK(at_status.address() == 3201);
    CHECK(at_status.word() == enabled_word);
    at_rest_procedure const at_missing = led(plain, {begun, disabled, word(0), missing});
    CHECK(at_missing.address() == 5202);
    CHECK(at_missing.word() == 0);
}
