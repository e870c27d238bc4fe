// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// PAGE: docs/trace.md
// BEGINS: pcapng_writer capture
#include <rtuwire/trace.hpp>

using namespace rtuwire;

struct output_file {
    void write(byte_view bytes) noexcept;
};

void snippet(output_file& file, std::uint64_t wall, instant now, byte_view frame)
{
    // BLOCK
}
