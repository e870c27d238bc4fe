// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A file of a program that checks frames. Built twice, with different switches, its functions must not have
// the same names: a linker would keep one of each and drop the other.
#include <rtuwire/core/result.hpp>
#include <rtuwire/wire/adu.hpp>

#ifndef NAME
#define NAME one_form
#endif

bool NAME(rtuwire::byte_view bytes);
bool NAME(rtuwire::byte_view bytes) { return rtuwire::decode_adu(bytes).has_value(); }
