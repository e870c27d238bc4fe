// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Vectors and reset of a Cortex-M3: variables get their values, then main runs and its result is the
// emulator's.
#include <array>
#include <cstdint>

#include "board.hpp"

extern "C" {
extern std::uint32_t data_source, data_begin, data_end, bss_begin, bss_end, stack_end;
}

void reset();
void hang();
void systick();

// A program without a line defines neither.
[[gnu::weak]] void on_line_interrupt() {}
[[gnu::weak]] void on_tick() {}

int main();
// A start-up has to call it, which a program may not.
#pragma GCC diagnostic ignored "-Wpedantic"

namespace {

using handler = void (*)();

constexpr unsigned core_vectors = 16;
constexpr unsigned line_vectors = 16;
constexpr unsigned systick_vector = 15;

consteval auto make_handlers()
{
    // The stack's end comes before them.
    std::array<handler, core_vectors + line_vectors - 1> all{};
    for (handler& each : all) {
        each = hang;
    }
    all[0] = reset;
    all[systick_vector - 1] = systick;
    for (unsigned number = 0; number < line_vectors; ++number) {
        if ((board::line_interrupts >> number & 1U) != 0) {
            all[core_vectors + number - 1] = on_line_interrupt;
        }
    }
    return all;
}

struct vector_table {
    std::uint32_t* stack;
    std::array<handler, core_vectors + line_vectors - 1> handlers;
};

} // namespace

[[gnu::section(".vectors"), gnu::used]] extern constexpr vector_table vectors{&stack_end, make_handlers()};

void reset()
{
    std::uint32_t const* from = &data_source;
    for (std::uint32_t* to = &data_begin; to != &data_end; ++to, ++from) {
        *to = *from;
    }
    for (std::uint32_t* to = &bss_begin; to != &bss_end; ++to) {
        *to = 0;
    }
    board::begin();
    board::end(main());
}

void hang() { board::end(70); }

void systick()
{
    board::milliseconds_gone = board::milliseconds_gone + 1;
    on_tick();
}
