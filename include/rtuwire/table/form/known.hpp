// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// An enumeration of which not every word is a value: a word in a hole is refused on reading.
#pragma once

#include <array>
#include <cstdint>

#include <rtuwire/core/result.hpp>
#include <rtuwire/core/version.hpp>
#include <rtuwire/table/enumeration.hpp>
#include <rtuwire/table/register.hpp>
#include <rtuwire/wire/errc.hpp>

namespace rtuwire {
inline namespace RTUWIRE_BUILD {

/// `reg<known<valve>>` holds only what `enumerators<valve>` lists: any other word is `value_without_meaning`, read or
/// written. `reg<valve>` shows on reading whatever the device sent.
template <register_enumeration E> struct known {
    static_assert(enumerators<E>.size() > 0, "this enumeration lists no values: specialise enumerators for it");

    using value_type = E;
    static constexpr std::uint16_t word_count = 1;
    using words = std::array<std::uint16_t, 1>;

    [[nodiscard]] static constexpr result<E> from_words(words const& from) noexcept
    {
        if (not detail::has_meaning(detail::listed_words<E>(), from[0])) {
            return errc::value_without_meaning;
        }
        return static_cast<E>(from[0]);
    }
    [[nodiscard]] static constexpr words to_words(E value) noexcept { return {static_cast<std::uint16_t>(value)}; }
};

} // namespace RTUWIRE_BUILD
} // namespace rtuwire
