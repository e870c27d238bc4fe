// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// Function 43 type 14, read device identification (AP 6.21). The length byte of each object decides, never a
// fixed size: references of 11 and of 12 characters both occur.
#pragma once

#include <concepts>
#include <optional>

#include <rtuwire/core/version.hpp>
#include <rtuwire/wire/adu.hpp>
#include <rtuwire/wire/function.hpp>
#include <rtuwire/wire/serial_line_rules.hpp>

namespace rtuwire {
inline namespace RTUWIRE_BUILD {

/// Which objects are requested.
enum class identification_access : std::uint8_t {
    basic = 1,
    regular = 2,
    extended = 3,
    single = detail::identification_row::single_access
};

/// The objects every device has.
inline constexpr std::uint8_t vendor_name = 0x00;
inline constexpr std::uint8_t product_code = 0x01;
inline constexpr std::uint8_t major_minor_revision = 0x02;

/// One page of a device's identification; a view of the received bytes. Objects are visited with
/// `first()` and `after()`.
struct device_identification {
    static constexpr std::size_t max_size = max_pdu_size;
    static constexpr std::size_t head_size = detail::identification_row::head;

    /// One object: its number and its text, not terminated.
    struct object {
        std::uint8_t id;
        byte_view value;
    };

    identification_access access;
    std::uint8_t conformity; ///< 01..03, or 81..83 where single access is possible too
    bool more_follows;
    std::uint8_t next_object; ///< where the next page starts, 0 when none follows
    std::uint8_t count;
    byte_view list; ///< id, length and text, `count` times

    [[nodiscard]] constexpr errc check() const noexcept
    {
        if (size() > max_size) {
            return errc::frame_too_long;
        }
        std::size_t const found = detail::objects_in(list);
        return found > 0 and found == count ? errc::none : errc::malformed;
    }
    [[nodiscard]] constexpr std::size_t size() const noexcept { return head_size + list.size(); }
    constexpr void write(byte_writer& out) const noexcept
    {
        out.u8(detail::to_u8(function_code::encapsulated_interface));
        out.u8(detail::identification_mei_type);
        out.u8(static_cast<std::uint32_t>(access));
        out.u8(conformity);
        out.u8(more_follows ? 0xFFU : 0U);
        out.u8(next_object);
        out.u8(count);
        out.bytes(list);
    }

    // Templates, so that a file which does not call them has no optional to compile.

    /// The first object of the page, if there is one.
    template <std::same_as<object> Object = object> [[nodiscard]] constexpr std::optional<Object> first() const noexcept
    {
        return object_in<Object>(list);
    }

    /// The object that follows one of this page, if there is one.
    template <std::same_as<object> Object = object>
    [[nodiscard]] constexpr std::optional<Object> after(object const& previous) const noexcept
    {
        std::size_t taken = 0;
        for (auto at = first<Object>(); at; at = object_in<Object>(list.subspan(taken))) {
            taken += 2 + at->value.size();
            if (at->id == previous.id) {
                return object_in<Object>(list.subspan(taken));
            }
        }
        return std::nullopt;
    }

    /// The text of an object, if this page holds it.
    template <std::same_as<byte_view> Text = byte_view, std::same_as<object> Object = object>
    [[nodiscard]] constexpr std::optional<Text> find(std::uint8_t id) const noexcept
    {
        for (auto at = first<Object>(); at; at = after<Object>(*at)) {
            if (at->id == id) {
                return at->value;
            }
        }
        return std::nullopt;
    }

    /// Whether a PDU is a page: `wrong_function`, `wrong_length` when it ends within its head, `malformed`
    /// when the object count and the bytes disagree or the numbers do not rise, or none.
    [[nodiscard]] static constexpr errc check_page(byte_view pdu) noexcept
    {
        return detail::identification_row::check_page(pdu);
    }

    /// Reads a PDU. Errors: those of `check_page`.
    [[nodiscard]] static constexpr result<device_identification> decode(byte_view pdu) noexcept
    {
        if (errc const wrong = check_page(pdu); wrong != errc::none) {
            return wrong;
        }
        return device_identification{static_cast<identification_access>(detail::to_u8(pdu[2])),
                                     detail::to_u8(pdu[3]),
                                     detail::to_u8(pdu[4]) == 0xFF,
                                     detail::to_u8(pdu[5]),
                                     detail::to_u8(pdu[6]),
                                     pdu.subspan(head_size)};
    }

private:
    template <typename Object> static constexpr std::optional<Object> object_in(byte_view bytes) noexcept
    {
        if (bytes.size() < 2 or bytes.size() - 2 < detail::to_u8(bytes[1])) {
            return std::nullopt;
        }
        return Object{detail::to_u8(bytes[0]), bytes.subspan(2, detail::to_u8(bytes[1]))};
    }
};

/// Requests the identification of one unit, from one object on.
struct read_device_identification {
    using response = device_identification;
    static constexpr function_code code = detail::function_row<read_device_identification>::code;
    static constexpr detail::frame_rules rules = detail::function_row<read_device_identification>::rules;
    static constexpr std::size_t max_size = detail::identification_row::max_size;

    identification_access access{identification_access::basic};
    std::uint8_t object{vendor_name};

    [[nodiscard]] constexpr errc check() const noexcept
    {
        return detail::is_quantity(static_cast<std::uint8_t>(access), 4) ? errc::none : errc::malformed;
    }
    [[nodiscard]] constexpr std::size_t size() const noexcept { return max_size; }
    constexpr void write(byte_writer& out) const noexcept
    {
        out.u8(detail::to_u8(function_code::encapsulated_interface));
        out.u8(detail::identification_mei_type);
        out.u8(static_cast<std::uint32_t>(access));
        out.u8(object);
    }

    /// Reads a PDU. Errors: `wrong_function` (another type within function 43 too), `wrong_length`,
    /// `malformed` for an access code outside 1..4.
    [[nodiscard]] static constexpr result<read_device_identification> decode(byte_view pdu) noexcept
    {
        if (not detail::is_pdu_of(pdu, function_code::encapsulated_interface)) {
            return errc::wrong_function;
        }
        if (pdu.size() >= 2 and detail::to_u8(pdu[1]) != detail::identification_mei_type) {
            return errc::wrong_function;
        }
        if (pdu.size() != max_size) {
            return errc::wrong_length;
        }
        return detail::checked_pdu(read_device_identification{static_cast<identification_access>(detail::to_u8(pdu[2])),
                                                              detail::to_u8(pdu[3])});
    }

    friend constexpr bool operator==(read_device_identification const&, read_device_identification const&) = default;
};

} // namespace RTUWIRE_BUILD
} // namespace rtuwire
