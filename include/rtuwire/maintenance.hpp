// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// Public header: a drive's configuration as a whole, read, compared and restored. The parameters of a type are in
// altivar/atv320_parameters.hpp and the like; the client that carries it out is in client.hpp. docs/names.md lists what
// is public.
#pragma once

// What refuses a device that is no drive stands directly below this header: see altivar/atv12.hpp.
#include <rtuwire/altivar/device/drive_type.hpp>

#include <rtuwire/altivar/maintenance/backup.hpp>
#include <rtuwire/altivar/maintenance/restore.hpp>
#include <rtuwire/wire/errc_name.hpp>
