// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// A server's end of a line, without the registers: which frames are requests to it, and when a response may leave.
// Internal: server/server.hpp is the one to use.
//
//   event                                  listening  asked       responding    transmitting
//   a whole request to this unit or all    asked      asked (1)   asked (1)     stays
//   any other byte                         stays      listening   listening     stays
//   a damaged byte                         stays      stays       stays         stays
//   serve, a response is due               -          responding  stays         stays
//   serve, none is due                     -          listening   -             -
//   poll_transmit after t3.5 of silence    stays      stays       transmitting  stays
//   poll_transmit before                   stays      stays       stays         stays
//   sent                                   stays      stays       stays         listening
//   its time limit                         -          listening   listening     listening (2)
//
// (1) the newer one: what waited is dropped, and so it is where the table says listening. (2) after the next silence.
// Time limit: for asked and responding, frame_end + response_limit after the request's last byte; for transmitting,
// the time of the response's characters and response_limit more.
#pragma once

#include <cstddef>
#include <cstdint>

#include <rtuwire/core/time.hpp>
#include <rtuwire/core/version.hpp>
#include <rtuwire/rtu/frame_cutter.hpp>
#include <rtuwire/rtu/line.hpp>
#include <rtuwire/server/respond.hpp>
#include <rtuwire/server/server_reception.hpp>
#include <rtuwire/wire/limits.hpp>

namespace rtuwire::inline RTUWIRE_BUILD {

/// A server without its functions and banks; what its calls do stands at `basic_server`. `Units` knows by
/// `contains(unit)` which unit addresses are its own.
template <typename Diagnostics, typename Units>
class server_engine : public server_reception<server_engine<Diagnostics, Units>, Diagnostics> {
    friend server_trace<server_engine, Diagnostics>;
    friend server_reception<server_engine, Diagnostics>;

public:
    /// Reports that the last stop bit of what `poll_transmit` returned was sent at `now`: the next byte begins a
    /// frame. In any other phase it only means that the line was not silent at `now`.
    constexpr void sent(instant now) noexcept
    {
        if (phase_ == phase::transmitting) {
            framer_.restart(now);
            phase_ = phase::listening;
            this->pass_sent(now);
        } else {
            framer_.note_activity(now);
        }
    }

    /// Lets time pass. Where `sent` was not called in time, the server listens again once the line has been silent
    /// for `frame_end` since the last byte; a `sent` after that does no harm.
    constexpr void advance(instant now) noexcept
    {
        end_overdue(now);
        framer_.advance(now);
        if (phase_ == phase::listening) {
            take_frame();
        }
    }

    /// The bytes to send now, once, after the `serve` or `advance` that found the silence before sending; empty when
    /// there are none. They are stored in the server, unchanged until `sent`, or until the time limit without it.
    [[nodiscard]] constexpr byte_view poll_transmit() noexcept
    {
        if (phase_ != phase::responding or not framer_.is_quiet()) {
            return {};
        }
        phase_ = phase::transmitting;
        std::size_t const size = pdu_size_ + adu_overhead;
        until_ = until_ + framer_.line().characters(size) + response_limit;
        this->pass_leaving();
        return {framer_.storage().data(), size};
    }

    /// When `advance` is due next. Listening: never before the first `advance`; with a frame begun, or while bytes are
    /// ignored, the last byte + `frame_end` (t3.5 with an open end); between frames, and in any other phase, the last
    /// byte + the silence before sending, until `advance` has processed it; after that never between frames, and in
    /// any other phase the time limit, which may come first.
    [[nodiscard]] constexpr deadline poll_deadline() const noexcept
    {
        if (phase_ == phase::listening) {
            return framer_.poll_end_deadline();
        }
        instant const quiet = framer_.last_activity() + framer_.line().silence();
        return framer_.is_quiet() or reached(quiet, until_) ? until_ : quiet;
    }

    /// Whether a request waits for `serve`.
    [[nodiscard]] constexpr bool is_asked() const noexcept { return phase_ == phase::asked; }

    /// How long after its request, and the silence that may have ended that, the sending of a response may start; and
    /// how long after its last character `sent` may be called. Later its client may have timed out, and take the
    /// response for one to another request; no client waits less for a response. A transmitter that has not started,
    /// or not reported its end, within this time never will.
    static constexpr duration response_limit = milliseconds(100);

protected:
    static constexpr server_profile default_profile{};

    constexpr server_engine(Units const& units, line_timing const& its_line, server_profile const& allowed) noexcept
        : units_{units}, profile_{&allowed}, framer_{its_line}
    {}

    constexpr void set_units(Units const& units) noexcept { units_ = units; }

    /// Serves a waiting request: on that bank, or on those of the units. Force-inlined, which is smaller.
    template <typename Functions, typename Bank>
    [[gnu::always_inline]] constexpr void serve_by(Bank&& bank, instant now) noexcept
    {
        advance(now);
        if (phase_ != phase::asked) {
            return;
        }
        diagnostics_.note_request();
        pdu_buffer pdu{framer_.storage().subspan(1).template first<max_pdu_size>(), pdu_size_};
        request_head const asked{static_cast<function_code>(to_u8(pdu.bytes[0])), is_broadcast_};
        bool const may_restart = asked.function == function_code::diagnostics and not asked.is_broadcast;
        if (diagnostics_.is_listen_only() and not may_restart) {
            pdu.size = 0;
        } else {
            std::uint8_t const unit = to_u8(framer_.storage()[0]);
            diagnostics_.note_end(
                asked.function, units_.template execute_on<Functions>(unit, asked, pdu, bank, *profile_, diagnostics_));
        }
        if (asked.is_broadcast or pdu.size == 0) {
            diagnostics_.count_no_response();
            phase_ = phase::listening;
            return;
        }
        pdu_size_ = static_cast<std::uint8_t>(pdu.size);
        static_cast<void>(append_crc(framer_.storage(), pdu.size));
        phase_ = phase::responding;
    }

private:
    using phase = server_phase;

    /// From a request to its end, or to where its response may leave.
    constexpr duration longest_silence() const noexcept
    {
        line_timing const& line = framer_.line();
        return line.frame_end() < line.silence() ? line.silence() : line.frame_end();
    }

    constexpr void take_frame() noexcept
    {
        if (not framer_.poll_end()) {
            return;
        }
        if (framer_.verdict() != errc::none) {
            diagnostics_.note_error();
            this->pass_damaged();
            return;
        }
        diagnostics_.note_message();
        adu const heard = framer_.frame();
        this->pass_frame(heard);
        std::uint8_t expected = exception_bit; // no response
        if (not framer_.is_foreign_response() and not heard.is_exception()) {
            if (units_.contains(heard.unit()) or heard.unit() == 0) {
                is_broadcast_ = heard.unit() == 0;
                pdu_size_ = static_cast<std::uint8_t>(heard.pdu().size());
                until_ = framer_.last_activity() + longest_silence() + response_limit;
                phase_ = phase::asked;
            } else {
                expected = heard.wire_code();
            }
        }
        framer_.note_foreign_request(heard.unit(), expected);
    }

    /// Listens again where the time limit of what the server was doing is over. Judged by what the line did before `now`.
    constexpr void end_overdue(instant now) noexcept
    {
        if (phase_ != phase::listening and reached(framer_.within_reach_of_line(now), until_)) {
            if (phase_ == phase::transmitting) {
                framer_.resynchronise();
                phase_ = phase::listening;
            }
            drop_request();
        }
    }

    /// Drops the waiting request, or its response.
    constexpr void drop_request() noexcept
    {
        if (phase_ == phase::responding) {
            diagnostics_.count_no_response();
        }
        phase_ = phase::listening;
    }

    // Small first, as in the framer, and its memory last.
    phase phase_{phase::listening};
    Units units_;
    std::uint8_t pdu_size_{0}; ///< of the request, then of the response
    bool is_broadcast_{false}; ///< whether the request goes to every unit
    instant until_{0};         ///< when the phase ends by itself, unless it is listening
    server_profile const* profile_;
    [[no_unique_address]] Diagnostics diagnostics_{};
    detail::frame_receiver<direction::request> framer_;
};

} // namespace rtuwire
