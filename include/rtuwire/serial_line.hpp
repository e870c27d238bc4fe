// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// Public header: the functions of serial lines only, 07, 08, 11, 12, 17, 20, 21 and 24, and device identification,
// 43/14; beside client.hpp or frames.hpp. docs/names.md lists what is public.
#pragma once

#include <rtuwire/wire/serial_line/device_identification.hpp>
#include <rtuwire/wire/serial_line/diagnostics.hpp>
#include <rtuwire/wire/serial_line/fifo_queue.hpp>
#include <rtuwire/wire/serial_line/file_records.hpp>
#include <rtuwire/wire/serial_line/unit_report.hpp>
