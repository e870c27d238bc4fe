// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// What a compiler calls by itself, byte by byte: for a processor that the C library at hand is not made for.
#include <cstddef>

extern "C" {

void* memcpy(void* to, void const* from, std::size_t size)
{
    auto* const place = static_cast<char*>(to);
    for (std::size_t i = 0; i < size; ++i) {
        place[i] = static_cast<char const*>(from)[i];
    }
    return to;
}

void* memmove(void* to, void const* from, std::size_t size)
{
    auto* const place = static_cast<char*>(to);
    auto const* const bytes = static_cast<char const*>(from);
    if (place < bytes) {
        return memcpy(to, from, size);
    }
    while (size > 0) {
        --size;
        place[size] = bytes[size];
    }
    return to;
}

void* memset(void* to, int value, std::size_t size)
{
    for (std::size_t i = 0; i < size; ++i) {
        static_cast<char*>(to)[i] = static_cast<char>(value);
    }
    return to;
}

int memcmp(void const* one, void const* other, std::size_t size)
{
    for (std::size_t i = 0; i < size; ++i) {
        int const difference = static_cast<unsigned char const*>(one)[i] - static_cast<unsigned char const*>(other)[i];
        if (difference != 0) {
            return difference;
        }
    }
    return 0;
}

} // extern "C"
