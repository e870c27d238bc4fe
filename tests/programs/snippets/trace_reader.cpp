// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// PAGE: docs/trace.md
// BEGINS: capture_reader reader
#include <rtuwire/trace.hpp>

#include <optional>

using namespace rtuwire;

struct input_file {
    std::optional<byte_view> read();
};
void show(std::uint64_t unix_microseconds, traced_frame const& frame);
void complain(literal what, std::uint64_t offset);

void snippet(input_file& file)
{
    // BLOCK
}
