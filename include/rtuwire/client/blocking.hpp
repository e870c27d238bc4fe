// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// A client that waits, for hosts: it drives the sans-IO client over a port until an outcome is there.
// Knows of the operating system only what the port shows.
#pragma once

#include <array>
#include <concepts>
#include <cstddef>

#include <rtuwire/client/client.hpp>
#include <rtuwire/client/single_question.hpp>
#include <rtuwire/core/version.hpp>
#include <rtuwire/rtu/receive_from.hpp>

namespace rtuwire::inline RTUWIRE_BUILD {

/// A serial port as seen from here: it has a clock, takes all it is given before a deadline and sends it
/// at the line's pace, and reads what is there or arrives before a deadline (none: an empty span). It may
/// also report damaged bytes: see `reports_receive_errors`.
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

/// The end of one pass of a client or a bus over a host's port, after `advance` and `converse`: sends
/// what there is to send, then takes what has arrived, or arrives until `until` or until the engine has
/// something to do. `place` is working memory. Errors: those of the port.
template <typename Engine, serial_port Port>
result<void> pump(Engine& engine, Port& port, byte_span place, instant until,
                  duration write_limit = milliseconds(1'000))
{
    if (byte_view const frame = engine.poll_transmit(); not frame.empty()) {
        auto const written = port.write(frame, port.now() + write_limit);
        if (not written) {
            return written;
        }
        // Asking the driver until when costs a call, and adapters do not know.
        engine.sent(port.now() + engine.line().characters(frame.size()));
    }
    return receive_from(port, engine, place, *earlier(engine.poll_deadline(), until));
}

/// Asks and waits. Borrows its port, which must outlive it.
template <serial_port Port> class blocking_client {
public:
    blocking_client(Port& port, line_timing const& line,
                    client_options const& options = {}) noexcept
        : port_{port}, client_{line, options}, write_limit_{options.response_timeout}
    {}

    /// Asks one question and waits for its outcome. The answer is a view of this client's memory, valid until
    /// the next `ask`. Errors: those of encoding, an exception of the unit, those of the client, those of the
    /// port.
    template <typename To, pdu Request>
    result<typename Request::response> ask(To to, Request const& question) &
    {
        single_question talk{to, question};
        auto const outcome = outcome_of(talk);
        if (not outcome) {
            return outcome.error();
        }
        byte_view const pdu = outcome->pdu();
        byte_writer{answer_}.bytes(pdu);
        return response{byte_view{answer_}.first(pdu.size())}.template to<Request>();
    }
    template <typename To, pdu Request>
    result<typename Request::response> ask(To to, Request const& question) && = delete;

    /// Tells everyone on the line and waits out the turnaround delay. Errors: those of encoding, of
    /// the client, of the port.
    template <broadcastable Request> result<void> tell_all(Request const& command)
    {
        single_question talk{broadcast, command};
        auto const outcome = outcome_of(talk);
        if (not outcome) {
            return outcome.error();
        }
        return {};
    }

    /// Runs a conversation until it is settled; one that is settled already begins anew where it can. Errors:
    /// `finished` where it can't; those of the port: the question under way is then cancelled and the
    /// conversation told so.
    template <conversation Talk> result<void> run(Talk& talk)
    {
        static_assert(not endless_conversation<Talk>, "this conversation never ends: give it to a client in each pass");
        if (talk.settled()) {
            if constexpr (requires { talk.begin(); }) {
                talk.begin();
            } else {
                return errc::finished;
            }
        }
        auto passed = drop_stale_input();
        while (passed) {
            instant const now = port_.now();
            client_.advance(now);
            client_.converse(talk, now);
            if (client_.is_busy()) {
                passed = pump(client_, port_, input_, now + write_limit_, write_limit_);
            } else if (talk.settled()) {
                return {};
            } else {
                passed = wait_for(talk, now);
            }
        }
        give_up(talk, port_.now());
        return passed.error();
    }

private:
    /// Ends what is under way: of a port that failed, nothing more is known.
    template <typename Talk> void give_up(Talk& talk, instant now)
    {
        client_.cancel(talk, now);
        client_.sent(now);
        bool const is_asked = client_.is_asked_by(talk);
        if (client_.deliver(talk, false, now) == errc::pending and is_asked) {
            talk.forget();
            talk.accept(errc::cancelled);
        }
    }

    template <typename Talk> result<response> outcome_of(Talk& talk)
    {
        auto const ended = run(talk);
        if (not ended) {
            return ended.error();
        }
        return talk.outcome();
    }

    /// Waits until a conversation that paused at `now` may have something to ask again. A deadline that was
    /// over by then has had its effect; where none is left, the conversation is looked at again soon.
    template <typename Talk> result<void> wait_for(Talk& talk, instant now)
    {
        auto const ahead = [now](deadline const& next) {
            return next and not reached(now, *next) ? next : deadline{};
        };
        deadline next = ahead(client_.poll_deadline());
        if constexpr (timed_conversation<Talk>) {
            next = earlier(next, ahead(talk.poll_deadline()));
        }
        return receive_until(next ? *next : now + longest_pause);
    }

    /// What the operating system kept from before the question must not pass for its answer. Where the
    /// line has to fall silent first, one wait serves for both.
    result<void> drop_stale_input()
    {
        instant const now = port_.now();
        client_.advance(now);
        return receive_until(client_.is_quiet() ? now : now + client_.line().t3_5());
    }

    result<void> receive_until(instant until)
    {
        return receive_from(port_, client_, input_, until);
    }

    /// How long a conversation is left alone that pauses and does not say until when.
    static constexpr duration longest_pause = milliseconds(10);

    Port& port_;
    host_client client_;
    duration write_limit_;
    std::array<std::byte, max_adu_size> input_{};
    std::array<std::byte, max_pdu_size> answer_{};
};

} // namespace rtuwire
