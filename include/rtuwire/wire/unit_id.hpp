// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// The address of a frame: a unit, 1..247, or broadcast (SL 2.2); by express permission a reserved one, or 0 for the only unit
// of a line. A value of these types is always valid on the wire, so that a function that takes one need not check it.
#pragma once

#include <compare>
#include <cstdint>

#include <rtuwire/core/result.hpp>
#include <rtuwire/core/version.hpp>
#include <rtuwire/wire/errc.hpp>

namespace rtuwire {
inline namespace RTUWIRE_BUILD {

/// Never defined: reached only in a constant expression, so that the compiler prints the name.
void a_unit_address_is_1_to_247();
void a_reserved_address_is_248_to_255();

namespace detail {

class destination;

/// A number in source code that is a unit address. A class of its own, because Clang 14 crashes on the second
/// use of a class whose own constructor is consteval.
class unit_number {
public:
    consteval unit_number(int number) noexcept
        RTUWIRE_REFUSES(a_unit_address_is_1_to_247, not(number >= 1 and number <= 247))
        : byte_{static_cast<std::uint8_t>(number)}
    {
        if (number < 1 or number > 247) {
            a_unit_address_is_1_to_247();
        }
    }

    [[nodiscard]] constexpr std::uint8_t byte() const noexcept { return byte_; }

private:
    std::uint8_t byte_;
};

/// The same of an address that SL 2.2 reserves.
class reserved_number {
public:
    consteval reserved_number(int number) noexcept
        RTUWIRE_REFUSES(a_reserved_address_is_248_to_255, not(number >= 248 and number <= 255))
        : byte_{static_cast<std::uint8_t>(number)}
    {
        if (number < 248 or number > 255) {
            a_reserved_address_is_248_to_255();
        }
    }

    [[nodiscard]] constexpr std::uint8_t byte() const noexcept { return byte_; }

private:
    std::uint8_t byte_;
};

} // namespace detail

/// The address of one unit, 1..247, or an express `reserved` one.
class unit_id {
public:
    /// A unit address known at compile time: unit_id{7}.
    explicit constexpr unit_id(detail::unit_number number) noexcept : byte_{number.byte()} {}

    /// A unit address known only at run time; `errc::invalid_unit` outside 1..247.
    [[nodiscard]] static constexpr result<unit_id> checked(std::uint32_t number) noexcept
    {
        if (number < 1 or number > 247) {
            return errc::invalid_unit;
        }
        return unit_id{from_wire{}, static_cast<std::uint8_t>(number)};
    }

    /// One of the addresses 248..255, which SL 2.2 reserves and some units answer to, most of them whatever their own is:
    /// with two of them on a line both answer. A client keeps 255 apart from no other unit: a missing response of it, a `pause`
    /// of its policy or a `hold` of it keep every unit from being asked. A late response of any of these counts as `noise`. No
    /// drive of this library is asked so.
    [[nodiscard]] static constexpr unit_id reserved(detail::reserved_number number) noexcept
    {
        return unit_id{from_wire{}, number.byte()};
    }

    /// A reserved address known only at run time; `errc::invalid_unit` outside 248..255.
    [[nodiscard]] static constexpr result<unit_id> checked_reserved(std::uint32_t number) noexcept
    {
        if (number < 248 or number > 255) {
            return errc::invalid_unit;
        }
        return unit_id{from_wire{}, static_cast<std::uint8_t>(number)};
    }

    /// The address as it stands on the wire.
    [[nodiscard]] constexpr std::uint8_t byte() const noexcept { return byte_; }

    friend constexpr auto operator<=>(unit_id, unit_id) noexcept = default;

private:
    friend class detail::destination;

    struct from_wire {};
    constexpr unit_id(from_wire, std::uint8_t byte) noexcept : byte_{byte} {}

    std::uint8_t byte_;
};

namespace detail {

/// Every unit on the line; none answers.
struct broadcast_t {};

/// The one unit of a line, at address 0.
struct only_unit_t {};

} // namespace detail

inline constexpr detail::broadcast_t broadcast{};

/// Address 0 of a line with one unit that answers there, whatever its own address is: `single_request{only_unit,
/// read_holding_registers{0, 1}}`, on a client whose `client_needs` say `has_only_unit`. The response has address 0, too. What
/// may be broadcast is not sent so: a write to address 0 stays a `broadcast`, which nobody confirms. No `unit_id`, so that no
/// drive is asked or commanded so.
inline constexpr detail::only_unit_t only_unit{};

namespace detail {

/// One unit, or all of them: what a write may be sent to.
class destination {
public:
    constexpr destination(unit_id unit) noexcept : byte_{unit.byte()} {}
    constexpr destination(broadcast_t) noexcept : byte_{0} {}

    [[nodiscard]] constexpr bool is_broadcast() const noexcept { return byte_ == 0; }

    /// The unit, where it is one.
    [[nodiscard]] constexpr unit_id unit() const noexcept { return unit_id{unit_id::from_wire{}, byte_}; }

    /// The address as it stands on the wire; 0 for broadcast.
    [[nodiscard]] constexpr std::uint8_t byte() const noexcept { return byte_; }

    friend constexpr bool operator==(destination, destination) noexcept = default;

private:
    std::uint8_t byte_;
};

} // namespace detail

} // namespace RTUWIRE_BUILD
} // namespace rtuwire
