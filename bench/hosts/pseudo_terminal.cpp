// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A transaction over a real pseudo-terminal, function 03 of four registers back to back: time and processor time of both
// ends, of a pair of rtuwire's and a pair of libmodbus's, in turns in one run and all on one processor: how long another one
// takes to wake is the machine's, and more than either. Then how long rtuwire's client lets the
// line rest between a response and its next request, with the specification's silence: a far end that answers at once.
#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <vector>

#include <modbus.h>
#include <sched.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <rtuwire/port.hpp>
#include <rtuwire/rtuwire.hpp>

using namespace rtuwire;

namespace {

constexpr unsigned transactions = 2'000;
constexpr unsigned rounds = 5;
constexpr std::uint32_t bits_per_second = 115'200;
constexpr line_timing no_wire = line_timing::without_wire();

/// A bank that knows how often it was read.
struct counted_bank : word_bank<16> {
    errc read(std::uint16_t start, std::size_t count, byte_writer& out) noexcept
    {
        ++reads;
        return word_bank<16>::read(start, count, out);
    }
    unsigned reads{0};
};

void serve(pseudo_terminal& port)
{
    server node{unit_id{1}, no_wire};
    counted_bank bank;
    while (bank.reads < transactions and serve_once(node, port, bank, milliseconds(1'000))) {
    }
}

bool ask(char const* device, line_timing const& timing, unsigned count)
{
    posix_serial port;
    if (not port.open(device, {.bits_per_second = bits_per_second})) {
        return false;
    }
    blocking_client line{port, timing};
    for (unsigned i = 0; i < count; ++i) {
        if (not line.ask(unit_id{1}, read_holding_registers{.start = 0, .count = 4})) {
            return false;
        }
    }
    return true;
}

modbus_t* peer(char const* device)
{
    modbus_t* const context = modbus_new_rtu(device, static_cast<int>(bits_per_second), 'N', 8, 1);
    modbus_set_slave(context, 1);
    return context;
}

/// libmodbus has no server on a descriptor: its context gets the near end in the place of a device.
void serve_by_libmodbus(int near)
{
    modbus_t* const context = peer("/dev/null");
    modbus_mapping_t* const map = modbus_mapping_new(0, 0, 16, 0);
    modbus_set_socket(context, near);
    std::array<std::uint8_t, MODBUS_RTU_MAX_ADU_LENGTH> request{};
    for (unsigned i = 0; i < transactions;) {
        int const size = modbus_receive(context, request.data());
        if (size > 0) {
            modbus_reply(context, request.data(), size, map);
            ++i;
        }
    }
}

bool ask_by_libmodbus(char const* device)
{
    modbus_t* const context = peer(device);
    std::array<std::uint16_t, 4> values{};
    bool is_right = modbus_connect(context) == 0;
    for (unsigned i = 0; i < transactions and is_right; ++i) {
        is_right = modbus_read_registers(context, 0, 4, values.data()) == 4;
    }
    modbus_close(context);
    modbus_free(context);
    return is_right;
}

/// Microseconds of a transaction, on the clock and of both processors.
struct cost {
    double elapsed;
    double processor;
};

double microseconds_of(timeval const& at)
{
    return 1e6 * static_cast<double>(at.tv_sec) + static_cast<double>(at.tv_usec);
}

double processor_time(int whose)
{
    rusage used{};
    ::getrusage(whose, &used);
    return microseconds_of(used.ru_utime) + microseconds_of(used.ru_stime);
}

/// What `client` and `server` take, each in a process of its own.
template <typename Server, typename Client> cost cost_of(unsigned count, Server server, Client client)
{
    pid_t const far = ::fork();
    if (far == 0) {
        server();
        ::_exit(0);
    }
    ::usleep(100'000); // a server listens when its line was silent once
    double const before = processor_time(RUSAGE_SELF);
    double const ended = processor_time(RUSAGE_CHILDREN);
    instant const start = steady_now();
    bool const is_right = client();
    auto const elapsed = static_cast<double>((steady_now() - start).microseconds);
    double const own = processor_time(RUSAGE_SELF) - before;
    ::waitpid(far, nullptr, 0);
    if (not is_right) {
        std::puts("pseudo_terminal: a response is missing");
        std::exit(1);
    }
    return {elapsed / count, (own + processor_time(RUSAGE_CHILDREN) - ended) / count};
}

cost by_rtuwire()
{
    pseudo_terminal line;
    static_cast<void>(line.open());
    return cost_of(
        transactions, [&] { serve(line); }, [&] { return ask(line.path().c_str(), no_wire, transactions); });
}

cost by_libmodbus()
{
    int const near = ::posix_openpt(O_RDWR | O_NOCTTY);
    ::grantpt(near);
    ::unlockpt(near);
    char device[64]{};
    ::ptsname_r(near, device, sizeof device);
    int const kept_open = ::open(device, O_RDWR | O_NOCTTY);
    termios raw{};
    ::tcgetattr(kept_open, &raw);
    ::cfmakeraw(&raw);
    ::tcsetattr(kept_open, TCSANOW, &raw);
    cost const found = cost_of(
        transactions, [&] { serve_by_libmodbus(near); }, [&] { return ask_by_libmodbus(device); });
    ::close(kept_open);
    ::close(near);
    return found;
}

cost median(std::vector<cost> all)
{
    auto const middle = [&](double cost::*part) {
        std::sort(all.begin(), all.end(),
                  [part](cost const& left, cost const& right) { return left.*part < right.*part; });
        return all[all.size() / 2].*part;
    };
    return {middle(&cost::elapsed), middle(&cost::processor)};
}

char const* verdict(bool is_met) { return is_met ? "met" : "MISSED"; }

void show_pairs()
{
    std::vector<cost> ours;
    std::vector<cost> theirs;
    for (unsigned i = 0; i < rounds; ++i) {
        ours.push_back(by_rtuwire());
        theirs.push_back(by_libmodbus());
    }
    cost const own = median(ours);
    cost const other = median(theirs);
    std::printf("transaction over a pseudo-terminal, one processor, no silence kept: rtuwire %.1f us, libmodbus %.1f "
                "us: %.2f times, "
                "at most 1.5: %s\n",
                own.elapsed, other.elapsed, own.elapsed / other.elapsed, verdict(own.elapsed <= 1.5 * other.elapsed));
    std::printf("processor time of both ends: rtuwire %.1f us, libmodbus %.1f us: %.2f times, at most 2: %s\n",
                own.processor, other.processor, own.processor / other.processor,
                verdict(own.processor <= 2 * other.processor));
}

/// Answers whatever comes at once with four registers.
void answer_at_once(pseudo_terminal& port, unsigned count)
{
    constexpr auto response = "01 03 08 00 00 00 00 00 00 00 00 95 D7"_hex;
    std::array<std::byte, 256> place{};
    for (unsigned i = 0; i < count;) {
        auto const bytes = port.read(place, port.now() + milliseconds(1'000));
        if (bytes and not bytes->empty()) {
            static_cast<void>(port.write(response, port.now() + milliseconds(1'000)));
            ++i;
        }
    }
}

void show_dead_time(std::uint32_t bits)
{
    constexpr unsigned count = 200;
    line_timing const timing = line_timing::host(bits, character_format::even_8_1);
    pseudo_terminal line;
    static_cast<void>(line.open());
    cost const found = cost_of(
        count, [&] { answer_at_once(line, count); }, [&] { return ask(line.path().c_str(), timing, count); });
    // The client counts the time that its request takes to leave as if there were a wire.
    double const wire = timing.characters(8).microseconds;
    double const dead = found.elapsed - wire;
    double const least = timing.t3_5().microseconds;
    std::printf(
        "client at %u bit/s, between a response and the next request: %.2f ms (t3.5: %.2f), at most 0.3 more: %s\n",
        bits, dead / 1'000, least / 1'000, verdict(dead <= least + 300));
}

/// This process and those it starts run on the processor that it is on.
void stay_on_one_processor()
{
#ifdef __linux__
    cpu_set_t here;
    CPU_ZERO(&here);
    CPU_SET(static_cast<unsigned>(::sched_getcpu()), &here);
    static_cast<void>(::sched_setaffinity(0, sizeof here, &here));
#endif
}

} // namespace

int main()
{
    stay_on_one_processor();
    show_pairs();
    for (std::uint32_t const bits : {9'600U, 19'200U, 115'200U}) {
        show_dead_time(bits);
    }
}
