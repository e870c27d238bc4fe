// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// Public header: frames without a client or a server; encode, decode, check. docs/names.md lists what is public.
#pragma once

#include <rtuwire/core/crc16.hpp>
#include <rtuwire/core/hex.hpp>
#include <rtuwire/core/literal.hpp>
#include <rtuwire/rtu/framer.hpp>
#include <rtuwire/rtu/line.hpp>
#include <rtuwire/wire/adu.hpp>
#include <rtuwire/wire/errc.hpp>
#include <rtuwire/wire/errc_name.hpp>
#include <rtuwire/wire/functions.hpp>
#include <rtuwire/wire/raw.hpp>
#include <rtuwire/wire/response.hpp>
