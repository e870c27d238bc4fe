// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A drive's table in the form of a register file.
#pragma once

#include "catalog/catalog.hpp"
#include "device/register_file_writer.hpp"

namespace tool {

/// What commands a motor, may move one or changes how it turns has `moves = true`.
void export_drive(drive_catalog const& drive, register_file_writer& into);

} // namespace tool
