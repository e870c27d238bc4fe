// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// What a client or a server tells of its line while it works, and who can be told: nobody, a sink of its frames, what counts
// (client/statistics.hpp), or several of them. An engine that nobody observes holds no byte of this and runs no instruction
// for it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <type_traits>

#include <rtuwire/core/bytes.hpp>
#include <rtuwire/core/time.hpp>
#include <rtuwire/core/version.hpp>
#include <rtuwire/trace/traced_frame.hpp>
#include <rtuwire/wire/errc.hpp>

namespace rtuwire {
inline namespace RTUWIRE_BUILD {

/// What can be counted.
enum class line_event : std::uint8_t {
    request,    ///< a request left for the first time
    repetition, ///< a request left again
    reply,      ///< a response was accepted
    timeout,    ///< no response in time
    late,       ///< a response came after its time, while no other was awaited
    foreign,    ///< a response of another unit
    crc,        ///< a frame with a wrong CRC, or with a receive error
    length,     ///< a frame whose size is wrong
    mismatch,   ///< a good frame that is no response to the request
    exception,  ///< an exception response
    collision,  ///< our own transmission came back changed
    jam,        ///< the line did not fall silent
    noise,      ///< a byte that belonged to no response
};

namespace detail {

/// What a frame counts as, by the error that was found in it.
[[nodiscard]] constexpr line_event event_of(errc found) noexcept
{
    if (found == errc::none) {
        return line_event::reply;
    }
    if (is_exception(found)) {
        return line_event::exception;
    }
    if (found == errc::frame_too_short or found == errc::frame_too_long or found == errc::wrong_length) {
        return line_event::length;
    }
    if (found == errc::crc_mismatch or found == errc::uart_error) {
        return line_event::crc;
    }
    return found == errc::wrong_unit ? line_event::foreign : line_event::mismatch;
}

/// What a frame is that ended while a response was awaited: by what was found in it; whether its CRC is right, and its size
/// the one that its own bytes tell; whether the unit that it names owes a response to an earlier request.
[[nodiscard]] constexpr frame_verdict verdict_on_response(errc found, bool is_whole, bool is_owed) noexcept
{
    if (not is_whole) {
        return frame_verdict::damaged;
    }
    if (found == errc::none or is_exception(found)) {
        return frame_verdict::good;
    }
    if (found == errc::wrong_unit) {
        return is_owed ? frame_verdict::late : frame_verdict::foreign;
    }
    return found == errc::line_echo ? frame_verdict::echo : frame_verdict::stray;
}

/// Who is told nothing; also what another observer need not care for.
struct no_observer {
    /// A request to a unit begins to leave, or something has happened to it that is no frame.
    static constexpr void on_event(line_event, std::uint8_t) noexcept {}
    /// A frame of this end has left, or will have by then.
    static constexpr void on_sent(byte_view, frame_role, instant) noexcept {}
    /// Bytes have arrived by then: what is told from here on ended then.
    static constexpr void on_arrival(instant) noexcept {}
    /// A frame ended by then while the response of a unit was awaited: what it counts as, and the error that was found in it.
    static constexpr void on_response(line_event, errc, std::uint8_t, instant) noexcept {}
    /// Bytes came that nobody asked for, the first of them after silence or not; of a late response of that unit, or 0.
    static constexpr void on_stray(byte_view, bool, std::uint8_t) noexcept {}
    /// The rest of a response is not waited for; whether it began as one of the unit that was asked.
    static constexpr void on_response_cut(byte_view, bool) noexcept {}
    /// What was sent came back, or a part of it.
    static constexpr void on_echo(byte_view, frame_role) noexcept {}
    /// Any other bytes have arrived, as a frame or as none.
    static constexpr void on_bytes(byte_view, frame_role, frame_verdict) noexcept {}
    /// A frame of this end begins to leave; bytes arrive while it does. Told by a server.
    static constexpr void on_leaving() noexcept {}
    static constexpr void on_arrival_while_leaving(byte_view, byte_view, frame_role) noexcept {}
};

/// Whether an engine tells anybody anything; whether a sink can take its frames.
template <typename Observer> inline constexpr bool is_observed = not std::is_same_v<Observer, no_observer>;
template <typename Observer, typename Sink>
inline constexpr bool is_traced_by = requires(Observer& observer, Sink& sink)
{
    observer.trace_to(sink);
};

/// Hands the frames to a sink.
template <typename Sink> class tracing {
    static_assert(frame_sink<Sink>, "a sink of frames has a function take(traced_frame const&) that is noexcept");

public:
    constexpr void trace_to(Sink& frames) noexcept { sink_ = &frames; }

    static constexpr void on_event(line_event, std::uint8_t) noexcept {}

    constexpr void on_sent(byte_view bytes, frame_role role, instant at) noexcept
    {
        hand({bytes, at, role, frame_verdict::good, true});
    }

    constexpr void on_arrival(instant at) noexcept { heard_ = at; }

    static constexpr void on_response(line_event, errc, std::uint8_t, instant) noexcept {}

    /// Those behind the start of a late response belong to it.
    constexpr void on_stray(byte_view bytes, bool is_start, std::uint8_t late_unit) noexcept
    {
        is_late_ = is_start ? late_unit != 0 : is_late_;
        on_bytes(bytes, is_late_ ? frame_role::response : frame_role::unknown,
                 is_late_ ? frame_verdict::late : frame_verdict::stray);
    }

    constexpr void on_response_cut(byte_view bytes, bool is_of_unit) noexcept
    {
        on_stray(bytes, true, is_of_unit ? std::uint8_t{1} : std::uint8_t{0});
    }

    constexpr void on_echo(byte_view bytes, frame_role role) noexcept
    {
        hand({bytes, heard_, role, frame_verdict::echo, true});
    }

    constexpr void on_bytes(byte_view bytes, frame_role role, frame_verdict verdict) noexcept
    {
        hand({bytes, heard_, role, verdict, false});
    }

    constexpr void on_leaving() noexcept { echoed_ = 0; }

    /// The next bytes of the echo of `own`, or others. After others no more are its echo.
    constexpr void on_arrival_while_leaving(byte_view bytes, byte_view own, frame_role role) noexcept
    {
        bool const is_echo =
            bytes.size() <= own.size() - echoed_ and same_bytes(bytes, own.subspan(echoed_, bytes.size()));
        echoed_ = is_echo ? echoed_ + bytes.size() : own.size();
        is_echo ? on_echo(bytes, role) : on_bytes(bytes, frame_role::unknown, frame_verdict::stray);
    }

private:
    constexpr void hand(traced_frame const& frame) noexcept
    {
        if (sink_ != nullptr and not frame.bytes.empty()) {
            sink_->take(frame);
        }
    }

    Sink* sink_{nullptr};
    instant heard_{0};
    std::size_t echoed_{0}; ///< how many bytes of the frame that leaves have come back
    bool is_late_{false};
};

/// Both are told.
template <typename First, typename Second> struct observers {
    constexpr void on_event(line_event what, std::uint8_t unit) noexcept
    {
        first.on_event(what, unit);
        second.on_event(what, unit);
    }
    constexpr void on_sent(byte_view frame, frame_role role, instant at) noexcept
    {
        first.on_sent(frame, role, at);
        second.on_sent(frame, role, at);
    }
    constexpr void on_arrival(instant now) noexcept
    {
        first.on_arrival(now);
        second.on_arrival(now);
    }
    constexpr void on_response(line_event what, errc found, std::uint8_t unit, instant now) noexcept
    {
        first.on_response(what, found, unit, now);
        second.on_response(what, found, unit, now);
    }
    constexpr void on_stray(byte_view bytes, bool is_start, std::uint8_t late_unit) noexcept
    {
        first.on_stray(bytes, is_start, late_unit);
        second.on_stray(bytes, is_start, late_unit);
    }
    constexpr void on_response_cut(byte_view bytes, bool is_of_unit) noexcept
    {
        first.on_response_cut(bytes, is_of_unit);
        second.on_response_cut(bytes, is_of_unit);
    }
    constexpr void on_echo(byte_view bytes, frame_role role) noexcept
    {
        first.on_echo(bytes, role);
        second.on_echo(bytes, role);
    }
    constexpr void on_bytes(byte_view bytes, frame_role role, frame_verdict verdict) noexcept
    {
        first.on_bytes(bytes, role, verdict);
        second.on_bytes(bytes, role, verdict);
    }
    constexpr void on_leaving() noexcept
    {
        first.on_leaving();
        second.on_leaving();
    }
    constexpr void on_arrival_while_leaving(byte_view bytes, byte_view own, frame_role role) noexcept
    {
        first.on_arrival_while_leaving(bytes, own, role);
        second.on_arrival_while_leaving(bytes, own, role);
    }

    /// The one that hands frames to such a sink gets it.
    template <typename Sink>
        requires(is_traced_by<First, Sink> or is_traced_by<Second, Sink>)
    constexpr void trace_to(Sink& frames) noexcept
    {
        if constexpr (is_traced_by<First, Sink>) {
            first.trace_to(frames);
        } else {
            second.trace_to(frames);
        }
    }

    [[no_unique_address]] First first{};
    [[no_unique_address]] Second second{};
};

/// The observer, or the first of several: what counts stands there.
template <typename Observer> [[nodiscard]] constexpr auto& first_of(Observer& observer) noexcept
{
    if constexpr (requires { observer.first; }) {
        return first_of(observer.first);
    } else {
        return observer;
    }
}

} // namespace detail

} // namespace RTUWIRE_BUILD
} // namespace rtuwire
