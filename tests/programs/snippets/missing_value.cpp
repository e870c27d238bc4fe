// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// PAGE: docs/bad-line.md
// BEGINS: void rtuwire::on_missing_value
#include <rtuwire/client.hpp>

#include "board_of_a_page.hpp"

// BLOCK
