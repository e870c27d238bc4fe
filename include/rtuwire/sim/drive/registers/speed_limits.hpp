// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// The three frequencies that limit each other: LSP <= HSP <= TFR. Held for a request as a whole, whatever order its words
// have: each register by itself, against what the others hold before, would let both of two wrong words pass.
// Internal: may change with any version.
#pragma once

#include <cstddef>
#include <cstdint>

#include <rtuwire/core/literal.hpp>
#include <rtuwire/core/version.hpp>

namespace rtuwire::inline RTUWIRE_BUILD::sim {

/// Whether a register is one of the three.
[[nodiscard]] constexpr bool is_speed_limit(literal code) noexcept
{
    return code == literal{"LSP"} or code == literal{"HSP"} or code == literal{"TFR"};
}

/// The three as they are, or as a request would leave them; one that a drive does not have limits nothing.
template <typename Image> class speed_limits {
    static constexpr std::size_t lsp = Image::at("LSP");
    static constexpr std::size_t hsp = Image::at("HSP");
    static constexpr std::size_t tfr = Image::at("TFR");
    static constexpr std::uint16_t no_limit = 0xFFFF;

public:
    explicit constexpr speed_limits(Image const& held) noexcept
        : lowest_{held.get(lsp)}, high_{held.get(hsp)}, highest_{tfr == Image::nowhere ? no_limit : held.get(tfr)}
    {}

    /// Takes a word of the request; one of another register changes nothing.
    constexpr void put(std::size_t place, std::uint16_t word) noexcept
    {
        lowest_ = place == lsp ? word : lowest_;
        high_ = place == hsp ? word : high_;
        highest_ = place == tfr ? word : highest_;
    }

    /// Whether they fit each other.
    [[nodiscard]] constexpr bool hold() const noexcept { return lowest_ <= high_ and high_ <= highest_; }

private:
    std::uint16_t lowest_;
    std::uint16_t high_;
    std::uint16_t highest_;
};

} // namespace rtuwire::sim
