// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A view of a text that is gone after its statement.
// EXPECT: a text that ends with its expression gives no view: give it a name first
#include <string>
#include <string_view>

#include <rtuwire/core/text.hpp>
#include <rtuwire/core/units.hpp>

using namespace rtuwire;

std::size_t shown(decihertz speed)
{
#ifdef REFUSED
    std::string_view const view = text_of(speed);
#else
    auto const text = text_of(speed);
    std::string_view const view = text;
#endif
    return view.size() + std::string{text_of(speed)}.size();
}
