// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A result of a value whose copy is more than its bytes.
// EXPECT: a result holds trivially copyable values only
#include <string>

#include <rtuwire/core/result.hpp>

#ifdef REFUSED
using text = std::string;
#else
using text = char const*;
#endif

using named = decltype(*rtuwire::result<text>{text{}});
