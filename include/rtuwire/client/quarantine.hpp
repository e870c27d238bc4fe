// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// The time in which an answer that came too late may still arrive: until it is over, its unit is asked
// nothing new, because an answer does not say which question it is to.
#pragma once

#include <cstdint>

#include <rtuwire/core/time.hpp>

namespace rtuwire {

/// One unit's time, or everybody's once two units owe an answer.
class quarantine {
public:
    /// An answer of `unit` may come until then.
    constexpr void begin(std::uint8_t unit, instant end) noexcept
    {
        unit_ = is_on_ and unit_ != unit ? any_unit : unit;
        is_on_ = true;
        end_ = end;
    }

    constexpr void advance(instant now) noexcept { is_on_ = is_on_ and not reached(now, end_); }

    /// Whether a unit may not be asked yet.
    [[nodiscard]] constexpr bool covers(std::uint8_t unit) const noexcept
    {
        return is_on_ and (unit_ == any_unit or unit_ == unit);
    }

    [[nodiscard]] constexpr deadline end() const noexcept
    {
        return is_on_ ? deadline{end_} : deadline{};
    }

    /// Whose answer is owed, where it is one unit's; 0 where none is.
    [[nodiscard]] constexpr std::uint8_t unit() const noexcept
    {
        return is_on_ ? unit_ : std::uint8_t{0};
    }

private:
    /// Stands for several units; no unit has it.
    static constexpr std::uint8_t any_unit = 0xFF;

    instant end_{};
    std::uint8_t unit_{0};
    bool is_on_{false};
};

} // namespace rtuwire
