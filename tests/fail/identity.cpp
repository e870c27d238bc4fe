// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Objects of a device in an order in which no client could page through them.
// EXPECT: the vendor's name first, numbers that rise, texts that fit
#include <rtuwire/server/identification.hpp>

using namespace rtuwire;

#ifdef REFUSED
constexpr device_object objects[] = {{vendor_name, "A"}, {2, "1"}, {product_code, "B"}};
#else
constexpr device_object objects[] = {{vendor_name, "A"}, {product_code, "B"}, {2, "1"}};
#endif
static_assert(identity_of<objects>.conformity() == 0x81);
