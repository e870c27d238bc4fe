// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Stands for the header of this name in raspberrypi/pico-sdk 2.2.0, of which it declares what the board's file calls.
// ../../../facts/pico_sdk.cpp holds it to that.
#pragma once

#include "types.h"

extern "C" {
uint32_t time_us_32();
absolute_time_t make_timeout_time_us(uint64_t us);
bool best_effort_wfe_or_timeout(absolute_time_t timeout);
}
