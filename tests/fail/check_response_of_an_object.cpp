// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A check of the response that needs a request's object: no client has one, so nothing would ever be checked.
// EXPECT: check_response of a request is a static function: errc (byte_view request_pdu, byte_view response_pdu)
#include <rtuwire/ask/single_request.hpp>
#include <rtuwire/wire/registers.hpp>

using namespace rtuwire;

struct careful_read : read_holding_registers {
#ifdef REFUSED
    constexpr errc check_response(byte_view, byte_view) const { return errc::none; }
#else
    static constexpr errc check_response(byte_view, byte_view) { return errc::none; }
#endif
};

single_request<careful_read> ask{unit_id{1}, careful_read{{.start = 3201, .count = 1}}};
