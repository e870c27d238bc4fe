// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
#include "parameters/maps.hpp"

#include <rtuwire/altivar/atv12_parameters.hpp>

maps_of maps_of_atv12()
{
    return {&rtuwire::altivar::atv12::parameters, &rtuwire::altivar::atv12::unverified_parameters};
}
