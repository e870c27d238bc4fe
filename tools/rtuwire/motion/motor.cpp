// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
#include "motion/motor.hpp"

#include <utility>

namespace tool {

motor_maker maker_of(std::string_view drive) noexcept
{
    constexpr std::pair<std::string_view, motor_maker> known[] = {{"atv12", make_motor_of_atv12},
                                                                  {"atv28", make_motor_of_atv28},
                                                                  {"atv310", make_motor_of_atv310},
                                                                  {"atv310_2026", make_motor_of_atv310_2026},
                                                                  {"atv320", make_motor_of_atv320}};
    for (auto const& [name, maker] : known) {
        if (name == drive) {
            return maker;
        }
    }
    return nullptr;
}

} // namespace tool
