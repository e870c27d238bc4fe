// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// Public header: the server, its engine and its banks of registers. docs/names.md lists what is public.
#pragma once

#include <rtuwire/frames.hpp>
#include <rtuwire/rtu/interrupt_queue.hpp>
#include <rtuwire/server/banks.hpp>
#include <rtuwire/server/blocking.hpp>
#include <rtuwire/server/hooks.hpp>
#include <rtuwire/server/identification.hpp>
#include <rtuwire/server/respond.hpp>
#include <rtuwire/server/server.hpp>
#include <rtuwire/server/typed_bank.hpp>
#include <rtuwire/server/units.hpp>
#include <rtuwire/table/form/ascii.hpp>
#include <rtuwire/table/form/floating.hpp>
#include <rtuwire/table/form/packed.hpp>
#include <rtuwire/table/form/real_text.hpp>
#include <rtuwire/table/form/whole.hpp>
