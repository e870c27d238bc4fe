// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// The client with all parameters of the ATV320.
#include <rtuwire/client.hpp>

#include <rtuwire/altivar/atv320_parameters.hpp>
