// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// A server answers a request in the place where it lies: in the memory of its frame.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include <rtuwire/core/bytes.hpp>
#include <rtuwire/core/version.hpp>
#include <rtuwire/wire/limits.hpp>

namespace rtuwire::inline RTUWIRE_BUILD {

/// Where a request PDU lies, and then its answer. Whoever answers writes into `octets`, after it has
/// read what it needs of them, and sets `size`; an error leaves that to `respond_in_place`.
struct pdu_place {
    std::span<std::byte, max_pdu_size> octets;
    std::size_t size; ///< of the request, then of the answer: 0 where none is due

    [[nodiscard]] constexpr byte_view view() const noexcept { return octets.first(size); }
};

} // namespace rtuwire
