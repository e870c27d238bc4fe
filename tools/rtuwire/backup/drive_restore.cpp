// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
#include "backup/drive_restore.hpp"

#include <rtuwire/altivar/all.hpp>

#include "backup/drive_restore_of.hpp"
#include "port/whole_drive.hpp"

namespace tool {

restore_function restore_for(std::string_view drive) noexcept
{
    restore_function function = nullptr;
    rtuwire::altivar::all_drives::for_each([&]<typename Drive>() {
        if constexpr (has_all_parameters<Drive>) {
            if (drive == std::string_view{Drive::name}) {
                function = &restore_to<Drive>;
            }
        }
    });
    return function;
}

} // namespace tool
