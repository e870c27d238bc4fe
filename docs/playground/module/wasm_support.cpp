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

void abort() { __builtin_trap(); }
void __cxa_pure_virtual() { __builtin_trap(); }
int __cxa_atexit(void (*)(void*), void*, void*) { return 0; } // a page that closes destroys nothing
}

_LIBCPP_BEGIN_NAMESPACE_STD
void __libcpp_verbose_abort(char const*, ...) { __builtin_trap(); }
_LIBCPP_END_NAMESPACE_STD

#endif
