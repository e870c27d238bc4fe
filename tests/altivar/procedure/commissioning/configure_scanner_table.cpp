// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// The table of a configuration of the scanner: each stage and each answer, as it stands beside the code.
#include <rtuwire/altivar/procedure/commissioning/configure_scanner.hpp>

#include "altivar/procedure/status_words.hpp"
#include "altivar/procedure/step_table.hpp"
#include "support/catch.hpp"

#include <rtuwire/altivar/atv12.hpp>

using namespace rtuwire;
using namespace rtuwire::altivar;
using namespace rtuwire::test;
using kind = outcome_kind;

namespace {

constexpr cell done = ends(kind::succeeded), silent = ends(kind::silent), refused = ends(kind::refused);
constexpr cell running = ends(kind::refused_while_running);

/// Two registers to read and one to write, in four slots each way.
constexpr std::array<std::uint16_t, 2> inputs{3201, 8604};
constexpr std::array<std::uint16_t, 1> outputs{8501};
constexpr cell first = writes(12701, 3201);

constexpr std::array<stage_row<12>, 1> look_rows{{
    {"a look", {begun}, {first, first, first, first, running, running, running, first, first, silent, refused, silent}},
}};

constexpr std::array<answer, 4> others{{
    {"confirmed", confirmed},
    {"no response", failed(errc::timed_out)},
    {"refused", failed(errc::server_device_failure)},
    {"limit over", late},
}};
constexpr event looked = word(disabled_word), ok = confirmed;
constexpr std::array<stage_row<4>, 8> rows{{
    {"input slot 1", {begun, looked}, {writes(12702, 8604), silent, refused, silent}},
    {"input slot 2", {begun, looked, ok}, {writes(12703, 0), silent, refused, silent}},
    {"input slot 3", {begun, looked, ok, ok}, {writes(12704, 0), silent, refused, silent}},
    {"input slot 4", {begun, looked, ok, ok, ok}, {writes(12721, 8501), silent, refused, silent}},
    {"output slot 1", {begun, looked, ok, ok, ok, ok}, {writes(12722, 0), silent, refused, silent}},
    {"output slot 2", {begun, looked, ok, ok, ok, ok, ok}, {writes(12723, 0), silent, refused, silent}},
    {"output slot 3", {begun, looked, ok, ok, ok, ok, ok, ok}, {writes(12724, 0), silent, refused, silent}},
    {"output slot 4", {begun, looked, ok, ok, ok, ok, ok, ok, ok}, {done, silent, refused, silent}},
}};

constexpr scanner_procedure configure{atv12::device::layout, inputs, outputs};
constexpr scanner_procedure outputs_only{atv12::device::layout, std::span{inputs}.first(0), std::span{inputs}.first(2)};

} // namespace

TEST_CASE("a configuration of the scanner does at its look what its table says")
{
    check_table(configure, looks, look_rows);
    CHECK(does(configure, begun, reads(3201)));
}

TEST_CASE("a configuration of the scanner does at each slot, at each answer, what its table says")
{
    check_table(configure, others, rows);
    CHECK(does(led(outputs_only, {begun}), looked, writes(12701, 0)));
    CHECK(does(led(outputs_only, {begun, looked, ok, ok, ok, ok}), ok, writes(12722, 8604)));
}
