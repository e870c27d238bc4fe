// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// A server's response to function 43 type 14 (AP 6.21): its objects, split into pages that fit a PDU. They are stored
// as they are sent: number, length and characters of each, one after the other.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include <rtuwire/core/bytes.hpp>
#include <rtuwire/core/literal.hpp>
#include <rtuwire/core/version.hpp>
#include <rtuwire/server/decoded_request.hpp>
#include <rtuwire/wire/errc.hpp>
#include <rtuwire/wire/serial_line/device_identification.hpp>

namespace rtuwire {
inline namespace RTUWIRE_BUILD {

/// One object of a device's identification; its text has at most 244 characters.
struct device_object {
    std::uint8_t id;
    literal value;

    /// Appends it encoded as in a response; a text longer than 244 characters fits no response.
    constexpr void write(byte_writer& out) const noexcept
    {
        out.u8(id);
        out.u8(static_cast<std::uint32_t>(value.size()));
        for (char const letter : value) {
            out.u8(static_cast<std::uint8_t>(letter));
        }
    }
};

namespace detail {

/// The largest object number of an access category: 02, 7F or FF.
[[nodiscard]] constexpr std::uint8_t last_object_of(identification_access access) noexcept
{
    if (access == identification_access::basic) {
        return major_minor_revision;
    }
    return access == identification_access::regular ? 0x7F : 0xFF;
}

/// The conformity level of a device whose largest object number is `last_object`, with single access: 81, 82 or 83.
[[nodiscard]] constexpr std::uint8_t conformity_of(std::uint8_t last_object) noexcept
{
    if (last_object > last_object_of(identification_access::regular)) {
        return 0x83;
    }
    return last_object > last_object_of(identification_access::basic) ? 0x82 : 0x81;
}

} // namespace detail

/// A device's objects, in bytes that are stored elsewhere; or none.
class device_objects {
public:
    static constexpr std::size_t head_size = 2;       ///< number and length
    static constexpr std::size_t max_text_size = 244; ///< of an object that fills a page

    /// None.
    constexpr device_objects() noexcept = default;

    /// Objects encoded as in a response, for objects known only at run time. `malformed` unless the first is the
    /// vendor's name, their numbers increase and each text has at most 244 characters.
    [[nodiscard]] static constexpr result<device_objects> from(byte_view bytes) noexcept
    {
        if (detail::objects_in(bytes) == 0 or detail::to_u8(bytes[0]) != vendor_name) {
            return errc::malformed;
        }
        device_objects made;
        made.bytes_ = bytes;
        for (byte_view rest = bytes; not rest.empty();) {
            if (detail::to_u8(rest[1]) > max_text_size) {
                return errc::malformed;
            }
            made.conformity_ = detail::conformity_of(detail::to_u8(rest[0]));
            rest = rest.subspan(head_size + detail::to_u8(rest[1]));
        }
        return made;
    }

    /// The same objects with another conformity level: for a device whose manual prints one that does not follow
    /// from its objects.
    [[nodiscard]] constexpr device_objects with_conformity(std::uint8_t level) const noexcept
    {
        device_objects made = *this;
        made.conformity_ = level;
        return made;
    }

    [[nodiscard]] constexpr bool empty() const noexcept { return bytes_.empty(); }
    [[nodiscard]] constexpr byte_view bytes() const noexcept { return bytes_; }

    /// The conformity level: the category of all objects, with single access (81, 82 or 83), unless another was set.
    [[nodiscard]] constexpr std::uint8_t conformity() const noexcept { return conformity_; }

private:
    byte_view bytes_{};
    std::uint8_t conformity_{0x81};
};

namespace detail {

/// The bytes of objects known at compile time.
template <auto const& Objects> [[nodiscard]] consteval auto bytes_of() noexcept
{
    constexpr std::size_t size = [] {
        std::size_t all = 0;
        for (device_object const& each : Objects) {
            all += device_objects::head_size + each.value.size();
        }
        return all;
    }();
    std::array<std::byte, size> bytes{};
    byte_writer out{bytes};
    for (device_object const& each : Objects) {
        each.write(out);
    }
    return bytes;
}

/// The storage of these bytes.
template <auto const& Objects> inline constexpr auto object_bytes = bytes_of<Objects>();

} // namespace detail

/// The identity made of objects known at compile time: an array, or a std::array, of `device_object` at namespace or
/// class scope (Clang 14 fails on one within a function). Objects that `device_objects::from` refuses do not compile.
template <auto const& Objects>
inline constexpr device_objects identity_of = [] {
    constexpr auto made = device_objects::from(detail::object_bytes<Objects>);
    static_assert(made.has_value(), "the vendor's name first, numbers that rise, texts that fit");
    return *made;
}();

namespace detail {

/// Replaces the request of function 43 in `pdu` by its response, with as many objects as fit. Errors, as exceptions:
/// `illegal_function` for a type other than 14 or without objects, `illegal_data_value` for another size or access,
/// `illegal_data_address` for a single object that does not exist. A stream that asks for an unknown object starts at
/// the first.
[[nodiscard]] constexpr errc write_identification(pdu_buffer& pdu, device_objects const& objects) noexcept
{
    constexpr std::size_t request_size = read_device_identification::max_size;
    auto const bytes = pdu.bytes;
    if (objects.empty()) {
        return errc::illegal_function;
    }
    if (pdu.size >= 2 and to_u8(bytes[1]) != identification_mei_type) {
        return errc::illegal_function;
    }
    if (pdu.size != request_size or not is_quantity(to_u8(bytes[2]), 4)) {
        return errc::illegal_data_value;
    }
    auto const access = static_cast<identification_access>(to_u8(bytes[2]));
    bool const is_single = access == identification_access::single;
    std::uint8_t last = last_object_of(access);
    std::byte const* const begin = objects.bytes().data();
    std::byte const* const end = begin + objects.bytes().size();
    std::byte const* at = begin;
    while (at != end and at[0] != bytes[3]) {
        at += device_objects::head_size + to_u8(at[1]);
    }
    if (at == end or to_u8(at[0]) > last) {
        if (is_single) {
            return errc::illegal_data_address;
        }
        at = begin;
    }
    if (is_single) {
        last = to_u8(at[0]);
    }
    // Function, type and access are there already.
    bytes[3] = to_byte(objects.conformity());
    bytes[4] = bytes[5] = std::byte{0};
    std::size_t size = device_identification::head_size;
    std::uint32_t count = 0;
    while (at != end and to_u8(at[0]) <= last) {
        std::byte const* const after = at + device_objects::head_size + to_u8(at[1]);
        if (size + static_cast<std::size_t>(after - at) > max_pdu_size) {
            bytes[4] = std::byte{0xFF};
            bytes[5] = at[0];
            break;
        }
        while (at != after) {
            bytes[size++] = *at++;
        }
        ++count;
    }
    bytes[6] = to_byte(count);
    pdu.size = size;
    return errc::none;
}

} // namespace detail

} // namespace RTUWIRE_BUILD
} // namespace rtuwire
