// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Which writes are refused for safety, before a frame leaves.
#pragma once

#include "catalog/catalog.hpp"
#include "choices.hpp"
#include "words/value_words.hpp"

namespace tool {

/// Ends the command where a value is never written, or needs --allow-run that was not said. A value that is not known
/// yet, because another register sets its step, is looked at once it is.
void refuse_unsafe_write(value_to_write const& value, drive_catalog const& drive, permissions const& allowed);

} // namespace tool
