// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
#include <rtuwire/altivar/atv310.hpp>

#include "motion/motor_of.hpp"

namespace tool {

std::unique_ptr<motor> make_motor_of_atv310_2026(motor_line const& line, rtuwire::unit_id unit,
                                                 asked_motion const& asked)
{
    return make_motor<rtuwire::altivar::atv310::device_2026>(line, unit, asked);
}

} // namespace tool
