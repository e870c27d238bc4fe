// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// Where the scanner of a drive has its slots: registers that one request reads or writes in place of others.
// Internal: may change with any version.
#pragma once

#include <cstdint>

#include <rtuwire/core/version.hpp>

namespace rtuwire::inline RTUWIRE_BUILD::altivar {

/// The first addresses of the slots of the Altivar scanners.
inline constexpr std::uint16_t scanner_input_addresses = 12'701;  ///< NMA1
inline constexpr std::uint16_t scanner_output_addresses = 12'721; ///< NCA1
inline constexpr std::uint16_t scanner_input_words = 12'741;      ///< NM1
inline constexpr std::uint16_t scanner_output_words = 12'761;     ///< NC1

} // namespace rtuwire::altivar
