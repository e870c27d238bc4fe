// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Callables at registers: what is asked before a write and told after it, in which order, and that a refusal leaves
// nothing half done. The order is held against what the bank below notes down, not against the hooks' own code.
#include <rtuwire/server.hpp>

#include <array>
#include <optional>
#include <string_view>
#include <type_traits>
#include <utility>

#include "support/proof.hpp"
#include "support/server_on_a_line.hpp"
#include "support/whole_bank.hpp"

#include <rtuwire/server/respond.hpp>

using namespace rtuwire;
using namespace rtuwire::detail;

namespace {

/// What happened, in order: '?' and a letter for a check, '!' and a letter for an action, 'c', 'w' and 'r' for the
/// bank's own check, write and read.
struct record {
    std::array<char, 40> letters{};
    std::size_t size{0};

    constexpr void note(char what)
    {
        if (size + 1 < letters.size()) {
            letters[size++] = what;
        }
    }
    constexpr void note(char how, char what)
    {
        note(how);
        note(what);
    }
    constexpr bool is(std::string_view wanted) const { return std::string_view{letters.data(), size} == wanted; }
};

/// Four words from 100 on; 103 takes no word above 9.
struct noting_bank {
    record& seen;
    word_bank<4> words{100};

    constexpr errc check_read(std::uint16_t start, std::size_t count) const { return words.check_read(start, count); }
    constexpr errc check_write(std::uint16_t start, register_view values) const
    {
        seen.note('c');
        for (std::size_t i = 0; i < values.size(); ++i) {
            if (start + i == 103 and values[i] > 9) {
                return errc::illegal_data_value;
            }
        }
        return words.check_write(start, values);
    }
    constexpr errc read(std::uint16_t start, std::size_t count, byte_writer& out)
    {
        seen.note('r');
        return words.read(start, count, out);
    }
    constexpr errc write(std::uint16_t start, register_view values)
    {
        seen.note('w');
        return words.write(start, values);
    }
};

using functions_of_registers = function_list<read_holding_registers, write_single_register, write_multiple_registers<>,
                                             mask_write_register, read_write_multiple_registers<>>;

struct outcome {
    record seen{};
    std::array<std::byte, max_pdu_size> place{};
    std::size_t size{0};
    std::array<std::uint16_t, 4> words{};

    constexpr bool is(std::string_view order, byte_view pdu, std::array<std::uint16_t, 4> const& left) const
    {
        return seen.is(order) and same_bytes(byte_view{place}.first(size), pdu) and words == left;
    }
};

/// A request to a bank that refuses 7 at address 101, and everything above 8 at 102 while it is busy. The hooks are
/// named in another order than that of the addresses.
constexpr outcome after(byte_view pdu, bool is_busy = false)
{
    outcome got;
    noting_bank bank{got.seen};
    auto served =
        with_hooks(bank)
            .on_write(102, [&](std::uint16_t) { got.seen.note('!', 'c'); })
            .check(102,
                   [&](std::uint16_t asked) {
                       got.seen.note('?', 'c');
                       return is_busy and asked > 8 ? errc::server_device_failure : errc::none;
                   })
            .on_write(101, [&](std::uint16_t now) { got.seen.note('!', now == bank.words.get(101) ? 'b' : 'x'); })
            .check(101,
                   [&](std::uint16_t asked) {
                       got.seen.note('?', bank.words.get(101) == 0 ? 'b' : 'x');
                       return asked == 7 ? errc::illegal_data_value : errc::none;
                   })
            .on_write(101, [&](std::uint16_t) { got.seen.note('!', 'B'); });
    std::array<std::byte, max_pdu_size> place{};
    byte_view const told = respond<functions_of_registers>(pdu, served, server_profile{}, place);
    got.size = told.size();
    for (std::size_t i = 0; i < told.size(); ++i) {
        got.place[i] = told[i];
    }
    for (std::size_t i = 0; i < 4; ++i) {
        got.words[i] = bank.words.get(static_cast<std::uint16_t>(100 + i));
    }
    return got;
}

// Function 06: asked, written, told, in this order. A register without hooks: only written.
STATIC_CHECK(after("06 00 65 00 05"_hex).is("c?bw!b!B", "06 00 65 00 05"_hex, {0, 5, 0, 0}));
STATIC_CHECK(after("06 00 64 00 05"_hex).is("cw", "06 00 64 00 05"_hex, {5, 0, 0, 0}));
// Exception 03 for the value, 04 for the state.
STATIC_CHECK(after("06 00 65 00 07"_hex).is("c?b", "86 03"_hex, {0, 0, 0, 0}));
STATIC_CHECK(after("06 00 66 00 09"_hex, true).is("c?c", "86 04"_hex, {0, 0, 0, 0}));
STATIC_CHECK(after("06 00 66 00 09"_hex, false).is("c?cw!c", "06 00 66 00 09"_hex, {0, 0, 9, 0}));
// Function 16: all checks, one write, all actions, by address.
STATIC_CHECK(after("10 00 64 00 03 06 00 01 00 02 00 03"_hex).is("c?b?cw!b!B!c", "10 00 64 00 03"_hex, {1, 2, 3, 0}));
// The first refusal ends it, and nothing is half written.
STATIC_CHECK(after("10 00 64 00 03 06 00 01 00 07 00 09"_hex, true).is("c?b", "90 03"_hex, {0, 0, 0, 0}));
STATIC_CHECK(after("10 00 64 00 03 06 00 01 00 02 00 09"_hex, true).is("c?b?c", "90 04"_hex, {0, 0, 0, 0}));
// The bank's own checks of all registers come first, and no hook hears of what they refuse.
STATIC_CHECK(after("10 00 65 00 03 06 00 07 00 03 00 63"_hex).is("c", "90 03"_hex, {0, 0, 0, 0}));
STATIC_CHECK(after("10 00 65 00 04 08 00 01 00 02 00 03 00 04"_hex).is("c", "90 02"_hex, {0, 0, 0, 0}));
// Function 22 asks with the value that the register would get; 23 reads after the actions.
STATIC_CHECK(after("16 00 65 FF F0 00 07"_hex).is("rc?b", "96 03"_hex, {0, 0, 0, 0}));
STATIC_CHECK(after("16 00 65 FF F0 00 06"_hex).is("rc?bw!b!B", "16 00 65 FF F0 00 06"_hex, {0, 6, 0, 0}));
STATIC_CHECK(after("17 00 64 00 02 00 65 00 01 02 00 05"_hex).is("c?bw!b!Br", "17 04 00 00 00 05"_hex, {0, 5, 0, 0}));
STATIC_CHECK(after("17 00 64 00 02 00 65 00 01 02 00 07"_hex).is("c?b", "97 03"_hex, {0, 0, 0, 0}));

namespace pump {

enum class mode : std::uint16_t { off = 1, on = 4 };
inline constexpr reg<signed_decihertz> setpoint{.code = "SET", .address = 10, .min = -600, .max = 600};
inline constexpr reg<decihertz> actual{.code = "ACT", .address = 11, .mode = access::read_only};
inline constexpr reg<mode> how{.code = "HOW", .address = 12};

} // namespace pump

/// A pump that turns only while there is water, and shows at once what it was told.
struct pump_unit {
    bank<pump::setpoint, pump::actual, pump::how> registers{};
    bool is_empty{false};
    int orders{0};
    pump::mode mode{};

    constexpr auto served()
    {
        return with_hooks(registers)
            .check<pump::setpoint>(
                [this](signed_decihertz) { return is_empty ? errc::server_device_failure : errc::none; })
            .on_write<pump::setpoint>([this](signed_decihertz now) {
                ++orders;
                registers.set<pump::actual>(now < 0_Hz ? decihertz{0} : setting<pump::actual>::checked(now)->value());
            })
            .on_write<pump::how>([this](pump::mode now) { mode = now; });
    }

    constexpr bool answers(byte_view pdu, byte_view wanted)
    {
        auto bank = served();
        std::array<std::byte, max_pdu_size> place{};
        return same_bytes(respond(pdu, bank, server_profile{}, place), wanted);
    }
};

constexpr bool typed()
{
    pump_unit unit;
    bool ok = unit.answers("06 00 0A 01 F4"_hex, "06 00 0A 01 F4"_hex);
    ok = unit.registers.get<pump::actual>() == 50_Hz and unit.orders == 1 and ok;
    ok = unit.answers("06 00 0A FF 9C"_hex, "06 00 0A FF 9C"_hex) and ok; // -10.0 Hz
    ok = unit.registers.get<pump::actual>() == 0_Hz and unit.orders == 2 and ok;
    ok = unit.answers("06 00 0C 00 04"_hex, "06 00 0C 00 04"_hex) and unit.mode == pump::mode::on and ok;
    // The bank's limits come first: 60.1 Hz; a register that is only read.
    ok = unit.answers("06 00 0A 02 59"_hex, "86 03"_hex) and unit.answers("06 00 0B 00 01"_hex, "86 02"_hex) and ok;
    unit.is_empty = true;
    ok = unit.answers("06 00 0A 00 01"_hex, "86 04"_hex) and unit.answers("06 00 0A 02 59"_hex, "86 03"_hex) and ok;
    return ok and unit.orders == 2 and unit.registers.get<pump::setpoint>() == -10_Hz;
}
PROOF("a hook of a typed register gets its value, behind the bank's own limits", typed)

/// What a server says to a frame, and what is left of it.
constexpr bool is_silent_to(byte_view frame, pump_unit& unit)
{
    constexpr line_timing timing{19'200, character_format::even_8_1};
    server node{unit_id{3}, timing};
    auto bank = unit.served();
    instant now{0};
    node.advance(now);
    now = now + milliseconds(10);
    node.advance(now);
    node.receive(frame, now);
    node.serve(bank, now);
    now = now + milliseconds(10);
    node.advance(now);
    return node.poll_transmit().empty();
}

constexpr bool broadcasts()
{
    pump_unit unit;
    auto const slow = *encode(broadcast, write_single_register{.address = 10, .value = 100});
    auto const fast = *encode(broadcast, write_single_register{.address = 10, .value = 500});
    bool ok = is_silent_to(slow, unit) and unit.orders == 1 and unit.registers.get<pump::actual>() == 10_Hz;
    unit.is_empty = true;
    ok = is_silent_to(fast, unit) and unit.orders == 1 and ok;
    return ok and unit.registers.get<pump::setpoint>() == 10_Hz;
}
PROOF("a broadcast is checked and acted on, without a response", broadcasts)

constexpr bool program_side()
{
    pump_unit unit;
    unit.is_empty = true;
    [[maybe_unused]] auto const bank = unit.served();
    unit.registers.set<pump::setpoint>(20_Hz);
    return unit.orders == 0 and unit.registers.get<pump::setpoint>() == 20_Hz;
}
PROOF("what the program itself sets calls no hook", program_side)

/// A write that the bank fails to do: nothing acts on it.
constexpr bool failed_write()
{
    test::whole_bank bank;
    bank.fail(errc::server_device_failure);
    int acts = 0;
    auto served = with_hooks(bank).on_write(1, [&](std::uint16_t) { ++acts; });
    std::array<std::byte, max_pdu_size> place{};
    bool is_told = same_bytes(respond("06 00 01 00 05"_hex, served, server_profile{}, place), "86 04"_hex);
    return is_told and acts == 0;
}
PROOF("no action follows a write that failed", failed_write)

/// Hooks that change themselves, and one at the last address.
constexpr bool corners()
{
    word_bank<2> bank{65'534};
    std::uint16_t sum = 0;
    auto served = with_hooks(bank).on_write(65'535, [&sum, calls = 0](std::uint16_t now) mutable {
        ++calls;
        sum = static_cast<std::uint16_t>(sum + now * calls);
    });
    std::array<std::byte, max_pdu_size> place{};
    for (int i = 0; i < 2; ++i) {
        static_cast<void>(respond("10 FF FE 00 02 04 00 01 00 05"_hex, served, server_profile{}, place));
    }
    return sum == 15;
}
PROOF("an action may change itself, and the last address has hooks too", corners)

// A server finds the same functions behind hooks, each with the same response; a plain bank gets none by them.
using hooked_whole = decltype(with_hooks(std::declval<test::whole_bank&>()).on_write(1, [](std::uint16_t) {}));
using hooked_words = decltype(with_hooks(std::declval<word_bank<4>&>()));
static_assert(std::is_same_v<served_functions<hooked_whole>, served_functions<test::whole_bank>>);
static_assert(std::is_same_v<served_functions<hooked_words>, served_functions<word_bank<4>>>);

constexpr bool passes_on(byte_view pdu)
{
    test::whole_bank plain, behind;
    for (auto* each : {&plain, &behind}) {
        each->queued = 2;
        each->queue[1] = 0x1234;
        static_cast<void>(each->measured.set(2, 7));
        static_cast<void>(each->contacts.set(3, true));
    }
    auto served = with_hooks(behind).check(1, [](std::uint16_t) { return errc::illegal_data_value; });
    std::array<std::byte, max_pdu_size> left{}, right{};
    serial_diagnostics one, other;
    byte_view const wanted = respond<public_functions>(pdu, plain, server_profile{}, left, one);
    byte_view const told = respond<public_functions>(pdu, served, server_profile{}, right, other);
    return same_bytes(wanted, told) and not wanted.empty() and to_u8(wanted[0]) < 0x80 and
           plain.writes == behind.writes and plain.switched.get(3) == behind.switched.get(3);
}
STATIC_CHECK(passes_on("01 00 00 00 08"_hex) and passes_on("02 00 00 00 08"_hex));
STATIC_CHECK(passes_on("04 00 02 00 01"_hex) and passes_on("05 00 03 FF 00"_hex) and passes_on("07"_hex));
STATIC_CHECK(passes_on("11"_hex) and passes_on("14 07 06 00 01 00 00 00 02"_hex) and passes_on("18 00 64"_hex));
STATIC_CHECK(passes_on("15 09 06 00 02 00 07 00 01 12 34"_hex) and passes_on("0F 00 03 00 02 01 03"_hex));

struct bank_with_own : word_bank<4> {
    static constexpr std::optional<errc> respond(function_code function, pdu_buffer& pdu)
    {
        pdu.size = 1;
        return function == static_cast<function_code>(0x41) ? std::optional{errc::none} : std::nullopt;
    }
};
constexpr bool passes_own_functions_on()
{
    bank_with_own bank;
    auto served = with_hooks(bank);
    std::array<std::byte, max_pdu_size> place{};
    return same_bytes(respond("41 02"_hex, served, server_profile{}, place), "41"_hex);
}
PROOF("a function of the bank's own is still there behind hooks", passes_own_functions_on)

// Registers of several words: a hook gets the whole value, or none.
inline constexpr reg<float32<celsius>> limit{.code = "LIM", .address = 20};
inline constexpr reg<unsigned32<watt_hours, word_order::low_first>> budget{.code = "BUD", .address = 22};
inline constexpr reg<count16> next_one{.code = "NXT", .address = 24};

struct wide_unit {
    word_bank<8> plain{20};
    bank<limit, budget, next_one> typed{};
    std::uint32_t watt_hours_now{0};
    int acts{0};

    template <typename Bank> constexpr byte_view answer(Bank& bank, byte_view pdu)
    {
        auto served = with_hooks(bank)
                          .template check<limit>(
                              [](auto asked) { return asked.count() > 80 ? errc::illegal_data_value : errc::none; })
                          .template on_write<limit>([this](auto) { ++acts; })
                          .template on_write<budget>([this](auto now) { watt_hours_now = now.count(); });
        size = respond(pdu, served, server_profile{}, place).size();
        return byte_view{place}.first(size);
    }
    std::array<std::byte, max_pdu_size> place{};
    std::size_t size{0};
};

constexpr bool several_words()
{
    wide_unit unit;
    // 60.5 degrees are 42720000 hexadecimal, 90 are 42B40000.
    bool ok = same_bytes(unit.answer(unit.typed, "10 00 14 00 02 04 42 72 00 00"_hex), "10 00 14 00 02"_hex);
    ok =
        unit.acts == 1 and same_bytes(unit.answer(unit.typed, "10 00 14 00 02 04 42 B4 00 00"_hex), "90 03"_hex) and ok;
    ok = same_bytes(unit.answer(unit.typed, "10 00 16 00 02 04 56 78 12 34"_hex), "10 00 16 00 02"_hex) and ok;
    ok = unit.watt_hours_now == 0x1234'5678 and unit.acts == 1 and ok;
    // Half a register is the bank's exception 02; no number, its 03.
    ok = same_bytes(unit.answer(unit.typed, "06 00 14 42 B4"_hex), "86 02"_hex) and unit.acts == 1 and ok;
    return same_bytes(unit.answer(unit.typed, "10 00 14 00 02 04 7F C0 00 00"_hex), "90 03"_hex) and ok;
}
PROOF("a hook of a register of several words gets its whole value", several_words)

constexpr bool several_words_of_plain_ones()
{
    wide_unit unit;
    bool ok = same_bytes(unit.answer(unit.plain, "10 00 14 00 02 04 42 B4 00 00"_hex), "90 03"_hex);
    ok = same_bytes(unit.answer(unit.plain, "10 00 14 00 02 04 7F C0 00 00"_hex), "90 03"_hex) and ok; // no number
    // By halves, a value that the check refuses would be written without it: half a register is refused here, too,
    // whichever half, and by itself or beside other words.
    ok = same_bytes(unit.answer(unit.plain, "06 00 14 42 B4"_hex), "86 02"_hex) and unit.acts == 0 and ok;
    ok = same_bytes(unit.answer(unit.plain, "06 00 15 00 00"_hex), "86 02"_hex) and ok;
    ok = same_bytes(unit.answer(unit.plain, "10 00 13 00 02 04 00 07 42 B4"_hex), "90 02"_hex) and ok;
    ok = same_bytes(unit.answer(unit.plain, "10 00 15 00 02 04 00 00 12 34"_hex), "90 02"_hex) and ok;
    ok = same_bytes(unit.answer(unit.plain, "06 00 18 00 07"_hex), "06 00 18 00 07"_hex) and ok;
    return ok and same_bytes(unit.answer(unit.plain, "10 00 14 00 03 06 42 72 00 00 00 01"_hex), "90 02"_hex) and
           same_bytes(unit.answer(unit.plain, "10 00 14 00 02 04 42 72 00 00"_hex), "10 00 14 00 02"_hex) and
           unit.acts == 1;
}
PROOF("a bank of plain words may hold such a register, too", several_words_of_plain_ones)

constexpr bool acts_on_whole_values_only()
{
    word_bank<8> plain{20};
    int acts = 0;
    auto served = with_hooks(plain).on_write<limit>([&](real<celsius>) { ++acts; });
    std::array<std::byte, max_pdu_size> place{};
    auto const answer = [&](byte_view pdu) { return respond(pdu, served, server_profile{}, place); };
    bool ok =
        same_bytes(answer("06 00 14 42 B4"_hex), "86 02"_hex) and same_bytes(answer("06 00 15 00 00"_hex), "86 02"_hex);
    ok = same_bytes(answer("10 00 14 00 02 04 7F C0 00 00"_hex), "90 03"_hex) and plain.get(20) == 0 and acts == 0 and
         ok;
    return same_bytes(answer("10 00 14 00 02 04 42 B4 00 00"_hex), "10 00 14 00 02"_hex) and acts == 1 and ok;
}
PROOF("nothing is written that an action could not be told", acts_on_whole_values_only)

// Callables without state take no room beside the bank's address.
static_assert(sizeof(with_hooks(std::declval<word_bank<4>&>())) == sizeof(void*));
static_assert(sizeof(with_hooks(std::declval<bank<pump::how>&>()).on_write<pump::how>([](pump::mode) {})) ==
              sizeof(void*));

} // namespace
