// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Stands for the header of this name in espressif/esp-idf 6.0.2, of which it declares what the board's file calls.
#pragma once

#include <stdint.h>

extern "C" int64_t esp_timer_get_time();
