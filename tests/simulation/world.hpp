// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A client and three servers on a simulated line, in virtual time. Whatever a register holds says whose
// it is and where, so that an answer to another question is seen.
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include <rtuwire/client/client.hpp>
#include <rtuwire/server/server.hpp>
#include <rtuwire/sim/line.hpp>
#include <rtuwire/sim/usb_adapter.hpp>

namespace rtuwire::simulation {

/// What register `address` of `unit` holds, whatever is written to it.
[[nodiscard]] inline std::uint16_t word_of(std::uint8_t unit, std::uint16_t address)
{
    std::uint32_t mixed = (std::uint32_t{unit} << 16U | address) * 0x9E37'79B1U;
    mixed ^= mixed >> 15U;
    mixed *= 0x85EB'CA77U;
    return static_cast<std::uint16_t>(mixed >> 16U);
}

/// Reads as `word_of`; remembers the last write and counts all.
struct telling_bank {
    std::uint8_t unit{0};
    unsigned writes{0};
    std::uint16_t address{0};
    std::uint16_t count{0};
    std::uint16_t first{0};

    static errc check_read(std::uint16_t start, std::size_t many)
    {
        return start + many <= 0x10000 ? errc::none : errc::illegal_data_address;
    }
    static errc check_write(std::uint16_t start, register_view values)
    {
        return check_read(start, values.size());
    }
    errc read(std::uint16_t start, std::size_t many, byte_writer& out) const
    {
        for (std::size_t i = 0; i < many; ++i) {
            out.u16(word_of(unit, static_cast<std::uint16_t>(start + i)));
        }
        return errc::none;
    }
    errc write(std::uint16_t start, register_view values)
    {
        ++writes;
        address = start;
        count = static_cast<std::uint16_t>(values.size());
        first = values[0];
        return errc::none;
    }
};

/// How the client's end is wired.
struct wiring {
    character_format format{character_format::even_8_1};
    client_options options{.response_timeout = milliseconds(60), .late_answer = milliseconds(60)};
    bool has_adapter{false};
    std::uint32_t seed{1};
};

class world {
public:
    static constexpr unsigned servers = 3;
    static constexpr unsigned stranger = 7;
    static constexpr std::uint32_t bits_per_second = 19'200;

    explicit world(wiring const& how)
        : timing_{how.has_adapter ? line_timing::host(bits_per_second, how.format)
                                  : line_timing{bits_per_second, how.format}},
          wire_{bits_per_second, how.format, how.seed}, link_{timing_, how.options},
          nodes_{node(1, how.format), node(2, how.format), node(3, how.format)},
          adapter_{milliseconds(how.has_adapter ? 4U + how.seed % 13U : 0U)},
          has_adapter_{how.has_adapter}, has_echo_{how.options.has_echo}
    {
        for (unsigned i = 0; i < servers; ++i) {
            banks_[i].unit = static_cast<std::uint8_t>(i + 1);
        }
        idle(milliseconds(60));
    }

    sim::line& wire() { return wire_; }
    auto& link() { return link_; }
    telling_bank& bank(unsigned unit) { return banks_[unit - 1]; }
    instant now() const { return now_; }

    /// Somebody else talks, now.
    void disturb(byte_view octets) { wire_.talk(stranger, octets, now_); }

    /// Whether a server lately sent just this PDU: then an accepted answer is not a damaged one.
    bool was_sent(byte_view pdu) const
    {
        bool found = false;
        for (said const& each : said_) {
            byte_view const frame = byte_view{each.octets}.first(each.size);
            found = found or (each.size > 3 and same_bytes(frame.subspan(1, each.size - 3), pdu));
        }
        return found;
    }

    /// Lets time pass until a question has its outcome; how long that took.
    template <typename Take> duration ask(request question, patience with, Take take)
    {
        instant const start = now_;
        static_cast<void>(link_.start(question, now_, with));
        for (;;) {
            if (auto const outcome = link_.poll_outcome()) {
                take(*outcome);
                return now_ - start;
            }
            step(milliseconds(1'000));
        }
    }

    void idle(duration length)
    {
        instant const end = now_ + length;
        while (not reached(now_, end)) {
            step(end - now_);
        }
    }

private:
    struct said {
        std::array<std::byte, max_adu_size> octets{};
        std::size_t size{0};
    };

    static server node(std::uint8_t unit, character_format format)
    {
        return {*unit_id::checked(unit), line_timing{bits_per_second, format}};
    }

    /// One pass, and the jump to what happens next.
    void step(duration most)
    {
        hear();
        pass(link_, client_sent_, 0);
        for (unsigned i = 0; i < servers; ++i) {
            server& each = nodes_[i];
            each.advance(now_);
            each.serve(banks_[i], now_);
            byte_view const frame = pass(each, node_sent_[i], i + 1);
            if (not frame.empty()) {
                remember(frame);
            }
        }
        jump(most);
    }

    /// Sends what a party wants sent, and tells it when that has left.
    template <typename Party> byte_view pass(Party& party, deadline& sent, unsigned talker)
    {
        if (sent and reached(now_, *sent)) {
            party.sent(*sent);
            sent.reset();
        }
        party.advance(now_);
        byte_view const frame = party.poll_transmit();
        if (not frame.empty()) {
            sent = wire_.talk(talker, frame, now_);
        }
        return frame;
    }

    void remember(byte_view frame)
    {
        said& place = said_[next_said_];
        next_said_ = (next_said_ + 1) % said_.size();
        place.size = frame.size();
        byte_writer{place.octets}.bytes(frame);
    }

    void hear()
    {
        while (auto const heard = wire_.listen(now_)) {
            for (unsigned i = 0; i < servers; ++i) {
                if (not heard->is_from(i + 1)) {
                    tell(nodes_[i], *heard);
                }
            }
            if (not heard->is_from(0) or has_echo_) {
                if (has_adapter_) {
                    adapter_.take(heard->octet, now_); // it says nothing of damage
                } else {
                    tell(link_, *heard);
                }
            }
        }
        if (byte_view const lump = adapter_.give(now_); not lump.empty()) {
            link_.receive(lump, now_);
        }
    }

    template <typename Party> static void tell(Party& party, sim::sound const& heard)
    {
        if (heard.is_damaged) {
            party.receive_error(heard.at);
        } else {
            party.receive(byte_view{&heard.octet, 1}, heard.at);
        }
    }

    void jump(duration most)
    {
        deadline next = now_ + most;
        next = earlier(next, wire_.poll_deadline());
        next = earlier(next, adapter_.poll_deadline());
        next = earlier(next, link_.poll_deadline());
        next = earlier(next, client_sent_);
        for (unsigned i = 0; i < servers; ++i) {
            next = earlier(next, nodes_[i].poll_deadline());
            next = earlier(next, node_sent_[i]);
        }
        now_ = reached(now_, *next) ? now_ + microseconds(1) : *next;
    }

    line_timing timing_;
    sim::line wire_;
    basic_client<line_statistics> link_;
    std::array<server, servers> nodes_;
    std::array<telling_bank, servers> banks_{};
    sim::usb_adapter adapter_;
    deadline client_sent_{};
    std::array<deadline, servers> node_sent_{};
    std::array<said, 16> said_{};
    std::size_t next_said_{0};
    instant now_{0xFFFF'0000U};
    bool has_adapter_;
    bool has_echo_;
};

} // namespace rtuwire::simulation
