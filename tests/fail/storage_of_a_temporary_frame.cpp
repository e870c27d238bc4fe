// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Bytes to be written, of a buffer that is gone before anybody writes them.
// EXPECT: deleted
// EXPECT: storage
#include <rtuwire/core/bytes.hpp>

using namespace rtuwire;
using namespace rtuwire::detail;

std::size_t place()
{
#ifdef REFUSED
    byte_span const kept = fixed_buffer<8>{}.storage();
#else
    fixed_buffer<8> buffer;
    byte_span const kept = buffer.storage();
#endif
    return kept.size();
}
