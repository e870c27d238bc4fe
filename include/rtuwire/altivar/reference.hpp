// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// How fast: a speed goes to LFRD, a frequency to LFR, and which of them is in the value's unit.
#pragma once

#include <concepts>
#include <cstdint>

#include <rtuwire/core/version.hpp>
#include <rtuwire/table/device.hpp>
#include <rtuwire/table/setting.hpp>

namespace rtuwire::inline RTUWIRE_BUILD::altivar {

/// Which way the motor turns.
enum class heading : std::uint8_t { forward, reverse };

/// A reference as a register write.
struct reference_write {
    std::uint16_t address{0};
    std::uint16_t word{0};
};

/// A reference for one device: 1500_rpm or 50_Hz. A negative one turns the motor the other way round
/// than the direction says.
template <device_type Device> class reference {
    using speed = setting<Device::speed_reference>;
    using hertz_setting = setting<Device::frequency_reference>;

public:
    template <std::integral Rep, typename Scale>
    consteval reference(quantity<rotation, Rep, Scale> value) noexcept
        : write_{Device::speed_reference.address, speed{value}.word()}
    {}

    template <std::integral Rep, typename Scale>
    consteval reference(quantity<frequency, Rep, Scale> value) noexcept
        : write_{Device::frequency_reference.address, hertz_setting{value}.word()}
    {}

    /// A setting that was checked when running.
    constexpr reference(speed value) noexcept
        : write_{Device::speed_reference.address, value.word()}
    {}
    constexpr reference(hertz_setting value) noexcept
        : write_{Device::frequency_reference.address, value.word()}
    {}

    [[nodiscard]] constexpr reference_write write() const noexcept { return write_; }

private:
    reference_write write_;
};

} // namespace rtuwire::altivar
