// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
#include "catalog/catalog_drives.hpp"
#include "catalog/catalog_of.hpp"

#include <rtuwire/altivar/atv28.hpp>

namespace tool {

drive_catalog const& catalog_of_atv28() noexcept { return catalog_of<rtuwire::altivar::atv28::device>(); }

} // namespace tool
