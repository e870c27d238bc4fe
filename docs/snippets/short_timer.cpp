// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// What the page of boards shows of a clock by a timer of 16 bits. The timer stands in for an STM32's: each look at it takes time,
// and the interrupt of its overflow comes as soon as none is being served.
#include <cstdint>
#include <iostream>

#include <rtuwire/client.hpp>

using namespace rtuwire;

namespace {

std::uint32_t gone = 0; // microseconds of the whole program
std::uint32_t pace = 1; // of a look at a register
bool is_pending = false;
bool is_in_interrupt = false;

void pass_time();

struct counter {
    operator std::uint32_t() const
    {
        pass_time();
        return gone & 0xFFFFU;
    }
};
struct status {
    operator std::uint32_t() const
    {
        pass_time();
        return is_pending ? 1U : 0U;
    }
};
struct timer {
    counter CNT;
    status SR;
};
struct timer_handle {
    timer* Instance;
};
using TIM_HandleTypeDef = timer_handle;
constexpr std::uint32_t TIM_SR_UIF = 1;

timer registers;
TIM_HandleTypeDef htim3{&registers};

//! [clock]
std::uint32_t volatile turns = 0; // of htim3: prescaler as for TIM2, period 65535, begun with its interrupt

instant now() // in place of the file's own
{
    std::uint32_t high = 0;
    std::uint32_t low = 0;
    do {
        high = turns;
        low = htim3.Instance->CNT;
        if ((htim3.Instance->SR & TIM_SR_UIF) != 0) { // it has wrapped, and its interrupt waits for this one to end
            low = htim3.Instance->CNT;
            low += 0x10000U;
        }
    } while (high != turns); // its interrupt came in between: both anew
    return instant{(high << 16U) + low};
}
//! [clock]

} // namespace

//! [overflow]
extern "C" void HAL_TIM_PeriodElapsedCallback(TIM_HandleTypeDef* timer)
{
    if (timer == &htim3) {
        turns = turns + 1;
    }
}
//! [overflow]

namespace {

void pass_time()
{
    std::uint32_t const before = gone;
    gone += pace;
    is_pending = is_pending or (before >> 16U) != (gone >> 16U);
    if (is_pending and not is_in_interrupt) {
        is_pending = false; // as the HAL's handler does before it calls
        HAL_TIM_PeriodElapsedCallback(&htim3);
    }
}

/// Whether a look at the clock tells a moment between its begin and its end.
bool is_right()
{
    std::uint32_t const begin = gone;
    std::uint32_t const told = now().microseconds;
    return told - begin <= gone - begin;
}

} // namespace

int main()
{
    for (std::uint32_t i = 0; i < 400'000; ++i) {
        pace = 1 + i % 7;
        is_in_interrupt = i % 3 != 0; // of the line, at the same priority
        if (not is_right()) {
            std::cout << "wrong after " << gone << " us\n";
            return 1;
        }
        is_in_interrupt = false;
        pass_time();
    }
    std::cout << "right for " << gone << " us\n";
    return 0;
}
