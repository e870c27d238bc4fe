// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Stands for the header of this name in zephyrproject-rtos/zephyr 4, of which it declares what the board's file calls.
#pragma once

#include <stdint.h>

typedef int64_t k_ticks_t;
struct k_timeout_t {
    k_ticks_t ticks;
};
struct k_sem {
    unsigned count, limit;
};
#define K_SEM_DEFINE(name, initial, most) k_sem name = {initial, most}
#define K_USEC(us) (k_timeout_t{(us) / 100}) // CONFIG_SYS_CLOCK_TICKS_PER_SEC=10000

extern "C" {
int64_t k_uptime_ticks();
uint64_t k_ticks_to_us_floor64(uint64_t ticks);
int k_sem_take(k_sem* sem, k_timeout_t timeout);
void k_sem_give(k_sem* sem);
}
