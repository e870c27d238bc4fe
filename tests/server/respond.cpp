// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A server as a pure function: which answer to which request, and what changes.
#include <rtuwire/server/respond.hpp>

#include <array>

#include "support/proof.hpp"

#include <rtuwire/core/hex.hpp>

using namespace rtuwire;
using namespace rtuwire::detail;

namespace {

constexpr device_object objects[] = {
    {vendor_name, "Schneider Electric"}, {product_code, "ATV310H037N4"}, {major_minor_revision, "0201"}};
constexpr server_profile drive{.limits = {63, 61, 4, 4}, .identity = identity_of<objects>};
constexpr server_profile atv28_like{.functions = function_set{function_code::read_holding_registers,
                                                              function_code::write_single_register,
                                                              function_code::write_multiple_registers},
                                    .limits = {7, 7, 0, 0}};

/// Ten registers at 100, of which 105 holds 5555.
constexpr auto fresh()
{
    word_bank<10> bank{100};
    static_cast<void>(bank.set(105, 0x5555));
    return bank;
}

/// Whether a request PDU gets this response and leaves register 105 at a value.
template <std::size_t Asked, std::size_t Answered>
constexpr bool answers(server_profile const& profile, std::array<std::byte, Asked> const& request,
                       std::array<std::byte, Answered> const& expected, std::uint16_t register_105 = 0x5555)
{
    auto bank = fresh();
    std::array<std::byte, max_pdu_size> place{};
    bool const apart = same_bytes(respond(request, bank, profile, place), expected);
    bool const kept = bank.get(105) == register_105;
    // The same in the request's own place.
    auto other = fresh();
    byte_writer{place}.bytes(request);
    byte_view const asked = byte_view{place}.first(request.size());
    return apart and kept and same_bytes(respond(asked, other, profile, place), expected) and
           other.get(105) == register_105;
}

STATIC_CHECK(answers(drive, "03 00 69 00 02"_hex, "03 04 55 55 00 00"_hex));
STATIC_CHECK(answers(drive, "06 00 69 12 34"_hex, "06 00 69 12 34"_hex, 0x1234));
STATIC_CHECK(answers(drive, "10 00 68 00 02 04 00 01 12 34"_hex, "10 00 68 00 02"_hex, 0x1234));
// Writes first, then reads.
STATIC_CHECK(answers(drive, "17 00 69 00 01 00 68 00 02 04 00 01 12 34"_hex, "17 02 12 34"_hex, 0x1234));
STATIC_CHECK(answers(drive, "08 00 00 A5 37"_hex, "08 00 00 A5 37"_hex));

// 01 comes before 03, 03 before 02.
STATIC_CHECK(answers(drive, "04 00 69 00 01"_hex, "84 01"_hex));
STATIC_CHECK(answers(drive, "01 00 00 07 D1"_hex, "81 01"_hex));
STATIC_CHECK(answers(drive, "42"_hex, "C2 01"_hex));
STATIC_CHECK(answers(drive, "00"_hex, "80 01"_hex));
STATIC_CHECK(answers(drive, "03 FF FF 00 00"_hex, "83 03"_hex));
STATIC_CHECK(answers(drive, "03 FF FF 00 40"_hex, "83 03"_hex));
STATIC_CHECK(answers(drive, "03 FF FF 00 3F"_hex, "83 02"_hex));
STATIC_CHECK(answers(drive, "03"_hex, "83 03"_hex));
STATIC_CHECK(answers(drive, "03 00 63 00 01"_hex, "83 02"_hex));
STATIC_CHECK(answers(drive, "03 00 6D 00 02"_hex, "83 02"_hex));
STATIC_CHECK(answers(drive, "06 00 6E 12 34"_hex, "86 02"_hex));
STATIC_CHECK(answers(drive, "03 00 69 00 02 00"_hex, "83 03"_hex));
STATIC_CHECK(answers(drive, "06 00 69 12 34 00"_hex, "86 03"_hex));
STATIC_CHECK(answers(drive, "10 00 69 00 01 02 12 34 00"_hex, "90 03"_hex));
STATIC_CHECK(answers(drive, "17 00 69 00 01 00 69 00 01 02 12 34 00 00"_hex, "97 03"_hex));
STATIC_CHECK(answers(drive, "10 00 69 00 7B 06 00 01 00 02 00 03"_hex, "90 03"_hex));
STATIC_CHECK(answers(drive, "10 00 69 00 01 02 00 05 AA BB"_hex, "90 03"_hex));
STATIC_CHECK(answers(drive, "10 00 69 00 01 03 00 05 00"_hex, "90 03"_hex));
// Quantity, byte count and size agree, all three of them.
STATIC_CHECK(answers(drive, "10 00 69 00 01 03 12 34"_hex, "90 03"_hex));
STATIC_CHECK(answers(drive, "10 00 69 00 02 02 12 34"_hex, "90 03"_hex));
STATIC_CHECK(answers(drive, "10 00 69 01 01 02 12 34"_hex, "90 03"_hex));
STATIC_CHECK(answers(drive, "17 00 69 00 01 00 69 00 01 03 12 34"_hex, "97 03"_hex));
STATIC_CHECK(answers(drive, "17 00 69 00 01 00 69 01 01 02 12 34"_hex, "97 03"_hex));
STATIC_CHECK(answers(drive, "10 00 69 00 06 0C 00 01 00 02 00 03 00 04 00 05 00 06"_hex, "90 02"_hex));

// Both halves of function 23 are checked before anything is written.
STATIC_CHECK(answers(drive, "17 00 6D 00 02 00 69 00 01 02 12 34"_hex, "97 02"_hex));
STATIC_CHECK(answers(drive, "17 00 69 00 01 00 6E 00 01 02 12 34"_hex, "97 02"_hex));
STATIC_CHECK(answers(drive, "17 00 69 00 05 00 69 00 01 02 12 34"_hex, "97 03"_hex));
STATIC_CHECK(answers(drive, "17 00 69 00 01 00 69 00 05 0A 00 01 00 02 00 03 00 04 00 05"_hex, "97 03"_hex));
STATIC_CHECK(answers(drive, "17 00 69 00 01 00 69 00 01 02"_hex, "97 03"_hex));

/// Whether every beginning of a request is refused with exception 03, and writes nothing.
template <std::size_t Size> constexpr bool is_refused_when_cut(std::array<std::byte, Size> const& request)
{
    for (std::size_t size = 1; size < Size; ++size) {
        auto bank = fresh();
        std::array<std::byte, max_pdu_size> place{};
        byte_view const response = respond(byte_view{request}.first(size), bank, drive, place);
        bool const is_refusal =
            response.size() == 2 and response[0] == (request[0] | std::byte{0x80}) and response[1] == std::byte{3};
        if (not is_refusal or bank.get(105) != 0x5555) {
            return false;
        }
    }
    return true;
}
STATIC_CHECK(is_refused_when_cut("03 00 69 00 01"_hex));
STATIC_CHECK(is_refused_when_cut("06 00 69 12 34"_hex));
STATIC_CHECK(is_refused_when_cut("10 00 69 00 01 02 12 34"_hex));
STATIC_CHECK(is_refused_when_cut("17 00 69 00 01 00 69 00 01 02 12 34"_hex));

// A device with fewer functions and limits.
STATIC_CHECK(answers(atv28_like, "03 00 64 00 07"_hex, "03 0E 00 00 00 00 00 00 00 00 00 00 55 55 00 00"_hex));
STATIC_CHECK(answers(atv28_like, "03 00 64 00 08"_hex, "83 03"_hex));
STATIC_CHECK(answers(atv28_like, "17 00 69 00 01 00 69 00 01 02 12 34"_hex, "97 01"_hex));
STATIC_CHECK(answers(atv28_like, "2B 0E 01 00"_hex, "AB 01"_hex));
STATIC_CHECK(answers(server_profile{}, "2B 0E 01 00"_hex, "AB 01"_hex));

// Diagnostics: only the loop-back.
STATIC_CHECK(answers(drive, "08 00 01 00 00"_hex, "88 01"_hex));
STATIC_CHECK(answers(drive, "08 00 01"_hex, "88 01"_hex));
STATIC_CHECK(answers(drive, "08 00 00 A5"_hex, "88 03"_hex));
STATIC_CHECK(answers(drive, "08"_hex, "88 03"_hex));

constexpr bool answers_up_to_253_bytes()
{
    auto bank = fresh();
    std::array<std::byte, max_pdu_size + 1> request{std::byte{8}};
    std::array<std::byte, max_pdu_size> place{};
    byte_view const largest = byte_view{request}.first(max_pdu_size);
    return same_bytes(respond(largest, bank, drive, place), largest) and respond(request, bank, drive, place).empty();
}
PROOF("the largest PDU is answered, a larger one is none", answers_up_to_253_bytes)

constexpr bool never_answers()
{
    auto bank = fresh();
    std::array<std::byte, max_pdu_size> place{};
    return respond("83 02"_hex, bank, drive, place).empty() and respond("80"_hex, bank, drive, place).empty() and
           respond(byte_view{}, bank, drive, place).empty() and
           respond("03 00 69 00 02"_hex, bank, drive, byte_span{place}.first(8)).empty();
}
PROOF("there is no response to a response, to nothing, or without room for one", never_answers)

/// A bank whose registers cannot be reached.
struct broken_bank {
    static constexpr errc check_read(std::uint16_t, std::size_t) { return errc::none; }
    static constexpr errc check_write(std::uint16_t, register_view) { return errc::none; }
    static constexpr errc read(std::uint16_t, std::size_t, byte_writer&) { return errc::device_failed; }
    static constexpr errc write(std::uint16_t, register_view) { return errc::server_device_failure; }
};

constexpr bool failure_is_04()
{
    broken_bank bank;
    std::array<std::byte, max_pdu_size> place{};
    return same_bytes(respond("03 00 69 00 02"_hex, bank, drive, place), "83 04"_hex) and
           same_bytes(respond("06 00 69 00 02"_hex, bank, drive, place), "86 04"_hex);
}
PROOF("a bank that fails is exception 04", failure_is_04)

/// A bank that stands for another unit, whose exception had a code that no document has.
struct far_bank : broken_bank {
    static constexpr errc read(std::uint16_t, std::size_t, byte_writer&) { return exception_error(0x80); }
};

constexpr bool sends_no_unlisted_code()
{
    far_bank bank;
    std::array<std::byte, max_pdu_size> place{};
    return same_bytes(respond("03 00 69 00 02"_hex, bank, drive, place), "83 04"_hex);
}
PROOF("the stand-in for unlisted codes does not leave as a code", sends_no_unlisted_code)

template <std::size_t Size> constexpr std::uint16_t after_broadcast(std::array<std::byte, Size> const& request)
{
    auto bank = fresh();
    std::array<std::byte, max_pdu_size> place{};
    if (request_head{static_cast<function_code>(to_u8(request[0])), true}.has_effect<register_functions>()) {
        static_cast<void>(respond(request, bank, drive, place));
    }
    return bank.get(105);
}
STATIC_CHECK(after_broadcast("06 00 69 12 34"_hex) == 0x1234);
STATIC_CHECK(after_broadcast("10 00 69 00 01 02 12 34"_hex) == 0x1234);
STATIC_CHECK(after_broadcast("17 00 69 00 01 00 69 00 01 02 12 34"_hex) == 0x5555);
STATIC_CHECK(after_broadcast("10 00 69 00 02 02 12 34"_hex) == 0x5555);

} // namespace
