// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// The stand-in for ESP-IDF's driver by this name, so that the page's program compiles as it stands.
#pragma once

#include "../../esp_idf.hpp"
