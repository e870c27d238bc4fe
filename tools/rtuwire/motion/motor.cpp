// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
#include "motion/motor.hpp"

#include <rtuwire/altivar/all.hpp>

#include "motion/motor_of.hpp"

namespace tool {

motor_maker maker_of(std::string_view drive) noexcept
{
    motor_maker maker = nullptr;
    rtuwire::altivar::all_drives::for_each([&]<typename Drive>() {
        if (drive == std::string_view{Drive::name}) {
            maker = &make_motor<Drive>;
        }
    });
    return maker;
}

} // namespace tool
