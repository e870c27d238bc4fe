// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A client and three servers on a simulated line, in virtual time. Whatever a register holds says whose
// it is and where, so that a response to another request is seen.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "../support/asking.hpp"

#include <rtuwire/client/client.hpp>
#include <rtuwire/client/statistics.hpp>
#include <rtuwire/server/server.hpp>
#include <rtuwire/sim/line/line.hpp>
#include <rtuwire/sim/line/usb_adapter.hpp>

namespace rtuwire::simulation {

using namespace detail;

/// What register `address` of `unit` holds, whatever is written to it.
[[nodiscard]] inline std::uint16_t word_of(std::uint8_t unit, std::uint16_t address)
{
    std::uint32_t mixed = (std::uint32_t{unit} << 16U | address) * 0x9E37'79B1U;
    mixed ^= mixed >> 15U;
    mixed *= 0x85EB'CA77U;
    return static_cast<std::uint16_t>(mixed >> 16U);
}

/// What a server did with its registers; a read has no values.
struct access_record {
    std::uint16_t start{0};
    std::size_t count{0};
    std::vector<std::byte> values{};

    /// Whether a frame asks for it; a foreign unit's may be of any size.
    [[nodiscard]] bool is_asked_by(byte_view frame) const
    {
        constexpr std::size_t shortest = 8;
        if (frame.size() < shortest) {
            return false;
        }
        bool const is_read = values.empty();
        auto const writes = [&](std::size_t start_at, std::size_t values_at) {
            return not is_read and frame.size() >= values_at + 2 and u16_at(frame, start_at) == start and
                   same_bytes(frame.subspan(values_at, frame.size() - values_at - 2), values);
        };
        bool const reads = is_read and u16_at(frame, 2) == start and u16_at(frame, 4) == count;
        auto const function = static_cast<function_code>(to_u8(frame[1]));
        if (function == function_code::read_holding_registers) {
            return reads;
        }
        if (function == function_code::read_write_multiple_registers) {
            return reads or writes(6, 11);
        }
        bool const is_one = function == function_code::write_single_register and writes(2, 4);
        return is_one or (function == function_code::write_multiple_registers and writes(2, 7));
    }
};

/// Counts the frames that servers found damaged, all of them together.
struct damage_counter : loopback_only {
    static inline unsigned long heard{0};
    static void note_error() noexcept { ++heard; }
};

/// Reads as `word_of`; remembers the last write and counts all.
struct telling_bank {
    std::uint8_t unit{0};
    std::vector<access_record> access_records{};
    unsigned writes{0};
    std::uint16_t address{0};
    std::uint16_t count{0};
    std::uint16_t first{0};

    static errc check_read(std::uint16_t start, std::size_t many)
    {
        return start + many <= 0x10000 ? errc::none : errc::illegal_data_address;
    }
    static errc check_write(std::uint16_t start, register_view values) { return check_read(start, values.size()); }
    errc read(std::uint16_t start, std::size_t many, byte_writer& out)
    {
        access_records.push_back({start, many, {}});
        for (std::size_t i = 0; i < many; ++i) {
            out.u16(word_of(unit, static_cast<std::uint16_t>(start + i)));
        }
        return errc::none;
    }
    errc write(std::uint16_t start, register_view values)
    {
        byte_view const bytes = values.bytes();
        access_records.push_back({start, values.size(), {bytes.begin(), bytes.end()}});
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
    client_options options{.response_timeout = milliseconds(60), .late_response = milliseconds(60)};
    bool has_adapter{false};
    std::uint32_t seed{1};
};

class world {
public:
    static constexpr unsigned servers = 3;
    static constexpr unsigned foreign_unit = 7;
    static constexpr std::uint32_t bits_per_second = 19'200;

    explicit world(wiring const& how)
        : timing_{how.has_adapter ? line_timing::host(bits_per_second, how.format)
                                  : line_timing{bits_per_second, how.format}},
          wire_{bits_per_second, how.format, how.seed}, link_{timing_, how.options}, nodes_{node(1, how.format),
                                                                                            node(2, how.format),
                                                                                            node(3, how.format)},
          adapter_{milliseconds(how.has_adapter ? 4U + how.seed % 13U : 0U)}, has_adapter_{how.has_adapter},
          has_line_echo_{how.options.has_line_echo}
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

    /// Another sender sends, now.
    void disturb(byte_view bytes)
    {
        asked_.keep(bytes);
        wire_.transmit(foreign_unit, bytes, now_);
    }

    /// How often a server did what nobody lately asked for: its request was damaged into another one
    /// with a good CRC.
    unsigned long unasked() const { return unasked_; }

    /// Whether a server lately sent just this PDU: then an accepted answer is not a damaged one.
    bool was_sent(byte_view pdu) const
    {
        return said_.holds([&](byte_view frame) { return same_bytes(frame.subspan(1, frame.size() - 3), pdu); });
    }

    /// Lets time pass until a request has its outcome; how long that took.
    template <typename Take> duration ask(request_frame inquiry, retry_policy with, Take take)
    {
        instant const start = now_;
        static_cast<void>(link_.start(inquiry, now_, with));
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
    /// The last frames that somebody sent.
    class memory {
    public:
        void keep(byte_view frame)
        {
            if (frame.empty()) {
                return;
            }
            frames_[next_].assign(frame.begin(), frame.end());
            next_ = (next_ + 1) % frames_.size();
        }
        template <typename Is> bool holds(Is is) const
        {
            bool found = false;
            for (auto const& frame : frames_) {
                found = found or (frame.size() >= min_adu_size and is(byte_view{frame}));
            }
            return found;
        }

    private:
        std::array<std::vector<std::byte>, 16> frames_{};
        std::size_t next_{0};
    };

    using server = basic_server<damage_counter>;

    static server node(std::uint8_t unit, character_format format)
    {
        return {*unit_id::checked(unit), line_timing{bits_per_second, format}};
    }

    /// One pass, and the jump to what happens next.
    void step(duration most)
    {
        hear();
        asked_.keep(pass(link_, client_sent_, 0));
        for (unsigned i = 0; i < servers; ++i) {
            server& each = nodes_[i];
            each.advance(now_);
            each.serve(banks_[i], now_);
            hold_to_account(banks_[i]);
            said_.keep(pass(each, node_sent_[i], i + 1));
        }
        jump(most);
    }

    /// Sends what a party wants sent, and tells it when that has left.
    template <typename Party> byte_view pass(Party& bus, deadline& sent, unsigned sender)
    {
        if (sent and reached(now_, *sent)) {
            bus.sent(*sent);
            sent.reset();
        }
        bus.advance(now_);
        byte_view const frame = bus.poll_transmit();
        if (not frame.empty()) {
            sent = wire_.transmit(sender, frame, now_);
        }
        return frame;
    }

    void hold_to_account(telling_bank& bank)
    {
        for (access_record const& done : bank.access_records) {
            bool const was_asked =
                asked_.holds([&](byte_view frame) { return to_u8(frame[0]) == bank.unit and done.is_asked_by(frame); });
            unasked_ += was_asked ? 0 : 1;
        }
        bank.access_records.clear();
    }

    void hear()
    {
        while (auto const heard = wire_.receive(now_)) {
            for (unsigned i = 0; i < servers; ++i) {
                if (not heard->is_from(i + 1)) {
                    tell(nodes_[i], *heard);
                }
            }
            if (not heard->is_from(0) or has_line_echo_) {
                if (has_adapter_) {
                    adapter_.take(heard->byte, now_); // it says nothing of damage
                } else {
                    tell(link_, *heard);
                }
            }
        }
        if (byte_view const lump = adapter_.give(now_); not lump.empty()) {
            link_.receive(lump, now_);
        }
    }

    template <typename Party> static void tell(Party& bus, detail::character const& heard)
    {
        if (heard.is_damaged) {
            bus.receive_error(heard.at);
        } else {
            bus.receive(byte_view{&heard.byte, 1}, heard.at);
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
    test::asking<basic_client<observed_by<line_statistics>>> link_;
    std::array<server, servers> nodes_;
    std::array<telling_bank, servers> banks_{};
    sim::usb_adapter adapter_;
    deadline client_sent_{};
    std::array<deadline, servers> node_sent_{};
    memory asked_{};
    memory said_{};
    unsigned long unasked_{0};
    instant now_{0xFFFF'0000U};
    bool has_adapter_;
    bool has_line_echo_;
};

} // namespace rtuwire::simulation
