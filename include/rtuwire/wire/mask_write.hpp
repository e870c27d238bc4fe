// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// Function 22, mask write register (AP 6.16). Request and response are the same bytes.
#pragma once

#include <rtuwire/core/version.hpp>
#include <rtuwire/wire/function.hpp>
#include <rtuwire/wire/pdu_fields.hpp>

namespace rtuwire {
inline namespace RTUWIRE_BUILD {

/// Changes single bits of one register of one unit or of all, in one transaction: the register becomes
/// (its value AND `and_mask`) OR (`or_mask` AND NOT `and_mask`). The response repeats the request.
struct mask_write_register {
    using response = mask_write_register;
    static constexpr function_code code = function_code::mask_write_register;
    static constexpr detail::frame_rules rules{detail::sized(detail::length_rule::fixed, 10),
                                               detail::sized(detail::length_rule::fixed, 10),
                                               detail::answer_rule::whole};
    static constexpr std::size_t max_size = 7;
    static constexpr bool may_be_broadcast = true;

    std::uint16_t address;
    std::uint16_t and_mask; ///< 1: the bit stays
    std::uint16_t or_mask;  ///< what a bit that does not stay becomes

    /// The register's value after the write.
    [[nodiscard]] constexpr std::uint16_t applied_to(std::uint16_t value) const noexcept
    {
        return static_cast<std::uint16_t>((value & and_mask) | (or_mask & ~std::uint32_t{and_mask}));
    }

    [[nodiscard]] constexpr errc check() const noexcept { return errc::none; }
    [[nodiscard]] constexpr std::size_t size() const noexcept { return max_size; }
    constexpr void write(byte_writer& out) const noexcept
    {
        detail::write_head(out, code, address, and_mask);
        out.u16(or_mask);
    }

    /// Reads a PDU. Errors: `wrong_function`, `wrong_length`.
    [[nodiscard]] static constexpr result<mask_write_register> decode(byte_view pdu) noexcept
    {
        if (errc const wrong = detail::check_size(pdu, code, max_size); wrong != errc::none) {
            return wrong;
        }
        return mask_write_register{detail::u16_at(pdu, 1), detail::u16_at(pdu, 3), detail::u16_at(pdu, 5)};
    }

    /// Answers a request.
    /// Internal.
    template <typename Memory, typename Server>
    [[nodiscard]] static constexpr errc respond(Memory& pdu, Server const& at) noexcept
    {
        std::uint16_t const address = detail::u16_at(pdu.bytes, 1);
        if (errc const wrong = at.bank.check_read(address, 1); wrong != errc::none) {
            return wrong;
        }
        // The register stands behind the request, which is the response.
        auto const place = pdu.bytes.template subspan<max_size, 2>();
        byte_writer out{place};
        if (errc const wrong = at.bank.read(address, 1, out); wrong != errc::none) {
            return wrong;
        }
        if (out.size() != place.size()) {
            return errc::server_device_failure;
        }
        mask_write_register const asked{address, detail::u16_at(pdu.bytes, 3), detail::u16_at(pdu.bytes, 5)};
        detail::put_u16(place.data(), asked.applied_to(detail::u16_at(place, 0)));
        register_view const value{place};
        if (errc const wrong = at.bank.check_write(address, value); wrong != errc::none) {
            return wrong;
        }
        return at.bank.write(address, value);
    }

    friend constexpr bool operator==(mask_write_register const&, mask_write_register const&) = default;
};

} // namespace RTUWIRE_BUILD
} // namespace rtuwire
