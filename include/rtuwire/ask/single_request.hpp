// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// The conversation of one request: it owns the request and keeps a copy of the response, so that no other traffic can
// change it.
#pragma once

#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <optional>

#include <rtuwire/ask/conversation.hpp>
#include <rtuwire/core/version.hpp>
#include <rtuwire/wire/adu.hpp>
#include <rtuwire/wire/function.hpp>
#include <rtuwire/wire/serial_line_rules.hpp>

namespace rtuwire {
inline namespace RTUWIRE_BUILD {

namespace detail {

/// The largest response PDU to a request of this type, in bytes.
template <typename Request> inline constexpr std::size_t largest_response = max_pdu_size;
template <typename Request>
    requires requires { Request::response::max_size; }
inline constexpr std::size_t largest_response<Request> = Request::response::max_size;

/// A request has something of that name, which nobody would ask where it is no static function.
template <typename Request>
concept names_response_check = requires
{
    &Request::check_response;
};

/// The function of a request; none where that is not known before it is made, as of `raw_pdu`.
template <typename Request> inline constexpr function_set function_of{};
template <typename Request>
    requires std::same_as<std::remove_cv_t<decltype(Request::code)>, function_code>
inline constexpr function_set function_of<Request>{Request::code};

/// Whether a request may go to everyone, or to the only unit of a line, at address 0.
template <typename Request, typename To>
inline constexpr bool may_go_to_0 =
    broadcastable<Request> ? std::same_as<To, broadcast_t> : std::same_as<To, only_unit_t>;

/// Where a request goes; to a unit where it may not go there, so that nothing more is said than why it may not.
template <typename Request, typename To> [[nodiscard]] constexpr auto where_it_may_go(To whom) noexcept
{
    if constexpr (std::same_as<To, unit_id> or may_go_to_0<Request, To>) {
        return whom;
    } else {
        return unit_id{1};
    }
}

/// One request in a frame of at most `FrameSize` bytes, and room for a response PDU of `ResponseSize`.
template <std::size_t FrameSize, std::size_t ResponseSize> class sized_request : public finite_conversation {
public:
    /// Encodes the request; where that fails, nothing is sent and `outcome()` says why.
    template <typename To, pdu Request> constexpr sized_request(To whom, Request const& its_request) noexcept
    {
        auto const written = encode_into(frame_, whom, its_request);
        if (written) {
            size_ = static_cast<std::uint16_t>(written->size());
        } else {
            settle(written.error());
        }
    }

    /// A request that cannot be: nothing is sent, and `outcome()` says why.
    explicit constexpr sized_request(errc why) noexcept { settle(why); }

    /// Sends the same request once more; it is then no longer settled. One that could not be encoded stays settled, and
    /// says so once more.
    constexpr void again() noexcept
    {
        if (size_ != 0) {
            reopen();
        } else {
            tell_again();
        }
    }

    constexpr std::optional<request_frame> next() const& noexcept
    {
        if (settled()) {
            return std::nullopt;
        }
        return request_frame{byte_view{frame_}.first(size_)};
    }
    std::optional<request_frame> next() const&& = delete;

    constexpr void accept(result<response> const& outcome) noexcept
    {
        if (not outcome) {
            return settle(outcome.error());
        }
        byte_view const pdu = outcome->pdu();
        if (pdu.size() > ResponseSize) {
            return settle(errc::wrong_length);
        }
        settle(errc::none);
        response_size_ = static_cast<std::uint8_t>(pdu.size());
        for (std::size_t i = 0; i < pdu.size(); ++i) {
            response_[i] = pdu[i];
        }
    }

    /// The response, or why there is none; `busy` until it is settled. It is a view of this conversation's memory.
    [[nodiscard]] constexpr result<response> outcome() const& noexcept
    {
        if (error() != errc::none) {
            return error();
        }
        return response{byte_view{response_}.first(response_size_)};
    }
    result<response> outcome() const&& = delete;

protected:
    /// What was asked, of a request that could be encoded.
    [[nodiscard]] constexpr byte_view request_pdu() const noexcept { return pdu_of(byte_view{frame_}.first(size_)); }

private:
    std::uint16_t size_{0};
    std::array<std::byte, FrameSize> frame_{};
    std::array<std::byte, ResponseSize> response_{};
    std::uint8_t response_size_{0};
};

} // namespace detail

/// The conversation of one request of a type: `single_request ask{unit_id{7}, read_holding_registers{...}}`; `OfOnlyUnit` where
/// it goes to `only_unit`.
template <detail::pdu Request, bool OfOnlyUnit = false>
class single_request
    : public detail::sized_request<Request::max_size + detail::adu_overhead, detail::largest_response<Request>> {
    static_assert(detail::has_response_check<Request> or not detail::names_response_check<Request>,
                  "check_response of a request is a static function: errc (byte_view request_pdu, byte_view "
                  "response_pdu)");

    using base = detail::sized_request<Request::max_size + detail::adu_overhead, detail::largest_response<Request>>;

public:
    using request_type = Request;
    static constexpr function_set asks = detail::function_of<Request>;
    static constexpr bool asks_only_unit = OfOnlyUnit;

    using base::base;

    /// Asks `whom`, a unit address or a station; the request is copied.
    template <typename To>
    constexpr single_request(To whom, Request const& its_request) noexcept
        : base{detail::where_it_may_go<Request>(whom), its_request}
    {
        static_assert(std::same_as<To, unit_id> or std::same_as<To, detail::broadcast_t> or
                          std::same_as<To, detail::only_unit_t>,
                      "a request goes to a unit, unit_id{7}, or to all of them, broadcast: not to a plain number");
        static_assert(OfOnlyUnit == std::same_as<To, detail::only_unit_t>,
                      "the type of a request to only_unit is single_request<Request, true>, and of no other");
        static_assert(not OfOnlyUnit or not detail::broadcastable<Request>,
                      "what may be broadcast is one at address 0, which nobody answers: send it to broadcast");
        static_assert(not std::same_as<To, detail::broadcast_t> or detail::broadcastable<Request>,
                      "a broadcast has no response, so only a write can be broadcast");
    }

    constexpr void accept(result<response> const& outcome) noexcept
    {
        using row = detail::function_row<Request>;
        if constexpr (detail::checks_response<row> or detail::has_own_format<Request>) {
            if (outcome and not outcome->pdu().empty()) { // it is after a broadcast
                errc const wrong = row::check_response(this->request_pdu(), outcome->pdu());
                if (wrong != errc::none) {
                    return this->settle(wrong);
                }
            }
        }
        base::accept(outcome);
    }
};

template <typename To, detail::pdu Request>
single_request(To, Request) -> single_request<Request, std::same_as<To, detail::only_unit_t>>;

} // namespace RTUWIRE_BUILD
} // namespace rtuwire
