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

/// Writes one object; how many octets that takes, or 0 where they do not fit.
constexpr std::size_t write_object(byte_span out, device_object const& object) noexcept
{
    constexpr std::size_t head = 2;
    std::size_t const size = head + object.value.size();
    if (size > out.size()) {
        return 0;
    }
    out[0] = to_byte(object.id);
    out[1] = to_byte(static_cast<std::uint32_t>(object.value.size()));
    for (std::size_t i = head; i < size; ++i) {
        out[i] = static_cast<std::byte>(object.value[i - head]);
    }
    return size;
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

/// Writes the answer to a request into `out` (at most 253 octets) and returns how many. Errors, as
/// exceptions: `illegal_data_address` for a single object that does not exist; a stream that asks for
/// an unknown object starts at the first. `server_device_failure` when an object fits no page.
[[nodiscard]] constexpr result<std::size_t>
write_identification(byte_span out, device_objects objects,
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
    if (out.size() < device_identification::head_size) {
        return errc::server_device_failure;
    }
    out[0] = to_byte(to_u8(function_code::encapsulated_interface));
    out[1] = to_byte(identification_mei_type);
    out[2] = static_cast<std::byte>(asked.access);
    out[3] = to_byte(conformity_of(objects));
    std::size_t size = device_identification::head_size;
    std::uint32_t count = 0;
    out[more_at] = out[next_at] = std::byte{0};
    for (; index < objects.size() and objects[index].id <= last; ++index) {
        std::size_t const written = write_object(out.subspan(size), objects[index]);
        if (written == 0) {
            out[more_at] = std::byte{0xFF};
            out[next_at] = to_byte(objects[index].id);
            break;
        }
        size += written;
        ++count;
        if (is_single) {
            break;
        }
    }
    if (count == 0) {
        return errc::server_device_failure;
    }
    out[count_at] = to_byte(count);
    return size;
}

} // namespace rtuwire
