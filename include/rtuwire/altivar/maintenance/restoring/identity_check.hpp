// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// Whether a drive is of the family that a configuration is for: by its product code, or, where it does not say that, by
// registers that are only read and that another family lacks. Knows no request.
// Internal: may change with any version.
#pragma once

#include <cstdint>

#include <rtuwire/altivar/maintenance/drive_family.hpp>
#include <rtuwire/altivar/parameters/parameter.hpp>
#include <rtuwire/ask/conversation.hpp>
#include <rtuwire/core/version.hpp>
#include <rtuwire/wire/serial_line/device_identification.hpp>

namespace rtuwire {
inline namespace RTUWIRE_BUILD {
namespace altivar {

/// Decides by the response to a request for the product code.
class identity_check {
public:
    enum class verdict : std::uint8_t {
        same,
        other,       ///< another family; or it told its product code before, and does not now
        not_told,    ///< it has no function 43/14
        not_reached, ///< no response, or one that is none: the error tells
    };

    /// For a drive of one family; the configuration and the map are of another, or of the same.
    constexpr identity_check(drive_family const& its_family, drive_family const& wanted, literal of_map,
                             bool has_identification) noexcept
        : family_{its_family}, is_meant_{its_family.is_known() and its_family == wanted and
                                         (of_map.size() == 0 or drive_family::of(of_map) == its_family)},
          has_identification_{has_identification}
    {}

    /// As it was made, for a drive that has an identification or not.
    [[nodiscard]] constexpr identity_check anew(bool has_identification) const noexcept
    {
        identity_check same = *this;
        same.has_identification_ = has_identification;
        same.is_identified_ = false;
        same.was_told_ = false;
        return same;
    }

    /// Whether configuration and map are for such a drive.
    [[nodiscard]] constexpr bool is_meant() const noexcept { return is_meant_; }
    [[nodiscard]] constexpr bool has_identification() const noexcept { return has_identification_; }

    /// Whether the drive was identified since `expire`.
    [[nodiscard]] constexpr bool holds() const noexcept { return is_identified_; }

    /// The drive is asked again before the next write; one that does not tell who it is, is not.
    constexpr void expire() noexcept { is_identified_ = not has_identification_; }

    /// The registers were compared.
    constexpr void note_same() noexcept { is_identified_ = true; }

    constexpr verdict judge(result<response> const& outcome, errc& error) noexcept
    {
        error = outcome.error();
        if (is_lack(error)) {
            bool const told_before = was_told_;
            has_identification_ = told_before;
            return told_before ? verdict::other : verdict::not_told;
        }
        if (not outcome) {
            return verdict::not_reached;
        }
        auto const page = outcome->to<read_device_identification>();
        if (not page) {
            error = page.error();
            return verdict::not_reached;
        }
        auto const product = page->find(product_code);
        bool const is_same = product and drive_family::of(*product) == family_;
        is_identified_ = is_same;
        was_told_ = was_told_ or is_same;
        return is_same ? verdict::same : verdict::other;
    }

    /// Whether a register is compared where the drive does not tell who it is.
    [[nodiscard]] static constexpr bool is_compared(parameter const& row) noexcept
    {
        return not row.is_writable() and row.source != provenance::doubtful;
    }

private:
    /// Whether a drive that sent this has no function 43/14, or not this object.
    static constexpr bool is_lack(errc error) noexcept
    {
        return error == errc::illegal_function or error == errc::illegal_data_address or
               error == errc::illegal_data_value;
    }

    drive_family family_;
    bool is_meant_;
    bool has_identification_;
    bool is_identified_{false};
    bool was_told_{false}; ///< by the product code, ever
};

} // namespace altivar
} // namespace RTUWIRE_BUILD
} // namespace rtuwire
