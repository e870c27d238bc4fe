// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// A server's answer to function 43 type 14 (AP 6.21): its objects, cut into pages that fit a PDU.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include <rtuwire/core/bytes.hpp>
#include <rtuwire/core/text.hpp>
#include <rtuwire/server/pdu_place.hpp>
#include <rtuwire/wire/errc.hpp>
#include <rtuwire/wire/pdu/device_identification.hpp>

namespace rtuwire {

/// One object of a device's identification; its text has at most 244 characters.
struct device_object {
    std::uint8_t id;
    text value;
};

/// A device's objects, their numbers rising; owned by somebody else.
using device_objects = std::span<device_object const>;

/// The largest object number of an access category: 02, 7F or FF.
[[nodiscard]] constexpr std::uint8_t last_object_of(std::uint8_t category) noexcept
{
    if (category == 1) {
        return major_minor_revision;
    }
    return category == 2 ? 0x7F : 0xFF;
}

/// The category that holds all of a device's objects, with single access: 81, 82 or 83.
[[nodiscard]] constexpr std::uint8_t conformity_of(device_objects objects) noexcept
{
    std::uint8_t const last = objects.empty() ? std::uint8_t{0} : objects.back().id;
    std::uint8_t category = 0x81;
    while (last > last_object_of(category & 0x0FU)) {
        ++category;
    }
    return category;
}

/// The index of an object, or the number of objects where there is no such one.
[[nodiscard]] constexpr std::size_t index_of(device_objects objects, std::uint8_t id) noexcept
{
    std::size_t index = 0;
    while (index < objects.size() and objects[index].id != id) {
        ++index;
    }
    return index;
}

/// Answers the request `asked`, which lies in `pdu`, with as many objects as fit. Errors, as exceptions:
/// `illegal_data_address` for a single object that does not exist; a stream that asks for an unknown
/// object starts at the first. `server_device_failure` when an object fits no page.
[[nodiscard]] constexpr errc write_identification(pdu_place& pdu, device_objects objects,
                                                  read_device_identification const& asked) noexcept
{
    constexpr std::size_t more_at = 4;
    constexpr std::size_t next_at = 5;
    constexpr std::size_t count_at = 6;
    bool const is_single = asked.access == identification_access::single;
    std::uint8_t const last = last_object_of(static_cast<std::uint8_t>(asked.access));
    std::size_t index = index_of(objects, asked.object);
    if (index == objects.size() or objects[index].id > last) {
        if (is_single) {
            return errc::illegal_data_address;
        }
        index = 0;
    }
    // Function, type and access are there already.
    auto const octets = pdu.octets;
    octets[3] = to_byte(conformity_of(objects));
    octets[more_at] = octets[next_at] = std::byte{0};
    std::size_t size = device_identification::head_size;
    std::uint32_t count = 0;
    for (; index < objects.size() and objects[index].id <= last; ++index) {
        device_object const& each = objects[index];
        if (size + 2 + each.value.size() > max_pdu_size) {
            octets[more_at] = std::byte{0xFF};
            octets[next_at] = to_byte(each.id);
            break;
        }
        octets[size++] = to_byte(each.id);
        octets[size++] = to_byte(static_cast<std::uint32_t>(each.value.size()));
        for (std::size_t i = 0; i < each.value.size(); ++i) {
            octets[size++] = static_cast<std::byte>(each.value[i]);
        }
        ++count;
        if (is_single) {
            break;
        }
    }
    octets[count_at] = to_byte(count);
    pdu.size = size;
    return count > 0 ? errc::none : errc::server_device_failure;
}

} // namespace rtuwire
