// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// The largest PDU of each kind (AP 4.1, 6.3, 6.12, 6.17), and which may be sent to everyone.
#include "support/proof.hpp"

#include <rtuwire/core/hex.hpp>
#include <rtuwire/wire/pdu/device_identification.hpp>
#include <rtuwire/wire/pdu/diagnostics.hpp>
#include <rtuwire/wire/pdu/exception.hpp>
#include <rtuwire/wire/pdu/raw.hpp>
#include <rtuwire/wire/pdu/read_holding_registers.hpp>
#include <rtuwire/wire/pdu/read_write_multiple_registers.hpp>
#include <rtuwire/wire/pdu/write_multiple_registers.hpp>
#include <rtuwire/wire/pdu/write_single_register.hpp>

using namespace rtuwire;

STATIC_CHECK(read_holding_registers::max_size == 5);
STATIC_CHECK(read_holding_registers_response::max_size == 252);
STATIC_CHECK(write_single_register::max_size == 5);
STATIC_CHECK(write_multiple_registers<>::max_size == 252);
STATIC_CHECK(read_write_multiple_registers<>::max_size == 252);
STATIC_CHECK(read_write_multiple_registers_response::max_size == 252);
STATIC_CHECK(read_device_identification::max_size == 4);
STATIC_CHECK(diagnostics<>::max_size == 253);
STATIC_CHECK(raw_pdu<>::max_size == 253);
STATIC_CHECK(device_identification::max_size == 253);

// With words of its own, a request has room for these, as far as its function allows.
STATIC_CHECK(write_multiple_registers<register_block<2>>::max_size == 6 + 4);
STATIC_CHECK(write_multiple_registers<register_block<200>>::max_size == 252);
STATIC_CHECK(read_write_multiple_registers<register_block<3>>::max_size == 10 + 6);
STATIC_CHECK(diagnostics<register_block<1>>::max_size == 3 + 2);
STATIC_CHECK(raw_pdu<std::array<std::byte, 5>>::max_size == 1 + 5);
STATIC_CHECK(raw_pdu<std::array<std::byte, 251>>::max_size == 252);
STATIC_CHECK(raw_pdu<std::array<std::byte, 253>>::max_size == 253);

STATIC_CHECK(broadcastable<write_single_register>);
STATIC_CHECK(broadcastable<write_multiple_registers<>>);
STATIC_CHECK(not broadcastable<read_holding_registers>);
STATIC_CHECK(not broadcastable<read_write_multiple_registers<>>);
STATIC_CHECK(not broadcastable<read_device_identification>);

// Another type within function 43, and one that is cut off.
STATIC_CHECK(read_device_identification::decode("2B 0D"_hex) == errc::wrong_function);
STATIC_CHECK(read_device_identification::decode("2B 0E"_hex) == errc::wrong_length);
STATIC_CHECK(read_device_identification::decode("2B"_hex) == errc::wrong_length);
