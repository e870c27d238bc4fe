// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// The bit rate and the format of a line on which somebody talks, found without a word to it.
#pragma once

#include "choices.hpp"
#include "exit_status.hpp"

namespace tool {

/// Listens at one usual setting after the other until frames come whose CRCs are right, and shows it. A silent line is told
/// so: `no_answer`.
exit_status find_heard_setting(choices const& chosen);

} // namespace tool
