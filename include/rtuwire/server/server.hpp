// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// A unit's end of a line (SL 2.4.2): takes requests to this unit and to everyone, answers the former,
// and is silent on anything else. Owns neither the wire, nor a clock, nor the registers.
//
//   phase         event                                          -> next phase
//   listening     a whole request to this unit or everyone       -> asked
//   asked         serve                                          -> answering; listening where no response is due
//                 bytes; the end of its time                     -> listening, the request is dropped
//   answering     poll_transmit after t3.5 of silence            -> transmitting
//                 bytes; the end of its time                     -> listening, the response is dropped
//   transmitting  sent                                           -> listening
//                 the end of its time                            -> listening after the next silence
//
// The end of its time: for asked and answering, frame_end + answer_limit after the request's last byte;
// for transmitting, the time of the response's characters and answer_limit more.
#pragma once

#include <cstdint>
#include <optional>

#include <rtuwire/core/time.hpp>
#include <rtuwire/core/version.hpp>
#include <rtuwire/rtu/framer.hpp>
#include <rtuwire/rtu/line.hpp>
#include <rtuwire/server/respond.hpp>
#include <rtuwire/wire/unit_id.hpp>

namespace rtuwire::inline RTUWIRE_BUILD {

/// Serves one unit address. In each pass call `receive` with what arrived, `sent` when the last stop
/// bit of a response has left, `advance`, `serve`; then send what `poll_transmit` gives. Sleep no longer
/// than `poll_deadline` says; call `advance` at least every 35 minutes. `now` never goes back.
///
/// Which frames end. Bytes are ignored until the line was silent for `frame_end` once; before the first
/// `advance`, time is not known and all bytes are ignored. Then a frame begins with the next byte. It ends
/// - at the size of its request's length rule (wire/frame_length.hpp) with a right CRC;
/// - where the last good frame was a request to another unit and the first two bytes are that unit and that
///   function, with or without 80: at the size of the response's rule, too, whichever size comes first with a
///   right CRC. For functions 01 to 04 the size of a request does not count where the fifth byte is above 7
///   (01, 02) or above 0 (03, 04): such a quantity is not allowed. Where the other rule tells one byte more (or
///   for function 43 is asked again there) and the frame may be a request by its fifth byte, the end is
///   open: a byte 00 that comes next is part of the frame, which then ended by the other rule; any other
///   byte, or t3.5 of silence, ends it. Where both rules give the size, it ended by the request's;
/// - else after a silence of `frame_end`. It is then good if its CRC is right and it has 4 to 256 bytes.
/// A chunk of n bytes handed over at `now` comes after a silence of s where `now` is s + n characters, or
/// more, after the last byte before it. A frame with a wrong CRC, with a byte that was reported damaged, too
/// short or too long is dropped, and ends by silence only.
///
/// What follows from a good frame. To this unit or to 0, with a function below 80: it is a request and waits
/// for `serve`. To another unit, a function below 80, and not ended at the size of an expected response: a
/// request to another unit. Anything else is ignored, and what was expected no longer is. No frame is
/// looked for anywhere but at its first byte. Another unit's response to a request that was not heard is
/// read as a request; its CRC is then wrong, and the next silence ends it.
///
/// Which requests are executed. A request is executed by `serve` if no byte was received after it, damaged
/// ones aside, and `now` is before its end of time. Otherwise it is neither executed nor answered: its client
/// may have given up and asked for something else. Broadcasts are no exception: serve within the client's
/// turnaround delay. The bytes behind it are read as the next frame, which may be the newer request.
/// A response leaves when t3.5 has passed since the last byte, damaged or not; it is dropped if a
/// byte that is not damaged arrives before `poll_transmit` hands it out, or at the end of time. The request
/// was executed then.
template <typename Diagnostics> class basic_server {
public:
    /// Listens as `unit`; the profile, and the objects in it, outlive the server.
    constexpr basic_server(unit_id unit, line_timing const& timing,
                           server_profile const& profile) noexcept
        : unit_{unit.octet()}, profile_{&profile}, framer_{timing}
    {}

    /// Listens as `unit` with every function and the specification's limits, without identification.
    constexpr basic_server(unit_id unit, line_timing const& timing) noexcept
        : basic_server{unit, timing, default_profile}
    {}

    basic_server(unit_id, line_timing const&, server_profile&&) = delete;

    /// Takes bytes that had arrived by `now`, in any chunking. Drops a request that waits for `serve`, or its
    /// response, and reads on. While a response leaves, bytes are ignored, and only keep the line from being
    /// silent.
    constexpr void receive(byte_view octets, instant now) noexcept
    {
        while (not octets.empty()) {
            if (phase_ == phase::transmitting) {
                receive_error(now);
                return;
            }
            drop_request();
            octets = octets.subspan(framer_.receive(octets, now));
            take_frame();
        }
    }

    /// Reports a byte that arrived damaged (parity, framing, overrun): its frame is refused. After a request,
    /// where the line often makes one when it turns around, it only delays the response; bytes behind it are
    /// ignored up to a silence of `frame_end`, and drop the request all the same. A frame that silence ended
    /// before it, and no `advance` has seen, is dropped.
    constexpr void receive_error(instant now) noexcept
    {
        if (phase_ == phase::listening) {
            framer_.receive_error(now);
        } else {
            framer_.note_activity(now);
            framer_.resynchronise();
        }
    }

    /// The same, where the receiver says that it lost an octet.
    constexpr void receive_overrun(instant now) noexcept
    {
        diagnostics_.note_overrun();
        receive_error(now);
    }

    /// Takes note that the last stop bit of what `poll_transmit` gave has left at `now`: the next byte begins
    /// a frame. In any other phase the line was not silent at `now`, and nothing else.
    constexpr void sent(instant now) noexcept
    {
        if (phase_ == phase::transmitting) {
            framer_.restart(now);
            phase_ = phase::listening;
        } else {
            framer_.note_activity(now);
        }
    }

    /// Lets time pass. Where `sent` did not come in time, the server listens again once the line has been
    /// silent for `frame_end` since the last byte; a `sent` after that does no harm.
    constexpr void advance(instant now) noexcept
    {
        if (phase_ != phase::listening and reached(now, until_)) {
            if (phase_ == phase::transmitting) {
                framer_.resynchronise();
                phase_ = phase::listening;
            }
            drop_request();
        }
        framer_.advance(now);
        if (phase_ == phase::listening) {
            take_frame();
        }
    }

    /// Calls `advance`; then does what a request asks of the registers, and prepares the response. A broadcast
    /// is executed for functions 06 and 16 only, and never answered.
    template <register_bank Bank> constexpr void serve(Bank& bank, instant now) noexcept
    {
        advance(now);
        if (phase_ != phase::asked) {
            return;
        }
        diagnostics_.note_request();
        pdu_place pdu{framer_.storage().subspan(1).first<max_pdu_size>(), pdu_size_};
        bool const is_broadcast = to_u8(framer_.storage()[0]) == 0;
        bool const is_meant = not is_broadcast or may_be_broadcast(pdu.view());
        bool const is_deaf =
            diagnostics_.is_listen_only() and
            (is_broadcast or not is_pdu_of(pdu.view(), function_code::diagnostics));
        if (is_meant and not is_deaf) {
            respond_in_place(pdu, bank, *profile_, diagnostics_);
            count(pdu.view());
        } else {
            pdu.size = 0;
            if (not is_deaf) {
                diagnostics_.note_exception(errc::illegal_function);
            }
        }
        if (is_broadcast or pdu.size == 0) {
            diagnostics_.note_silence();
            phase_ = phase::listening;
            return;
        }
        pdu_size_ = static_cast<std::uint8_t>(pdu.size);
        static_cast<void>(seal(framer_.storage(), pdu.size));
        phase_ = phase::answering;
    }

    /// The bytes to send now, once, after the `serve` or `advance` that saw t3.5 of silence; empty when there
    /// is nothing. They lie in the server, unchanged until `sent`, or until the end of time in its place.
    [[nodiscard]] constexpr byte_view poll_transmit() noexcept
    {
        if (phase_ != phase::answering or not framer_.is_quiet()) {
            return {};
        }
        phase_ = phase::transmitting;
        byte_view const frame = framer_.storage().first(pdu_size_ + adu_overhead);
        until_ = until_ + framer_.line().characters(frame.size()) + answer_limit;
        return frame;
    }

    /// When `advance` has something to do. Listening: never between frames and before the first `advance`;
    /// with a frame begun, or while bytes are ignored, the last byte + `frame_end` (t3.5 with an open end).
    /// In any other phase: the end of its time; the last byte + t3.5 before that, until `advance` has seen it.
    [[nodiscard]] constexpr deadline poll_deadline() const noexcept
    {
        if (phase_ == phase::listening) {
            return framer_.poll_end_deadline();
        }
        instant const quiet = framer_.last_activity() + framer_.line().t3_5();
        return framer_.is_quiet() or reached(quiet, until_) ? until_ : quiet;
    }

    /// Listens to another address from the next frame on; without one, to broadcasts only. An answer that waits
    /// still leaves.
    constexpr void listen_as(std::optional<unit_id> unit) noexcept
    {
        unit_ = unit ? unit->octet() : std::uint8_t{0};
    }

    /// Whether a request waits for `serve`.
    [[nodiscard]] constexpr bool is_asked() const noexcept { return phase_ == phase::asked; }

    /// How long after its request, and the silence that may have ended that, a response may start to leave;
    /// and how long after its last character `sent` may come. Later its client may have given up, and the
    /// response pass for one to another request; no client waits less for a response. A transmitter that has
    /// not started, or not told of its end, within this time never will.
    static constexpr duration answer_limit = milliseconds(100);

private:
    enum class phase : std::uint8_t { listening, asked, answering, transmitting };

    static constexpr server_profile default_profile{};

    constexpr void take_frame() noexcept
    {
        if (not framer_.poll_end()) {
            return;
        }
        if (framer_.verdict() != errc::none) {
            diagnostics_.note_error();
            return;
        }
        diagnostics_.note_message();
        adu const heard = framer_.frame();
        std::uint8_t expected = exception_bit; // no response
        if (not framer_.is_overheard() and not heard.is_exception()) {
            if (heard.unit() == unit_ or heard.unit() == 0) {
                pdu_size_ = static_cast<std::uint8_t>(heard.pdu().size());
                until_ = framer_.last_activity() + framer_.line().frame_end() + answer_limit;
                phase_ = phase::asked;
            } else {
                expected = heard.wire_code();
            }
        }
        framer_.overhear(heard.unit(), expected);
    }

    constexpr void count(byte_view answer) noexcept
    {
        if (not answer.empty() and (to_u8(answer[0]) & exception_bit) != 0) {
            diagnostics_.note_exception(exception_error(to_u8(answer[1])));
        }
    }

    /// Drops the request that waits, or its answer.
    constexpr void drop_request() noexcept
    {
        if (phase_ == phase::answering) {
            diagnostics_.note_silence();
        }
        phase_ = phase::listening;
    }

    // Small first, as in the framer.
    phase phase_{phase::listening};
    std::uint8_t unit_;
    std::uint8_t pdu_size_{0}; ///< of the request, then of the answer
    instant until_{0};         ///< when the phase ends by itself, unless it is listening
    server_profile const* profile_;
    framer<direction::request> framer_;
    [[no_unique_address]] Diagnostics diagnostics_{};
};

/// A server that answers of function 08 the loopback (sub-function 0) only.
using server = basic_server<loop_back>;

/// A server that counts, and can be told to listen only.
using counting_server = basic_server<serial_diagnostics>;

} // namespace rtuwire
