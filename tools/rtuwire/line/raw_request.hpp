// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A request of any function, as its bytes say: to a unit, or to all of them.
#pragma once

#include <cstddef>

#include <rtuwire/client.hpp>

namespace tool {

struct raw_request {
    using response = rtuwire::raw_pdu<>;
    static constexpr std::size_t max_size = rtuwire::max_pdu_size;
    static constexpr bool may_be_broadcast = true;

    rtuwire::raw_pdu<> pdu;

    [[nodiscard]] constexpr rtuwire::errc check() const noexcept { return pdu.check(); }
    [[nodiscard]] constexpr std::size_t size() const noexcept { return pdu.size(); }
    constexpr void write(rtuwire::byte_writer& out) const noexcept { pdu.write(out); }
    [[nodiscard]] static constexpr rtuwire::errc check_response(rtuwire::byte_view request_pdu,
                                                                rtuwire::byte_view response_pdu) noexcept
    {
        return rtuwire::raw_pdu<>::check_response(request_pdu, response_pdu);
    }
};

/// Sends it once, whatever comes of it, 05 (acknowledge) and 06 (busy) as well.
template <typename Request> class request_once : public rtuwire::single_request<Request> {
public:
    static constexpr rtuwire::conversation_properties properties{.repetition = rtuwire::repetition::never};

    using rtuwire::single_request<Request>::single_request;
};

/// Nobody knows what a second one would do.
using sent_once = request_once<raw_request>;

} // namespace tool
