// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// The functions of a server beside those of registers: which exception to which request, in the specification's order
// (function, quantity, address, execution), and that nothing is written in part.
#include <rtuwire/server/respond.hpp>

#include <array>

#include "support/catch.hpp"
#include "support/fact.hpp"
#include "support/whole_bank.hpp"

#include <rtuwire/core/hex.hpp>

using namespace rtuwire;
using namespace rtuwire::detail;
using rtuwire::test::whole_bank;

namespace {

whole_bank fresh()
{
    whole_bank bank;
    static_cast<void>(bank.words.set(4, 0x0012));
    static_cast<void>(bank.switched.set(3, true));
    bank.files[0] = {1, 2, 3, 4, 5, 6, 7, 8};
    bank.files[1] = bank.files[0];
    return bank;
}

bool is_as_before(whole_bank const& bank)
{
    whole_bank const before = fresh();
    bool is_same = bank.files == before.files;
    for (std::uint16_t i = 0; i < 64; ++i) {
        is_same = is_same and bank.switched.get(i) == before.switched.get(i);
    }
    for (std::uint16_t i = 0; i < 16; ++i) {
        is_same = is_same and bank.words.get(i) == before.words.get(i);
    }
    return is_same;
}

/// The exception to a request of a bank, and 0 for a normal response; 0xFF where it was refused and changed something.
template <typename Functions = public_functions>
unsigned exception_of(whole_bank& bank, byte_view asked, server_profile const& profile = {})
{
    serial_diagnostics line;
    std::array<std::byte, max_pdu_size> place{};
    byte_view const told = respond<Functions>(asked, bank, profile, place, line);
    if (told.size() != 2 or told[0] != (asked[0] | std::byte{0x80})) {
        return 0;
    }
    return is_as_before(bank) ? to_u8(told[1]) : 0xFFU;
}

/// Function 65, which nobody has.
struct doubling {
    static constexpr function_code code = static_cast<function_code>(65);
    [[maybe_unused]] static constexpr frame_rules rules{sized(length_rule::fixed, 6), sized(length_rule::fixed, 6),
                                                        answer_rule::own};

    template <typename Memory, typename Server> static constexpr errc respond(Memory& pdu, Server const&) noexcept
    {
        put_u16(&pdu.bytes[1], static_cast<std::uint16_t>(2U * u16_at(pdu.view(), 1)));
        return errc::none;
    }
};

template <std::size_t Size> unsigned exception_to(std::array<std::byte, Size> const& asked)
{
    whole_bank bank = fresh();
    return exception_of(bank, asked);
}

/// Whether a good request of a function is answered; is refused by a server without it (01), with a byte more or less
/// (03), and by a bank that fails (04, or whatever it says).
template <std::size_t Size> bool is_checked(std::array<std::byte, Size> const& good, bool can_fail = true)
{
    std::array<std::byte, Size + 1> longer{};
    byte_writer{longer}.bytes(good);
    auto bank = fresh();
    auto other = fresh();
    auto failing = fresh();
    auto busy = fresh();
    auto odd = fresh();
    failing.fail(errc::server_device_failure);
    busy.fail(errc::server_device_busy);
    odd.fail(errc::device_failed);
    server_profile const without{.functions = function_set{function_code::read_holding_registers}};
    using test::is;
    return is(exception_of(bank, good) == 0, "the good one") and
           is(exception_of<register_functions>(other, good) == 1, "a server without the function") and
           is(exception_of(other, good, without) == 1, "a profile without it") and
           is(exception_of(other, longer) == 3, "a byte more") and
           is(Size == 1 or exception_of(other, byte_view{good}.first(Size - 1)) == 3, "a byte less") and
           is(not can_fail or exception_of(failing, good) == 4, "a failure") and
           is(not can_fail or exception_of(busy, good) == 6, "busy") and
           is(not can_fail or exception_of(odd, good) == 4, "an error without a code");
}

/// Its registers are half there.
struct half_bank : whole_bank {
    constexpr errc read(std::uint16_t, std::size_t, byte_writer& out)
    {
        out.u8(0x12);
        return errc::none;
    }
    constexpr errc read_fifo(std::uint16_t, byte_writer& out) const
    {
        out.u8(0x12);
        return errc::none;
    }
    constexpr errc read_file(file_run, byte_writer&) const { return errc::none; }
};

} // namespace

TEST_CASE("every function is refused where it is not there, is not whole, or fails")
{
    CHECK(is_checked("01 00 00 00 40"_hex));
    CHECK(is_checked("02 00 00 00 20"_hex));
    CHECK(is_checked("04 00 00 00 08"_hex, false));
    CHECK(is_checked("05 00 3F FF 00"_hex));
    CHECK(is_checked("07"_hex, false));
    CHECK(is_checked("0B"_hex, false));
    CHECK(is_checked("0C"_hex, false));
    CHECK(is_checked("0F 00 00 00 40 08 01 02 03 04 05 06 07 08"_hex));
    CHECK(is_checked("11"_hex, false));
    CHECK(is_checked("14 07 06 00 01 00 00 00 08"_hex));
    CHECK(is_checked("15 09 06 00 02 00 07 00 01 12 34"_hex));
    CHECK(is_checked("16 00 0F 00 F2 00 25"_hex));
    CHECK(is_checked("18 00 64"_hex));
}

TEST_CASE("each run of a request is written")
{
    whole_bank bank = fresh();
    CHECK(exception_of(bank, "15 14 06 00 01 00 00 00 02 12 34 56 78 06 00 02 00 07 00 01 9A BC"_hex) == 0);
    CHECK((bank.files[0][0] == 0x1234 and bank.files[0][1] == 0x5678 and bank.files[0][2] == 3));
    CHECK((bank.files[1][6] == 7 and bank.files[1][7] == 0x9ABC));
    CHECK(bank.writes == 2);
}

TEST_CASE("the quantity or value comes before the address")
{
    // Bits: the quantity comes before the address.
    CHECK(exception_to("01 FF FF 00 00"_hex) == 3);
    CHECK(exception_to("01 FF FF 07 D1"_hex) == 3);
    CHECK(exception_to("01 FF FF 07 D0"_hex) == 2);
    CHECK(exception_to("01 00 00 00 41"_hex) == 2);
    CHECK(exception_to("01 00 3F 00 02"_hex) == 2);
    CHECK(exception_to("01 00 3F 00 01"_hex) == 0);
    CHECK(exception_to("02 FF FF 00 00"_hex) == 3);
    CHECK(exception_to("02 FF FF 07 D1"_hex) == 3);
    CHECK(exception_to("02 00 00 00 21"_hex) == 2);
    CHECK(exception_to("02 FF FF 00 01"_hex) == 2);
    CHECK(exception_to("04 FF FF 00 00"_hex) == 3);
    CHECK(exception_to("04 FF FF 00 7E"_hex) == 3);
    CHECK(exception_to("04 00 00 00 09"_hex) == 2);
    CHECK(exception_to("04 FF FF 00 7D"_hex) == 2);
    CHECK(exception_to("05 FF FF 12 34"_hex) == 3);
    CHECK(exception_to("05 FF FF 00 FF"_hex) == 3);
    CHECK(exception_to("05 00 40 FF 00"_hex) == 2);
    CHECK(exception_to("05 FF FF 00 00"_hex) == 2);
    CHECK(exception_to("0F FF FF 00 00 00"_hex) == 3);
    CHECK(exception_to("0F FF FF 00 09 01 FF"_hex) == 3);
    CHECK(exception_to("0F FF FF 00 08 02 FF FF"_hex) == 3);
    CHECK(exception_to("0F 00 39 00 08 01 FF"_hex) == 2);
    CHECK(exception_to("0F FF FF 00 01 01 FF"_hex) == 2);
    CHECK(exception_to("16 00 10 00 F2 00 25"_hex) == 2);
    CHECK(exception_to("18 00 65"_hex) == 2);
}

TEST_CASE("of files, the byte count comes before each reference, file and record")
{
    // Files: the byte count, then each reference, file and record (the diagrams of AP 6.14 and 6.15).
    CHECK(exception_to("14 00"_hex) == 3);
    CHECK(exception_to("14 06 06 00 01 00 00 00"_hex) == 3);
    CHECK(exception_to("14 07 07 00 01 00 00 00 01"_hex) == 2);
    CHECK(exception_to("14 07 06 00 00 00 00 00 01"_hex) == 2);
    CHECK(exception_to("14 07 06 00 03 00 00 00 01"_hex) == 2);
    CHECK(exception_to("14 07 06 00 01 00 08 00 01"_hex) == 2);
    CHECK(exception_to("14 07 06 00 01 27 10 00 01"_hex) == 2);
    CHECK(exception_to("14 07 06 00 01 00 00 00 00"_hex) == 3);
    CHECK(exception_to("14 07 06 00 01 00 00 00 7A"_hex) == 3); // more than a response carries
    CHECK(exception_to("14 0E 06 00 01 00 00 00 01 06 00 03 00 00 00 01"_hex) == 2);
    CHECK(exception_to("15 00"_hex) == 3);
    CHECK(exception_to("15 0A 06 00 01 00 00 00 01 12 34 06"_hex) == 3);
    CHECK(exception_to("15 09 06 00 01 00 00 00 02 12 34"_hex) == 3);
    CHECK(exception_to("15 09 07 00 01 00 00 00 01 12 34"_hex) == 2);
    CHECK(exception_to("15 09 06 00 00 00 00 00 01 12 34"_hex) == 2);
    CHECK(exception_to("15 09 06 00 01 27 10 00 01 12 34"_hex) == 2);
    // Of several runs the first that is wrong decides, whatever is wrong with it.
    CHECK(exception_to("14 0E 06 00 01 00 00 00 00 06 00 00 00 00 00 01"_hex) == 3);
    CHECK(exception_to("14 0E 06 00 00 00 00 00 01 06 00 01 00 00 00 00"_hex) == 2);
    CHECK(exception_to("15 10 06 00 01 00 00 00 00 06 00 00 00 00 00 01 12 34"_hex) == 3);
    CHECK(exception_to("15 10 06 00 00 00 00 00 01 12 34 06 00 01 00 00 00 00"_hex) == 2);
    // Of several runs none is written where one is refused.
    CHECK(exception_to("15 12 06 00 01 00 00 00 01 12 34 06 00 03 00 00 00 01 12 34"_hex) == 2);
    CHECK(exception_to("15 12 06 00 01 00 00 00 01 12 34 06 00 02 00 08 00 01 12 34"_hex) == 2);
    CHECK(exception_to("15 12 06 00 01 00 00 00 01 12 34 07 00 02 00 07 00 01 12 34"_hex) == 2);
    CHECK(exception_to("15 12 06 00 01 00 00 00 01 12 34 06 00 02 00 07 00 01 56 78"_hex) == 0);
}

TEST_CASE("a request of function 20 has as many runs as fit a PDU")
{
    std::array<std::byte, max_pdu_size> asked{std::byte{0x14}};
    byte_writer out{byte_span{asked}.subspan(2)};
    while (out.ok()) {
        write_run(out, {1, 0, 1});
    }
    for (std::size_t size = 0; size <= asked.size() - 2; ++size) {
        CAPTURE(size);
        asked[1] = to_byte(static_cast<std::uint32_t>(size));
        whole_bank bank = fresh();
        CHECK(exception_of(bank, byte_view{asked}.first(2 + size)) == (size > 0 and size % 7 == 0 ? 0U : 3U));
    }
}

TEST_CASE("a function that a server has not is exception 01 at any size")
{
    whole_bank bank = fresh();
    using only_coils = function_list<read_coils>;
    CHECK(exception_of<only_coils>(bank, "01 00 00 00 01"_hex) == 0);
    CHECK(exception_of<only_coils>(bank, "01 00 00 00"_hex) == 3);
    for (std::size_t size = 1; size <= 6; ++size) {
        CHECK(exception_of<only_coils>(bank, byte_view{"05 00 00 00 01 00"_hex}.first(size)) == 1);
        CHECK(exception_of<only_coils>(bank, byte_view{"03 00 00 00 01 00"_hex}.first(size)) == 1);
    }
}

TEST_CASE("a function of a list that is not public needs no entry of a profile, and takes none from the public ones")
{
    whole_bank bank = fresh();
    using with_one_more = function_list<read_coils, doubling>;
    CHECK(exception_of<with_one_more>(bank, "41 00 04"_hex) == 0);
    CHECK(exception_of<with_one_more>(bank, "01 00 00 00 01"_hex) == 0);
    CHECK(exception_of<with_one_more>(bank, "01 00 00 00 01"_hex, {.functions = function_set{}}) == 1);
    CHECK(exception_of<function_list<read_coils>>(bank, "41 00 04"_hex) == 1);
}

TEST_CASE("a server of input registers, files or coils alone needs nothing else of its bank")
{
    struct inputs_only {
        word_bank<4> words{};
        word_bank<4>& input_registers() { return words; }
    } inputs;
    static_cast<void>(inputs.words.set(1, 0x1234));
    struct file_only {
        static errc check_write_file(file_run run, register_view values)
        {
            return run.file == 4 and values.size() == run.count ? errc::none : errc::illegal_data_address;
        }
        errc write_file(file_run, register_view values)
        {
            word = values[0];
            return errc::none;
        }
        std::uint16_t word{0};
    } file;
    std::array<std::byte, max_pdu_size> place{};
    loopback_only line;
    auto const ask = [&]<typename... Functions>(function_list<Functions...> functions, byte_view asked, auto& bank) {
        return respond<decltype(functions)>(asked, bank, server_profile{}, place, line);
    };
    using of_inputs = function_list<read_input_registers>;
    using of_files = function_list<write_file_record<>>;
    CHECK(same_bytes(ask(of_inputs{}, "04 00 01 00 01"_hex, inputs), "04 02 12 34"_hex));
    CHECK(same_bytes(ask(of_inputs{}, "04 00 01 00 04"_hex, inputs), "84 02"_hex));
    CHECK(same_bytes(ask(of_inputs{}, "03 00 01 00 01"_hex, inputs), "83 01"_hex));
    CHECK(same_bytes(ask(of_files{}, "15 09 06 00 04 00 00 00 01 56 78"_hex, file),
                     "15 09 06 00 04 00 00 00 01 56 78"_hex));
    CHECK(file.word == 0x5678);
    CHECK(same_bytes(ask(of_files{}, "14 07 06 00 04 00 00 00 01"_hex, file), "94 01"_hex));
}

TEST_CASE("a queue of more than 31 registers is exception 03, an identifier that does not fit 04")
{
    whole_bank bank = fresh();
    bank.queued = 31;
    CHECK(exception_of(bank, "18 00 64"_hex) == 0);
    bank.queued = 32;
    CHECK(exception_of(bank, "18 00 64"_hex) == 3);
    struct long_id {
        std::array<std::byte, 252> bytes{};
        std::size_t size{251};
        [[nodiscard]] byte_view server_id() const { return byte_view{bytes}.first(size); }
    } unit;
    std::array<std::byte, max_pdu_size> place{};
    auto const identify = [&] {
        constexpr auto asked = "11"_hex;
        return respond<function_list<report_server_id>>(asked, unit, server_profile{}, place);
    };
    CHECK(identify().size() == 253);
    unit.size = 252;
    CHECK(same_bytes(identify(), "91 04"_hex));
}

TEST_CASE("a bank that gives less than it was asked for is exception 04, and nothing is written")
{
    half_bank bank;
    std::array<std::byte, max_pdu_size> place{};
    serial_diagnostics line;
    auto const is_refused = [&](byte_view asked) {
        byte_view const told = respond<public_functions>(asked, bank, server_profile{}, place, line);
        return told.size() == 2 and told[1] == std::byte{4} and bank.writes == 0;
    };
    CHECK(is_refused("16 00 04 00 F2 00 25"_hex));
    CHECK(is_refused("18 00 64"_hex));
    CHECK(is_refused("14 07 06 00 01 00 00 00 01"_hex));
}

TEST_CASE("what is left of the last byte of a response is 0")
{
    whole_bank bank;
    for (std::uint16_t i = 0; i < 64; ++i) {
        REQUIRE(bank.switched.set(i, true));
    }
    std::array<std::byte, max_pdu_size> place{};
    place.fill(std::byte{0xFF});
    serial_diagnostics line;
    CHECK(same_bytes(respond<public_functions>("01 00 05 00 0B"_hex, bank, server_profile{}, place, line),
                     "01 02 FF 07"_hex));
}
