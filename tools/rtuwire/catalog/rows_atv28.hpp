// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// The registers of the ATV28 as rows. No public list has groups of this drive: three simple ones.
#pragma once

#include <span>

#include <rtuwire/altivar/own_parameters.hpp>

namespace tool {

[[nodiscard]] std::span<rtuwire::altivar::parameter_group const> rows_of_atv28() noexcept;

} // namespace tool
