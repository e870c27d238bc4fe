// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
#include <rtuwire/altivar/atv28.hpp>

#include "motion/motor_of.hpp"

namespace tool {

std::unique_ptr<motor> make_motor_of_atv28(motor_line const& line, rtuwire::unit_id unit, asked_motion const& asked)
{
    return std::make_unique<motor_of<rtuwire::altivar::atv28::device>>(line, unit, asked); // a frequency in each case
}

} // namespace tool
