// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Answers of 21 bytes over a line with a bit error in a hundred: undetected COUNT [SEED]. How many damaged
// ones a client accepts, against what the code's weight distribution says it has to.
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>

#include "../support/asking.hpp"

#include <rtuwire/client/client.hpp>
#include <rtuwire/core/crc16.hpp>
#include <rtuwire/sim/line/line.hpp>
#include <rtuwire/wire/registers.hpp>

using namespace rtuwire;
using namespace rtuwire::detail;

namespace {

constexpr std::size_t size = 21; ///< 8 registers
constexpr double error_rate = 0.01;
constexpr std::uint32_t in_a_million = 10'000;

/// The chance that errors in the bits from `first` on, and none before, leave the CRC right. By the
/// weights of the dual code (MacWilliams): 2^-16 times the sum of (1 - 2p)^w over its 65 536 words.
double chance_from(std::size_t first)
{
    constexpr std::size_t bits = size * 8;
    std::array<std::uint16_t, bits> column{}; // the syndrome of each bit alone
    for (std::size_t bit = first; bit < bits; ++bit) {
        std::array<std::byte, size> error{};
        error[bit / 8] = static_cast<std::byte>(1U << (bit % 8));
        // The CRC is affine: what an error adds is the difference to no error.
        column[bit] = static_cast<std::uint16_t>(crc16(error) ^ crc16(std::array<std::byte, size>{}));
    }
    double sum = 0;
    for (std::uint32_t word = 0; word < 65'536; ++word) {
        int weight = 0;
        for (std::size_t bit = first; bit < bits; ++bit) {
            weight += std::popcount(word & column[bit]) & 1;
        }
        sum += std::pow(1 - 2 * error_rate, weight);
    }
    double const all_right = std::pow(1 - error_rate, double(bits - first));
    return std::pow(1 - error_rate, double(first)) * (sum / 65'536 - all_right);
}

/// The 99 % interval of a Poisson count.
struct interval {
    double low{0};
    double high{0};

    explicit interval(double mean)
    {
        double term = std::exp(-mean);
        double sum = term;
        for (double count = 1; sum < 0.995; ++count) {
            if (sum < 0.005) {
                low = count;
            }
            term *= mean / count;
            sum += term;
            high = count;
        }
    }
};

/// A client that asks, and a line that damages what it gets.
struct listener {
    sim::line wire;
    test::asking<client> link{line_timing{19'200, character_format::none_8_1}, {.retries = 0}};
    instant now{0};
    frame_of<read_holding_registers> inquiry = *encode(*unit_id::checked(1), read_holding_registers{0, 8});

    explicit listener(std::uint32_t seed) : wire{19'200, character_format::none_8_1, seed}
    {
        sim::line_faults noisy;
        noisy.bit_errors = in_a_million;
        wire.set_faults(noisy);
        link.advance(now);
    }

    /// Whether a damaged response was accepted.
    bool is_fooled(byte_view response)
    {
        now = now + milliseconds(1'500); // over any quarantine
        link.advance(now);
        static_cast<void>(link.start(request_frame{inquiry}, now));
        link.advance(now);
        static_cast<void>(link.poll_transmit());
        link.sent(now);
        instant const end = wire.transmit(1, response, now);
        while (auto const heard = wire.receive(end + milliseconds(5))) {
            if (heard->is_damaged) {
                link.receive_error(heard->at);
            } else {
                link.receive(byte_view{&heard->byte, 1}, heard->at);
            }
        }
        now = end + milliseconds(10);
        link.advance(now);
        auto const outcome = link.poll_outcome();
        bool const is_wrong = outcome and *outcome and not same_bytes((*outcome)->pdu(), response.subspan(1, size - 3));
        link.cancel(now);
        static_cast<void>(link.poll_outcome());
        return is_wrong;
    }
};

} // namespace

int main(int argc, char** argv)
{
    unsigned long const count = argc > 1 ? std::strtoul(argv[1], nullptr, 10) : 2'000'000;
    listener listener{static_cast<std::uint32_t>(argc > 2 ? std::strtoul(argv[2], nullptr, 10) : 1)};
    detail::random_source random_source{99};
    std::array<std::byte, size> response{std::byte{1}, std::byte{3}, std::byte{16}};
    unsigned long fooled = 0;
    for (unsigned long i = 0; i < count; ++i) {
        for (std::size_t at = 3; at < size - 2; ++at) {
            response[at] = to_byte(random_source.next());
        }
        std::uint16_t const crc = crc16(byte_view{response}.first(size - 2));
        response[size - 2] = to_byte(crc);
        response[size - 1] = to_byte(std::uint32_t{crc} >> 8U);
        fooled += listener.is_fooled(response) ? 1U : 0U;
    }
    double const raw = chance_from(0);
    // The unit, the function and the byte count have to be right; so have start and stop bits.
    double const checked = chance_from(24);
    double const framed = checked * std::pow(1 - error_rate, 2.0 * size);
    interval const expected{framed * double(count)};
    std::printf("the CRC alone lets %.2e of the responses pass damaged; unit, function and length checks "
                "leave %.2e, start and stop bits %.2e\n"
                "%lu of %lu accepted damaged, 99 %% interval %.0f to %.0f\n",
                raw, checked, framed, fooled, count, expected.low, expected.high);
    return double(fooled) >= expected.low and double(fooled) <= expected.high ? 0 : 1;
}
