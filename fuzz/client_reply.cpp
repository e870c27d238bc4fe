// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Any bytes as the response to any request of any function, at once: what is accepted has the unit, function, length and
// echo of the request and a right CRC.
//
// The first byte chooses the function by its place in the list, and whether the client is one for hosts (40) and the
// response gets the CRC that belongs to it (80); the second one tells how many bytes of the request follow behind its
// code. The rest is the response.
#include <concepts>

#include <rtuwire/rtuwire.hpp>

#include "input.hpp"

#include "../tests/support/asking.hpp"

using namespace rtuwire;
using namespace rtuwire::detail;
using fuzz::require;

namespace {

constexpr unit_id unit{1};
constexpr std::uint8_t is_of_host = 0x40, has_crc = 0x80;

/// Whether a whole frame of the unit with this PDU was heard. Others may have come before it.
bool was_heard(byte_view heard, byte_view pdu)
{
    std::size_t const size = pdu.size() + adu_overhead;
    for (; heard.size() >= size; heard = heard.subspan(1)) {
        bool const is_it = heard[0] == std::byte{1} and same_bytes(heard.subspan(1, pdu.size()), pdu);
        if (is_it and crc16(heard.first(size)) == 0) {
            return true;
        }
    }
    return false;
}

/// How many bytes a response to a request has that repeat it.
std::size_t repeated(byte_view asked)
{
    switch (to_u8(asked[0])) {
    case 5:
    case 6:
    case 15:
    case 16: return 5;
    case 21:
    case 22: return asked.size();
    case 8: {
        std::uint16_t const what = u16_at(asked, 1);
        bool const is_whole = what <= 0x0A and what != 0x02 and (what < 0x04 or what == 0x0A);
        return is_whole or what == 0x14 ? asked.size() : 3;
    }
    default: return 1;
    }
}

/// Whether a response has the size that its function gives it (AP 6).
bool is_size_right(byte_view asked, byte_view pdu)
{
    auto const is_counted = [&](std::size_t bytes) { return pdu.size() == 2 + bytes and to_u8(pdu[1]) == bytes; };
    switch (to_u8(asked[0])) {
    case 1:
    case 2: return is_counted((u16_at(asked, 3) + 7U) / 8);
    case 3:
    case 4:
    case 23: return is_counted(std::size_t{2} * u16_at(asked, 3));
    case 5:
    case 6:
    case 11:
    case 15:
    case 16: return pdu.size() == 5;
    case 7: return pdu.size() == 2;
    case 8:
    case 21:
    case 22: return pdu.size() == asked.size();
    case 12:
    case 17:
    case 20: return pdu.size() >= 2 and is_counted(pdu.size() - 2);
    case 24: return pdu.size() >= 3 and pdu.size() == 3U + u16_at(pdu, 1);
    case 43: return pdu.size() > 7 and same_bytes(pdu.first(3), asked.first(3));
    default: return true;
    }
}

/// A decoder refuses what the client let pass, or finds in it what has its size.
template <typename Function> void check_decoder(byte_view pdu)
{
    if (auto const told = response{pdu}.to<Function>()) {
        require(told->check() == errc::none and told->size() == pdu.size());
    }
}

/// What a client of this type makes of the answer to a request.
template <typename Client, typename Function> void ask(byte_view asked, byte_view heard)
{
    test::asking<Client> link{line_timing{19'200, character_format::even_8_1}, {.retries = 0}};
    instant now{0};
    link.advance(now);
    now = now + milliseconds(10);
    link.advance(now);
    auto const taken = link.start(request_frame{asked}, now);
    if (not taken) {
        // The memory of a board's client holds a long request and a long response one at a time.
        return require(taken.error() == errc::buffer_too_small and not std::same_as<Client, host_client>);
    }
    require(same_bytes(link.poll_transmit(), asked));
    link.sent(now);
    link.receive(heard, now + milliseconds(200));
    now = now + milliseconds(300);
    link.advance(now);
    now = now + milliseconds(10'000);
    link.advance(now);
    auto const outcome = link.poll_outcome();
    if (outcome and *outcome) {
        byte_view const asked_pdu = pdu_of(asked);
        byte_view const pdu = (*outcome)->pdu();
        std::size_t const same = repeated(asked_pdu);
        require(was_heard(heard, pdu) and is_size_right(asked_pdu, pdu));
        require(pdu.size() >= same and same_bytes(pdu.first(same), asked_pdu.first(same)));
        check_decoder<Function>(pdu);
    }
}

template <typename Function> void ask(fuzz::input& in, std::uint8_t choice)
{
    std::array<std::byte, max_pdu_size> pdu{static_cast<std::byte>(Function::code)};
    byte_view const fields = in.some(in.u8());
    if (fields.size() >= pdu.size()) {
        return;
    }
    for (std::size_t i = 0; i < fields.size(); ++i) {
        pdu[1 + i] = fields[i];
    }
    auto const value = Function::decode(byte_view{pdu}.first(1 + fields.size()));
    if (not value) {
        return;
    }
    auto const made = encode(unit, *value);
    if (not made) {
        return;
    }
    auto const frame = *made;
    fuzz::frame const heard{in.some(max_adu_size + 8), (choice & has_crc) != 0};
    if ((choice & is_of_host) != 0) {
        ask<host_client, Function>(frame, heard.view());
    } else {
        ask<client, Function>(frame, heard.view());
    }
}

template <typename... Functions> void ask_one(function_list<Functions...>, fuzz::input& in)
{
    std::uint8_t const choice = in.u8();
    std::size_t left = choice % is_of_host % sizeof...(Functions);
    ((left-- == 0 ? ask<Functions>(in, choice) : static_cast<void>(0)), ...);
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(std::uint8_t const* data, std::size_t size)
{
    fuzz::input in{data, size};
    ask_one(public_functions{}, in);
    return 0;
}
