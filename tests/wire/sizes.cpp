// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// The largest PDU of each kind (AP 4.1, 6), and which may be sent to everyone.
#include "support/proof.hpp"

#include <rtuwire/core/hex.hpp>
#include <rtuwire/serial_line.hpp>
#include <rtuwire/wire/functions.hpp>
#include <rtuwire/wire/raw.hpp>

using namespace rtuwire;
using namespace rtuwire::detail;

STATIC_CHECK(read_holding_registers::max_size == 5);
STATIC_CHECK(read_holding_registers_response::max_size == 252);
STATIC_CHECK(write_single_register::max_size == 5);
STATIC_CHECK(write_multiple_registers<>::max_size == 252);
STATIC_CHECK(read_write_multiple_registers<>::max_size == 252);
STATIC_CHECK(read_write_multiple_registers_response::max_size == 252);
STATIC_CHECK(read_device_identification::max_size == 4);
STATIC_CHECK(diagnostics<>::max_size == 253);
STATIC_CHECK(read_coils::max_size == 5 and read_coils_response::max_size == 252);
STATIC_CHECK(read_discrete_inputs::max_size == 5 and read_discrete_inputs_response::max_size == 252);
STATIC_CHECK(read_input_registers::max_size == 5 and read_input_registers_response::max_size == 252);
STATIC_CHECK(write_single_coil::max_size == 5);
STATIC_CHECK(read_exception_status::max_size == 1 and read_exception_status_response::max_size == 2);
STATIC_CHECK(get_comm_event_counter::max_size == 1 and get_comm_event_counter_response::max_size == 5);
STATIC_CHECK(get_comm_event_log::max_size == 1 and get_comm_event_log_response::max_size == 72);
STATIC_CHECK(write_multiple_coils<>::max_size == 252 and write_multiple_coils_response::max_size == 5);
STATIC_CHECK(write_multiple_registers_response::max_size == 5);
STATIC_CHECK(report_server_id::max_size == 1 and report_server_id_response::max_size == 253);
STATIC_CHECK(read_file_record<>::max_size == 247 and read_file_record_response::max_size == 247);
STATIC_CHECK(write_file_record<>::max_size == 253 and file_writes::max_size == 253);
STATIC_CHECK(mask_write_register::max_size == 7);
STATIC_CHECK(read_fifo_queue::max_size == 3 and read_fifo_queue_response::max_size == 67);
STATIC_CHECK(raw_pdu<>::max_size == 253);
STATIC_CHECK(device_identification::max_size == 253);

// With words of its own, a request has room for these, as far as its function allows.
STATIC_CHECK(write_multiple_registers<register_block<2>>::max_size == 6 + 4);
STATIC_CHECK(write_multiple_registers<register_block<200>>::max_size == 252);
STATIC_CHECK(read_write_multiple_registers<register_block<3>>::max_size == 10 + 6);
STATIC_CHECK(diagnostics<register_block<1>>::max_size == 3 + 2);
STATIC_CHECK(write_multiple_coils<bit_block<9>>::max_size == 6 + 2);
STATIC_CHECK(write_multiple_coils<bit_block<1968>>::max_size == 252);
STATIC_CHECK(write_multiple_coils<bit_block<2000>>::max_size == 252);
STATIC_CHECK(write_file_record<register_block<3>>::max_size == 9 + 6);
STATIC_CHECK(raw_pdu<std::array<std::byte, 5>>::max_size == 1 + 5);
STATIC_CHECK(raw_pdu<std::array<std::byte, 251>>::max_size == 252);
STATIC_CHECK(raw_pdu<std::array<std::byte, 253>>::max_size == 253);

STATIC_CHECK(broadcastable<write_single_register>);
STATIC_CHECK(broadcastable<write_multiple_registers<>>);
STATIC_CHECK(broadcastable<write_single_coil>and broadcastable<write_multiple_coils<>>);
STATIC_CHECK(broadcastable<write_file_record<>>and broadcastable<mask_write_register>);
STATIC_CHECK(not broadcastable<read_coils> and not broadcastable<read_discrete_inputs>);
STATIC_CHECK(not broadcastable<read_input_registers> and not broadcastable<read_exception_status>);
STATIC_CHECK(not broadcastable<diagnostics<>> and not broadcastable<get_comm_event_counter>);
STATIC_CHECK(not broadcastable<get_comm_event_log> and not broadcastable<report_server_id>);
STATIC_CHECK(not broadcastable<read_file_record<>> and not broadcastable<read_fifo_queue>);
STATIC_CHECK(not broadcastable<read_holding_registers>);
STATIC_CHECK(not broadcastable<read_write_multiple_registers<>>);
STATIC_CHECK(not broadcastable<read_device_identification>);

// Another type within function 43, and one that is cut off.
STATIC_CHECK(read_device_identification::decode("2B 0D"_hex) == errc::wrong_function);
STATIC_CHECK(read_device_identification::decode("2B 0E"_hex) == errc::wrong_length);
STATIC_CHECK(read_device_identification::decode("2B"_hex) == errc::wrong_length);
