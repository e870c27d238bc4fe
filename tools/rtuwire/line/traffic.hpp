// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Who talks on a line before this program does.
#pragma once

#include <rtuwire/client.hpp>

#include "port/any_port.hpp"

namespace tool {

/// Listens for a time. Refuses a line on which others talk.
void refuse_traffic(any_port& port, rtuwire::duration time, option_form form = option_form::typed);

} // namespace tool
