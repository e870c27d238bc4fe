// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A host's port to a line behind a USB adapter, with one unit on it, in virtual time: what a client makes of its time is a
// number that no machine changes. Neither the adapter's way out, the USB bus nor the host takes time here, which would hide
// what a client waits for by itself.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <deque>

#include <rtuwire/client.hpp>
#include <rtuwire/sim/line/usb_adapter.hpp>

namespace rtuwire::bench {

/// The line, its unit and its adapter.
struct adapter_setting {
    std::uint32_t bits_per_second;
    duration latency; ///< of the adapter's timer
    sim::usb_timer timer;
    std::uint16_t registers; ///< that each request reads
    duration unit_takes{};   ///< from a request's last character to its response's first
};

/// One opened port. The unit answers requests of function 03; its registers are counted on from the number of the request,
/// so that no response is like another.
class adapter_port {
public:
    explicit adapter_port(adapter_setting const& how)
        : how_{how}, wire_{how.bits_per_second, character_format::even_8_1}, adapter_{how.latency, how.timer}
    {}

    /// What `posix_serial` says of such a device.
    [[nodiscard]] line_timing timing() const
    {
        return line_timing::usb(how_.bits_per_second, character_format::even_8_1);
    }

    [[nodiscard]] instant now() const { return now_; }

    /// The request leaves at once; its response is on the line from then on.
    result<void> write(byte_view request, instant)
    {
        instant const asked = now_ + wire_.characters(request.size());
        if (duration const rest = now_ - ends_; asked_ == 0 or rest < shortest_rest_) {
            shortest_rest_ = rest;
        }
        instant const begin = asked + how_.unit_takes;
        ++asked_;
        register_block<125> words;
        for (std::size_t i = 0; i < how_.registers; ++i) {
            words.set(i, static_cast<std::uint16_t>(asked_ + i));
        }
        std::array<std::byte, max_adu_size> place{};
        auto const response = encode_into(
            place, unit,
            read_holding_registers_response{register_view{words.view().bytes().first(2U * how_.registers)}});
        for (std::size_t i = 0; i < response->size(); ++i) {
            due_.push_back(character{begin + wire_.characters(i + 1), (*response)[i]});
        }
        ends_ = due_.back().at;
        return {};
    }

    result<byte_span> read(byte_span place, instant until)
    {
        for (;;) {
            while (not due_.empty() and reached(now_, due_.front().at)) {
                adapter_.take(due_.front().byte, now_);
                due_.pop_front();
            }
            if (byte_view const lump = adapter_.give(now_); not lump.empty()) {
                byte_writer{place}.bytes(lump);
                return place.first(lump.size());
            }
            deadline next = due_.empty() ? deadline{} : deadline{due_.front().at};
            next = earlier(next, adapter_.poll_deadline());
            if (not next or not reached(until, *next)) {
                now_ = reached(now_, until) ? now_ : until;
                return place.first(0);
            }
            now_ = *next;
        }
    }

    /// The least time that the line rested between a response and the next request.
    [[nodiscard]] duration shortest_rest() const { return shortest_rest_; }

    static constexpr unit_id unit{7};

private:
    struct character {
        instant at;
        std::byte byte;
    };

    adapter_setting how_;
    line_timing wire_;
    sim::usb_adapter adapter_;
    std::deque<character> due_{};
    instant now_{0xFFFF'0000U}; // the counter goes round
    instant ends_{0xFFFF'0000U};
    duration shortest_rest_{};
    unsigned asked_{0};
};

/// Microseconds of a transaction with a client of ours, of this timing; 0 where one failed.
inline double by_rtuwire(adapter_port& port, adapter_setting const& how, unsigned transactions,
                         line_timing const& timing)
{
    blocking_client line{port, timing};
    instant const begin = port.now();
    for (unsigned i = 0; i < transactions; ++i) {
        auto const response = line.ask(port.unit, read_holding_registers{.start = 0, .count = how.registers});
        if (not response or response->registers.size() != how.registers or
            response->registers[how.registers - 1U] != i + how.registers) {
            return 0;
        }
    }
    return double((port.now() - begin).microseconds) / transactions;
}

/// The same with one that waits for no silence, as libmodbus does: it sends, reads as many bytes as there should be, and
/// sends again.
inline double by_ideal(adapter_port& port, adapter_setting const& how, unsigned transactions)
{
    std::array<std::byte, max_adu_size> place{};
    auto const request = encode_into(place, port.unit, read_holding_registers{.start = 0, .count = how.registers});
    instant const begin = port.now();
    for (unsigned i = 0; i < transactions; ++i) {
        static_cast<void>(port.write(*request, port.now()));
        std::size_t const due = 5U + 2U * how.registers;
        std::array<std::byte, max_adu_size> response{};
        for (std::size_t count = 0; count < due;) {
            count += port.read(response, port.now() + milliseconds(1'000))->size();
        }
    }
    return double((port.now() - begin).microseconds) / transactions;
}

} // namespace rtuwire::bench
