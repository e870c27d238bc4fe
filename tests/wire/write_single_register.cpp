// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Function 06: any address and value, one size.
#include <rtuwire/wire/registers.hpp>

#include "support/encode_space.hpp"
#include "support/proof.hpp"
#include "support/random.hpp"

#include <rtuwire/core/hex.hpp>

using namespace rtuwire;
using namespace rtuwire::detail;

namespace {

constexpr bool needs_its_room() { return test::needs_room(write_single_register{9001, 0x000D}, 8); }
PROOF("a frame of function 06 needs eight bytes", needs_its_room)

constexpr bool has_five_bytes()
{
    constexpr auto bytes = "06 21 35 00 0F 00 00"_hex;
    for (std::size_t size = 0; size <= bytes.size(); ++size) {
        test::exact_bytes const pdu{byte_view{bytes}.first(size)};
        errc const expected = size == 0 ? errc::wrong_function : size == 5 ? errc::none : errc::wrong_length;
        if (write_single_register::decode(pdu.view()).error() != expected) {
            return false;
        }
    }
    return true;
}
PROOF("function 06 has five bytes", has_five_bytes)

constexpr bool takes_any_value()
{
    test::random random{6};
    for (unsigned round = 0; round < 200; ++round) {
        write_single_register const tell{static_cast<std::uint16_t>(random.below(0x1'0000)),
                                         static_cast<std::uint16_t>(random.below(0x1'0000))};
        if (not test::survives(tell, [&](auto const& read) { return read == tell; })) {
            return false;
        }
    }
    write_single_register const last{0xFFFF, 0x8000};
    return test::survives(last, [&](auto const& read) { return read == last; });
}
PROOF("function 06 takes any address and any value", takes_any_value)

} // namespace
