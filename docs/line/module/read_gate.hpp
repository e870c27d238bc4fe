// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// The last thing that a frame passes before it leaves the page.
#pragma once

#include <rtuwire/frames.hpp>

namespace line_page {

/// Whether these bytes are one whole frame that only reads: function 01, 02, 03, 04 or 43/14, of its own length, to one unit of
/// 1 to 247, with a right CRC. Knows nothing of the encoders.
[[nodiscard]] bool is_read(rtuwire::byte_view frame) noexcept;

} // namespace line_page
