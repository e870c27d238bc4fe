// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// The door to the registers of the ATV320. What is done with them stands in altivar/procedure and altivar/cyclic.
#pragma once

#include <rtuwire/altivar/device/atv320.hpp>
