// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A whole transaction as a constant expression: request bytes, server, answer bytes, decoded value,
// for each function; and many at run time in random chunks.
#include <rtuwire/rtuwire.hpp>

#include <array>

#include "support/proof.hpp"
#include "support/random.hpp"

using namespace rtuwire;
using namespace rtuwire::detail;

namespace {

constexpr line_timing line{19'200, character_format::even_8_1};
constexpr device_object objects[] = {{0, "Schneider Electric"}, {1, "ATV310H037N"}, {2, "0201"}};
constexpr server_profile profile{.identity = identity_of<objects>};

/// A client and unit 2 on one perfect line in virtual time.
struct line_of_two {
    client link{line};
    server node{unit_id{2}, line, profile};
    word_bank<64> bank{3100};
    instant now{0xFFFF'FFFFU - 50'000U};
    test::random chunks{1};
    std::array<std::byte, max_pdu_size> received{};

    template <typename End> constexpr void carry(byte_view bytes, End& to)
    {
        while (not bytes.empty()) {
            std::size_t const size = 1 + chunks.below(static_cast<std::uint32_t>(bytes.size()));
            now = now + line.characters(size);
            to.receive(bytes.first(size), now);
            bytes = bytes.subspan(size);
        }
    }

    template <conversation Conversation> constexpr void run(Conversation& conversation)
    {
        for (unsigned step = 0; step < 200 and not conversation.settled(); ++step) {
            link.advance(now);
            node.advance(now);
            node.serve(bank, now);
            link.converse(conversation, now);
            if (byte_view const asked = link.poll_transmit(); not asked.empty()) {
                carry(asked, node);
                link.sent(now);
            }
            if (byte_view const given = node.poll_transmit(); not given.empty()) {
                carry(given, link);
                node.sent(now);
            }
            now = now + microseconds(300);
        }
    }

    template <typename Request> constexpr result<typename Request::response> ask(Request const& request)
    {
        single_request conversation{unit_id{2}, request};
        run(conversation);
        if (not conversation.outcome()) {
            return conversation.outcome().error();
        }
        byte_view const pdu = conversation.outcome()->pdu();
        byte_writer{received}.bytes(pdu);
        return response{byte_view{received}.first(pdu.size())}.template to<Request>();
    }
};

constexpr bool reads()
{
    line_of_two both;
    static_cast<void>(both.bank.set(3103, 600));
    auto const response = both.ask(read_holding_registers{3102, 4});
    return response and response->registers.size() == 4 and response->registers[1] == 600;
}
PROOF("function 03: a register's value arrives", reads)

constexpr bool writes()
{
    line_of_two both;
    return both.ask(write_single_register{3102, 13}) and both.bank.get(3102) == 13;
}
PROOF("function 06: a register's value is written", writes)

constexpr bool writes_several()
{
    line_of_two both;
    auto const response = both.ask(write_multiple_registers{3104, register_block{20, 30}});
    return response and response->count == 2 and both.bank.get(3105) == 30;
}
PROOF("function 16: several values are written", writes_several)

constexpr bool exchanges()
{
    line_of_two both;
    auto const response = both.ask(read_write_multiple_registers{3104, 2, 3105, register_block{7}});
    return response and response->registers[1] == 7 and both.bank.get(3105) == 7;
}
PROOF("function 23: values are written, then read", exchanges)

constexpr bool loops_back()
{
    line_of_two both;
    auto const response = both.ask(diagnostics{subfunction::return_query_data, register_block{0xA537}});
    return response and response->data[0] == 0xA537;
}
PROOF("function 08: what is sent comes back", loops_back)

constexpr bool identifies()
{
    line_of_two both;
    auto const response = both.ask(read_device_identification{});
    return response and response->count == 3 and response->find(product_code)->size() == 11;
}
PROOF("function 43: a unit says who it is", identifies)

constexpr bool refuses()
{
    line_of_two both;
    return both.ask(read_holding_registers{1, 1}) == errc::illegal_data_address and
           both.ask(raw_pdu{static_cast<function_code>(0x41), {}}) == errc::illegal_function;
}
PROOF("an exception arrives with its number", refuses)

} // namespace

TEST_CASE("ten thousand transactions in random chunks all give the right value")
{
    line_of_two both;
    test::random random{3};
    unsigned wrong = 0;
    for (unsigned round = 0; round < 10'000; ++round) {
        auto const address = static_cast<std::uint16_t>(3100 + random.below(64));
        auto const value = static_cast<std::uint16_t>(random.next());
        bool const written = both.ask(write_single_register{address, value}).has_value();
        auto const response = both.ask(read_holding_registers{address, 1});
        wrong += written and response and response->registers[0] == value ? 0U : 1U;
    }
    CHECK(wrong == 0);
}
