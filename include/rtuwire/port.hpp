// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// Public header: where the operating system begins. docs/names.md lists what is public.
#pragma once

#include <rtuwire/core/literal.hpp>
#include <rtuwire/port/chrono.hpp>
#include <rtuwire/port/descriptor.hpp>
#include <rtuwire/port/host_lookup.hpp>
#include <rtuwire/port/mbap.hpp>
#include <rtuwire/port/mbap_listener.hpp>
#include <rtuwire/port/mbap_stream.hpp>
#include <rtuwire/port/posix_serial.hpp>
#include <rtuwire/port/pseudo_terminal.hpp>
#include <rtuwire/port/serial_settings.hpp>
#include <rtuwire/port/tcp_acceptor.hpp>
#include <rtuwire/port/tcp_stream.hpp>
#include <rtuwire/port/transceiver.hpp>
#include <rtuwire/port/win32_serial.hpp>
#include <rtuwire/wire/unit_id.hpp>
