// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// Public header: the client, its conversations, and registers with types. docs/names.md lists what is public.
#pragma once

#include <rtuwire/ask/access.hpp>
#include <rtuwire/ask/plan_writer.hpp>
#include <rtuwire/ask/poller.hpp>
#include <rtuwire/ask/single_request.hpp>
#include <rtuwire/ask/words_read.hpp>
#include <rtuwire/client/blocking.hpp>
#include <rtuwire/client/bus.hpp>
#include <rtuwire/client/client.hpp>
#include <rtuwire/client/statistics.hpp>
#include <rtuwire/core/text.hpp>
#include <rtuwire/frames.hpp>
#include <rtuwire/rtu/interrupt_queue.hpp>
#include <rtuwire/table/device.hpp>
#include <rtuwire/table/enumeration.hpp>
#include <rtuwire/table/form/ascii.hpp>
#include <rtuwire/table/form/floating.hpp>
#include <rtuwire/table/form/packed.hpp>
#include <rtuwire/table/form/real_text.hpp>
#include <rtuwire/table/form/whole.hpp>
#include <rtuwire/table/read_plan.hpp>
#include <rtuwire/table/register.hpp>
#include <rtuwire/table/register_text.hpp>
#include <rtuwire/table/setting.hpp>
#include <rtuwire/table/table.hpp>
