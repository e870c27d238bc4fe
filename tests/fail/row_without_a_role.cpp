// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// The row of a register that is written, and that does not say what a restore does with it.
// EXPECT: a_register_that_is_written_says_what_it_is_for_a_restore
#include <rtuwire/altivar/atv12.hpp>
#include <rtuwire/altivar/own_parameters.hpp>

using namespace rtuwire::altivar;

#ifdef REFUSED
inline constexpr parameter row = row_of(atv12::cmd);
#else
inline constexpr parameter row = row_of(atv12::cmd, roles::commands);
#endif
