// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// Which block of a parameter map is read next: the largest without a hole, or, where the drive refused one, halves of
// it, until the register that it refuses stands alone.
// Internal: may change with any version.
#pragma once

#include <cstdint>

#include <rtuwire/altivar/maintenance/map_blocks.hpp>
#include <rtuwire/core/version.hpp>
#include <rtuwire/wire/errc.hpp>

namespace rtuwire {
inline namespace RTUWIRE_BUILD {
namespace altivar {

/// A walk over the rows that pass a filter, from the lowest address to the highest. `find` a block, ask the drive for
/// it, then `pass` or `refuse` it.
///
/// While it is known that a register before `suspect_end_` was refused, no block is asked for that was refused before.
class block_walk {
public:
    explicit constexpr block_walk(std::uint16_t limit) noexcept : limit_{limit} {}

    /// Begins again at the lowest address.
    constexpr void begin() noexcept
    {
        at_ = 0;
        suspect_end_ = 0;
    }

    /// Finds the next block; whether there is one.
    template <typename Filter> constexpr bool find(parameter_map const& map, Filter const& filter) noexcept
    {
        std::uint32_t const suspects = suspect_end_ > at_ ? suspect_end_ - at_ : 0;
        std::uint16_t const most = suspects > 1 ? static_cast<std::uint16_t>((suspects + 1) / 2) : limit_;
        block_ = block_from(map, at_, suspects == 1 ? std::uint16_t{1} : most, filter);
        return block_.count != 0;
    }

    [[nodiscard]] constexpr detail::address_block block() const noexcept { return block_; }

    /// The first address of which nothing is known yet.
    [[nodiscard]] constexpr std::uint32_t position() const noexcept { return at_; }

    /// The block was read, or its one register was told as refused: goes on behind it.
    constexpr void pass() noexcept { at_ = std::uint32_t{block_.start} + block_.count; }

    /// The drive refused the block. Returns whether it was one register, which then is the culprit.
    constexpr bool refuse() noexcept
    {
        if (block_.count == 1) {
            suspect_end_ = 0;
            return true;
        }
        at_ = block_.start;
        suspect_end_ = at_ + block_.count;
        return false;
    }

private:
    std::uint32_t at_{0};
    std::uint32_t suspect_end_{0};
    detail::address_block block_{};
    std::uint16_t limit_;
};

/// Whether a drive that sent this exception refused the registers that were asked for: it is worth asking for fewer.
/// A drive without the function, or a gateway without the drive, says the same of each.
[[nodiscard]] constexpr bool is_of_registers(errc error) noexcept
{
    return is_exception(error) and error != errc::illegal_function and error != errc::gateway_path_unavailable and
           error != errc::gateway_target_failed_to_respond;
}

} // namespace altivar
} // namespace RTUWIRE_BUILD
} // namespace rtuwire
