// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// What a controller has to know of each drive beyond its registers, as the manuals and the published parameter files
// have it: one row for each thing, one column for each drive.
#include <rtuwire/altivar/device/drive_layout.hpp>

#include "support/proof.hpp"

#include <array>
#include <type_traits>

#include <rtuwire/altivar/atv12.hpp>
#include <rtuwire/altivar/atv28.hpp>
#include <rtuwire/altivar/atv310.hpp>
#include <rtuwire/altivar/atv320.hpp>

using namespace rtuwire;
using namespace rtuwire::detail;
using namespace rtuwire::altivar;
using cia402::state_machine_options;

namespace {

using drive = drive_layout;
using guard = safeguard_layout;

template <typename Device, typename T> constexpr T in(T drive::*field) { return Device::layout.*field; }
template <typename Device, typename T> constexpr T in(T state_machine_options::*field)
{
    return Device::layout.state_machine.*field;
}
template <typename Device, typename T> constexpr T in(T guard::*field) { return Device::layout.safeguards.*field; }
template <typename Device, typename T> constexpr T in(T scanner_registers::*field) { return Device::scanner.*field; }
template <typename Device, typename T> constexpr T in(T cycle_registers::*field) { return Device::cycle.*field; }

/// Whether a field is so in the ATV12, the ATV310 of 2014 and that of 2026, the ATV320, and the ATV28.
template <typename T> using same = std::type_identity_t<T>;
template <typename Part, typename T>
constexpr bool are(T Part::*field, same<T> of_12, same<T> of_310, same<T> of_310_2026, same<T> of_320, same<T> of_28)
{
    return in<atv12::device>(field) == of_12 and in<atv310::device>(field) == of_310 and
           in<atv310::device_2026>(field) == of_310_2026 and in<atv320::device>(field) == of_320 and
           in<atv28::device>(field) == of_28;
}

// Words: control and status, each with its extension, the last fault, the output frequency and its lower limit.
STATIC_CHECK(are(&drive::cmd, 8501, 8501, 8501, 8501, 400));
STATIC_CHECK(are(&drive::eta, 3201, 3201, 3201, 3201, 458));
STATIC_CHECK(are(&drive::lft, 7121, 7121, 7121, 7121, 457));
STATIC_CHECK(are(&drive::cmi, 8504, 8504, 8504, 8504, 402));
STATIC_CHECK(are(&drive::eti, 3206, 3206, 3206, 3206, 459));
STATIC_CHECK(are(&drive::rfr, 3202, 3202, 3202, 3202, 451));
STATIC_CHECK(are(&drive::lsp, 3105, 3105, 3105, 3105, 251));

// The chart: 3B is drawn for all but the ATV28; a quick stop ends by itself on an ATV12 and an ATV310, while the ATV320
// (QSTD as delivered) and the ATV28 wait for "disable voltage"; nobody has transition 16. A configuration that is
// written in "switched on" leads back to "switch on disabled", but on the ATV28, whose transition 10 has no such cause.
STATIC_CHECK(are(&state_machine_options::enables_from_ready, true, true, true, true, false));
STATIC_CHECK(are(&state_machine_options::quick_stop_waits, false, false, false, true, true));
STATIC_CHECK(are(&state_machine_options::resumes_from_quick_stop, false, false, false, false, false));
STATIC_CHECK(are(&drive::falls_back_when_configured, true, true, true, true, false));

// Status bits: the ATV28's bit 4 is 1 where power is absent, and its bit 9 tells of forced local control alone, which
// refuses commands. ETI shows an access to the EEPROM in bit 0, which the ATV28 reserves.
STATIC_CHECK(are(&drive::mains_bit_is_inverted, false, false, false, false, true));
STATIC_CHECK(are(&drive::shows_forced_local_only, false, false, false, false, true));
STATIC_CHECK(are(&drive::refuses_commands_in_local, false, false, false, false, true));
STATIC_CHECK(are(&drive::shows_eeprom_access, true, true, true, true, false));

// Control bits: bit 8 halts, but releases the link of an ATV28, which alone has direct control by bit 15 and a word for
// DC injection. CMI restores the factory settings by bit 0 and saves by bit 1; an ATV28's recalls by bit 2.
STATIC_CHECK(are(&drive::halt, 0x0100, 0x0100, 0x0100, 0x0100, 0));
STATIC_CHECK(are(&drive::direct_control, 0, 0, 0, 0, 0x8000));
STATIC_CHECK(are(&drive::dc_injection, 0, 0, 0, 0, 0xA00A));
STATIC_CHECK(are(&drive::cmi_orders, 0x0003, 0x0003, 0x0003, 0x0003, 0x0007));

// Times: TTO goes up to 30 s, the ATV28's time-out is always 7 s. It says nothing for up to 2 s while it saves, and is
// given 0.1 s more; it fails where a request comes before it has answered the one before. The others answer while they
// save, and are looked at every 50 ms.
constexpr duration longest_tto = milliseconds(30'000), always = milliseconds(7'000);
constexpr duration one_look = milliseconds(50), saving = milliseconds(2'100);
STATIC_CHECK(are(&drive::longest_silence, longest_tto, longest_tto, longest_tto, longest_tto, always));
STATIC_CHECK(are(&drive::eeprom_time, one_look, one_look, one_look, one_look, saving));
STATIC_CHECK(are(&drive::fails_when_cut_short, false, false, false, false, true));

// The scanner's words each way, NMA and NCA with their addresses, NM and NC with what they hold.
using scanner = scanner_registers;
STATIC_CHECK(are(&scanner::words, 4, 4, 8, 8, 0));
STATIC_CHECK(are(&scanner::input_addresses, 12701, 12701, 12701, 12701, 0));
STATIC_CHECK(are(&scanner::output_addresses, 12721, 12721, 12721, 12721, 0));
STATIC_CHECK(are(&scanner::input_words, 12741, 12741, 12741, 12741, 0));
STATIC_CHECK(are(&scanner::output_words, 12761, 12761, 12761, 12761, 0));

// The cycle: ETA and RFRD, CMD and LFRD where the scanner has them as delivered, in as many words as function 23 moves, or
// all eight where it moves too few. An ATV28 has neither: seven words up to ETA, then CMD and LFR.
using cycle = cycle_registers;
constexpr auto one = function_code::read_write_multiple_registers, two = function_code::write_multiple_registers;
STATIC_CHECK(are(&cycle::by, one, one, two, one, two));
STATIC_CHECK(are(&cycle::by_scanner, true, true, true, true, false));
STATIC_CHECK(are(&cycle::speed, 8604, 8604, 8604, 8604, 452));

/// Whether a list holds these addresses, in this order, and nothing behind them but words that are free.
template <std::size_t Count>
constexpr bool holds(cycle_addresses const& list, std::array<std::uint16_t, Count> const& addresses, std::size_t size)
{
    bool is_so = list.size() == size;
    for (std::size_t i = 0; i < list.size(); ++i) {
        is_so = is_so and list[i] == (i < Count ? addresses[i] : 0);
    }
    return is_so;
}
template <typename Device> constexpr bool cycles_by_scanner(std::size_t size)
{
    return holds(Device::cycle.reads, std::array<std::uint16_t, 2>{3201, 8604}, size) and
           holds(Device::cycle.writes, std::array<std::uint16_t, 2>{8501, 8602}, size);
}
STATIC_CHECK(cycles_by_scanner<atv12::device>(4) and cycles_by_scanner<atv310::device>(4));
STATIC_CHECK(cycles_by_scanner<atv310::device_2026>(8) and cycles_by_scanner<atv320::device>(4));
STATIC_CHECK(holds(atv28::device::cycle.reads, std::array<std::uint16_t, 7>{452, 453, 454, 455, 456, 457, 458}, 7));
STATIC_CHECK(holds(atv28::device::cycle.writes, std::array<std::uint16_t, 2>{400, 401}, 2));

// An ATV320 may be set to an I/O profile, by CHCF = 3, and may be behind the 8501 of any declared type.
STATIC_CHECK(io_profile == 3);
STATIC_CHECK(may_have_io_profile(atv320::device::layout) and may_have_io_profile(atv12::device::layout));
STATIC_CHECK(may_have_io_profile(atv310::device::layout) and may_have_io_profile(atv310::device_2026::layout));
STATIC_CHECK(not may_have_io_profile(atv28::device::layout));
STATIC_CHECK(not is_drive_profile(0) and is_drive_profile(1) and is_drive_profile(2) and not is_drive_profile(3));
STATIC_CHECK(atv320::device::layout.cmd == later_control_word);
STATIC_CHECK(are(&drive::other_cmd, 400, 400, 400, 400, 8501));

// What a drive does when its link is lost, and who may command it: SLL, TTO and the channels. An ATV28 has one bit of
// CMI instead, NTO, and its terminals command until the line does. Atr, DOTD, the inputs and tCC where a file has them.
STATIC_CHECK(are(&guard::sll, 7010, 7010, 7010, 7010, 0));
STATIC_CHECK(are(&guard::tto, 6005, 6005, 6005, 6005, 0));
STATIC_CHECK(are(&guard::nto, 0, 0, 0, 0, 0x4000));
STATIC_CHECK(are(&guard::fixed_timeout, {}, {}, {}, {}, always));
STATIC_CHECK(are(&guard::chcf, 8401, 8401, 8401, 8401, 0));
STATIC_CHECK(are(&guard::cd1, 8423, 8423, 8423, 8423, 0));
STATIC_CHECK(are(&guard::fr1, 8413, 8413, 8413, 8413, 0));
STATIC_CHECK(are(&guard::flo, 8431, 8431, 8431, 8431, 0));
STATIC_CHECK(are(&guard::atr, 0, 0, 0, 7122, 150));
STATIC_CHECK(are(&guard::dotd, 0, 0, 0, 8652, 0));
STATIC_CHECK(are(&guard::inputs, 5201, 0, 0, 5202, 478));
STATIC_CHECK(are(&guard::tcc, 11101, 0, 0, 11101, 6));
STATIC_CHECK(are(&guard::is_local_at_power_up, false, false, false, false, true));

} // namespace
