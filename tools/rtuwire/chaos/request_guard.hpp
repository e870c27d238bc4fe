// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// That nothing which is made up or damaged is a request, with whatever went before it: to the server none at all, to the
// client none that does more than read, as other units may hang on its wire.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <rtuwire/frames.hpp>

#include "chaos/line_fault.hpp"

namespace tool {

/// Looks at all that goes one way.
class request_guard {
public:
    explicit request_guard(frame_way way) : way_{way} {}

    /// Whether bytes may go; those that may have gone then. `is_own`: not as they came. Where nothing has gone for 3 s, which
    /// is longer than receivers wait for the rest of a frame, what comes is judged alone: else one piece behind which each
    /// whole frame completes another would hold all back for ever.
    [[nodiscard]] bool lets_pass(rtuwire::byte_view bytes, bool is_own, rtuwire::instant now);

private:
    /// One that ends behind `from`.
    bool holds_request(std::size_t from) const;
    /// A piece with a right CRC.
    bool is_refused(std::size_t at, std::size_t end) const;

    frame_way way_;
    std::vector<std::byte> bytes_{};
    std::vector<bool> is_own_{};
    rtuwire::instant gone_{0}; ///< when bytes went last
};

} // namespace tool
