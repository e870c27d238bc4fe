// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// Public header: everything that needs no operating system. docs/names.md says which smaller one a task needs.
#pragma once

#include <rtuwire/altivar/all.hpp>
#include <rtuwire/client.hpp>
#include <rtuwire/drives.hpp>
#include <rtuwire/frames.hpp>
#include <rtuwire/serial_line.hpp>
#include <rtuwire/server.hpp>
#include <rtuwire/sim.hpp>
#include <rtuwire/trace.hpp>
