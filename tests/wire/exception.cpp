// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A server's refusal: any function, any number, one size.
#include <rtuwire/wire/raw.hpp>

#include "support/encode_space.hpp"
#include "support/proof.hpp"

#include <rtuwire/core/hex.hpp>

using namespace rtuwire;
using namespace rtuwire::detail;

namespace {

constexpr bool needs_its_room() { return test::needs_room(exception_response{function_code::diagnostics, 2}, 5); }
PROOF("an exception response needs five bytes", needs_its_room)

constexpr bool refuses_any_function()
{
    for (std::uint32_t number = 0; number <= 0xFF; ++number) {
        exception_response const refusal{static_cast<function_code>(number), 3};
        bool const is_right = number < 0x80 ? test::survives(refusal, [&](auto const& read) { return read == refusal; })
                                            : test::is_refused(refusal, errc::invalid_function);
        if (not is_right) {
            return false;
        }
    }
    return true;
}
PROOF("a refusal names any function below 128", refuses_any_function)

constexpr bool keeps_any_number()
{
    for (std::uint32_t code = 0; code <= 0xFF; ++code) {
        auto const number = static_cast<std::uint8_t>(code);
        exception_response const refusal{function_code::write_single_register, number};
        if (refusal.error() != exception_error(number) or
            not test::survives(refusal, [&](auto const& read) { return read.code == number; })) {
            return false;
        }
    }
    return true;
}
PROOF("a refusal keeps any number", keeps_any_number)

constexpr bool has_two_bytes()
{
    constexpr auto bytes = "83 02 00"_hex;
    for (std::size_t size = 0; size <= bytes.size(); ++size) {
        test::exact_bytes const pdu{byte_view{bytes}.first(size)};
        errc const expected = size == 0 ? errc::wrong_function : size == 2 ? errc::none : errc::wrong_length;
        if (exception_response::decode(pdu.view()).error() != expected) {
            return false;
        }
    }
    return true;
}
PROOF("an exception response has two bytes", has_two_bytes)

} // namespace
