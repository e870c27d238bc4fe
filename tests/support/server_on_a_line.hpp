// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A server with its registers, its line and its clock: what the tests of servers say and hear.
#pragma once

#include <rtuwire/rtu/line.hpp>
#include <rtuwire/server/banks.hpp>
#include <rtuwire/server/server.hpp>

namespace rtuwire::test {

using namespace detail;

/// The times of most tests.
inline constexpr line_timing usual_line{19'200, character_format::even_8_1};

/// Unit 1 with four registers from 0 on, or another bank; its clock starts five seconds before it wraps, and its line
/// has been silent.
template <typename Server = server, typename Bank = word_bank<4>> struct server_on_a_line {
    line_timing line;
    Server node;
    Bank bank{};
    instant now{0xFFFF'FFFFU - 5'000'000U};

    explicit constexpr server_on_a_line(line_timing const& timing = usual_line) : line{timing}, node{one, timing}
    {
        start();
    }

    constexpr server_on_a_line(line_timing const& timing, server_profile const& profile)
        : line{timing}, node{one, timing, profile}
    {
        start();
    }

    /// Time passes, and the loop is busy elsewhere.
    constexpr void sleep(duration length)
    {
        now = now + length;
        node.advance(now);
    }

    /// Time passes, then a pass of the loop serves.
    constexpr void pass(duration length)
    {
        sleep(length);
        node.serve(bank, now);
    }

    /// Bytes arrive; the loop has not come round yet.
    constexpr void receive(byte_view bytes)
    {
        now = now + line.characters(bytes.size());
        node.receive(bytes, now);
    }

    /// Bytes arrive, and are served at once.
    constexpr void hear(byte_view bytes)
    {
        receive(bytes);
        pass({});
    }

    /// What it sends now; until it has left, the clock goes on.
    constexpr byte_view send()
    {
        byte_view const frame = node.poll_transmit();
        if (not frame.empty()) {
            now = now + line.characters(frame.size());
            node.sent(now);
        }
        return frame;
    }

    /// Whether it answers these bytes after t3.5 and not before, and listens again.
    constexpr bool says(byte_view bytes)
    {
        if (not node.poll_transmit().empty()) {
            return false;
        }
        pass(line.t3_5());
        bool const is_right = same_bytes(send(), bytes);
        pass(line.t3_5());
        return is_right;
    }

    /// What it answers to a PDU for a unit; the bytes are valid until the next.
    constexpr byte_view ask(byte_view pdu, std::uint8_t unit = 1)
    {
        std::array<std::byte, max_adu_size> frame{};
        byte_writer out{frame};
        out.u8(unit);
        out.bytes(pdu);
        std::uint16_t const crc = crc16(out.written());
        out.u8(crc & 0xFFU);
        out.u8(std::uint32_t{crc} >> 8U);
        receive(out.written());
        pass(line.t3_5());
        byte_view const response = node.poll_transmit();
        if (not response.empty()) {
            node.sent(now);
        }
        pass(line.t3_5());
        return response;
    }

    constexpr bool is_silent()
    {
        pass(milliseconds(500));
        return node.poll_transmit().empty();
    }

private:
    static constexpr unit_id one{1};

    constexpr void start()
    {
        node.advance(now);
        sleep(milliseconds(100));
    }
};

} // namespace rtuwire::test
