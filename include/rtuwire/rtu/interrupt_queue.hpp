// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// Passes what the interrupts of a UART report to the loop: bytes, receive errors and "sent", each with its
// time, in the order in which they happened. One side writes, the other reads; there are no locks and no
// interrupt is masked. Knows no frame, no clock and no UART.
// Uses the atomic loads and stores of rtu/published.hpp only.
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <type_traits>

#include <rtuwire/core/bytes.hpp>
#include <rtuwire/core/time.hpp>
#include <rtuwire/core/version.hpp>
#include <rtuwire/rtu/published.hpp>

namespace rtuwire {
inline namespace RTUWIRE_BUILD {

namespace detail {

/// Reports an overrun. A server that counts overruns has a separate function for it.
template <typename Engine> constexpr void report_overrun(Engine& engine, instant at) noexcept
{
    if constexpr (requires { engine.receive_overrun(at); }) {
        engine.receive_overrun(at);
    } else {
        engine.receive_error(at);
    }
}

} // namespace detail

/// Passes the events of a line from interrupts to a loop. The interrupts call `receive`, `receive_error`,
/// `receive_overrun` and `sent`; they all have one priority, so that none of them interrupts another. The
/// loop calls `deliver_to`. Both take their times from the same clock.
///
/// When the queue is full, what does not fit is dropped. The loop then gets a receive error in its place, so
/// that the frame under way is refused, and the error is counted. "Sent" always has room, as long as the loop
/// calls `deliver_to` once between two transmissions.
///
/// The capacity is a power of two; two places of it are not for bytes. It must hold what arrives in the
/// longest pass of the loop: 64 are enough for 35 ms at 19 200 bit/s and for 5.9 ms at 115 200 bit/s
/// (characters of 11 bits). A place takes 6 bytes of RAM. On an 8-bit processor 128 is the most.
template <std::size_t Capacity = 64> class interrupt_queue {
    static_assert(std::has_single_bit(Capacity) and Capacity >= 8 and Capacity <= 32'768,
                  "the capacity of an interrupt_queue is a power of two from 8 to 32 768");

    /// Counts past the capacity and wraps, so that full and empty differ. One byte where that is enough, which
    /// every processor loads and stores in one access.
    using index = std::conditional_t<(Capacity <= 128), std::uint8_t, std::uint16_t>;

public:
    /// Zero-initialised: a `constinit` queue takes no flash.
    constexpr interrupt_queue() noexcept = default;

    /// Deleted: an interrupt knows it by its address.
    interrupt_queue(interrupt_queue const&) = delete;
    interrupt_queue& operator=(interrupt_queue const&) = delete;

    /// In the interrupt: a byte had arrived by `at`.
    constexpr void receive(std::byte value, instant at) noexcept
    {
        put(kind::byte, value, at);
        publish();
    }

    /// In the interrupt: all bytes of the UART's buffer had arrived by `at`. The loop sees them together.
    constexpr void receive(byte_view bytes, instant at) noexcept
    {
        for (std::byte const each : bytes) {
            put(kind::byte, each, at);
        }
        publish();
    }

    /// In the interrupt: a byte arrived damaged (parity, framing). Call it in place of `receive`.
    constexpr void receive_error(instant at) noexcept
    {
        put(kind::damage, {}, at);
        publish();
    }

    /// In the interrupt: the UART lost a byte. Call it before `receive` of the next byte.
    constexpr void receive_overrun(instant at) noexcept
    {
        put(kind::overrun, {}, at);
        publish();
    }

    /// In the interrupt: the last stop bit of a transmission left at `at`. Where the same interrupt also
    /// reports received bytes, pass those first.
    constexpr void sent(instant at) noexcept
    {
        put(kind::sent, {}, at);
        publish();
    }

    /// In the loop: passes the events up to `now`, a time that the loop read before, to a client, a bus or a
    /// server. Events up to 65 ms later wait for the next call, so that time never goes back. An event of any other time
    /// has waited for this call: the loop may have paused for so long that the clock came round.
    template <typename Engine> constexpr void deliver_to(Engine& engine, instant now) noexcept
    {
        index const end = detail::load(in_);
        while (out_ != end) {
            if (is_just_ahead(time_of(out_), now)) {
                return;
            }
            deliver_next(engine, end);
        }
        // Bytes were dropped and no event has come after them. Their times are not known here: the line is
        // taken to have been busy until now.
        if (detail::load(has_dropped_) != 0 and not has_told_ and detail::load(in_) == end) {
            has_told_ = true;
            told_at_ = now;
            tell_drop(engine, now);
        }
    }

    /// In the loop: whether there is nothing to deliver. A loop that sleeps masks interrupts, checks this,
    /// sleeps only when it is true, and unmasks: then no interrupt comes between the check and the sleep.
    [[nodiscard]] constexpr bool is_empty() const noexcept
    {
        bool const has_drop_to_tell = detail::load(has_dropped_) != 0 and not has_told_;
        return detail::load(in_) == out_ and not has_drop_to_tell;
    }

    /// In the loop: how often bytes were dropped because the queue was full; the number of receive errors
    /// that `deliver_to` gave for it.
    [[nodiscard]] constexpr std::uint32_t overflows() const noexcept { return overflows_; }

private:
    enum class kind : std::uint8_t { byte, damage, overrun, sent, drop };

    /// Two places are always kept free for "sent": the second is for a drop that must come before it.
    static constexpr std::size_t kept_for_sent = 2;

    static constexpr std::size_t place_of(index position) noexcept { return position % Capacity; }

    constexpr instant time_of(index position) const noexcept { return instant{times_[place_of(position)]}; }

    static constexpr index next(index position) noexcept { return static_cast<index>(position + 1U); }

    /// An event is later than `now` only where its interrupt came after the loop had read that.
    static constexpr bool is_just_ahead(instant at, instant now) noexcept
    {
        constexpr duration longest{0x1'0000}; // as `within_reach` has it
        return at != now and at - now < longest;
    }

    constexpr void put(kind what, std::byte value, instant at) noexcept
    {
        std::size_t const free = Capacity - static_cast<index>(written_ - detail::load(out_));
        std::size_t const wanted = 1U + has_dropped_;
        bool const is_sent = what == kind::sent;
        if (free < (is_sent ? 1U : wanted + kept_for_sent)) {
            dropped_at_ = at;
            // In this order: the loop that sees the drop also sees all that came before it.
            publish();
            detail::store(has_dropped_, std::uint8_t{1});
            return;
        }
        if (has_dropped_ != 0 and free >= wanted) {
            write(kind::drop, {}, dropped_at_);
            detail::store(has_dropped_, std::uint8_t{0});
        }
        write(what, value, at);
    }

    constexpr void publish() noexcept { detail::store(in_, written_); }

    constexpr void write(kind what, std::byte value, instant at) noexcept
    {
        std::size_t const place = place_of(written_);
        times_[place] = at.microseconds;
        kinds_[place] = what;
        values_[place] = value;
        written_ = next(written_);
    }

    /// A drop that was reported before any event came after it.
    constexpr bool is_told_drop(index position) const noexcept
    {
        return kinds_[place_of(position)] == kind::drop and has_told_ and reached(told_at_, time_of(position));
    }

    template <typename Engine> constexpr void deliver_next(Engine& engine, index end) noexcept
    {
        kind const what = kinds_[place_of(out_)];
        instant const at = time_of(out_);
        bool const was_told = is_told_drop(out_);
        if (what == kind::byte) {
            deliver_bytes(engine, end, at);
            return;
        }
        detail::store(out_, next(out_));
        switch (what) {
        case kind::byte: break;
        case kind::damage: engine.receive_error(at); break;
        case kind::overrun: detail::report_overrun(engine, at); break;
        case kind::sent: engine.sent(at); break;
        case kind::drop:
            if (not was_told) { // else reported already
                tell_drop(engine, at);
            }
            has_told_ = false;
            break;
        }
    }

    /// Passes together the bytes that one interrupt received together, and no others: an engine takes the
    /// bytes of one call as having arrived back to back. They are copied, so that they are contiguous and
    /// their places are free while the engine works.
    template <typename Engine> constexpr void deliver_bytes(Engine& engine, index end, instant at) noexcept
    {
        std::array<std::byte, Capacity> bytes;
        std::size_t count = 0;
        index out = out_;
        do {
            bytes[count++] = values_[place_of(out)];
            out = next(out);
        } while (out != end and kinds_[place_of(out)] == kind::byte and time_of(out) == at);
        detail::store(out_, out);
        engine.receive(byte_view{bytes.data(), count}, at);
    }

    template <typename Engine> constexpr void tell_drop(Engine& engine, instant at) noexcept
    {
        ++overflows_;
        detail::report_overrun(engine, at);
    }

    // Written by the interrupt.
    index written_{0}; ///< the loop does not read it
    index in_{0};
    std::uint8_t has_dropped_{0}; ///< and no event reports it yet
    instant dropped_at_{0};       ///< the last one; the loop does not read it
    // Written by the loop.
    index out_{0};
    bool has_told_{false}; ///< a drop was reported before its event came
    instant told_at_{0};
    std::uint32_t overflows_{0};
    // Written by the interrupt from `written_` on, read by the loop from `out_` to `in_`.
    std::array<std::uint32_t, Capacity> times_{}; ///< of instants
    std::array<kind, Capacity> kinds_{};
    std::array<std::byte, Capacity> values_{};
};

} // namespace RTUWIRE_BUILD
} // namespace rtuwire
