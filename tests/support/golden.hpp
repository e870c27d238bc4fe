// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Golden frames: bytes against the value they stand for, both ways, and their size.
#pragma once

#include <array>
#include <concepts>
#include <cstddef>

#include "support/length.hpp"

#include <rtuwire/wire/adu.hpp>
#include <rtuwire/wire/serial_line/diagnostics.hpp>

namespace rtuwire::test {

using namespace detail;

/// Whether the length rules know the frame: a request has a response, a response has none, and the
/// value that is its own answer stands for both. The query of function 08 may have any size.
template <pdu P> constexpr bool is_told_as(P const& value, byte_view frame)
{
    if constexpr (requires { requires std::same_as<typename P::response, diagnostics<>>; }) {
        if (value.what == subfunction::return_query_data) {
            return is_ended_by_silence(direction::request, frame, 4) and
                   is_ended_by_silence(direction::response, frame, 4);
        }
    }
    if constexpr (requires { requires std::same_as<decltype(P::decode(frame)), result<typename P::response>>; }) {
        return is_told(direction::request, frame) and is_told(direction::response, frame);
    } else if constexpr (requires { typename P::response; }) {
        return is_told(direction::request, frame);
    } else {
        return is_told(direction::response, frame);
    }
}

/// Whether a value encodes to exactly these bytes, they decode to a value that encodes to them,
/// and their first bytes tell their size.
template <typename To, pdu P, std::size_t Size>
constexpr bool encodes(To to, P const& value, std::array<std::byte, Size> const& bytes)
{
    auto const taken = decode_adu(bytes);
    if (not taken or taken->unit() != destination{to}.byte() or not(encode(to, value) == bytes)) {
        return false;
    }
    auto const again = P::decode(taken->pdu());
    return again and encode(to, *again) == bytes and is_told_as(value, bytes);
}

} // namespace rtuwire::test
