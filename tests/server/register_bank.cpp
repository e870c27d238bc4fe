// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Plain words, reached by address.
#include <rtuwire/server/banks.hpp>

#include <array>

#include "support/proof.hpp"

using namespace rtuwire;

namespace {

STATIC_CHECK(register_bank<word_bank<4>>);

constexpr word_bank<4> at_100{100};
STATIC_CHECK(at_100.contains(100) and at_100.contains(103));
STATIC_CHECK(not at_100.contains(99) and not at_100.contains(104));
STATIC_CHECK(at_100.check_read(100, 4) == errc::none);
STATIC_CHECK(at_100.check_read(100, 5) == errc::illegal_data_address);
STATIC_CHECK(at_100.check_read(103, 2) == errc::illegal_data_address);
STATIC_CHECK(at_100.check_read(99, 1) == errc::illegal_data_address);
STATIC_CHECK(at_100.check_read(65535, 125) == errc::illegal_data_address);

constexpr word_bank<2> at_the_end{65534};
STATIC_CHECK(at_the_end.check_read(65535, 1) == errc::none);
STATIC_CHECK(at_the_end.check_read(65535, 2) == errc::illegal_data_address);
STATIC_CHECK(at_the_end.check_read(0, 1) == errc::illegal_data_address);

constexpr bool set_and_get()
{
    word_bank<4> bank{100};
    bool const set = bank.set(103, 7).has_value() and bank.set(104, 7) == errc::illegal_data_address;
    return set and bank.get(103) == 7 and bank.get(104) == 0 and bank.get(99) == 0;
}
PROOF("a word is set and got only where there is one", set_and_get)

constexpr bool writes_no_word_more()
{
    // Behind the two words there is no third, in the bytes nor at the end of the bank.
    constexpr register_block two{0x1234, 0x5678};
    word_bank<4> bank{100};
    static_cast<void>(bank.set(102, 7));
    using test::is;
    bool const first = is(bank.write(100, two.view()) == errc::none, "a write of the first two") and
                       is(bank.get(102) == 7, "the third is as it was");
    return first and is(bank.write(102, two.view()) == errc::none, "a write of the last two") and
           is(bank.get(100) == 0x1234, "the first word") and is(bank.get(101) == 0x5678, "the second word") and
           is(bank.get(102) == 0x1234, "the third word") and is(bank.get(103) == 0x5678, "the fourth word");
}
PROOF("as many words are written as there are values", writes_no_word_more)

constexpr bool reads_into_what_has_room()
{
    word_bank<4> bank{100};
    std::array<std::byte, 7> place{};
    byte_writer out{place};
    return bank.read(100, 3, out) == errc::none and bank.read(100, 1, out) == errc::server_device_failure and
           out.size() == 6;
}
PROOF("words that no response has room for are a failure of the unit", reads_into_what_has_room)

} // namespace
