// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// References: a speed is written to LFRD, a frequency to LFR; the unit of the value selects the register.
#pragma once

#include <concepts>
#include <cstdint>

#include <rtuwire/altivar/device/drive_layout.hpp>
#include <rtuwire/altivar/device/drive_type.hpp>
#include <rtuwire/core/version.hpp>
#include <rtuwire/table/device.hpp>
#include <rtuwire/table/setting.hpp>

namespace rtuwire {
inline namespace RTUWIRE_BUILD {
namespace altivar {

/// The direction in which the motor turns.
enum class run_direction : std::uint8_t { forward, reverse };

/// A reference as a register write. Its word is signed: below zero turns the motor in reverse.
/// Internal.
struct alignas(4) reference_write { // two words, else a copy is a call of memcpy
    std::uint16_t address;
    std::uint16_t word;
    bool is_speed{false}; ///< in rpm, else in 0.1 Hz

    [[nodiscard]] constexpr bool is_reverse() const noexcept { return (word & 0x8000U) != 0; }
    [[nodiscard]] constexpr bool is_zero() const noexcept { return word == 0; }

    /// The same without its sign.
    [[nodiscard]] constexpr std::uint16_t size() const noexcept
    {
        return is_reverse() ? static_cast<std::uint16_t>(0U - word) : word;
    }

    /// Whether a drive whose reference is another word turns at least as fast by it, the same way.
    [[nodiscard]] constexpr bool is_within(std::uint16_t standing) const noexcept
    {
        reference_write const other{address, standing};
        return size() <= other.size() and is_reverse() == other.is_reverse();
    }

    /// The same speed in the other direction. A word of 0 has no sign, and a motor with LSP above 0 turns at LSP for it:
    /// turned round, 0 is one count. -32768 has no counterpart: it is 32767.
    [[nodiscard]] constexpr reference_write reversed() const noexcept { return {address, reversed_word(), is_speed}; }
    [[nodiscard]] constexpr std::uint16_t reversed_word() const noexcept
    {
        bool const has_no_other = (word & 0x7FFFU) == 0;
        return static_cast<std::uint16_t>(has_no_other ? ~unsigned{word} : 0U - word);
    }
    [[nodiscard]] constexpr reference_write in(run_direction direction) const noexcept
    {
        return {address, direction == run_direction::reverse ? reversed_word() : word, is_speed};
    }

    /// One that would be 0 in the drive's steps of 0.1 Hz, and would lose its sign with that: at least this many rpm.
    [[nodiscard]] constexpr reference_write at_least(std::uint16_t rpm) const noexcept
    {
        bool const is_lost = is_speed and is_reverse() and size() < rpm;
        return is_lost ? reference_write{address, static_cast<std::uint16_t>(0U - rpm), is_speed} : *this;
    }

    /// The write for a motor in operation with this status: 0 names no direction, so one that turns in reverse keeps to it.
    [[nodiscard]] constexpr reference_write keeping(std::uint16_t status) const noexcept
    {
        return is_zero() and (status & runs_backwards_bit) != 0 ? reversed() : *this;
    }

    /// The write for a drive that turns in the other direction while bit 11 of its control word is set.
    [[nodiscard]] constexpr reference_write under(std::uint16_t control) const noexcept
    {
        return (control & reverse_bit) != 0 ? reversed() : *this;
    }
};

/// A reference for one device: 1500_rpm or 50_Hz; a negative one is in reverse. One of 0 has no direction of its own: see
/// the conversation that it is given to.
template <device_type Device> class reference {
    static_assert(parts_check<Device>::passed);
    using speed = setting<Device::speed_reference>;
    using hertz_setting = setting<Device::frequency_reference>;

public:
    /// A speed in source code; one that the register of the speed reference cannot hold does not compile.
    template <std::integral Rep, typename Scale>
    consteval reference(quantity<rotation, Rep, Scale> value) noexcept
        : write_{Device::speed_reference.address, speed{value}.word(), true}
    {}

    /// A frequency in source code; one that the register of the frequency reference cannot hold does not compile.
    template <std::integral Rep, typename Scale>
    consteval reference(quantity<frequency, Rep, Scale> its_value) noexcept
        : write_{Device::frequency_reference.address, hertz_setting{its_value}.word()}
    {}

    /// A plain number is taken in order to be refused in plain words.
    template <typename Number>
        requires std::integral<Number> or std::floating_point<Number>
    constexpr reference(Number) noexcept : write_{}
    {
        static_assert(not std::integral<Number> and not std::floating_point<Number>,
                      "a plain number is no reference: give it a unit, 50_Hz or 1500_rpm");
    }

    /// A setting that was checked at run time.
    constexpr reference(speed value) noexcept : write_{Device::speed_reference.address, value.word(), true} {}
    /// A frequency known at run time, which was checked.
    constexpr reference(hertz_setting value) noexcept : write_{Device::frequency_reference.address, value.word()} {}

    [[nodiscard]] constexpr reference_write write() const noexcept { return write_; }

private:
    reference_write write_;
};

} // namespace altivar
} // namespace RTUWIRE_BUILD
} // namespace rtuwire
