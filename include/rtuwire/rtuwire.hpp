// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// Every portable header, for the impatient. What needs an operating system is in port/.
#pragma once

#include <rtuwire/client/blocking.hpp>
#include <rtuwire/client/client.hpp>
#include <rtuwire/client/conversation.hpp>
#include <rtuwire/core/bytes.hpp>
#include <rtuwire/core/crc16.hpp>
#include <rtuwire/core/fixed_buffer.hpp>
#include <rtuwire/core/hex.hpp>
#include <rtuwire/core/result.hpp>
#include <rtuwire/core/text.hpp>
#include <rtuwire/core/time.hpp>
#include <rtuwire/core/units.hpp>
#include <rtuwire/rtu/framer.hpp>
#include <rtuwire/rtu/line.hpp>
#include <rtuwire/server/bank.hpp>
#include <rtuwire/server/blocking.hpp>
#include <rtuwire/server/identification.hpp>
#include <rtuwire/server/request.hpp>
#include <rtuwire/server/respond.hpp>
#include <rtuwire/server/server.hpp>
#include <rtuwire/wire/adu.hpp>
#include <rtuwire/wire/answer.hpp>
#include <rtuwire/wire/errc.hpp>
#include <rtuwire/wire/errc_name.hpp>
#include <rtuwire/wire/frame_length.hpp>
#include <rtuwire/wire/function.hpp>
#include <rtuwire/wire/limits.hpp>
#include <rtuwire/wire/pdu/device_identification.hpp>
#include <rtuwire/wire/pdu/diagnostics.hpp>
#include <rtuwire/wire/pdu/exception.hpp>
#include <rtuwire/wire/pdu/raw.hpp>
#include <rtuwire/wire/pdu/read_holding_registers.hpp>
#include <rtuwire/wire/pdu/read_write_multiple_registers.hpp>
#include <rtuwire/wire/pdu/write_multiple_registers.hpp>
#include <rtuwire/wire/pdu/write_single_register.hpp>
#include <rtuwire/wire/register_view.hpp>
#include <rtuwire/wire/unit_id.hpp>
