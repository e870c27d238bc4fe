// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// The properties of a device type, and a station: one such device at its unit address. A device is an empty
// type with constants: its functions, limits, unit addresses, line settings, time-out and registers.
// Differences between devices are data here, never an `if` on a name.
#pragma once

#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <span>

#include <rtuwire/core/result.hpp>
#include <rtuwire/core/time.hpp>
#include <rtuwire/core/version.hpp>
#include <rtuwire/table/register.hpp>
#include <rtuwire/table/table.hpp>
#include <rtuwire/wire/errc.hpp>
#include <rtuwire/wire/function.hpp>
#include <rtuwire/wire/unit_id.hpp>

namespace rtuwire {
inline namespace RTUWIRE_BUILD {

/// The unit addresses that a device can be set to, or answers to: of a reserved one, 248..255, see `unit_id::reserved`.
struct unit_range {
    std::uint8_t first{1};
    std::uint8_t last{247};

    [[nodiscard]] constexpr bool contains(std::uint32_t number) const noexcept
    {
        return number >= first and number <= last;
    }
};

/// Addresses that one read may span although not every one of them is described.
struct address_range {
    std::uint16_t first;
    std::uint16_t last;
    register_space space{register_space::holding};
};

/// The time-out after which a device reacts because no request arrives.
struct link_timeout {
    duration factory; ///< the time-out as delivered
    duration longest; ///< the longest that can be set; equal to `factory` where it is fixed
    bool is_adjustable{true};
};

namespace detail {

/// What a device type has to say, each part for itself.
template <typename T>
concept has_name = std::convertible_to<decltype(T::name), literal>;
template <typename T>
concept has_functions = std::convertible_to<decltype(T::functions), function_set>;
template <typename T>
concept has_limits = std::convertible_to<decltype(T::limits), device_limits>;
template <typename T>
concept has_units = std::convertible_to<decltype(T::units), unit_range>;
template <typename T>
concept has_readable = std::convertible_to<decltype((T::readable)), std::span<address_range const>>;
template <typename T>
concept has_registers = std::convertible_to<decltype(T::registers::size), std::size_t>;

} // namespace detail

/// A device type. `registers` is a `table`; `readable` lists what one read may span.
template <typename T>
concept device_type = detail::has_name<T> and detail::has_functions<T> and detail::has_limits<T> and
    detail::has_units<T> and detail::has_readable<T> and detail::has_registers<T>;

namespace detail {

/// Whether a device has a register, in its own steps or in others. Named, so that a compiler that says why it refuses
/// one prints the device and the register, not the whole table.
template <typename Device, auto const& R> inline constexpr bool has_register = Device::registers::template contains<R>;

/// Whether a device has the register of a register's scale, where it has one.
template <typename Device, auto const& R> [[nodiscard]] constexpr bool has_scale_of() noexcept
{
    if constexpr (has_scale_register<R>) {
        return has_register<Device, std::remove_cvref_t<decltype(R)>::form::scale_register>;
    } else {
        return true;
    }
}
template <typename Device, auto const& R> inline constexpr bool has_scale = has_scale_of<Device, R>();

} // namespace detail

/// Never defined: reached only in a constant expression, so that the compiler prints the name.
void unit_address_is_outside_the_range_of_this_device();

/// A unit address in source code that a device can be set to.
template <device_type Device> class unit_of {
public:
    /// An address in source code; one outside of the device's range does not compile.
    consteval unit_of(unit_id unit) noexcept : unit_{unit}
    {
        if (not Device::units.contains(unit.byte())) {
            unit_address_is_outside_the_range_of_this_device();
        }
    }

    [[nodiscard]] constexpr unit_id unit() const noexcept { return unit_; }

private:
    unit_id unit_;
};

namespace detail {

template <typename Device> inline constexpr bool is_described = requires { sizeof(Device); };

} // namespace detail

/// One device on a line: its type, which is a `device_type`, and its unit address.
template <typename Device> class station {
    static_assert(detail::is_described<Device>, "this device is only declared here: include its header, "
                                                "<rtuwire/altivar/atv320.hpp> for an ATV320");
    static_assert(detail::has_name<Device>, "a device has a name: `static constexpr literal name`");
    static_assert(detail::has_functions<Device>, "a device has functions: `static constexpr function_set functions`");
    static_assert(detail::has_limits<Device>, "a device has limits: `static constexpr device_limits limits`");
    static_assert(detail::has_units<Device>, "a device has unit addresses: `static constexpr unit_range units`");
    static_assert(detail::has_readable<Device>, "a device lists what a read may span: `static constexpr std::array<"
                                                "address_range, N> readable`");
    static_assert(detail::has_registers<Device>, "a device has registers: `using registers = table<...>`");

public:
    using device = Device;

    /// A unit address known at compile time, within the device's range.
    explicit constexpr station(unit_of<Device> where) noexcept : unit_{where.unit()} {}

    /// A plain number is taken in order to be refused in plain words.
    template <std::integral Number> explicit constexpr station(Number) noexcept : unit_{1}
    {
        static_assert(not std::integral<Number>,
                      "a plain number is no unit: station<...>{unit_id{7}}, or station<...>::checked(n) at run time");
    }

    /// A unit address known only at run time; `invalid_unit` outside the device's range.
    [[nodiscard]] static constexpr result<station> checked(std::uint32_t number) noexcept
    {
        constexpr std::uint32_t highest_usual = 247;
        auto const unit = number <= highest_usual ? unit_id::checked(number) : unit_id::checked_reserved(number);
        if (not unit or not Device::units.contains(number)) {
            return errc::invalid_unit;
        }
        return station{proven{}, *unit};
    }

    [[nodiscard]] constexpr unit_id unit() const noexcept { return unit_; }

private:
    struct proven {};
    constexpr station(proven, unit_id unit) noexcept : unit_{unit} {}

    unit_id unit_;
};

namespace detail {

/// Whether a device implements a function.
template <device_type Device> [[nodiscard]] constexpr bool implements(function_code function) noexcept
{
    return Device::functions.contains(function);
}

/// Whether every address of a space from `first` to `last` can be read: each is a described register or lies in
/// a range that the device's description calls readable.
template <device_type Device>
[[nodiscard]] constexpr bool is_readable_across(std::uint16_t first, std::uint16_t last,
                                                register_space space = register_space::holding) noexcept
{
    for (std::uint32_t address = first; address <= last; ++address) {
        bool known = false;
        for (address_range const& range : Device::readable) {
            known = known or (range.space == space and address >= range.first and address <= range.last);
        }
        if (not known and not Device::registers::has_address(static_cast<std::uint16_t>(address), space)) {
            return false;
        }
    }
    return true;
}

} // namespace detail

} // namespace RTUWIRE_BUILD
} // namespace rtuwire
