// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// Reads the identification of a drive: by function 43/14 where the device has it, else from the registers of its
// nameplate.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>

#include <rtuwire/ask/conversation.hpp>
#include <rtuwire/ask/poller.hpp>
#include <rtuwire/core/bytes.hpp>
#include <rtuwire/core/version.hpp>
#include <rtuwire/table/device.hpp>
#include <rtuwire/wire/function.hpp>
#include <rtuwire/wire/serial_line/device_identification.hpp>

namespace rtuwire {
inline namespace RTUWIRE_BUILD {
namespace altivar {

/// The basic objects, as text. An object of more than 48 characters is an error, not a shorter text.
struct identity {
    detail::fixed_buffer<48> vendor;
    detail::fixed_buffer<48> product;
    detail::fixed_buffer<48> revision;
};

/// Reads the basic objects page by page. Errors: those of the client; `malformed` for pages that never
/// end; `buffer_too_small` for a text over 48 characters.
template <device_type Device> class identify : public detail::finite_conversation {
public:
    static constexpr function_set asks{function_code::encapsulated_interface};

    /// Asks this drive who it is.
    explicit constexpr identify(station<Device> const& its_drive) noexcept : unit_{its_drive.unit()}
    {
        prepare(vendor_name);
    }

    /// Reads all of it once more.
    constexpr void again() noexcept
    {
        reopen();
        found_ = {};
        prepare(vendor_name);
    }

    constexpr std::optional<request_frame> next() const noexcept
    {
        if (settled()) {
            return std::nullopt;
        }
        return request_frame{frame_};
    }

    constexpr void accept(result<response> const& outcome) noexcept
    {
        if (not outcome) {
            return settle(outcome.error());
        }
        auto const page = outcome->to<read_device_identification>();
        errc const wrong = page ? take(*page) : page.error();
        if (wrong != errc::none) {
            settle(wrong);
        } else if (not page->more_follows) {
            settle(errc::none);
        } else if (page->next_object <= asked_) {
            settle(errc::malformed); // the same page for ever
        } else {
            prepare(page->next_object);
        }
    }

    /// The identification; `busy` until it is settled.
    [[nodiscard]] constexpr result<identity> outcome() const noexcept
    {
        return error() == errc::none ? result<identity>{found_} : result<identity>{error()};
    }

private:
    constexpr void prepare(std::uint8_t object) noexcept
    {
        asked_ = object;
        auto const frame = encode(unit_, read_device_identification{identification_access::basic, object});
        if (frame) {
            frame_ = *frame;
        }
    }

    constexpr errc take(device_identification const& page) noexcept
    {
        for (auto at = page.first(); at; at = page.after(*at)) {
            detail::fixed_buffer<48>* const place = place_of(at->id);
            if (place == nullptr) {
                continue;
            }
            if (at->value.size() > place->storage().size()) {
                return errc::buffer_too_small;
            }
            byte_writer{place->storage()}.bytes(at->value);
            place->resize(at->value.size());
        }
        return errc::none;
    }

    constexpr detail::fixed_buffer<48>* place_of(std::uint8_t id) noexcept
    {
        switch (id) {
        case vendor_name: return &found_.vendor;
        case product_code: return &found_.product;
        case major_minor_revision: return &found_.revision;
        default: return nullptr;
        }
    }

    identity found_{};
    detail::frame_of<read_device_identification> frame_{};
    unit_id unit_;
    std::uint8_t asked_{0};
};

/// A device without function 43: `latest()` holds the registers of its nameplate.
template <device_type Device>
    requires(not detail::implements<Device>(function_code::encapsulated_interface))
class identify<Device> : public poller<typename Device::nameplate::template plan<Device>> {
    using poller<typename Device::nameplate::template plan<Device>>::poller;
};

} // namespace altivar
} // namespace RTUWIRE_BUILD
} // namespace rtuwire
