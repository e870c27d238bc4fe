// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
#include "parameters/maps.hpp"

#include <rtuwire/altivar/atv320_parameters.hpp>

maps_of maps_of_atv320()
{
    return {&rtuwire::altivar::atv320::parameters, &rtuwire::altivar::atv320::unverified_parameters};
}
