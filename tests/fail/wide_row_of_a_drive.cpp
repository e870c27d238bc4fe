// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A row of a drive that holds two words: a backup reads one word a row, and a restore writes one.
// EXPECT: held_values
#include <rtuwire/altivar/own_parameters.hpp>
#include <rtuwire/client.hpp>

using namespace rtuwire;

inline constexpr altivar::parameter rows[]{
#ifdef REFUSED
    {"APH", 3231, {access::read_only, provenance::documented}, in<unsigned32<>>},
#else
    {"APH", 3231, {access::read_only, provenance::documented}, in<count16>},
#endif
};
