// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// The client's end of a line (SL 2.4.1): one request at a time. Owns neither the wire nor a clock; knows of functions
// only what wire/response.hpp says. It is two things: the duty on the line, which runs one request
// (client/line/transaction.hpp), and the conversations' desk, which knows whose it is, who is next and which motors run
// by order (client/desk/conversation_desk.hpp).
#pragma once

#include <cstddef>

#include <rtuwire/ask/commander.hpp>
#include <rtuwire/client/desk/conversation_desk.hpp>
#include <rtuwire/client/line/phase.hpp>
#include <rtuwire/client/line/quarantine.hpp>
#include <rtuwire/client/line/transaction.hpp>
#include <rtuwire/client/order/orders.hpp>
#include <rtuwire/core/version.hpp>
#include <rtuwire/trace/tracing.hpp>

namespace rtuwire::inline RTUWIRE_BUILD {

/// Sends one request at a time, for any number of conversations. In each pass call `receive` with what arrived, `sent`
/// when the last stop bit has left, `advance`; then `converse` for each conversation, in the same order; then send
/// what `poll_transmit` returns. Sleep no longer than until `poll_deadline`. Whoever comes later, even by
/// hours, finds over what was in force: a program may be stopped, and a client left unused, for any time.
///
/// Lifetimes: a conversation may be destroyed, moved or begun anew between any two calls. A request, and each
/// repetition of it, leaves only in a pass in which its conversation visits (`converse` is called for it); the bytes
/// to send are the client's own and unchanged until `sent` is called or the client's wait for it times out; an outcome
/// goes to the conversation that asked, or is dropped. A client may be assigned, or made anew in its place: what its
/// conversations asked and ordered before is over, and they may ask and order anew.
///
/// `Debts` holds the units with an outstanding response; `Front` is `shared_memory` or `separate_memory`; `Orders` is
/// `no_orders`, or `orders<Units>` for conversations that command motors: see client/order/orders.hpp.
template <typename Statistics, typename Line = stored<line_timing>, typename Options = stored<client_options>,
          typename Debts = quarantine<1>, std::size_t Front = shared_memory, typename Orders = no_orders>
class basic_client : public conversation_desk<transaction<Statistics, Line, Options, Debts, Front>, Orders> {
    using duty = transaction<Statistics, Line, Options, Debts, Front>;
    using desk = conversation_desk<duty, Orders>;
    using desk::is_held_back_;
    using desk::orders_;
    using desk::reservation_;
    using desk::seen_;
    using desk::turns_;

public:
    /// The same, of which a sink takes the frames as they pass, from `trace_to(sink)` on:
    /// `client::traced_by<trace_ring<4096>>`.
    template <frame_sink Sink>
    using traced_by = basic_client<tracing<Sink, Statistics>, Line, Options, Debts, Front, Orders>;

    using desk::cancel;
    using desk::desk;

    /// Lets time pass.
    constexpr void advance(instant now) noexcept { static_cast<void>(advance_within_reach(now)); }

    /// The same. Returns the time by which what was in force before is to be judged: see `within_reach`.
    /// Internal.
    constexpr instant advance_within_reach(instant now) noexcept
    {
        instant const at = seen_ == instant{0} ? now : within_reach(seen_, now); // 0: the first time
        seen_ = instant{now.microseconds | 1U};                                  // never 0
        bool const is_silence_over = orders_.advance(at);
        if ((duty::advance(now, at) or is_silence_over) and is_held_back_) {
            is_held_back_ = false;
            turns_.void_marks();
            turns_.note_waiting();
        }
        return at;
    }

    /// When the next pass has something to do.
    [[nodiscard]] constexpr deadline poll_deadline() const noexcept
    {
        earliest next;
        add_to(next);
        return next;
    }

    /// The same, for a caller that collects several.
    constexpr void add_to(earliest& next) const noexcept
    {
        duty::add_to(next, reservation_.is_held());
        orders_.add_to(next);
    }

    /// Whether no new request goes to a unit now: its response is outstanding, `hold` says so, or it was lost while it
    /// was ordered to run, and its own time-out has to stop it.
    [[nodiscard]] constexpr bool is_held(std::uint8_t unit) const noexcept
    {
        return duty::is_held(unit) or orders_.is_silent(unit, effect::none);
    }
    [[nodiscard]] constexpr bool is_held(unit_id unit) const noexcept { return is_held(unit.byte()); }

    /// Whether the request has left and others wait already: visits change nothing but the marks of those.
    /// Internal.
    [[nodiscard]] constexpr bool needs_no_visit() const noexcept
    {
        client_phase const at = duty::phase_now();
        bool const has_left = is_under_way(at) and at > client_phase::handed_out;
        return has_left and turns_.others_wait() and not reservation_.is_held() and not is_held_back_;
    }

    /// Which motors this client ordered to run.
    [[nodiscard]] constexpr Orders& motor_orders() noexcept { return orders_; }
    [[nodiscard]] constexpr Orders const& motor_orders() const noexcept { return orders_; }

    /// Ends the hold of a stop that was given up before its end: its unit can be commanded again; all units, where a
    /// stop of all units was given up. Where no stop holds a unit nothing changes.
    constexpr void release(unit_id unit) noexcept requires(Orders::is_kept) { orders_.release(unit.byte()); }
    constexpr void release_all() noexcept requires(Orders::is_kept) { orders_.release_all(); }

    /// Gives up the request under way, only where it is this conversation's.
    constexpr void cancel(asker const& whose, instant now) noexcept
    {
        if (desk::is_asked_by(whose)) {
            cancel(now);
        }
    }
};

/// A client that counts nothing.
using client = basic_client<no_statistics>;

/// The same for conversations that command the motors of up to `Units` units: start, stop, cycle and the like.
template <std::size_t Units = 1>
using drive_client = basic_client<no_statistics, stored<line_timing>, stored<client_options>, quarantine<1>,
                                  shared_memory, orders<Units>>;

/// The same where memory does not matter: its requests and responses may have any size.
using host_client = basic_client<no_statistics, stored<line_timing>, stored<client_options>, quarantine<1>,
                                 separate_memory, orders<32>>;

} // namespace rtuwire
