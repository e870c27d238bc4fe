// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// What the standard library would ask a system for. There is none: the module ends by a trap, which the page shows.
#if defined(__wasm__)

#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <new>
#include <string>

extern "C" char __heap_base; // where the linker's own data ends

namespace {

/// Blocks of 16, 32, 64... bytes; those that are given back wait in a list for each size. A tenth of what the C
/// library's allocator takes of the module.
class block_store {
    struct block {
        block* next;
    };
    struct alignas(std::max_align_t) head {
        std::size_t order;
    };

public:
    void* take(std::size_t size)
    {
        auto const order = static_cast<std::size_t>(std::bit_width((size + sizeof(head) - 1) | 15U));
        if (block* const found = free_[order]; found != nullptr) {
            free_[order] = found->next;
            return found;
        }
        char* const place = extend(std::size_t{1} << order);
        new (place) head{order};
        return place + sizeof(head);
    }

    void give_back(void* place)
    {
        if (place != nullptr) {
            std::size_t const order = reinterpret_cast<head*>(static_cast<char*>(place) - sizeof(head))->order;
            free_[order] = new (place) block{free_[order]};
        }
    }

private:
    static constexpr std::size_t page = 65'536;

    char* extend(std::size_t size)
    {
        char* const place = end_;
        end_ += size;
        std::size_t const there = __builtin_wasm_memory_size(0) * page;
        auto const needed = reinterpret_cast<std::uintptr_t>(end_);
        if (needed > there and __builtin_wasm_memory_grow(0, (needed - there + page - 1) / page) == ~std::size_t{0}) {
            __builtin_trap();
        }
        return place;
    }

    block* free_[32]{};
    char* end_{reinterpret_cast<char*>((reinterpret_cast<std::uintptr_t>(&__heap_base) + 15U) & ~std::uintptr_t{15})};
};

block_store blocks;

} // namespace

void* operator new(std::size_t size) { return blocks.take(size); }
void operator delete(void* place) noexcept { blocks.give_back(place); }
void operator delete(void* place, std::size_t) noexcept { blocks.give_back(place); }

extern "C" {
// One instruction each, where the C library has loops.
void* memcpy(void* to, void const* from, std::size_t size)
{
    __builtin_memcpy(to, from, size);
    return to;
}
void* memmove(void* to, void const* from, std::size_t size)
{
    __builtin_memmove(to, from, size);
    return to;
}
void* memset(void* to, int byte, std::size_t size)
{
    __builtin_memset(to, byte, size);
    return to;
}
// A byte at a time, where the C library looks at four.
[[clang::no_builtin]] void* memchr(void const* bytes, int wanted, std::size_t size)
{
    auto const* at = static_cast<unsigned char const*>(bytes);
    for (; size != 0; --size, ++at) {
        if (*at == static_cast<unsigned char>(wanted)) {
            return const_cast<unsigned char*>(at);
        }
    }
    return nullptr;
}
[[clang::no_builtin]] std::size_t strlen(char const* text)
{
    char const* end = text;
    while (*end != '\0') {
        ++end;
    }
    return static_cast<std::size_t>(end - text);
}

void abort() { __builtin_trap(); }
void __cxa_pure_virtual() { __builtin_trap(); }
int __cxa_atexit(void (*)(void*), void*, void*) { return 0; } // a page that closes destroys nothing
}

_LIBCPP_BEGIN_NAMESPACE_STD
void __libcpp_verbose_abort(char const*, ...) { __builtin_trap(); }

// Texts, compiled here for size, as the library's own are not: all that it keeps in one object, of which else a part would be
// there twice, and numbers without its table of digits.
template class basic_string<char>;
template string operator+<char, char_traits<char>, allocator<char>>(char const*, string const&);
template string& string::__assign_no_alias<true>(char const*, size_t);
template string& string::__assign_no_alias<false>(char const*, size_t);

namespace {

string decimal(unsigned long long value, bool is_negative)
{
    char digits[20];
    char* first = digits + sizeof(digits);
    do {
        *--first = static_cast<char>('0' + value % 10);
        value /= 10;
    } while (value != 0);
    string text(is_negative ? 1 : 0, '-');
    return text.append(first, static_cast<size_t>(digits + sizeof(digits) - first));
}

string decimal(long long value)
{
    auto const bits = static_cast<unsigned long long>(value);
    return decimal(value < 0 ? 0 - bits : bits, value < 0);
}

} // namespace

string to_string(int value) { return decimal(value); }
string to_string(long long value) { return decimal(value); }
string to_string(unsigned value) { return decimal(value, false); }
string to_string(unsigned long value) { return decimal(value, false); }
_LIBCPP_END_NAMESPACE_STD

#endif
