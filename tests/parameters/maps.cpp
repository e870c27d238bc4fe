// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
#include "parameters/maps.hpp"

maps_of const* maps_named(std::string_view drive)
{
    static maps_of const all[]{maps_of_atv12(), maps_of_atv310(), maps_of_atv320()};
    return drive == "atv12" ? &all[0] : drive == "atv310" ? &all[1] : drive == "atv320" ? &all[2] : nullptr;
}
