// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// The one list of the kinds of PDU, for tests and fuzz targets that try all of them.
#pragma once

// Beside this header: fuzz targets have no folder of tests to search.
#include "type_list.hpp"

#include <rtuwire/wire/pdu/device_identification.hpp>
#include <rtuwire/wire/pdu/diagnostics.hpp>
#include <rtuwire/wire/pdu/exception.hpp>
#include <rtuwire/wire/pdu/raw.hpp>
#include <rtuwire/wire/pdu/read_holding_registers.hpp>
#include <rtuwire/wire/pdu/read_write_multiple_registers.hpp>
#include <rtuwire/wire/pdu/write_multiple_registers.hpp>
#include <rtuwire/wire/pdu/write_single_register.hpp>

namespace rtuwire::test {

using all_pdus = type_list<read_holding_registers, read_holding_registers_response, write_single_register,
                           write_multiple_registers<>, write_multiple_registers_response,
                           read_write_multiple_registers<>, read_write_multiple_registers_response, diagnostics<>,
                           read_device_identification, device_identification, exception_response, raw_pdu<>>;

} // namespace rtuwire::test
