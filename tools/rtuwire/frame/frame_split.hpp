// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Several frames one after the other, without the silence that parted them: their ends by their lengths and CRCs.
#pragma once

#include <cstddef>
#include <vector>

#include <rtuwire/frames.hpp>

namespace tool {

/// A frame; or, where none begins, all bytes up to the next that is undamaged.
struct frame_piece {
    std::size_t offset;
    std::size_t size;
};

/// All bytes, in pieces. A frame ends where its function says so and its CRC is right.
[[nodiscard]] std::vector<frame_piece> split_frames(rtuwire::byte_view run);

} // namespace tool
