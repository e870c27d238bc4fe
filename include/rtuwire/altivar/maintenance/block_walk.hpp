// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// Which block of a parameter map is read next: the largest without a hole, or, where the drive refused one, halves of
// it, until the register that it refuses stands alone. Each look goes through the map, so that nothing is kept of it.
// Internal: may change with any version.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include <rtuwire/altivar/parameters/parameter_map.hpp>
#include <rtuwire/ask/conversation.hpp>
#include <rtuwire/core/result.hpp>
#include <rtuwire/core/version.hpp>
#include <rtuwire/table/request_plan.hpp>
#include <rtuwire/wire/errc.hpp>
#include <rtuwire/wire/function.hpp>
#include <rtuwire/wire/registers.hpp>

namespace rtuwire {
inline namespace RTUWIRE_BUILD {
namespace altivar {

/// A row and the group that it is in; null where there is none.
struct placed_row {
    parameter_group const* group{nullptr};
    parameter const* row{nullptr};
};

/// The row at an address.
[[nodiscard]] constexpr placed_row row_at(parameter_map const& map, std::uint16_t address) noexcept
{
    for (parameter_group const& group : map.groups()) {
        for (parameter const& each : group.rows) {
            if (each.address == address) {
                return {&group, &each};
            }
        }
    }
    return {};
}

/// One above the highest address: no row from there on.
inline constexpr std::uint32_t no_address = 0x1'0000;

/// The lowest address, from one on, of a row that passes `filter`; `no_address` where there is none. The filter is asked
/// only of rows that could be it.
template <typename Filter>
[[nodiscard]] constexpr std::uint32_t lowest_address(parameter_map const& map, std::uint32_t from,
                                                     Filter const& filter) noexcept
{
    std::uint32_t lowest = no_address;
    map.for_each([&](parameter const& each, parameter_group const&) {
        if (each.address >= from and each.address < lowest and filter(each)) {
            lowest = each.address;
        }
    });
    return lowest;
}

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
        block_ = block_of(map, lowest_address(map, at_, filter), suspects == 1 ? std::uint16_t{1} : most, filter);
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
    /// The block that begins at an address, without a hole, of at most `limit` registers; empty where that is none.
    template <typename Filter>
    static constexpr detail::address_block block_of(parameter_map const& map, std::uint32_t start, std::uint16_t limit,
                                                    Filter const& filter) noexcept
    {
        if (start == no_address) {
            return {};
        }
        std::array<bool, max_read_quantity> is_there{};
        std::size_t const most = limit < is_there.size() ? limit : is_there.size();
        map.for_each([&](parameter const& each, parameter_group const&) {
            if (each.address >= start and each.address - start < most and not is_there[each.address - start]) {
                is_there[each.address - start] = filter(each);
            }
        });
        std::uint16_t count = 1;
        while (count < most and is_there[count]) {
            ++count;
        }
        return {static_cast<std::uint16_t>(start), count};
    }

    std::uint32_t at_{0};
    std::uint32_t suspect_end_{0};
    detail::address_block block_{};
    std::uint16_t limit_;
};

/// The words of so many registers that were asked for, or why there are none.
[[nodiscard]] constexpr result<register_view> words_in(result<response> const& outcome, std::size_t count) noexcept
{
    if (not outcome) {
        return outcome.error();
    }
    auto const told = outcome->to<read_holding_registers>();
    if (not told) {
        return told.error();
    }
    return told->registers.size() == count ? result<register_view>{told->registers} : errc::wrong_length;
}

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
