// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
#include <rtuwire/altivar/atv310.hpp>

#include "backup/drive_restore_of.hpp"

namespace tool {

restored restore_atv310(restore_work const& work) { return restore_to<rtuwire::altivar::atv310::device>(work); }
restored restore_atv310_2026(restore_work const& work)
{
    return restore_to<rtuwire::altivar::atv310::device_2026>(work);
}

} // namespace tool
