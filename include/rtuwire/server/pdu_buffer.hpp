// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// The memory of a PDU: a server writes its response over the request, in the memory of the frame.
// Internal: may change with any version.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include <rtuwire/core/bytes.hpp>
#include <rtuwire/core/version.hpp>
#include <rtuwire/wire/limits.hpp>

namespace rtuwire::inline RTUWIRE_BUILD {

/// Holds a request PDU, then its response. A function that responds first reads what it needs of `bytes`, then writes
/// into them and sets `size`; for an error, `respond_in_place` does that.
struct pdu_buffer {
    std::span<std::byte, max_pdu_size> bytes;
    std::size_t size; ///< of the request, then of the response: 0 where none is due

    [[nodiscard]] constexpr byte_view view() const noexcept { return bytes.first(size); }
};

} // namespace rtuwire
