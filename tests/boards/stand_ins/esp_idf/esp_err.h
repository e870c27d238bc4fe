// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Stands for the header of this name in espressif/esp-idf 6.0.2, of which it declares what the board's file calls.
#pragma once

typedef int esp_err_t;
#define ESP_OK 0
void stand_in_error_check(esp_err_t error);
#define ESP_ERROR_CHECK(x) stand_in_error_check(x)
