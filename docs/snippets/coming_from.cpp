// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// What the page for programs with another library shows: what takes the place of its calls. The two ends of a
// pseudo-terminal are the line of a host; a board is simulated, with a server at the other end of its line.
//! [head]
#include <iostream>
#include <string>

#include <rtuwire/client.hpp>
#include <rtuwire/port.hpp>
#include <rtuwire/print.hpp>
#include <rtuwire/server.hpp>

using namespace rtuwire;
//! [head]
#include <atomic>
#include <cstdint>
#include <optional>
#include <thread>

namespace {

//! [client]
bool print_four(std::string const& device)
{
    host_serial port;
    if (auto const opened = port.open(device, {.bits_per_second = 19'200}); not opened) { // 8E1, unless told otherwise
        std::cerr << port.failure() << '\n';
        return false;
    }
    blocking_client line{port};
    auto const response = line.ask(unit_id{7}, read_holding_registers{.start = 100, .count = 4});
    if (not response) {
        std::cerr << response.error() << '\n'; // an exception of the unit, no response in time, a lost adapter
        return false;
    }
    for (std::size_t i = 0; i < response->registers.size(); ++i) {
        std::cout << response->registers[i] << '\n';
    }
    return true;
}
//! [client]

//! [options]
// Taken by blocking_client line{port, options} and by client link{timing, options}.
constexpr client_options options{.response_timeout = milliseconds(500), .retries = 0};
//! [options]

/// Whether a broadcast was sent, whose response nobody waits for.
template <typename Port> bool tell_all(Port& port)
{
    blocking_client line{port, line_timing::without_wire(), options};
    //! [broadcast]
    auto const told = line.send_broadcast(write_single_register{.address = 100, .value = 7});
    //! [broadcast]
    return told.has_value();
}

/// Serves until it is told to end; whether the port stayed.
template <typename Port, typename Bank> bool serve_all(Port& port, Bank& bank, std::atomic<bool> const& is_over)
{
    //! [server]
    server node{unit_id{7}, line_timing::host(19'200, character_format::even_8_1)};
    while (not is_over) {
        if (auto const served = serve_once(node, port, bank, milliseconds(100)); not served) {
            std::cerr << served.error() << '\n'; // the port failed
            return false;
        }
        static_cast<void>(bank.set(100, bank.get(101))); // 100 shows what a client wrote to 101
    }
    //! [server]
    return true;
}

/// Stands for a board: its line has a server at the other end.
class simulated_board {
public:
    interrupt_queue<> line;
    word_bank<16> far{100};
    int shown{0};

    explicit simulated_board(line_timing const& times) : times_{times}, node_{unit_id{7}, times}
    {
        static_cast<void>(far.set(103, 1'500));
        node_.advance(now_); // it listens before the first request
    }
    instant now() const { return now_; }
    void send(byte_view frame)
    {
        node_.receive(frame, now_ = now_ + times_.characters(frame.size()));
        line.sent(now_);
    }
    void sleep_until(deadline due)
    {
        while (line.is_empty() and not(due and reached(now_, *due))) {
            now_ = now_ + microseconds(100);
            node_.advance(now_);
            node_.serve(far, now_);
            if (byte_view const answer = node_.poll_transmit(); not answer.empty()) {
                for (std::byte const each : answer) {
                    line.receive(each, now_ = now_ + times_.characters(1));
                }
                node_.sent(now_);
            }
        }
    }
    void show(std::uint16_t value) { shown += value == 1'500 ? 1 : 0; }
    void show(errc) {}
    bool goes_on() const { return shown < 3 and not reached(now_, instant{0} + milliseconds(1'000)); }

private:
    instant now_{0};
    line_timing times_;
    server node_;
};

void run(simulated_board& board)
{
    //! [loop]
    client link{line_timing{19'200, character_format::even_8_1}};
    single_request ask{unit_id{7}, read_holding_registers{.start = 100, .count = 4}};
    while (board.goes_on()) { // a firmware: for (;;)
        auto const now = board.now();
        board.line.deliver_to(link, now); // the bytes that interrupts put into its interrupt_queue
        link.advance(now);
        link.converse(ask, now);
        if (ask.settled()) {
            auto const outcome = ask.outcome();
            auto const response = outcome ? outcome->to<read_holding_registers>() : outcome.error();
            if (response) {
                board.show(response->registers[3]);
            } else {
                board.show(response.error());
            }
            ask.again();
        }
        if (byte_view const frame = link.poll_transmit(); not frame.empty()) {
            board.send(frame); // enables the line's driver, and begins to send
        }
        board.sleep_until(link.poll_deadline()); // or until an interrupt; other work has its place here
    }
    //! [loop]
}

/// Reads a register, then writes what was made of it.
void run_in_order(simulated_board& board)
{
    client link{line_timing{19'200, character_format::even_8_1}};
    //! [order]
    single_request ask{unit_id{7}, read_holding_registers{.start = 103, .count = 1}};
    std::optional<single_request<write_single_register>> tell; // made once there is what to write

    auto const visit = [&](instant now) { // in the loop, in place of link.converse(ask, now) and what follows it
        if (not tell) {
            link.converse(ask, now);
            auto const outcome = ask.outcome(); // errc::busy until it has settled
            auto const seen = outcome ? outcome->to<read_holding_registers>() : outcome.error();
            if (seen) {
                auto const half = static_cast<std::uint16_t>(seen->registers[0] / 2);
                tell.emplace(unit_id{7}, write_single_register{.address = 101, .value = half});
            } else if (ask.settled()) {
                board.show(seen.error());
                ask.again();
            }
        } else if (not tell->settled()) {
            link.converse(*tell, now);
        }
    };
    //! [order]
    while (board.goes_on() and not(tell and tell->settled())) {
        auto const now = board.now();
        board.line.deliver_to(link, now);
        link.advance(now);
        visit(now);
        if (byte_view const frame = link.poll_transmit(); not frame.empty()) {
            board.send(frame);
        }
        board.sleep_until(link.poll_deadline());
    }
}

//! [callbacks]
struct tank_bank {
    std::uint16_t level{420};
    std::uint16_t limit{900};

    errc check_read(std::uint16_t start, std::size_t count) const { return in_range(start, count); }
    errc check_write(std::uint16_t start, register_view values) const
    {
        if (start != 101) {
            return errc::illegal_data_address; // the level, at 100, is only read
        }
        return values.size() == 1 and values[0] <= 1'000 ? errc::none : errc::illegal_data_value;
    }
    errc read(std::uint16_t start, std::size_t count, byte_writer& out)
    {
        for (std::size_t i = 0; i < count; ++i) {
            out.u16(start + i == 100 ? level : limit);
        }
        return errc::none;
    }
    errc write(std::uint16_t, register_view values)
    {
        limit = values[0];
        return errc::none;
    }

private:
    static errc in_range(std::size_t start, std::size_t count)
    {
        return start >= 100 and start + count <= 102 ? errc::none : errc::illegal_data_address;
    }
};
//! [callbacks]

/// Stands for the receive and transmit of a board's file, which have the port of a sketch: a client asks once, after
/// the line has been silent for 100 ms.
struct {
    instant now{0};
    int passes{0};
    bool is_answered{false};

    template <typename Engine> void receive(Engine& node)
    {
        now = now + milliseconds(10);
        if (++passes == 10) {
            auto const request = encode(unit_id{7}, write_single_register{.address = 101, .value = 12});
            node.receive(*request, now);
        }
        node.advance(now);
    }
    template <typename Engine> void transmit(Engine& node)
    {
        if (not node.poll_transmit().empty()) {
            is_answered = true;
            node.sent(now);
        }
    }
} sketch;
void receive(auto& node) { sketch.receive(node); }
void transmit(auto& node) { sketch.transmit(node); }
instant now() { return sketch.now; }

//! [sketch]
server node{unit_id{7}, line_timing::host(19'200, character_format::even_8_1)};
word_bank<16> registers{100};

void loop()
{
    receive(node); // this and transmit: as they stand in the file of your board
    node.serve(registers, now());
    static_cast<void>(registers.set(100, registers.get(101))); // 100 shows what a client wrote to 101
    transmit(node);
}
//! [sketch]

bool sketch_answers()
{
    for (int pass = 0; pass < 20; ++pass) {
        loop();
    }
    return sketch.is_answered and registers.get(100) == 12;
}

bool tank_answers()
{
    tank_bank tank;
    std::array<std::byte, max_pdu_size> place{};
    auto const answer = [&](auto const& request) {
        auto const frame = encode(unit_id{7}, request);
        return respond(decode_adu(*frame)->pdu(), tank, server_profile{}, place).size();
    };
    bool const is_read = answer(read_holding_registers{.start = 100, .count = 2}) == 6;
    bool const is_refused = answer(write_single_register{.address = 100, .value = 1}) == 2;
    bool const is_written = answer(write_single_register{.address = 101, .value = 800}) == 5 and tank.limit == 800;
    return is_read and is_refused and is_written and answer(read_holding_registers{.start = 101, .count = 2}) == 2;
}

} // namespace

int main()
{
    pseudo_terminal both;
    if (not both.open()) {
        return 1;
    }
    word_bank<16> bank{100};
    std::atomic<bool> is_over{false};
    bool has_stayed = false;
    std::thread device{[&] { has_stayed = serve_all(both, bank, is_over); }};
    bool const is_read = print_four(both.path());
    posix_serial port;
    bool const is_told = port.open(both.path()) and tell_all(port);
    is_over = true;
    device.join();

    simulated_board board{line_timing{19'200, character_format::even_8_1}};
    run(board);
    simulated_board second{line_timing{19'200, character_format::even_8_1}};
    run_in_order(second);
    bool const is_in_order = second.far.get(101) == 750;
    return is_read and is_told and has_stayed and is_in_order and board.shown == 3 and sketch_answers() and
                   tank_answers()
               ? 0
               : 1;
}
