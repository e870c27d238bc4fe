// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A bank of typed registers: access, limits and order of refusals; and typed access against it.
#include <rtuwire/server/typed_bank.hpp>

#include "support/proof.hpp"

#include <rtuwire/core/hex.hpp>
#include <rtuwire/server/respond.hpp>

using namespace rtuwire;
using namespace rtuwire::detail;

namespace {

enum class valve : std::uint16_t { closed = 1, open = 4 };
enum class lamp : std::uint16_t {};

} // namespace

template <>
inline constexpr auto rtuwire::enumerators<valve> = rtuwire::detail::name_list({{1, "closed"}, {4, "open"}});

namespace {

constexpr reg<decihertz> setpoint{.code = "SET", .address = 10, .min = 100, .max = 600, .factory = 500};
constexpr reg<signed_rpm> speed{.code = "SPD", .address = 11, .min = -1500, .max = 1500};
constexpr reg<decihertz> actual{.code = "ACT", .address = 12, .mode = access::read_only};
constexpr reg<count16> apart{.code = "APT", .address = 65535};
using pump_bank = bank<setpoint, speed, actual, apart>;

STATIC_CHECK(register_bank<pump_bank>);
STATIC_CHECK(pump_bank{}.get<setpoint>() == decihertz{500});
STATIC_CHECK(pump_bank{}.check_read(10, 3) == errc::none);
STATIC_CHECK(pump_bank{}.check_read(10, 4) == errc::illegal_data_address);
STATIC_CHECK(pump_bank{}.check_read(9, 1) == errc::illegal_data_address);
STATIC_CHECK(pump_bank{}.check_read(65535, 1) == errc::none);
STATIC_CHECK(pump_bank{}.check_read(65535, 2) == errc::illegal_data_address);

template <std::size_t Asked, std::size_t Answered>
constexpr bool answers(std::array<std::byte, Asked> const& request, std::array<std::byte, Answered> const& expected,
                       std::uint16_t setpoint_after)
{
    pump_bank registers;
    std::array<std::byte, max_pdu_size> place{};
    return same_bytes(respond(request, registers, server_profile{}, place), expected) and
           registers.get<setpoint>().count() == setpoint_after;
}

STATIC_CHECK(answers("06 00 0A 02 58"_hex, "06 00 0A 02 58"_hex, 600));
STATIC_CHECK(answers("06 00 0A 02 59"_hex, "86 03"_hex, 500));
STATIC_CHECK(answers("06 00 0A 00 63"_hex, "86 03"_hex, 500));
STATIC_CHECK(answers("06 00 0B FA 24"_hex, "06 00 0B FA 24"_hex, 500));
STATIC_CHECK(answers("06 00 0B FA 23"_hex, "86 03"_hex, 500));
STATIC_CHECK(answers("06 00 0C 00 01"_hex, "86 02"_hex, 500));
// The bad address of the third comes before the bad value of the first, and nothing is written.
STATIC_CHECK(answers("10 00 0A 00 03 06 FF FF 00 00 00 00"_hex, "90 02"_hex, 500));
STATIC_CHECK(answers("10 00 0A 00 02 04 00 C8 07 D0"_hex, "90 03"_hex, 500));
STATIC_CHECK(answers("10 00 0A 00 02 04 00 C8 05 DC"_hex, "10 00 0A 00 02"_hex, 200));

/// How many of all words a register of one's own takes.
template <auto const& R> constexpr unsigned taken_by()
{
    bank<R> registers;
    unsigned taken = 0;
    for (std::uint32_t word = 0; word < 0x1'0000; word += word < 16 ? 1 : 0x1FFF) {
        register_block const value{static_cast<std::uint16_t>(word)};
        errc const verdict = registers.check_write(R.address, value);
        taken += verdict == errc::none ? 1U : verdict == errc::illegal_data_value ? 0U : 1'000U;
    }
    return taken;
}
constexpr reg<valve> inlet{.code = "VAL", .address = 20};
constexpr reg<lamp> unnamed{.code = "LMP", .address = 21};
constexpr bool takes_what_means_something()
{
    register_block const open{4};
    return taken_by<inlet>() == 2 and bank<inlet>{}.check_write(20, open) == errc::none;
}
PROOF("an enumeration with names takes those values only", takes_what_means_something)
constexpr bool takes_any_without_names() { return taken_by<unnamed>() == 24; }
PROOF("an enumeration without names takes any word", takes_any_without_names)

constexpr bool takes_written()
{
    pump_bank registers;
    registers.set<actual>(decihertz{7});
    bool const own = not registers.take_written<actual>() and registers.get<actual>() == decihertz{7};
    constexpr register_block values{200};
    static_cast<void>(registers.write(10, values));
    return own and registers.take_written<setpoint>() and not registers.take_written<setpoint>() and
           not registers.take_written<speed>();
}
PROOF("a client's write is told once, the device's own is not", takes_written)

constexpr auto two_words = "01 F4 FF 9C"_hex;
constexpr auto full_word = "FF FF"_hex;

constexpr bool writes_and_reads_all()
{
    pump_bank registers;
    register_view const two{two_words};
    using test::is;
    bool ok = is(registers.get<actual>() == decihertz{0}, "zero without a factory value") and
              is(registers.get<apart>() == count16{0}, "zero in the register apart") and
              is(registers.check_write(10, two) == errc::none, "the write is allowed") and
              is(registers.write(10, two) == errc::none, "the write is done");
    ok = ok and is(registers.get<setpoint>() == decihertz{500}, "the first word") and
         is(registers.get<speed>() == signed_rpm{-100}, "the second word, below zero") and
         is(registers.take_written<setpoint>(), "the first was written") and
         is(registers.take_written<speed>(), "the second was written") and
         is(not registers.take_written<actual>(), "the third was not");
    std::array<std::byte, 6> place{};
    byte_writer out{place};
    ok = ok and is(registers.read(10, 3, out) == errc::none, "the read is done");
    return ok and is(same_bytes(out.written(), "01 F4 FF 9C 00 00"_hex), "all three words are read");
}
PROOF("all words of a range are written and read, in their order", writes_and_reads_all)

constexpr bool the_last_address()
{
    // Behind it there is neither a register nor a byte: the compiler refuses what reaches for them.
    pump_bank registers;
    register_view const one{full_word};
    bool const ok = registers.check_write(65535, one) == errc::none and registers.write(65535, one) == errc::none and
                    registers.get<apart>() == count16{65535};
    std::array<std::byte, 2> place{};
    byte_writer out{place};
    return ok and registers.read(65535, 1, out) == errc::none and same_bytes(out.written(), full_word);
}
PROOF("a register without limits takes any word, at the last address too", the_last_address)

} // namespace
