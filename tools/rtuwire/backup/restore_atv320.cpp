// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
#include <rtuwire/altivar/atv320.hpp>

#include "backup/drive_restore_of.hpp"

namespace tool {

restored restore_atv320(restore_work const& work) { return restore_to<rtuwire::altivar::atv320::device>(work); }

} // namespace tool
