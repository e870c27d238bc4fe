// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// The same, with one of them read: the compiler then looks for it among a thousand.
#include <rtuwire/client.hpp>

#include <rtuwire/altivar/atv320_parameters.hpp>

using namespace rtuwire;
using namespace rtuwire::altivar;

constexpr station<atv320::full_device> drive{unit_id{2}};

auto ask() { return read<atv320::parameter<"SP2">>(drive); }
