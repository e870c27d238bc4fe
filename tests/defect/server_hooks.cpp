// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// The order of the specification's diagrams (AP 7: function, address, value) holds for hooks, too: no check of a value is
// called for a request that is refused for an address, or for what is no value of its register.
#include <rtuwire/server/hooks.hpp>

#include <array>

#include "support/proof.hpp"

#include <rtuwire/core/hex.hpp>
#include <rtuwire/server/respond.hpp>
#include <rtuwire/table/form/floating.hpp>

using namespace rtuwire;
using namespace rtuwire::detail;

namespace {

inline constexpr reg<float32<celsius>> limit{.code = "LIM", .address = 22};

/// What comes of a request to words 20 to 27, of which 20, 21 and 24 have a check that refuses 7, and 22 and 23 are one
/// register whose check refuses more than 80 degrees.
struct outcome {
    std::array<std::byte, max_pdu_size> place{};
    std::size_t size{0};
    unsigned checks{0}; ///< how many were called
    bool is_unchanged{true};

    [[nodiscard]] constexpr bool is(byte_view told, unsigned calls) const
    {
        return same_bytes(byte_view{place}.first(size), told) and checks == calls and
               is_unchanged == (to_u8(told[0]) >= 0x80);
    }
};

constexpr outcome after(byte_view pdu)
{
    outcome got;
    word_bank<8> words{20};
    auto const not_seven = [&](std::uint16_t asked) {
        ++got.checks;
        return asked == 7 ? errc::illegal_data_value : errc::none;
    };
    auto served = with_hooks(words)
                      .check(20, not_seven)
                      .check(21, not_seven)
                      .check<limit>([&](real<celsius> asked) {
                          ++got.checks;
                          return asked.count() > 80 ? errc::illegal_data_value : errc::none;
                      })
                      .check(24, not_seven);
    got.size = respond(pdu, served, server_profile{}, got.place).size();
    for (std::uint16_t i = 0; i < 8; ++i) {
        got.is_unchanged = got.is_unchanged and words.get(static_cast<std::uint16_t>(20 + i)) == 0;
    }
    return got;
}

constexpr bool addresses_come_first()
{
    // The first word is one that its check refuses, and the register behind it is half there; from its other side, too.
    return after("10 00 15 00 02 04 00 07 42 72"_hex).is("90 02"_hex, 0) and
           after("10 00 14 00 03 06 00 01 00 07 42 72"_hex).is("90 02"_hex, 0) and
           after("10 00 17 00 02 04 00 00 00 07"_hex).is("90 02"_hex, 0) and
           // Of the bank: a last address that is not there.
           after("10 00 18 00 05 0A 00 07 00 01 00 01 00 01 00 01"_hex).is("90 02"_hex, 0) and
           // Function 23: the half that is read is checked first.
           after("17 00 63 00 01 00 14 00 01 02 00 07"_hex).is("97 02"_hex, 0) and
           after("17 00 14 00 01 00 15 00 02 04 00 07 42 72"_hex).is("97 02"_hex, 0);
}
PROOF("defect: D31 no check is called for a request with a wrong address", addresses_come_first)

constexpr bool values_come_next()
{
    // 7FC00000 is no number: 03, and the checks of the words around it are not called.
    return after("10 00 14 00 04 08 00 01 00 02 7F C0 00 00"_hex).is("90 03"_hex, 0) and
           after("10 00 16 00 03 06 7F C0 00 00 00 07"_hex).is("90 03"_hex, 0);
}
PROOF("defect: D31 no check is called where a word is no value of its register", values_come_next)

constexpr bool checks_come_last()
{
    // 42720000 are 60.5 degrees, 42B40000 are 90.
    return after("10 00 14 00 05 0A 00 01 00 02 42 72 00 00 00 03"_hex).is("10 00 14 00 05"_hex, 4) and
           after("10 00 14 00 05 0A 00 01 00 02 42 B4 00 00 00 03"_hex).is("90 03"_hex, 3) and
           after("10 00 14 00 05 0A 00 07 00 02 42 72 00 00 00 03"_hex).is("90 03"_hex, 1);
}
PROOF("defect: D31 checks are called in the order of the addresses, up to the first refusal", checks_come_last)

} // namespace
