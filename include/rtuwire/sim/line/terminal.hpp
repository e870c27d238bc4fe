// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// The ends of a simulated line: an engine each, and the transceiver between it and the line. Internal: sim/bench.hpp
// is the one to use.
// Internal: may change with any version.
#pragma once

#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <utility>

#include <rtuwire/core/bytes.hpp>
#include <rtuwire/core/time.hpp>
#include <rtuwire/core/version.hpp>
#include <rtuwire/rtu/line.hpp>
#include <rtuwire/sim/line/line.hpp>
#include <rtuwire/wire/limits.hpp>

namespace rtuwire::inline RTUWIRE_BUILD::sim {

/// What can be connected to a line: a client, a bus, a simulated drive, a server with its bank.
template <typename T>
concept line_end = requires(T& end, byte_view bytes, instant now)
{
    end.receive(bytes, now);
    end.receive_error(now);
    end.sent(now);
    end.advance(now);
    {
        end.poll_transmit()
        } -> std::same_as<byte_view>;
    {
        end.poll_deadline()
        } -> std::same_as<deadline>;
};

/// Bytes that were received one right after the other, up to and including a damaged one.
struct chunk {
    std::array<std::byte, max_adu_size> bytes{};
    std::size_t size{0};
    std::uint8_t senders{0};
    bool is_damaged{false};
    instant at{0}; ///< the end of the last one

    [[nodiscard]] constexpr bool takes(character const& next) const noexcept
    {
        bool const is_alike = next.senders == senders and not next.is_damaged and not is_damaged;
        return size == 0 or (is_alike and size < bytes.size());
    }
    constexpr void add(character const& next) noexcept
    {
        bytes[size++] = next.byte;
        senders = next.senders;
        is_damaged = next.is_damaged;
        at = next.at;
    }
};

/// One end of the line and the state of its transceiver.
template <std::size_t Sender, line_end End> struct terminal {
    static constexpr unsigned sender = Sender;

    End end;
    deadline sends_until{};
    bool is_cut{false};

    /// Its receiver is off while it sends.
    constexpr void receive(chunk const& heard) noexcept
    {
        if (is_cut or sends_until or ((heard.senders >> sender) & 1U) != 0) {
            return;
        }
        if (heard.is_damaged) {
            end.receive_error(heard.at);
        } else {
            end.receive(byte_view{heard.bytes}.first(heard.size), heard.at);
        }
    }

    /// Lets time pass; a server that knows its banks serves them.
    constexpr void advance(instant now) noexcept
    {
        if constexpr (requires { end.serve(now); }) {
            end.serve(now);
        } else {
            end.advance(now);
        }
    }

    constexpr void finish(instant now) noexcept
    {
        if (sends_until and reached(now, *sends_until)) {
            end.sent(*sends_until);
            sends_until = {};
        }
    }

    template <typename Line> constexpr void transmit(Line& line, line_timing const& timing, instant now) noexcept
    {
        if (sends_until) {
            return;
        }
        if (byte_view const frame = end.poll_transmit(); not frame.empty()) {
            sends_until = is_cut ? now + timing.characters(frame.size()) : line.transmit(sender, frame, now);
        }
    }

    constexpr void add_to(earliest& next) const noexcept
    {
        next.add(sends_until);
        next.add(end.poll_deadline());
    }
};

template <typename Numbers, line_end... Ends> class terminals;

/// All ends of a line, numbered as its senders.
template <std::size_t... Numbers, line_end... Ends>
class terminals<std::index_sequence<Numbers...>, Ends...> : terminal<Numbers, Ends>... {
public:
    /// `ends.make<End>(from)` makes each end.
    template <typename Maker, typename... From>
    explicit constexpr terminals(Maker const& ends, From const&... from) noexcept
        : terminal<Numbers, Ends>{ends.template make<Ends>(from)}...
    {}

    template <typename Action> constexpr void for_each(Action action) noexcept
    {
        (action(static_cast<terminal<Numbers, Ends>&>(*this)), ...);
    }

    template <std::size_t Number> [[nodiscard]] constexpr auto& at() noexcept { return find<Number>(*this); }

private:
    template <std::size_t Number, typename End>
    static constexpr terminal<Number, End>& find(terminal<Number, End>& found) noexcept
    {
        return found;
    }
};

} // namespace rtuwire::sim
