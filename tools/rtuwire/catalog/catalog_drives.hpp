// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// One catalog a drive, each compiled in a file of its own.
#pragma once

#include "catalog/catalog.hpp"

namespace tool {

[[nodiscard]] drive_catalog const& catalog_of_atv12() noexcept;
[[nodiscard]] drive_catalog const& catalog_of_atv28() noexcept;
[[nodiscard]] drive_catalog const& catalog_of_atv310() noexcept;
[[nodiscard]] drive_catalog const& catalog_of_atv310_2026() noexcept;
[[nodiscard]] drive_catalog const& catalog_of_atv320() noexcept;

} // namespace tool
