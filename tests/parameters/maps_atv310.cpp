// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
#include "parameters/maps.hpp"

#include <rtuwire/altivar/atv310_parameters.hpp>

maps_of maps_of_atv310() { return {&rtuwire::altivar::atv310::parameters, nullptr}; }
