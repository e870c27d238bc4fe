// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Whole transactions of the engines, so that their instructions can be counted. Apart from the single
// operations: where a compiler sees both, it inlines neither as it would alone.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

#include <rtuwire/client/client.hpp>
#include <rtuwire/core/hex.hpp>
#include <rtuwire/server/server.hpp>
#include <rtuwire/wire/registers.hpp>

namespace operations {

using namespace rtuwire;
using namespace rtuwire::detail;

inline constexpr unit_id address{1};
inline constexpr auto read_4 = "01 03 00 01 00 04 15 C9"_hex;
inline constexpr auto read_63 = *encode(address, read_holding_registers{1, 63});
inline constexpr auto read_125 = *encode(address, read_holding_registers{1, 125});
inline constexpr auto write_4 = "01 10 00 01 00 04 08 00 01 00 02 00 03 00 04 D3 7A"_hex;
inline constexpr auto exchange_4 = "01 17 00 01 00 04 00 01 00 04 08 00 01 00 02 00 03 00 04 2B 29"_hex;

struct memory {
    std::array<std::byte, 13> response_4{};
    std::array<std::byte, 131> response_63{};
    std::array<std::byte, 255> response_125{};
    word_bank<128> bank{};
    std::size_t sum{0};
};
inline memory all;

/// A response of function 03 with as many registers as fit.
template <std::size_t Size> void fill(std::array<std::byte, Size>& response)
{
    response[0] = std::byte{1};
    response[1] = std::byte{3};
    response[2] = static_cast<std::byte>(Size - 5);
    static_cast<void>(append_crc(response, Size - adu_overhead));
}

/// Nothing: what a call costs.
[[gnu::noinline]] inline void nothing() { asm volatile("" ::: "memory"); }

/// Engines with a line of their own, whose clock goes on from one transaction to the next.
struct engines {
    client asks_4{line_timing{19'200, character_format::even_8_1}};
    client asks_63{line_timing{19'200, character_format::even_8_1}};
    client asks_125{line_timing{19'200, character_format::even_8_1}};
    server node{address, line_timing{19'200, character_format::even_8_1}};
    instant now{0};
    std::size_t values{0};
};
inline engines* line = nullptr; ///< made when it is first needed: nothing runs before `main`

/// A read of so many registers, without end.
template <std::uint16_t Count> class read_again : public asker {
public:
    constexpr std::optional<request_frame> next() const noexcept { return request_frame{frame_}; }
    constexpr void accept(result<response> const& outcome) noexcept
    {
        line->values += outcome ? outcome->pdu().size() - 2 : 0;
    }
    static constexpr bool settled() noexcept { return false; }

private:
    frame_of<read_holding_registers> frame_ = *encode(address, read_holding_registers{1, Count});
};
constinit inline read_again<4> read_of_4;
constinit inline read_again<63> read_of_63;
constinit inline read_again<125> read_of_125;

inline void let_pass(duration length) { line->now = line->now + length; }

/// How bytes arrive: one by one, as from a receiver's interrupt, or all at once, as from DMA or a port of a host.
enum class fed { by_byte, whole };

template <typename Engine> [[gnu::noinline]] void feed(Engine& engine, byte_view bytes, fed how)
{
    if (how == fed::whole) {
        let_pass(microseconds(573 * static_cast<std::uint32_t>(bytes.size())));
        return engine.receive(bytes, line->now);
    }
    for (std::byte const& each : bytes) {
        let_pass(microseconds(573));
        engine.receive(each, line->now);
    }
}

/// One transaction of a client. Ends by taking the outcome and asking again.
template <typename Conversation>
[[gnu::noinline]] void transact(client& link, Conversation& conversation, byte_view response, fed how)
{
    let_pass(milliseconds(4));
    link.advance(line->now);
    link.converse(conversation, line->now);
    all.sum = all.sum + link.poll_transmit().size();
    link.sent(line->now);
    feed(link, response, how);
    link.advance(line->now);
    link.converse(conversation, line->now);
    all.sum = all.sum + (link.poll_deadline() ? 1 : 0);
}
inline void client_read_4() { transact(line->asks_4, read_of_4, all.response_4, fed::by_byte); }
inline void client_read_63() { transact(line->asks_63, read_of_63, all.response_63, fed::by_byte); }
inline void client_read_4_whole() { transact(line->asks_4, read_of_4, all.response_4, fed::whole); }
inline void client_read_63_whole() { transact(line->asks_63, read_of_63, all.response_63, fed::whole); }
inline void client_read_125_whole() { transact(line->asks_125, read_of_125, all.response_125, fed::whole); }

/// One transaction of the server.
[[gnu::noinline]] inline void answer(byte_view request, fed how)
{
    let_pass(milliseconds(4));
    line->node.advance(line->now);
    feed(line->node, request, how);
    line->node.serve(all.bank, line->now);
    let_pass(milliseconds(4));
    line->node.advance(line->now);
    all.sum = all.sum + line->node.poll_transmit().size();
    line->node.sent(line->now);
    all.sum = all.sum + (line->node.poll_deadline() ? 1 : 0);
}

inline void server_read_4() { answer(read_4, fed::by_byte); }
inline void server_read_4_whole() { answer(read_4, fed::whole); }
inline void server_read_63_whole() { answer(read_63, fed::whole); }
inline void server_read_125_whole() { answer(read_125, fed::whole); }
inline void server_exchange_4_whole() { answer(exchange_4, fed::whole); }

/// A request byte by byte up to its last byte but one, and then dropped: what `answer_last` does besides.
[[gnu::noinline]] inline void hear(byte_view request)
{
    line->node.advance(line->now);
    feed(line->node, request.first(request.size() - 1), fed::by_byte);
    let_pass(milliseconds(200));
    line->node.advance(line->now);
}

/// The same with the last byte: from there to the response that may leave as soon as the line is silent.
[[gnu::noinline]] inline void answer_last(byte_view request)
{
    line->node.advance(line->now);
    feed(line->node, request, fed::by_byte);
    line->node.serve(all.bank, line->now);
    let_pass(milliseconds(200));
    line->node.advance(line->now);
}
inline void hear_read_4() { hear(read_4); }
inline void hear_write_4() { hear(write_4); }
inline void hear_exchange_4() { hear(exchange_4); }
inline void last_byte_read_4() { answer_last(read_4); }
inline void last_byte_write_4() { answer_last(write_4); }
inline void last_byte_exchange_4() { answer_last(exchange_4); }

/// Whether the engines do what their names say.
inline bool are_right()
{
    fill(all.response_4);
    fill(all.response_63);
    fill(all.response_125);
    static engines made;
    line = &made;
    line->asks_4.advance(line->now);
    line->asks_4.converse(read_of_4, line->now);
    line->asks_63.advance(line->now);
    line->asks_63.converse(read_of_63, line->now);
    line->asks_125.advance(line->now);
    line->asks_125.converse(read_of_125, line->now);
    line->node.advance(line->now);
    client_read_4();
    client_read_63();
    client_read_4();
    all.sum = 0;
    server_read_4();
    server_read_4_whole();
    server_exchange_4_whole();
    bool const is_served = all.sum == 3 * (13 + 1); // with the deadline that it names
    client_read_4_whole();
    client_read_63_whole();
    client_read_125_whole();
    all.sum = 0;
    server_read_63_whole();
    server_read_125_whole();
    bool const is_served_long = all.sum == 131 + 255 + 2;
    last_byte_write_4();
    bool const is_written = all.bank.get(4) == 4;
    return line->values == 8 + 126 + 8 + 8 + 126 + 250 and is_served and is_served_long and is_written;
}

struct operation {
    char const* name;
    void (*run)();
    void (*less)(); ///< what is measured with it and does not count
};

inline constexpr operation list[] = {
    {"client_read_4", client_read_4, nothing},
    {"client_read_63", client_read_63, nothing},
    {"server_read_4", server_read_4, nothing},
    {"client_read_4_whole", client_read_4_whole, nothing},
    {"client_read_63_whole", client_read_63_whole, nothing},
    {"server_read_4_whole", server_read_4_whole, nothing},
    {"server_exchange_4_whole", server_exchange_4_whole, nothing},
    {"client_read_125_whole", client_read_125_whole, nothing},
    {"server_read_63_whole", server_read_63_whole, nothing},
    {"server_read_125_whole", server_read_125_whole, nothing},
    {"last_byte_read_4", last_byte_read_4, hear_read_4},
    {"last_byte_write_4", last_byte_write_4, hear_write_4},
    {"last_byte_exchange_4", last_byte_exchange_4, hear_exchange_4},
};

} // namespace operations
