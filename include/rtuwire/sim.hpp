// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// Public header: simulated drives and the line they hang on. docs/names.md lists what is public.
#pragma once

#include <rtuwire/sim/bench.hpp>
#include <rtuwire/sim/drive/unit.hpp>
#include <rtuwire/sim/line/line.hpp>
#include <rtuwire/sim/line/line_faults.hpp>
#include <rtuwire/sim/line/usb_adapter.hpp>
#include <rtuwire/wire/errc_name.hpp>
