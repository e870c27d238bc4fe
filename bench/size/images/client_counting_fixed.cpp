// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// The client that counts for its line, whose times are constants of the program.
#include "client.hpp"

#include <rtuwire/client/client.hpp>
#include <rtuwire/client/statistics.hpp>

namespace {

constexpr rtuwire::line_timing line{19'200, rtuwire::character_format::even_8_1};
constexpr rtuwire::client_options patient{};
constinit rtuwire::static_client<line, patient, rtuwire::line_statistics> link;

} // namespace

int main() { ask_on(link); }
