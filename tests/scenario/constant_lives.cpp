// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Lives of a server, of a client and of both on one line, as constant expressions: Clang, which evaluates them, refuses
// what sanitizers do not see, such as an address behind an array that nobody reads. Requests and responses of every
// public function, whole and damaged.
#include <rtuwire/rtuwire.hpp>

#include <array>

#include "support/proof.hpp"
#include "support/random.hpp"
#include "support/whole_bank.hpp"

using namespace rtuwire;
using namespace rtuwire::detail;

namespace {

constexpr line_timing line{19'200, character_format::even_8_1};
constexpr unit_id unit{2};
constexpr device_object objects[] = {{0, "vendor"}, {1, "code"}, {2, "0100"}, {0x80, "more"}};
constexpr server_profile profile{.identity = identity_of<objects>};

/// Requests of all functions that `long_bank` answers, one behind the other, each behind its size.
constexpr auto requests =
    "05 01 00 03 00 13  05 02 00 05 00 0B  05 03 00 01 00 0F  05 04 00 00 00 08  05 05 00 03 FF 00"
    "05 06 00 04 12 34  01 07  05 08 00 00 A5 37  07 08 00 00 A5 37 00 01  05 08 00 0B 00 00"
    "05 08 00 0A 00 00  01 0B  01 0C  08 0F 00 02 00 0A 02 CD 01  0A 10 00 01 00 02 04 00 0A 01 02"
    "01 11  09 14 07 06 00 01 00 00 00 79  10 14 0E 06 00 01 00 00 00 3C 06 00 02 00 00 00 3C"
    "17 14 15 06 00 01 00 00 00 02 06 00 02 00 05 00 70 06 00 03 00 05 00 01"
    "0B 15 09 06 00 04 00 07 00 01 AF 04"
    "16 15 14 06 00 01 00 00 00 02 12 34 56 78 06 00 02 00 07 00 01 9A BC"
    "07 16 00 04 00 F2 00 25  0E 17 00 03 00 06 00 0E 00 02 04 00 FF 00 FF  03 18 00 64  04 2B 0E 01 00"
    "04 2B 0E 03 00  04 2B 0E 04 80"_hex;

/// Every part of a PDU that a bank has to answer.
struct long_bank : test::whole_bank {
    static constexpr errc check_read_file(file_run) { return errc::none; }
    static constexpr errc read_file(file_run run, byte_writer& out)
    {
        for (std::uint32_t i = 0; i < run.count; ++i) {
            out.u16(run.record + i);
        }
        return errc::none;
    }
    static constexpr errc check_write_file(file_run, register_view) { return errc::none; }
    std::uint32_t sum{0};
    constexpr errc write_file(file_run, register_view values)
    {
        for (std::size_t i = 0; i < values.size(); ++i) {
            sum += values[i];
        }
        return errc::none;
    }
};

/// One of them; the last is followed by the first.
constexpr byte_view request_at(std::uint32_t index)
{
    byte_view rest{requests};
    for (; index > 0; --index) {
        rest = rest.subspan(1U + to_u8(rest[0]));
        rest = rest.empty() ? byte_view{requests} : rest;
    }
    return rest.subspan(1, to_u8(rest[0]));
}

/// A PDU, of three every one damaged: some of its bytes are others, it is cut, or goes on.
struct maybe_damaged {
    std::array<std::byte, max_pdu_size> memory{};
    std::size_t size;

    constexpr maybe_damaged(byte_view whole, test::random& random) : size{whole.size()}
    {
        byte_writer{memory}.bytes(whole);
        if (random.below(3) == 0) {
            for (std::uint32_t count = random.below(4); count > 0; --count) {
                auto const at = 1 + random.below(static_cast<std::uint32_t>(size + 8));
                std::uint32_t const most[] = {2, 9, 0x80, 0x100};
                memory[at % max_pdu_size] = to_byte(random.below(most[random.below(4)]));
            }
            std::size_t const sizes[] = {size, 1 + random.below(static_cast<std::uint32_t>(size)), size + 1, size + 9};
            size = sizes[random.below(4)];
            size = size < max_pdu_size ? size : max_pdu_size;
        }
    }
    [[nodiscard]] constexpr byte_view bytes() const { return byte_view{memory}.first(size); }
};

/// Whether the type of a response agrees with what a client let pass, of any function.
template <typename... Functions> constexpr bool is_decoded(function_list<Functions...>, response const& heard)
{
    auto const is_whole = [&]<typename Function>(std::type_identity<Function>) {
        if (to_u8(heard.pdu()[0]) != to_u8(Function::code)) {
            return true;
        }
        auto const read = heard.template to<Function>();
        return not read or (read->check() == errc::none and read->size() == heard.pdu().size());
    };
    return (is_whole(std::type_identity<Functions>{}) and ...);
}

/// A client and a unit in virtual time; of three frames every one is damaged, with the CRC that belongs to it.
struct life {
    host_client link{line, client_options{.retries = 1}}; // with room for the longest of both
    counting_server::with<public_functions> node{unit, line, profile};
    long_bank bank{};
    test::random random;
    instant now{0xFFFF'FFFFU - 5'000'000U};
    unsigned answered{0};

    explicit constexpr life(std::uint32_t seed) : random{seed} { bank.queued = seed % bank.queue.size(); }

    /// Hands a frame over in two chunks.
    template <typename End> constexpr void carry(byte_view frame, End& to)
    {
        std::size_t const first = 1 + random.below(static_cast<std::uint32_t>(frame.size() - 1));
        now = now + line.characters(first);
        to.receive(frame.first(first), now);
        now = now + line.characters(frame.size() - first);
        to.receive(frame.subspan(first), now);
    }

    constexpr void pass()
    {
        link.advance(now);
        node.advance(now);
        node.serve(bank, now);
        if (byte_view const asked = link.poll_transmit(); not asked.empty()) {
            carry(asked, node);
            link.sent(now);
        }
        if (byte_view const given = node.poll_transmit(); not given.empty()) {
            std::array<std::byte, max_adu_size> memory{};
            maybe_damaged const told{pdu_of(given), random};
            auto const frame =
                encode_into(memory, unit, raw_pdu{function_code{to_u8(told.bytes()[0])}, told.bytes().subspan(1)});
            carry(frame ? byte_view{*frame} : given, link);
            node.sent(now);
        }
    }

    /// Whether what the client makes of one request has the function and, as its type, the size of its bytes.
    constexpr bool exchange(std::uint32_t index)
    {
        maybe_damaged const asked{request_at(index), random};
        single_request conversation{unit, raw_pdu{function_code{to_u8(asked.bytes()[0])}, asked.bytes().subspan(1)}};
        for (unsigned step = 0; step < 40 and not conversation.settled(); ++step) {
            pass();
            link.converse(conversation, now);
            now = now + (step % 4 == 3 ? milliseconds(300) : microseconds(2'500));
        }
        auto const heard = conversation.outcome();
        answered += heard ? 1U : 0U;
        return not heard or
               (heard->pdu()[0] == asked.bytes()[0] and is_decoded(public_functions{}, response{heard->pdu()}));
    }
};

/// Lives that go through the requests one after the other, each short enough for a compiler's usual limit.
template <std::uint32_t Seed> constexpr bool lives()
{
    constexpr std::uint32_t exchanges = 24;
    life both{Seed};
    bool holds = true;
    for (std::uint32_t i = 0; i < exchanges; ++i) {
        holds = both.exchange(exchanges * Seed + i) and holds;
    }
    return holds and both.answered > exchanges / 2;
}
PROOF("a life of client and server is a constant, 1", lives<1>)
PROOF("a life of client and server is a constant, 2", lives<2>)
PROOF("a life of client and server is a constant, 3", lives<3>)
PROOF("a life of client and server is a constant, 4", lives<4>)

} // namespace
