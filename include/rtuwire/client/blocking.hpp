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

#include <rtuwire/ask/conversation.hpp>
#include <rtuwire/ask/single_request.hpp>
#include <rtuwire/client/client.hpp>
#include <rtuwire/client/needs.hpp>
#include <rtuwire/core/version.hpp>
#include <rtuwire/rtu/line.hpp>

namespace rtuwire {
inline namespace RTUWIRE_BUILD {

namespace detail {

/// A serial port: it has a clock; `write` accepts all bytes before a deadline and sends them at the line's pace;
/// `read` returns the bytes that are there or arrive before a deadline (none: an empty span). It may also report
/// damaged bytes: see `receive_from`. One that waits makes a `host_deadline` of `until` first: the program may be stopped for
/// an hour.
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
template <typename T>
concept timed_port = serial_port<T> and requires(T const& port)
{
    {
        port.timing()
        } -> std::same_as<line_timing>;
};

/// Passes on the bytes that arrive until a time that was named since the engine's last `advance`. That may be over for half an
/// hour, and seem to lie ahead: the program may have been stopped since, in a write or in a conversation.
template <typename Engine, serial_port Port>
result<void> receive_until(Engine& engine, Port& port, byte_span place, instant until)
{
    instant const now = port.now();
    keep_over(until, now, engine.judged_at(now));
    return receive_from(port, engine, place, until);
}

/// Sends what an engine has to send. Returns whether there was anything; the errors are those of the port. A time that was
/// named since the engine's last `advance`, and is over behind the write, is now: `sent` may let time pass, which tells no more.
template <typename Engine, serial_port Port>
result<bool> send_from(Engine& engine, Port& port, duration write_limit, instant& until)
{
    byte_view const frame = engine.poll_transmit();
    if (frame.empty()) {
        return false;
    }
    if (auto const written = port.write(frame, port.now() + write_limit); not written) {
        return written.error();
    }
    instant const now = port.now();
    keep_over(until, now, engine.judged_at(now));
    // Computed: asking the driver for the end costs a call, and adapters do not know it.
    engine.sent(now + engine.line().characters(frame.size()));
    return true;
}

/// Passes on the bytes that arrive until the engine's next deadline, or `until`, as `receive_until` does.
template <typename Engine, serial_port Port>
result<void> receive_within_pass(Engine& engine, Port& port, byte_span place, instant until)
{
    instant const now = port.now();
    keep_over(until, now, engine.judged_at(now));
    return receive_from(port, engine, place, *earlier(engine.poll_deadline(), until));
}

} // namespace detail

/// The end of one pass of a client or a bus over a host's port, after `advance` and `converse`: sends what is to be
/// sent, then passes on the bytes that have arrived, or arrive before `until` or the engine's next deadline. `place`
/// is working memory. Errors: those of the port.
template <typename Engine, detail::serial_port Port>
result<void> finish_pass(Engine& engine, Port& port, byte_span place, instant until,
                         duration write_limit = milliseconds(1'000))
{
    auto const sent = detail::send_from(engine, port, write_limit, until);
    return sent ? detail::receive_within_pass(engine, port, place, until) : result<void>{sent.error()};
}

/// Sends requests and waits for their outcomes. May be left unused for any time. Borrows its port, which must outlive
/// it. `Needs` is as for `basic_client`.
template <detail::serial_port Port, auto const& Needs = host_needs> class blocking_client {
    using engine = basic_client<Needs>;

public:
    /// The same, of which a sink takes the frames as they pass, from `trace_to(sink)` on; the same that counts.
    template <typename Sink> using traced_by = blocking_client<Port, detail::traced_needs<Needs, Sink>>;
    template <typename Counts> using observed_by = blocking_client<Port, detail::observed_needs<Needs, Counts>>;

    /// With these times, whatever the port is set to.
    blocking_client(Port& its_port, line_timing const& its_line, client_options const& its_options = {}) noexcept
        requires(not detail::told_by<Needs>::is_fixed)
        : port_{its_port}, client_{its_line, its_options}, write_limit_{time_to_write(its_line, its_options)}
    {}

    /// With the times that suit the device, as the port tells them now: `its_port` has been opened before. With needs that have a
    /// `timing`, with that and their options.
    explicit blocking_client(Port& its_port) noexcept
        requires(detail::timed_port<Port> or detail::told_by<Needs>::is_fixed)
        : port_{its_port}, client_{made_for(its_port)}, write_limit_{time_to_write(client_.line(), Needs.options)}
    {}
    /// With the port's times as they are now, and these options.
    blocking_client(Port& its_port, client_options const& its_options) noexcept
        requires(detail::timed_port<Port> and not detail::told_by<Needs>::is_fixed)
        : blocking_client{its_port, its_port.timing(), its_options}
    {}

    /// Sends one request and waits for its outcome. The response is a view of this client's memory, valid until the
    /// next `ask`. Errors: those of encoding, an exception of the unit, those of the client, those of the port.
    template <typename To, detail::pdu Request> result<typename Request::response> ask(To to, Request const& request) &
    {
        static_assert(not std::same_as<To, detail::broadcast_t>, "a broadcast has no response: use send_broadcast");
        single_request conversation{to, request};
        auto const outcome = run(conversation);
        if (not outcome) {
            return outcome.error();
        }
        byte_view const pdu = outcome->pdu();
        byte_writer{response_}.bytes(pdu);
        return response{byte_view{response_}.first(pdu.size())}.template to<Request>();
    }
    template <typename To, detail::pdu Request>
    result<typename Request::response> ask(To to, Request const& request) && = delete;

    /// Sends a broadcast and waits for the turnaround delay to end. Errors: those of encoding, of the client, of the
    /// port.
    template <detail::broadcastable Request> result<void> send_broadcast(Request const& command)
    {
        return run(single_request{broadcast, command});
    }

    /// The frame for which the last request failed, with `wrong_length`, `crc_mismatch` and the like: see the client's.
    /// Valid until the next `ask` or `run`.
    [[nodiscard]] std::optional<detail::refused_frame> refused() const noexcept { return client_.refused(); }

    /// What was counted, where counting was asked for.
    [[nodiscard]] auto const& statistics() const noexcept { return client_.statistics(); }

    /// Hands the frames that pass from here on to a sink, which must outlive this client. For a client `traced_by` it.
    template <typename Sink>
        requires detail::is_traced_by<typename detail::told_by<Needs>::observer, Sink>
    void trace_to(Sink& frames) noexcept { client_.trace_to(frames); }

    /// Whether the line has given back what was sent: see the client's.
    [[nodiscard]] bool has_seen_echo() const noexcept { return client_.has_seen_echo(); }

    /// Which motors this client ordered to run, and the end of a stop's hold that was given up: see the client's and the bus's.
    [[nodiscard]] bool is_ordered(unit_id unit) const noexcept requires(Needs.motors != 0)
    {
        return client_.motor_orders().is_ordered(unit.byte());
    }
    void release(unit_id unit) noexcept requires(Needs.motors != 0) { client_.release(unit); }
    void release_all() noexcept requires(Needs.motors != 0) { client_.release_all(); }

    /// Runs a conversation until it is settled, and returns its `outcome()`; where it has none, its `reason()`; where it
    /// has neither, a `result<void>`. Of a conversation without a name whose outcome is a view of its response
    /// (`single_request`), only the error: the response ends with the statement. One whose outcome is a value gives it.
    /// One that is already settled begins anew, by its `again()`; so does one that commands a motor and that an error of the
    /// port has left under way: a stop stops again. Errors besides its own: `used_already` where it has none; those of the
    /// port: the request under way is then cancelled, and the conversation itself gets that as its outcome.
    template <typename Conversation>
        requires conversation<std::remove_cvref_t<Conversation>>
    auto run(Conversation&& conversation)
    {
        errc const why = run_to_end(conversation);
        return why == errc::none ? detail::outcome_of(std::forward<Conversation>(conversation))
                                 : detail::outcome_of(std::forward<Conversation>(conversation), why);
    }

private:
    static engine made_for(Port& its_port) noexcept
    {
        if constexpr (detail::told_by<Needs>::is_fixed) {
            return engine{};
        } else {
            return engine{its_port.timing()};
        }
    }

    /// Whether a conversation stops motors, by a word that it sends whatever else fails, and ends by its own limit.
    template <typename Conversation> static constexpr bool has_to_stop(Conversation const& conversation) noexcept
    {
        if constexpr (detail::may_be_stop<Conversation>) {
            return conversation.is_stop();
        } else {
            return detail::stops_by_broadcast<Conversation> or detail::frees_all_units<Conversation>;
        }
    }

    /// Whether a conversation can be run. What a former run left of one that commands a motor was ordered, and timed, then.
    template <typename Conversation> static constexpr bool can_run(Conversation& conversation) noexcept
    {
        constexpr bool commands = detail::commanding_conversation<Conversation> or
                                  detail::stops_by_broadcast<Conversation> or detail::frees_all_units<Conversation>;
        return (commands and detail::begins_anew(conversation)) or detail::can_run(conversation);
    }

    /// Until it is settled; or `used_already`, or the error of the port. Where it has to stop, the port's reads end nothing
    /// before the word that stops has left, or 1 s in which it was not written, without what the program was stopped for: so
    /// much is sent even where nothing can be read. Nor does a write that fails, but for a device that is gone: one that has
    /// ended by that begins anew for 1 s, of which the program's stops count a third at most.
    template <conversation Conversation> errc run_to_end(Conversation& conversation)
    {
        static_assert(not detail::endless_conversation<Conversation>,
                      "this conversation never ends: give it to a client in each pass");
        if (not can_run(conversation)) {
            return errc::used_already;
        }
        auto passed = drop_stale_input();
        bool has_to_say = has_to_stop(conversation) and passed != errc::bus_jam;
        bool has_failed = false; // a write
        duration awake{};
        instant seen = port_.now();
        auto const is_written_again = [&] {
            return has_to_say and has_failed and awake < longest_wait and detail::begins_anew(conversation);
        };
        duration spent{};
        while (passed or (has_to_say and spent < longest_wait)) {
            instant const now = port_.now();
            duration const passed_by = now - std::exchange(seen, now);
            spent = spent + part_of(longest_wait, passed_by);
            awake = awake + (passed_by < most_of_a_pass ? passed_by : most_of_a_pass);
            client_.advance(now);
            client_.converse(conversation, now);
            if (conversation.settled() and not client_.is_asked_by(conversation)) {
                if constexpr (detail::frees_all_units<Conversation>) {
                    // The program was stopped while the line fell silent. Other stops are asked for no word before it has.
                    if (has_to_say and client_.is_quiet() and conversation.outcome().error() == errc::bus_jam) {
                        conversation.again();
                        continue;
                    }
                }
                if (is_written_again()) {
                    continue;
                }
                return errc::none; // one visit more would take its outcome back
            }
            if (not client_.is_busy()) {
                passed = wait_for(conversation, now);
                if (not passed and longest_wait < spent * 2) {
                    read_nothing(conversation);
                }
                continue;
            }
            bool const says_it = is_said(conversation);
            instant until = now + longest_wait;
            auto const sent = detail::send_from(client_, port_, write_limit_, until);
            bool const has_left = sent and *sent;
            passed = sent ? detail::receive_within_pass(client_, port_, input_, until) : result<void>{sent.error()};
            has_to_say = has_to_say and not(has_left and says_it) and (sent or is_passing(sent.error()));
            bool const goes_on =
                sent ? has_to_say and has_left : has_to_stop(conversation) and is_passing(sent.error());
            if (not passed and goes_on) {
                fail(conversation, passed.error());
                has_failed = has_failed or not sent;
                if (conversation.settled() and not is_written_again()) {
                    return errc::none;
                }
                if (not sent) {
                    passed = {};
                    spent = {};
                }
            }
        }
        give_up(conversation, port_.now());
        return passed.error();
    }

    /// Whether the request of a conversation that has to stop is its word.
    template <typename Conversation> static constexpr bool is_said(Conversation const& conversation) noexcept
    {
        if constexpr (detail::frees_all_units<Conversation>) {
            return true;
        } else if constexpr (detail::may_be_stop<Conversation> or detail::stops_by_broadcast<Conversation>) {
            return has_to_stop(conversation) and conversation.intent() == detail::effect::stopping;
        } else {
            return false;
        }
    }

    /// A stop that would read something before its next word goes on without it: what its unit owes may keep the read back for
    /// longer than this client goes on.
    template <typename Conversation> static constexpr void read_nothing(Conversation& conversation) noexcept
    {
        if constexpr (detail::stops_by_broadcast<Conversation>) {
            for (auto& each : conversation.stops()) {
                read_nothing(each);
            }
        } else if constexpr (detail::may_be_stop<Conversation>) {
            if (conversation.is_stop() and conversation.has_request() and
                conversation.intent() == detail::effect::none) {
                conversation.note_loss();
            }
        }
    }

    /// Whether another write may succeed behind one that failed so.
    static constexpr bool is_passing(errc why) noexcept
    {
        return why == errc::transmit_stalled or why == errc::device_failed;
    }

    /// Ends the request under way. The time of what its unit owes begins now, which may be an hour after the latest `advance`.
    template <typename Conversation> void end_request(Conversation& conversation, instant now)
    {
        client_.advance(now);
        client_.cancel(conversation, now);
        client_.sent(now);
    }

    /// Ends the request under way of a conversation that goes on: with the error of the port, for it may have left.
    template <typename Conversation> void fail(Conversation& conversation, errc why)
    {
        instant const now = port_.now();
        end_request(conversation, now);
        conversation.forget();
        conversation.accept(why);
    }

    /// Ends the request under way: once the port has failed, nothing more is known of it.
    template <typename Conversation> void give_up(Conversation& conversation, instant now)
    {
        end_request(conversation, now);
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
        if constexpr (detail::timed_conversation<Conversation>) {
            if (deadline const own = conversation.poll_deadline(); own and not reached(now, *own)) {
                next = earlier(next, own);
            }
        }
        return detail::receive_until(client_, port_, input_, next ? *next : now + longest_pause);
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
        duration busy{};
        for (;;) {
            stale_input old{client_};
            auto const passed = receive_from(port_, old, input_, until);
            if (not passed or not old.has_come) {
                return passed;
            }
            until = port_.now();
            busy = busy + part_of(limit, until - std::exchange(now, until));
            if (busy >= limit) {
                return errc::bus_jam;
            }
        }
    }

    /// For how long old input comes at least, and by how many reads, before it counts as one that never ends.
    static constexpr duration least_jam = milliseconds(100);
    static constexpr std::uint32_t least_reads_of_a_jam = 64;

    /// What one read, or one pass, counts of a limit: the program may have been stopped for most of it.
    static constexpr duration part_of(duration limit, duration passed) noexcept
    {
        duration const most{limit.microseconds / least_reads_of_a_jam};
        return passed < most ? passed : most;
    }

    /// A port has the response time-out to take a frame, but no more than the longest frame's own time on the line and 1 s.
    static constexpr duration time_to_write(line_timing const& line, client_options const& options) noexcept
    {
        duration const most = line.characters(max_adu_size) + milliseconds(1'000);
        return options.response_timeout < most ? options.response_timeout : most;
    }

    /// How long to wait for a conversation that pauses and gives no deadline.
    static constexpr duration longest_pause = milliseconds(10);
    /// What one pass counts at most of the time in which a stop is written again.
    static constexpr duration most_of_a_pass = milliseconds(334);
    /// How long to wait for bytes before the next pass, where the client has no earlier deadline.
    static constexpr duration longest_wait = milliseconds(1'000);

    Port& port_;
    engine client_;
    duration write_limit_;
    std::array<std::byte, max_adu_size> input_{};
    std::array<std::byte, max_pdu_size> response_{};
};

} // namespace RTUWIRE_BUILD
} // namespace rtuwire
