// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// Public header: frames as they passed. docs/names.md lists what is public.
#pragma once

#include <rtuwire/trace/capture/pcapng_writer.hpp>
#include <rtuwire/trace/line_listener.hpp>
#include <rtuwire/trace/trace_ring.hpp>
#include <rtuwire/trace/traced_frame.hpp>
