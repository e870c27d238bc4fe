// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// An enumeration that nobody listed has no names, and every word means something in it.
#include <rtuwire/table/enumeration.hpp>

#include "support/proof.hpp"

namespace {

using namespace rtuwire;
using namespace rtuwire::detail;

enum class unlisted : std::uint16_t { first, second };
enum class listed : std::uint16_t { off = 2, on = 5 };

} // namespace

namespace rtuwire {
template <> inline constexpr auto enumerators<listed> = name_list({{2, "OFF"}, {5, "ON"}});
} // namespace rtuwire

STATIC_CHECK(listed_values<unlisted>.empty());
STATIC_CHECK(name_of(unlisted::first).size() == 0 and name_of(unlisted::second).size() == 0);
STATIC_CHECK(has_meaning(listed_values<unlisted>, 0) and has_meaning(listed_values<unlisted>, 0xFFFF));

STATIC_CHECK(listed_values<listed> == std::array<std::uint16_t, 2>{2, 5});
STATIC_CHECK(name_of(listed::on) == literal{"ON"} and name_of(listed{3}).size() == 0);
STATIC_CHECK(has_meaning(listed_values<listed>, 2) and not has_meaning(listed_values<listed>, 0));
