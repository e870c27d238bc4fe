// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// A simulated drive at an address of a line: the drive, its server and what it says of itself.
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include <rtuwire/core/text.hpp>
#include <rtuwire/core/version.hpp>
#include <rtuwire/server/server.hpp>
#include <rtuwire/sim/drive.hpp>

namespace rtuwire::inline RTUWIRE_BUILD::sim {

/// What the drives say of their maker, and their conformity level: regular identification, as a stream.
inline constexpr text maker{"Schneider Electric"};
inline constexpr std::uint8_t printed_conformity = 0x02;

/// The functions and limits of a device, as a server answers them with these objects; without function 43
/// they are left out.
template <device_type Device>
[[nodiscard]] constexpr server_profile line_profile_with(device_objects const& objects) noexcept
{
    bool const tells = Device::functions.contains(function_code::encapsulated_interface);
    return {Device::functions, Device::limits,
            tells ? objects.with_conformity(printed_conformity) : device_objects{}};
}

/// A device that says what its manual prints.
template <device_type Device> struct line_profile {
    static constexpr std::array<device_object, 3> objects{
        {{vendor_name, maker}, {product_code, Device::reference}, {major_minor_revision, "0201"}}};
    static constexpr server_profile value = line_profile_with<Device>(identity_of<objects>);
};

/// A drive on a line. Call `receive`, `sent` and `advance` as for a server; then send what
/// `poll_transmit` gives.
template <device_type Device> class unit {
public:
    constexpr unit(unit_id address, line_timing const& line, instant now) noexcept
        : unit{address, line, now, line_profile<Device>::value}
    {}

    /// Says something else of itself than its manual prints; the profile outlives the unit.
    constexpr unit(unit_id address, line_timing const& line, instant now,
                   server_profile const& profile) noexcept
        : node_{address, line, profile}, drive_{now, address.octet()}, line_{drive_.line()}
    {}

    constexpr void receive(byte_view octets, instant now) noexcept
    {
        if (is_hearing()) {
            node_.receive(octets, now);
        }
    }
    constexpr void receive_error(instant now) noexcept { node_.receive_error(now); }
    constexpr void sent(instant now) noexcept { node_.sent(now); }

    /// Lets time pass for the drive and its server, and serves a request that is there.
    constexpr void advance(instant now) noexcept
    {
        drive_.advance(now);
        node_.advance(now);
        if (node_.is_asked()) {
            drive_.note_contact();
            ++requests_;
            node_.serve(drive_, now);
        }
        // The answer to the write that changed it has the old address still.
        node_.listen_as(checked_unit(drive_.address()));
    }

    [[nodiscard]] constexpr byte_view poll_transmit() noexcept { return node_.poll_transmit(); }
    [[nodiscard]] constexpr deadline poll_deadline() const noexcept
    {
        return node_.poll_deadline();
    }

    /// How many requests it was asked, broadcasts too.
    [[nodiscard]] constexpr std::uint32_t requests() const noexcept { return requests_; }

    [[nodiscard]] constexpr drive<Device>& inside() noexcept { return drive_; }
    [[nodiscard]] constexpr drive<Device> const& inside() const noexcept { return drive_; }

private:
    static constexpr std::optional<unit_id> checked_unit(std::uint16_t number) noexcept
    {
        auto const unit = unit_id::checked(number);
        return unit ? std::optional{*unit} : std::nullopt;
    }

    /// Not while it is silent, and not where its settings are no longer those of the line.
    constexpr bool is_hearing() const noexcept
    {
        return not drive_.is_silent() and drive_.line() == line_;
    }

    server node_;
    drive<Device> drive_;
    line_setting line_; ///< as it was put there
    std::uint32_t requests_{0};
};

} // namespace rtuwire::sim
