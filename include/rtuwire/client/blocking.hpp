// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// A blocking client for hosts: it runs the sans-IO client over a port until the outcome is there. Of the operating
// system it knows only what the port offers.
#pragma once

#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <type_traits>
#include <utility>

#include <rtuwire/ask/outcome_of.hpp>
#include <rtuwire/ask/single_request.hpp>
#include <rtuwire/client/client.hpp>
#include <rtuwire/client/needs.hpp>
#include <rtuwire/core/version.hpp>
#include <rtuwire/rtu/receive_from.hpp>

namespace rtuwire::inline RTUWIRE_BUILD {

/// A serial port: it has a clock; `write` accepts all bytes before a deadline and sends them at the line's pace;
/// `read` returns the bytes that are there or arrive before a deadline (none: an empty span). It may also report
/// damaged bytes: see `receive_from`. One that waits makes a `host_deadline` of `until` first: the program may be stopped for
/// an hour.
/// Internal.
template <typename T>
concept serial_port = requires(T& port, byte_view out, byte_span in, instant until)
{
    {
        port.now()
        } -> std::same_as<instant>;
    {
        port.write(out, until)
        } -> std::same_as<result<void>>;
    {
        port.read(in, until)
        } -> std::same_as<result<byte_span>>;
};

/// A serial port that also knows the times which suit its device, as `posix_serial` does.
/// Internal.
template <typename T>
concept timed_port = serial_port<T> and requires(T const& port)
{
    {
        port.timing()
        } -> std::same_as<line_timing>;
};

/// Passes on the bytes that arrive until a time that was named since the engine's last `advance`. That may be over for half an
/// hour, and seem to lie ahead: the program may have been stopped since, in a write or in a conversation.
/// Internal.
template <typename Engine, serial_port Port>
result<void> receive_until(Engine& engine, Port& port, byte_span place, instant until)
{
    instant const now = port.now();
    keep_over(until, now, engine.judged_at(now));
    return receive_from(port, engine, place, until);
}

/// The end of one pass of a client or a bus over a host's port, after `advance` and `converse`: sends what is to be
/// sent, then passes on the bytes that have arrived, or arrive before `until` or the engine's next deadline. `place`
/// is working memory. Errors: those of the port.
template <typename Engine, serial_port Port>
result<void> finish_pass(Engine& engine, Port& port, byte_span place, instant until,
                         duration write_limit = milliseconds(1'000))
{
    if (byte_view const frame = engine.poll_transmit(); not frame.empty()) {
        auto const written = port.write(frame, port.now() + write_limit);
        if (not written) {
            return written;
        }
        // Computed: asking the driver for the end costs a call, and adapters do not know it.
        engine.sent(port.now() + engine.line().characters(frame.size()));
    }
    instant const now = port.now();
    keep_over(until, now, engine.judged_at(now));
    return receive_from(port, engine, place, *earlier(engine.poll_deadline(), until));
}

/// Sends requests and waits for their outcomes. May be left unused for any time. Borrows its port, which must outlive
/// it. `Needs` is as for `basic_client`.
template <serial_port Port, auto const& Needs = host_needs> class blocking_client {
    using engine = basic_client<Needs>;

public:
    blocking_client(Port& its_port, line_timing const& its_line, client_options const& its_options = {}) noexcept
        requires(not told_by<Needs>::is_fixed)
        : port_{its_port}, client_{its_line, its_options}, write_limit_{its_options.response_timeout}
    {}

    /// For needs with a `timing`.
    explicit blocking_client(Port& its_port) noexcept requires(told_by<Needs>::is_fixed)
        : port_{its_port}, write_limit_{Needs.options.response_timeout}
    {}

    /// With the times that suit the device, as the port tells them now: `its_port` has been opened before.
    explicit blocking_client(Port& its_port, client_options const& its_options = {}) noexcept
        requires(timed_port<Port> and not told_by<Needs>::is_fixed)
        : blocking_client{its_port, its_port.timing(), its_options}
    {}

    /// Sends one request and waits for its outcome. The response is a view of this client's memory, valid until the
    /// next `ask`. Errors: those of encoding, an exception of the unit, those of the client, those of the port.
    template <typename To, pdu Request> result<typename Request::response> ask(To to, Request const& request) &
    {
        single_request conversation{to, request};
        auto const outcome = run(conversation);
        if (not outcome) {
            return outcome.error();
        }
        byte_view const pdu = outcome->pdu();
        byte_writer{response_}.bytes(pdu);
        return response{byte_view{response_}.first(pdu.size())}.template to<Request>();
    }
    template <typename To, pdu Request>
    result<typename Request::response> ask(To to, Request const& request) && = delete;

    /// Sends a broadcast and waits for the turnaround delay to end. Errors: those of encoding, of the client, of the
    /// port.
    template <broadcastable Request> result<void> send_broadcast(Request const& command)
    {
        return run(single_request{broadcast, command});
    }

    /// The frame for which the last request failed, with `wrong_length`, `crc_mismatch` and the like: see the client's.
    /// Valid until the next `ask` or `run`.
    [[nodiscard]] std::optional<refused_frame> refused() const noexcept { return client_.refused(); }

    /// What was counted, where counting was asked for.
    [[nodiscard]] auto const& statistics() const noexcept { return client_.statistics(); }

    /// Whether the line has given back what was sent: see the client's.
    [[nodiscard]] bool has_seen_echo() const noexcept { return client_.has_seen_echo(); }

    /// Runs a conversation until it is settled, and returns its `outcome()`; where it has none, its `reason()`; where it
    /// has neither, a `result<void>`. Of a conversation without a name, whose response would end with the statement, only
    /// the error. One that is already settled begins anew, by its `again()`. Errors besides its own: `used_already` where it
    /// has none; those of the port: the request under way is then cancelled, and the conversation itself gets that as its
    /// outcome.
    template <typename Conversation>
        requires conversation<std::remove_cvref_t<Conversation>>
    auto run(Conversation&& conversation)
    {
        errc const why = run_to_end(conversation);
        return why == errc::none ? outcome_of(std::forward<Conversation>(conversation))
                                 : outcome_of(std::forward<Conversation>(conversation), why);
    }

private:
    /// Until it is settled; or `used_already`, or the error of the port.
    template <conversation Conversation> errc run_to_end(Conversation& conversation)
    {
        static_assert(not endless_conversation<Conversation>,
                      "this conversation never ends: give it to a client in each pass");
        if (not can_run(conversation)) {
            return errc::used_already;
        }
        auto passed = drop_stale_input();
        while (passed) {
            instant const now = port_.now();
            client_.advance(now);
            client_.converse(conversation, now);
            if (conversation.settled() and not client_.is_asked_by(conversation)) {
                return errc::none; // one visit more would take its outcome back
            }
            if (client_.is_busy()) {
                passed = finish_pass(client_, port_, input_, now + longest_wait, write_limit_);
            } else {
                passed = wait_for(conversation, now);
            }
        }
        give_up(conversation, port_.now());
        return passed.error();
    }

    /// Ends the request under way: once the port has failed, nothing more is known of it.
    template <typename Conversation> void give_up(Conversation& conversation, instant now)
    {
        client_.cancel(conversation, now);
        client_.sent(now);
        bool const is_asked = client_.is_asked_by(conversation);
        if (not client_.deliver(conversation, false, now) and is_asked) {
            conversation.forget();
            conversation.accept(errc::cancelled);
        }
    }

    /// Waits until a conversation that paused at `now` may have a request again. A deadline of the client that has been
    /// reached asks for the next pass at once: it may be the conversation's turn then. One of the conversation has had its
    /// effect. Where no deadline is left, the conversation is looked at again after `longest_pause`.
    template <typename Conversation> result<void> wait_for(Conversation& conversation, instant now)
    {
        deadline next = client_.poll_deadline();
        if constexpr (timed_conversation<Conversation>) {
            if (deadline const own = conversation.poll_deadline(); own and not reached(now, *own)) {
                next = earlier(next, own);
            }
        }
        return receive_until(client_, port_, input_, next ? *next : now + longest_pause);
    }

    /// What passes bytes on to the client, and whether any came.
    struct stale_input {
        engine& client;
        bool has_come{false};

        void receive(byte_view bytes, instant at)
        {
            has_come = not bytes.empty();
            client.receive(bytes, at);
        }
        void receive_error(instant at)
        {
            has_come = true;
            client.receive_error(at);
        }
    };

    /// What the operating system buffered before the request, however much, must not be taken for its response. Where the
    /// line has to fall silent first, one wait serves both. `bus_jam`: more came than one read takes away, again and again for
    /// all of the time to send. A pause of the program, in which nothing was read, counts no more than one short read.
    result<void> drop_stale_input()
    {
        instant now = port_.now();
        client_.advance(now);
        instant until = client_.is_quiet() ? now : *earlier(client_.poll_deadline(), now + client_.line().silence());
        duration const limit = write_limit_ < least_jam ? least_jam : write_limit_;
        duration const longest_part{limit.microseconds / least_reads_of_a_jam};
        duration busy{};
        for (;;) {
            stale_input old{client_};
            auto const passed = receive_from(port_, old, input_, until);
            if (not passed or not old.has_come) {
                return passed;
            }
            until = port_.now();
            duration const part = until - std::exchange(now, until);
            busy = busy + (part < longest_part ? part : longest_part);
            if (busy >= limit) {
                return errc::bus_jam;
            }
        }
    }

    /// For how long old input comes at least, and by how many reads, before it counts as one that never ends.
    static constexpr duration least_jam = milliseconds(100);
    static constexpr std::uint32_t least_reads_of_a_jam = 64;

    /// How long to wait for a conversation that pauses and gives no deadline.
    static constexpr duration longest_pause = milliseconds(10);
    /// How long to wait for bytes before the next pass, where the client has no earlier deadline.
    static constexpr duration longest_wait = milliseconds(1'000);

    Port& port_;
    engine client_;
    duration write_limit_;
    std::array<std::byte, max_adu_size> input_{};
    std::array<std::byte, max_pdu_size> response_{};
};

} // namespace rtuwire
