// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// The requests of the drives' manuals, byte by byte, named as in the list of frames.
#include <rtuwire/wire/adu.hpp>

#include "support/golden.hpp"
#include "support/proof.hpp"

#include <rtuwire/core/hex.hpp>
#include <rtuwire/wire/registers.hpp>
#include <rtuwire/wire/serial_line/device_identification.hpp>
#include <rtuwire/wire/serial_line/diagnostics.hpp>

using namespace rtuwire;
using namespace rtuwire::detail;
using rtuwire::test::encodes;

namespace {

// fc03_req
STATIC_CHECK(encodes(unit_id{2}, read_holding_registers{3102, 4}, "02 03 0C 1E 00 04 27 6C"_hex));
// fc06_req_rsp
STATIC_CHECK(encodes(unit_id{2}, write_single_register{9001, 0x000D}, "02 06 23 29 00 0D 92 70"_hex));
// fc16_req
STATIC_CHECK(encodes(unit_id{2}, write_multiple_registers{9001, register_block{0x0014, 0x001E}},
                     "02 10 23 29 00 02 04 00 14 00 1E 73 A4"_hex));
// fc43_req
STATIC_CHECK(encodes(unit_id{2}, read_device_identification{}, "02 2B 0E 01 00 34 77"_hex));
// atv28_fc03_printed
STATIC_CHECK(encodes(unit_id{2}, read_holding_registers{450, 10}, "02 03 01 C2 00 0A 65 FE"_hex));
// atv28_fc03_ok
STATIC_CHECK(encodes(unit_id{2}, read_holding_registers{450, 7}, "02 03 01 C2 00 07 A4 3B"_hex));
// atv28_fc16_req
STATIC_CHECK(encodes(unit_id{2}, write_multiple_registers{400, register_block{0x000F, 0x0190}},
                     "02 10 01 90 00 02 04 00 0F 01 90 C9 E8"_hex));
// atv28_fault_reset
STATIC_CHECK(encodes(unit_id{2}, write_single_register{400, 0x0080}, "02 06 01 90 00 80 89 88"_hex));
// atv28_standby
STATIC_CHECK(encodes(unit_id{2}, write_single_register{400, 0x0006}, "02 06 01 90 00 06 08 2A"_hex));
// atv28_ready
STATIC_CHECK(encodes(unit_id{2}, write_single_register{400, 0x0007}, "02 06 01 90 00 07 C9 EA"_hex));
// atv28_fwd
STATIC_CHECK(encodes(unit_id{2}, write_single_register{400, 0x000F}, "02 06 01 90 00 0F C8 2C"_hex));
// atv28_rev
STATIC_CHECK(encodes(unit_id{2}, write_single_register{400, 0x080F}, "02 06 01 90 08 0F CF EC"_hex));
// atv28_direct_run
STATIC_CHECK(encodes(unit_id{2}, write_single_register{400, 0x800A}, "02 06 01 90 80 0A 69 EF"_hex));
// atv28_direct_stop
STATIC_CHECK(encodes(unit_id{2}, write_single_register{400, 0x900A}, "02 06 01 90 90 0A 64 2F"_hex));
// atv28_direct_dci
STATIC_CHECK(encodes(unit_id{2}, write_single_register{400, 0xA00A}, "02 06 01 90 A0 0A 70 2F"_hex));
// atv28_direct_fst
STATIC_CHECK(encodes(unit_id{2}, write_single_register{400, 0xC00A}, "02 06 01 90 C0 0A 58 2F"_hex));
// atv28_direct_revrun
STATIC_CHECK(encodes(unit_id{2}, write_single_register{400, 0x880A}, "02 06 01 90 88 0A 6E 2F"_hex));
// poll_eta
STATIC_CHECK(encodes(unit_id{2}, read_holding_registers{3201, 1}, "02 03 0C 81 00 01 D7 41"_hex));
// cmd_shutdown
STATIC_CHECK(encodes(unit_id{2}, write_single_register{8501, 0x0006}, "02 06 21 35 00 06 13 C9"_hex));
// cmd_switch_on
STATIC_CHECK(encodes(unit_id{2}, write_single_register{8501, 0x0007}, "02 06 21 35 00 07 D2 09"_hex));
// cmd_enable
STATIC_CHECK(encodes(unit_id{2}, write_single_register{8501, 0x000F}, "02 06 21 35 00 0F D3 CF"_hex));
// cmd_enable_rev
STATIC_CHECK(encodes(unit_id{2}, write_single_register{8501, 0x080F}, "02 06 21 35 08 0F D4 0F"_hex));
// cmd_disable_voltage
STATIC_CHECK(encodes(unit_id{2}, write_single_register{8501, 0x0000}, "02 06 21 35 00 00 93 CB"_hex));
// cmd_quick_stop
STATIC_CHECK(encodes(unit_id{2}, write_single_register{8501, 0x0002}, "02 06 21 35 00 02 12 0A"_hex));
// cmd_fault_reset
STATIC_CHECK(encodes(unit_id{2}, write_single_register{8501, 0x0080}, "02 06 21 35 00 80 92 6B"_hex));
// cmd_halt
STATIC_CHECK(encodes(unit_id{2}, write_single_register{8501, 0x010F}, "02 06 21 35 01 0F D2 5F"_hex));
// scan_read
STATIC_CHECK(encodes(unit_id{3}, read_holding_registers{12741, 4}, "03 03 31 C5 00 04 5B 2A"_hex));
// scan_write
STATIC_CHECK(encodes(unit_id{3}, write_multiple_registers{12761, register_block{0x000F, 0x05DC, 0x0000, 0x0000}},
                     "03 10 31 D9 00 04 08 00 0F 05 DC 00 00 00 00 87 2E"_hex));
// fc23_req
STATIC_CHECK(encodes(unit_id{2}, read_write_multiple_registers{12741, 3, 12761, register_block{0x000F, 0x05DC, 0x0000}},
                     "02 17 31 C5 00 03 31 D9 00 03 06 00 0F 05 DC 00 00 32 63"_hex));
// fc23_req4
STATIC_CHECK(encodes(unit_id{2},
                     read_write_multiple_registers{12741, 4, 12761, register_block{0x0006, 0x0000, 0x0000, 0x0000}},
                     "02 17 31 C5 00 04 31 D9 00 04 08 00 06 00 00 00 00 00 00 E6 B2"_hex));
// bcast_stop
STATIC_CHECK(encodes(broadcast, write_single_register{8501, 0x0000}, "00 06 21 35 00 00 92 29"_hex));
// fc08_loop
STATIC_CHECK(encodes(unit_id{2}, diagnostics{subfunction::return_query_data, register_block{0xA537}},
                     "02 08 00 00 A5 37 DA BE"_hex));
// atv28_fc03_printed asks for 10 words: legal Modbus, above the 7 that this drive takes.
STATIC_CHECK(not is_quantity(10, device_limits{.read = 7}.read));

} // namespace
