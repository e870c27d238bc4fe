// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
#include "catalog/catalog_drives.hpp"
#include "catalog/catalog_of.hpp"

#include <rtuwire/altivar/atv310.hpp>

namespace tool {

drive_catalog const& catalog_of_atv310() noexcept { return catalog_of<rtuwire::altivar::atv310::device>(); }
drive_catalog const& catalog_of_atv310_2026() noexcept { return catalog_of<rtuwire::altivar::atv310::device_2026>(); }

} // namespace tool
