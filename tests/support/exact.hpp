// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Bytes with nothing behind them: whoever reads or writes one too many is refused by the compiler
// in a constant expression, and seen by the address sanitizer in a run. A part of a larger array
// would hide both.
#pragma once

#include <cstddef>

#include <rtuwire/core/bytes.hpp>

namespace rtuwire::test {

/// A block of bytes of exactly the size that was asked for.
class exact_bytes {
public:
    explicit constexpr exact_bytes(std::size_t size, std::byte fill = {}) : data_{new std::byte[size]}, size_{size}
    {
        for (std::byte& byte : span()) {
            byte = fill;
        }
    }

    explicit constexpr exact_bytes(byte_view source) : exact_bytes{source.size()}
    {
        for (std::size_t i = 0; i < size_; ++i) {
            data_[i] = source[i];
        }
    }

    exact_bytes(exact_bytes const&) = delete;
    exact_bytes& operator=(exact_bytes const&) = delete;
    constexpr ~exact_bytes() { delete[] data_; }

    [[nodiscard]] constexpr byte_span span() noexcept { return {data_, size_}; }
    [[nodiscard]] constexpr byte_view view() const noexcept { return {data_, size_}; }

private:
    std::byte* data_;
    std::size_t size_;
};

} // namespace rtuwire::test
