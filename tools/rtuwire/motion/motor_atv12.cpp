// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
#include <rtuwire/altivar/atv12.hpp>

#include "motion/motor_of.hpp"

namespace tool {

std::unique_ptr<motor> make_motor_of_atv12(motor_line const& line, rtuwire::unit_id unit, asked_motion const& asked)
{
    return make_motor<rtuwire::altivar::atv12::device>(line, unit, asked);
}

} // namespace tool
