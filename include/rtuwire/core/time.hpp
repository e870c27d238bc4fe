// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// Time as the caller supplies it: wrapping 32-bit microseconds. The portable headers never read a clock. The
// count wraps after 71.6 minutes, so instants cannot be sorted: the only test is "has this deadline been
// reached", right for deadlines up to 35 minutes away on either side.
//
// The law of a time that is kept: whoever keeps one names a deadline for it, and who calls late, even an hour after it,
// finds it over. So an engine judges by `within_reach` of its last `advance`, or of what it last heard.
#pragma once

#include <compare>
#include <concepts>
#include <cstdint>
#include <optional>
#include <ratio>
#include <utility>

#include <rtuwire/core/version.hpp>

namespace rtuwire {
inline namespace RTUWIRE_BUILD {

/// Not constexpr, so that in a constant expression the compiler reports one of these names. At run
/// time they do nothing.
inline void a_duration_is_at_most_35_minutes() noexcept {}
inline void a_duration_is_not_negative() noexcept {}
inline void a_duration_counts_whole_microseconds() noexcept {}

namespace detail {

/// A quantity that measures a span of time: core/quantity.hpp has them.
template <typename T>
concept amount_of_time = T::dimension::is_time;

/// An amount of time in whole microseconds, and whether a part of one is left; of anything else, nothing: Clang 14 looks at
/// `RTUWIRE_REFUSES` before it looks at the constraint.
template <typename Amount> [[nodiscard]] constexpr std::int64_t whole_microseconds(Amount const& amount) noexcept
{
    if constexpr (amount_of_time<Amount>) {
        using step = std::ratio_divide<typename Amount::scale, std::micro>;
        return amount.count() * step::num / step::den;
    }
    return 0;
}
template <typename Amount> [[nodiscard]] constexpr bool has_part_of_a_microsecond(Amount const& amount) noexcept
{
    if constexpr (amount_of_time<Amount>) {
        using step = std::ratio_divide<typename Amount::scale, std::micro>;
        return amount.count() * step::num % step::den != 0;
    }
    return false;
}

} // namespace detail

/// A span of time in whole microseconds. One made by the functions below is at most `longest_duration`; the
/// difference of two instants may be more.
struct duration {
    std::uint32_t microseconds{0};

    /// Zero.
    constexpr duration() noexcept = default;

    /// `count` microseconds. Explicit, so that the bare 200 of `{.response_timeout = 200}` is refused.
    explicit constexpr duration(std::uint32_t count) noexcept : microseconds{count} {}

    /// A literal: 5_s, 0.02_s.
    template <detail::amount_of_time Amount>
    consteval duration(Amount amount) noexcept
        RTUWIRE_REFUSES(a_duration_is_not_negative, detail::whole_microseconds(amount) < 0)
            RTUWIRE_REFUSES(a_duration_counts_whole_microseconds, detail::has_part_of_a_microsecond(amount))
                RTUWIRE_REFUSES(a_duration_is_at_most_35_minutes,
                                detail::whole_microseconds(amount) > 35LL * 60 * 1'000'000)
    {
        if (amount.count() < 0) {
            a_duration_is_not_negative();
        }
        if (detail::has_part_of_a_microsecond(amount)) {
            a_duration_counts_whole_microseconds();
        }
        if (detail::whole_microseconds(amount) > 35LL * 60 * 1'000'000) {
            a_duration_is_at_most_35_minutes();
        }
        microseconds = static_cast<std::uint32_t>(detail::whole_microseconds(amount));
    }

    friend constexpr bool operator==(duration, duration) noexcept = default;
    /// Inlined: for size, GCC would call it for each comparison, and then compare what it returns.
    [[gnu::always_inline]] friend constexpr auto operator<=>(duration left, duration right) noexcept
    {
        return left.microseconds <=> right.microseconds;
    }

    /// The sum, or `longest_duration` where it is longer.
    friend constexpr duration operator+(duration left, duration right) noexcept;

    /// The multiple, or `longest_duration` where it is longer.
    friend constexpr duration operator*(duration left, std::uint32_t times) noexcept;
};

namespace detail {

/// The longest duration: 35 minutes. Half the counter's range is 47 s more, so that an engine may add the
/// time of its frame before a deadline looks as if it had passed.
inline constexpr duration longest_duration{35U * 60U * 1'000'000U};

} // namespace detail

constexpr duration operator+(duration left, duration right) noexcept
{
    std::uint32_t const sum = left.microseconds + right.microseconds;
    bool const is_too_long = sum < left.microseconds or sum > detail::longest_duration.microseconds;
    return is_too_long ? detail::longest_duration : duration{sum};
}

constexpr duration operator*(duration left, std::uint32_t times) noexcept
{
    std::uint64_t const product = std::uint64_t{left.microseconds} * times;
    return product > detail::longest_duration.microseconds ? detail::longest_duration
                                                           : duration{static_cast<std::uint32_t>(product)};
}

namespace detail {

/// `count` times `Size` microseconds; at run time, the nearest duration.
template <std::uint32_t Size, std::integral Count> [[nodiscard]] constexpr duration duration_of(Count count) noexcept
{
    if (std::cmp_less(count, 0)) {
        a_duration_is_not_negative();
        return duration{};
    }
    if (std::cmp_greater(count, longest_duration.microseconds / Size)) {
        a_duration_is_at_most_35_minutes();
        return longest_duration;
    }
    return duration{static_cast<std::uint32_t>(count) * Size};
}

} // namespace detail

namespace detail {

#if defined(__ARM_ARCH) && !defined(__ARM_FEATURE_IDIV)
#define RTUWIRE_DIVIDES_BY_LIBRARY 1
#else
#define RTUWIRE_DIVIDES_BY_LIBRARY 0
#endif
/// Whether this processor has no division, so that 270 bytes of a library do it: a Cortex-M0+.
inline constexpr bool divides_by_library = RTUWIRE_DIVIDES_BY_LIBRARY == 1;
#undef RTUWIRE_DIVIDES_BY_LIBRARY

/// A quotient, rounded down, as one finds it on paper. `by` is not 0, and below half of what a number can be.
[[nodiscard]] constexpr std::uint32_t quotient_by_bits(std::uint32_t number, std::uint32_t by) noexcept
{
    std::uint32_t found = 0, rest = 0;
    for (unsigned bit = 32; bit-- > 0;) {
        rest = rest << 1U | (number >> bit & 1U);
        found <<= 1U;
        if (rest >= by) {
            rest -= by;
            found |= 1U;
        }
    }
    return found;
}

/// The third of a number, rounded down: 1/4 + 1/16 + 1/64 and so on, and the third of what that lacks.
[[nodiscard]] constexpr std::uint32_t third_by_shifts(std::uint32_t number) noexcept
{
    std::uint32_t third = (number >> 2U) + (number >> 4U);
    third += third >> 4U;
    third += third >> 8U;
    third += third >> 16U;
    return third + ((number - 3U * third) * 11U >> 5U); // it lacks less than 16
}

/// The same, by the processor's division where it has one.
[[nodiscard]] constexpr std::uint32_t quotient(std::uint32_t number, std::uint32_t by) noexcept
{
    return divides_by_library ? quotient_by_bits(number, by) : number / by;
}
[[nodiscard]] constexpr duration third_of(duration all) noexcept
{
    return duration{divides_by_library ? third_by_shifts(all.microseconds) : all.microseconds / 3U};
}

} // namespace detail

/// `count` microseconds, 0 to `longest_duration`. A number outside does not compile in a constant expression,
/// and becomes the nearest duration at run time.
template <std::integral Count> [[nodiscard]] constexpr duration microseconds(Count count) noexcept
{
    return detail::duration_of<1>(count);
}

/// `count` milliseconds, 0 to `longest_duration`, as for `microseconds`.
template <std::integral Count> [[nodiscard]] constexpr duration milliseconds(Count count) noexcept
{
    return detail::duration_of<1'000>(count);
}

/// A point in time: the value of a free-running microsecond counter. Always made from a count: no value of
/// the counter means "never", and 0 may be up to 35 minutes in the future.
struct instant {
    std::uint32_t microseconds;

    /// The time at which the counter shows `count`.
    explicit constexpr instant(std::uint32_t count) noexcept : microseconds{count} {}

    friend constexpr bool operator==(instant, instant) noexcept = default;
    friend constexpr instant operator+(instant start, duration length) noexcept
    {
        return instant{start.microseconds + length.microseconds};
    }
    friend constexpr instant operator-(instant end, duration length) noexcept
    {
        return instant{end.microseconds - length.microseconds};
    }

    /// The time from `start` to `end`, across a wrap of the counter.
    friend constexpr duration operator-(instant end, instant start) noexcept
    {
        return duration{end.microseconds - start.microseconds};
    }
};

/// Whether `deadline` is now or lies in the past, seen from `now`.
[[nodiscard]] constexpr bool reached(instant now, instant deadline) noexcept
{
    return (now.microseconds - deadline.microseconds) < 0x8000'0000U;
}

namespace detail {

/// The shorter one. Of the counts: of two classes GCC would select one in memory.
[[nodiscard]] constexpr duration shorter_of(duration one, duration other) noexcept
{
    return duration{one < other ? one.microseconds : other.microseconds};
}

/// The time at which deadlines that were named up to `before` are judged `now`: after a pause of more than half the
/// counter, which makes what is over look as if it lay ahead, 35.5 minutes after `before`, when all of them were over.
/// A pause of a whole turn of the counter shows as none: what was in force may then last once more, but no longer than
/// it was set for. `before` may lie `ahead` of `now`: by the little that one look at a clock may be older than another;
/// where it is the end of a frame that is being sent, by the time that this takes.
[[nodiscard]] constexpr instant within_reach(instant before, instant now, duration ahead = duration{0x1'0000}) noexcept
{
    constexpr std::uint32_t half = 0x8000'0000U;
    std::uint32_t const reach = half - ahead.microseconds;
    return (now - before).microseconds - half < reach ? instant{before.microseconds + reach} : now;
}

/// Keeps a time that is over, by `at`, from looking as if it lay ahead some day. `at` is `within_reach` of the last call.
constexpr void keep_over(instant& end, instant now, instant at) noexcept
{
    if (reached(at, end)) {
        end = now;
    }
}

} // namespace detail

/// When something has to happen next, or never.
using deadline = std::optional<instant>;

namespace detail {

/// Keeps the earlier of two times. One that has come needs no note: who is called at it is called now.
constexpr void keep_earlier(deadline& kept, deadline const& next, instant now) noexcept
{
    if (next and not reached(now, *next) and not(kept and reached(*next, *kept))) {
        kept = next;
    }
}

/// The earliest of several times, added one by one: the same as a `deadline`, without making one for each
/// time. Always inlined, so that it stays in registers.
class earliest {
public:
    [[gnu::always_inline]] constexpr void add(instant at) noexcept
    {
        at_ = not is_set_ or reached(at_, at) ? at : at_;
        is_set_ = true;
    }
    constexpr void add(deadline const& at) noexcept
    {
        if (at) {
            add(*at);
        }
    }

    [[nodiscard]] constexpr operator deadline() const noexcept { return is_set_ ? deadline{at_} : deadline{}; }

private:
    instant at_{0};
    bool is_set_{false};
};

} // namespace detail

/// The one of two deadlines that comes first.
[[nodiscard]] constexpr deadline earlier(deadline left, deadline right) noexcept
{
    if (not left) {
        return right;
    }
    if (not right) {
        return left;
    }
    return reached(*right, *left) ? left : right;
}

} // namespace RTUWIRE_BUILD
} // namespace rtuwire
