// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// The drives' tables: sizes, a few rows of the manuals, and what differs between the drives.
#include <rtuwire/altivar/atv310.hpp>

#include "support/proof.hpp"

#include <rtuwire/altivar/atv12.hpp>
#include <rtuwire/altivar/atv28.hpp>
#include <rtuwire/altivar/atv320.hpp>
#include <rtuwire/table/read_plan.hpp>
#include <rtuwire/table/setting.hpp>

using namespace rtuwire;
using namespace rtuwire::detail;
using namespace rtuwire::altivar;

namespace {

STATIC_CHECK(atv28::device::registers::size == 109);
STATIC_CHECK(atv310::device_2026::registers::size == atv310::device::registers::size + 16);
STATIC_CHECK(atv310::device_2026::registers::contains<atv310::nm8>);
STATIC_CHECK(not atv310::device::registers::contains<atv310::nm8>);

// The manuals' round trips.
constexpr setting<atv12::acc> ramp = 1.3_s;
STATIC_CHECK(ramp.word() == 13);
STATIC_CHECK(from_word<value_of<atv12::hsp>>(0x01F4) == decihertz{500});
constexpr auto state = from_word<value_of<atv320::eta>>(0x0250);
STATIC_CHECK(state.has(status_bit::voltage_enabled) and state.has(status_bit::switch_on_disabled) and
             state.has(status_bit::remote));
STATIC_CHECK(
    state ==
    status_word{}.with(status_bit::voltage_enabled).with(status_bit::switch_on_disabled).with(status_bit::remote));

// One mnemonic, two scales.
STATIC_CHECK(std::same_as<value_of<atv12::uln>, volts>);
STATIC_CHECK(std::same_as<value_of<atv320::uln>, decivolts>);

// Mains present is the opposite bit.
STATIC_CHECK(static_cast<int>(atv28::status_bit::mains_absent) == 4);
STATIC_CHECK(static_cast<int>(status_bit::voltage_enabled) == 4);

STATIC_CHECK(name_of(compact::fault_code::slf1) == literal{"SLF1"});
STATIC_CHECK(name_of(static_cast<compact::fault_code>(999)).size() == 0);
STATIC_CHECK(name_of(atv28::analog_input_function::no) == literal{"nO"});
STATIC_CHECK(enumerators<atv28::analog_input_function>.size() == 1);

STATIC_CHECK(atv310::lcr.source == provenance::inferred and atv310::eta.source == provenance::documented);
STATIC_CHECK(atv28::ai2.source == provenance::doubtful);
STATIC_CHECK(atv320::acc.steps_set_by == literal{"INR"});

STATIC_CHECK(not atv28::device::functions.contains(function_code::read_write_multiple_registers));
STATIC_CHECK(atv320::device::limits.exchange_read == 20 and atv12::device::limits.exchange_read == 4);

using monitor = read_plan<atv320::device, atv320::eta, atv320::rfr, atv320::lcr, restepped<deciseconds, atv320::acc>>;
STATIC_CHECK(monitor::request_count == 2);
STATIC_CHECK(monitor::requests()[0] == address_block{3201, 4});
using old_monitor = read_plan<atv28::device, atv28::frh, atv28::rfr, atv28::eta, atv28::eti, atv28::dp1>;
STATIC_CHECK(old_monitor::request_count == 2);

} // namespace
