// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Whole transactions of four registers in one process, client to server and back: both of libmodbus's stacks and both of
// ours over a pair of sockets, with the system calls that each makes; and ours in memory, with framers and times, which
// nothing of libmodbus can be compared with.
#include <array>

#include <benchmark/benchmark.h>
#include <modbus.h>
#include <sys/socket.h>
#include <unistd.h>

#include <rtuwire/ask/single_request.hpp>
#include <rtuwire/client/client.hpp>
#include <rtuwire/port/descriptor.hpp>
#include <rtuwire/rtu/line.hpp>
#include <rtuwire/server/server.hpp>
#include <rtuwire/wire/registers.hpp>

using namespace rtuwire;
using namespace rtuwire::detail;

namespace {

constexpr line_timing timing{19'200, character_format::even_8_1};
constexpr unit_id one{1};

/// Both ends of a line in virtual time.
struct both_ends {
    client link{timing};
    server node{one, timing};
    word_bank<16> bank{};
    single_request<read_holding_registers> request{one, {1, 4}};
    instant now{0};

    both_ends()
    {
        link.advance(now);
        node.advance(now);
    }
    void pass(duration length)
    {
        now = now + length;
        link.advance(now);
        node.advance(now);
    }
    std::uint32_t ask()
    {
        request.again();
        link.converse(request, now);
        pass(timing.t3_5());
        link.converse(request, now);
        byte_view const asked = link.poll_transmit();
        link.sent(now);
        node.receive(asked, now);
        node.serve(bank, now);
        pass(timing.t3_5());
        byte_view const response = node.poll_transmit();
        link.receive(response, now);
        node.sent(now);
        link.converse(request, now);
        auto const read = request.outcome()->to<read_holding_registers>();
        return read ? read->registers[3] : 0U;
    }
};

void ours(benchmark::State& state)
{
    both_ends line;
    static_cast<void>(line.bank.set(4, 7));
    std::uint32_t sum = 0;
    for (auto _ : state) {
        sum += line.ask();
    }
    if (sum != 7 * static_cast<std::uint32_t>(state.iterations())) {
        state.SkipWithError("a transaction failed");
    }
}
BENCHMARK(ours)->Name("transactions/rtuwire in memory");

/// One end of a pair of sockets as a port.
struct socket_end {
    descriptor line;

    result<void> write(byte_view bytes) { return line.write(bytes, now() + milliseconds(1'000)); }
    result<byte_span> read(byte_span place, instant until) { return line.read(place, until); }
    static instant now() { return steady_now(); }
};

/// Client and server on a pair of sockets, in real time: each waits by `ppoll`, then reads, as a host's port does.
struct both_sockets {
    std::array<int, 2> pair{};
    socket_end near{};
    socket_end far{};
    host_client link{line_timing::without_wire()};
    server node{one, line_timing::without_wire()};
    word_bank<16> bank{};
    single_request<read_holding_registers> request{one, {1, 4}};
    std::array<std::byte, max_adu_size> place{};

    both_sockets()
    {
        ::socketpair(AF_UNIX, SOCK_STREAM | SOCK_NONBLOCK, 0, pair.data());
        near.line = descriptor{pair[0]};
        far.line = descriptor{pair[1]};
        link.advance(near.now());
        node.advance(far.now());
        ::usleep(100'000); // either end listens when its line was silent once
        static_cast<void>(bank.set(4, 7));
    }
    std::uint32_t ask()
    {
        request.again();
        instant const start = near.now();
        link.advance(start);
        link.converse(request, start);
        if (not near.write(link.poll_transmit())) {
            return 0;
        }
        link.sent(near.now());
        node.advance(far.now());
        static_cast<void>(receive_from(far, node, place, far.now() + milliseconds(100)));
        node.advance(far.now());
        node.serve(bank, far.now());
        node.advance(far.now());
        if (not far.write(node.poll_transmit())) {
            return 0;
        }
        node.sent(far.now());
        static_cast<void>(receive_from(near, link, place, near.now() + milliseconds(100)));
        link.advance(near.now());
        link.converse(request, near.now());
        auto const read = request.outcome()->to<read_holding_registers>();
        return read ? read->registers[3] : 0U;
    }
};

void ours_over_sockets(benchmark::State& state)
{
    both_sockets line;
    std::uint32_t sum = 0;
    for (auto _ : state) {
        sum += line.ask();
    }
    if (sum != 7 * static_cast<std::uint32_t>(state.iterations())) {
        state.SkipWithError("a transaction failed");
    }
}
BENCHMARK(ours_over_sockets)->Name("transactions/rtuwire over sockets");

/// Two of libmodbus's contexts on a pair of sockets.
struct two_contexts {
    std::array<int, 2> sockets{};
    modbus_t* master;
    modbus_t* slave;
    modbus_mapping_t* registers;

    two_contexts()
        : master{modbus_new_rtu("/dev/null", 115'200, 'E', 8, 1)},
          slave{modbus_new_rtu("/dev/null", 115'200, 'E', 8, 1)}, registers{modbus_mapping_new(0, 0, 16, 0)}
    {
        ::socketpair(AF_UNIX, SOCK_STREAM, 0, sockets.data());
        modbus_set_socket(master, sockets[0]);
        modbus_set_socket(slave, sockets[1]);
        modbus_set_slave(master, 1);
        modbus_set_slave(slave, 1);
        registers->tab_registers[4] = 7;
    }
    two_contexts(two_contexts const&) = delete;
    two_contexts& operator=(two_contexts const&) = delete;
    ~two_contexts()
    {
        modbus_mapping_free(registers);
        modbus_free(master);
        modbus_free(slave);
        ::close(sockets[0]);
        ::close(sockets[1]);
    }
    std::uint32_t ask()
    {
        std::array<std::uint8_t, 6> request{1, 3, 0, 1, 0, 4};
        std::array<std::uint8_t, MODBUS_RTU_MAX_ADU_LENGTH> asked{};
        std::array<std::uint8_t, MODBUS_RTU_MAX_ADU_LENGTH> response{};
        modbus_send_raw_request(master, request.data(), static_cast<int>(request.size()));
        int const size = modbus_receive(slave, asked.data());
        modbus_reply(slave, asked.data(), size, registers);
        int const got = modbus_receive_confirmation(master, response.data());
        return got == 13 ? response[10] : 0U;
    }
};

void theirs(benchmark::State& state)
{
    two_contexts line;
    std::uint32_t sum = 0;
    for (auto _ : state) {
        sum += line.ask();
    }
    if (sum != 7 * static_cast<std::uint32_t>(state.iterations())) {
        state.SkipWithError("a transaction failed");
    }
}
BENCHMARK(theirs)->Name("transactions/libmodbus over sockets");

} // namespace
