// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// The server on a line (SL 2.4.2): receives requests to its units and broadcasts, responds to the former, and sends
// nothing else. Owns neither the wire, nor a clock, nor the registers. Which frames are requests to it, and when a response
// may leave:
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

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <optional>

#include <rtuwire/core/bytes.hpp>
#include <rtuwire/core/time.hpp>
#include <rtuwire/core/version.hpp>
#include <rtuwire/rtu/framer.hpp>
#include <rtuwire/rtu/line.hpp>
#include <rtuwire/server/decoded_request.hpp>
#include <rtuwire/server/respond.hpp>
#include <rtuwire/server/serial_diagnostics.hpp>
#include <rtuwire/server/units.hpp>
#include <rtuwire/trace/observer.hpp>
#include <rtuwire/trace/traced_frame.hpp>
#include <rtuwire/wire/adu.hpp>
#include <rtuwire/wire/errc.hpp>
#include <rtuwire/wire/function.hpp>
#include <rtuwire/wire/unit_id.hpp>

namespace rtuwire {
inline namespace RTUWIRE_BUILD {

namespace detail {

/// Serves one unit address, or several (`for_units`). In each pass call `receive` with what arrived, `sent` when the last stop bit of a
/// response was sent, `advance`, `serve`; then send what `poll_transmit` returns. Sleep no longer than until
/// `poll_deadline`; a later call, even by hours, finds all earlier times over. One exception: a pause as long as whole turns of
/// the counter (71.6 minutes), or shorter than that by at most 256 characters and 100 ms, is not seen. `now` never goes back.
///
/// How frames end. Bytes are ignored until the line was silent for `frame_end` once; before the first `advance`, time
/// is not known and all bytes are ignored. Then a frame begins with the next byte. It ends
/// - at the size that the request's length rule gives (wire/functions.hpp), with a correct CRC;
/// - where the last good frame was a request to another unit and the first two bytes are that unit and that function,
///   with or without 80: also at the size that the response's rule gives, whichever size comes first with a correct
///   CRC. For functions 01 to 04 the size of a request does not count where the fifth byte is above 7 (01, 02) or
///   above 0 (03, 04): such a quantity is not allowed. Where the other rule gives one byte more (or for function 43
///   is applied again there) and the fifth byte allows a request, the end is open: a byte 00 that comes next is part
///   of the frame, which then ended by the other rule; any other byte, or t3.5 of silence, ends it. Where both rules
///   give the size, it ended by the request's;
/// - otherwise after a silence of `frame_end`. It is then good if its CRC is correct and it has 4 to 256 bytes.
/// A chunk of n bytes passed at `now` follows a silence of s where `now` is at least s + n characters after the last
/// byte before it. A frame with a wrong CRC, with a byte that was reported damaged, too short or too long is dropped,
/// and ends by silence only.
///
/// What a good frame means. To this unit or to 0, with a function below 80: it is a request and waits for `serve`. To
/// another unit, with a function below 80, and not ended at the size of an expected response: a request to another
/// unit. Any other frame is ignored, and no response is expected any longer. A frame is looked for only at its first
/// byte. Another unit's response to a request that was not received is decoded as a request; its CRC is then wrong,
/// and the next silence ends it.
///
/// Which requests are executed. `serve` executes a request if no undamaged byte was received after it and `now` is
/// before its time limit. Otherwise it is neither executed nor answered: its client may have timed out and sent
/// another request. This holds for broadcasts too: call `serve` within the client's turnaround delay. The bytes after
/// a request are decoded as the next frame, which may be the newer request. A response is sent when t3.5 has passed
/// since the last byte, damaged or not; it is dropped if an undamaged byte arrives before `poll_transmit` returns it,
/// or at the time limit. The request was executed even then.
template <typename Diagnostics, typename Functions = register_functions, typename Units = one_unit,
          typename Observer = no_observer>
class basic_server {
    using framing = framer_state<direction::request, frame_place<0>, stored<line_timing>>;

public:
    /// The same with other functions: `server::with<function_list<read_coils>>`; `public_functions` are all.
    template <typename Others> using with = basic_server<Diagnostics, Others, one_unit, Observer>;

    /// The same, of which a sink takes the frames as they pass, from `trace_to(sink)` on:
    /// `server::traced_by<trace_ring<4096>>`. One of several units is `server::traced_by<Sink>::for_units(...)`.
    template <typename Sink> using traced_by = basic_server<Diagnostics, Functions, one_unit, tracing<Sink>>;

    /// A server of several unit addresses, each with a bank of its own, that have one line and one frame's memory in
    /// common: `auto node = server::for_units(timing, bank_at{unit_id{3}, io}, bank_at{unit_id{4}, meter})`. It is
    /// served by `node.serve(now)`. Counters and listen-only mode of function 08 are those of the line: one for all.
    template <typename... Banks>
    [[nodiscard]] static constexpr auto for_units(line_timing const& timing, Banks&&... banks) noexcept
    {
        using units = unit_set<unit_entry<Banks>...>;
        return basic_server<Diagnostics, Functions, units, Observer>{timing, units{unit_entry<Banks>{banks}...}};
    }

    /// Listens as `unit`; the profile, and the objects in it, must outlive the server.
    constexpr basic_server(unit_id its_unit, line_timing const& its_timing, server_profile const& its_profile) noexcept
        requires(not Units::has_banks)
        : units_{its_unit.byte()}, profile_{&its_profile}, memory_{its_timing}
    {}

    /// Listens as `unit` with every function and the specification's limits, without identification.
    constexpr basic_server(unit_id its_unit, line_timing const& its_timing) noexcept requires(not Units::has_banks)
        : basic_server{its_unit, its_timing, default_profile}
    {}

    /// Deleted: a temporary profile would be gone.
    basic_server(unit_id, line_timing const&, server_profile&&) = delete;

    /// Listens as these units, each of which has its bank: made by `for_units`.
    /// Internal.
    constexpr basic_server(line_timing const& its_timing, Units const& its_units) noexcept requires(Units::has_banks)
        : units_{its_units}, profile_{&default_profile}, memory_{its_timing}
    {}

    /// Receives bytes that had arrived by `now`, in chunks of any size. Drops a request that waits for `serve`, or
    /// its response, and decodes the next frame. While a response is sent, bytes are ignored; they only keep the line
    /// from being silent.
    constexpr void receive(byte_view bytes, instant now) noexcept
    {
        if (phase_ == phase::transmitting and not bytes.empty()) {
            pass_while_leaving(bytes, now);
            return receive_error(now);
        }
        while (not bytes.empty()) {
            drop_request();
            [[maybe_unused]] bool const was_open = framer_.has_open_end();
            std::size_t const taken = framer_.receive(memory_, bytes, now);
            pass_taken(bytes.first(taken), was_open, now);
            bytes = bytes.subspan(taken);
            take_frame();
        }
    }

    /// The same of one byte, for a receiver that hands over each as it arrives: a program that calls only this has no code
    /// for chunks.
    constexpr void receive(std::same_as<std::byte> auto byte, instant now) noexcept
    {
        if (phase_ == phase::transmitting) {
            pass_while_leaving({&byte, 1}, now);
            return receive_error(now);
        }
        for (bool is_taken = false; not is_taken;) {
            drop_request();
            [[maybe_unused]] bool const was_open = framer_.has_open_end();
            is_taken = framer_.receive(memory_, byte, now);
            pass_taken({&byte, is_taken ? 1U : 0U}, was_open, now);
            take_frame();
        }
    }

    /// Reports a byte that arrived damaged (parity, framing, overrun): its frame is dropped. After a request, where
    /// the line's turnaround often produces one, it only delays the response; bytes after it are ignored up to a
    /// silence of `frame_end`, and still drop the request. A frame that silence ended before it, and no `advance` has
    /// processed, is dropped.
    constexpr void receive_error(instant now) noexcept
    {
        if (phase_ == phase::listening) {
            pass_unpolled(now);
            framer_.receive_error(memory_, now);
        } else {
            // After so long a pause the time limit would come to lie ahead again.
            if (framer_.within_reach_of_line(memory_, now) != now) {
                end_overdue(now);
            }
            static_cast<void>(framer_.begin_chunk(memory_, 1, now));
            framer_.resynchronise();
        }
    }

    /// The same, where the receiver reports that it lost a byte.
    constexpr void receive_overrun(instant now) noexcept
    {
        diagnostics_.note_overrun();
        receive_error(now);
    }

    /// Reports that the last stop bit of what `poll_transmit` returned was sent at `now`: the next byte begins a
    /// frame. In any other phase it only means that the line was not silent at `now`.
    constexpr void sent(instant now) noexcept
    {
        if (phase_ == phase::transmitting) {
            framer_.restart(now);
            phase_ = phase::listening;
            pass_sent(now);
        } else {
            end_overdue(now); // behind a later activity its limit could come to lie ahead again
            framer_.note_activity(now);
        }
    }

    /// Lets time pass. Where `sent` was not called in time, the server listens again once the line has been silent
    /// for `frame_end` since the last byte; a `sent` after that does no harm.
    constexpr void advance(instant now) noexcept
    {
        framer_.advance(memory_, now);
        if (phase_ == phase::listening) {
            take_frame();
        }
        end_overdue(now); // also what has just been taken: the silence that ended it may be an hour ago
    }

    /// Calls `advance`; then executes the waiting request on the registers and prepares the response. A broadcast is
    /// executed for writes only (functions 05, 06, 15, 16, 21 and 22), and never answered.
    template <typename Bank>
        requires(not Units::has_banks)
    constexpr void serve(Bank& bank, instant now) noexcept { serve_by(bank, now); }

    /// The same of a server of several units, which knows their banks.
    constexpr void serve(instant now) noexcept requires(Units::has_banks) { serve_by(own_banks{}, now); }

    /// The bytes to send now, once, after the `serve` or `advance` that found the silence before sending; empty when
    /// there are none. They are stored in the server, unchanged until `sent`, or until the time limit without it.
    [[nodiscard]] constexpr byte_view poll_transmit() noexcept
    {
        if (phase_ != phase::responding or not framer_.is_quiet()) {
            return {};
        }
        phase_ = phase::transmitting;
        std::size_t const size = pdu_size_ + adu_overhead;
        until_ = until_ + memory_.timing().characters(size) + response_limit;
        pass_leaving();
        return {memory_.bytes.data(), size};
    }

    /// When `advance` is due next. Listening: never before the first `advance`; with a frame begun, or while bytes are
    /// ignored, the last byte + `frame_end` (t3.5 with an open end); between frames, and in any other phase, the last
    /// byte + the silence before sending, until `advance` has processed it; after that never between frames, and in
    /// any other phase the time limit, which may come first.
    [[nodiscard]] constexpr deadline poll_deadline() const noexcept
    {
        if (phase_ == phase::listening) {
            return framer_.poll_end_deadline(memory_);
        }
        instant const quiet = framer_.last_activity() + memory_.timing().silence();
        return framer_.is_quiet() or reached(quiet, until_) ? until_ : quiet;
    }

    /// Whether a request waits for `serve`.
    [[nodiscard]] constexpr bool is_asked() const noexcept { return phase_ == phase::asked; }

    /// Listens to another address from the next frame on; without one, to broadcasts only. A waiting response is
    /// still sent.
    constexpr void listen_as(std::optional<unit_id> unit) noexcept requires(not Units::has_banks)
    {
        units_ = {unit ? unit->byte() : std::uint8_t{0}};
    }

    /// Hands the frames that pass from here on to a sink, which must outlive the server. For a server `traced_by` it.
    template <typename Sink>
        requires is_traced_by<Observer, Sink>
    constexpr void trace_to(Sink& frames) noexcept { observer_.trace_to(frames); }

    /// How long after its request, and the silence that may have ended that, the sending of a response may start; and
    /// how long after its last character `sent` may be called. Later its client may have timed out, and take the
    /// response for one to another request; no client waits less for a response. A transmitter that has not started,
    /// or not reported its end, within this time never will.
    static constexpr duration response_limit = milliseconds(100);

private:
    static constexpr server_profile default_profile{};

    /// What it waits for: a request; `serve`; the silence before its response; the end of that.
    enum class phase : std::uint8_t { listening, asked, responding, transmitting };

    /// Serves a waiting request: on that bank, or on those of the units. Force-inlined, which is smaller.
    template <typename Bank> [[gnu::always_inline]] constexpr void serve_by(Bank&& bank, instant now) noexcept
    {
        advance(now);
        if (phase_ != phase::asked) {
            return;
        }
        diagnostics_.note_request();
        pdu_buffer pdu{byte_span{memory_.bytes}.subspan(1).template first<max_pdu_size>(), pdu_size_};
        request_head const asked{static_cast<function_code>(to_u8(pdu.bytes[0])), is_broadcast_};
        bool const may_restart = asked.function == function_code::diagnostics and not asked.is_broadcast;
        if (diagnostics_.is_listen_only() and not may_restart) {
            pdu.size = 0;
        } else {
            std::uint8_t const unit = to_u8(memory_.bytes[0]);
            diagnostics_.note_end(
                asked.function, units_.template execute_on<Functions>(unit, asked, pdu, bank, *profile_, diagnostics_));
        }
        if (asked.is_broadcast or pdu.size == 0) {
            diagnostics_.count_no_response();
            phase_ = phase::listening;
            return;
        }
        pdu_size_ = static_cast<std::uint8_t>(pdu.size);
        static_cast<void>(append_crc(memory_.bytes, pdu.size));
        phase_ = phase::responding;
    }

    /// From a request to its end, or to where its response may leave.
    constexpr duration longest_silence() const noexcept
    {
        line_timing const& line = memory_.timing();
        return line.frame_end() < line.silence() ? line.silence() : line.frame_end();
    }

    constexpr void take_frame() noexcept
    {
        if (not framer_.poll_end()) {
            return;
        }
        if (framer_.verdict(memory_) != errc::none) {
            diagnostics_.note_error();
            pass_damaged();
            return;
        }
        diagnostics_.note_message();
        adu const heard = framer_.frame(memory_);
        pass_frame(heard);
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
        if (phase_ != phase::listening and reached(framer_.within_reach_of_line(memory_, now), until_)) {
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

    // What an observer is told of the frames that pass; without one these functions are empty.

    /// Traces an undamaged frame.
    [[gnu::always_inline]] constexpr void pass_frame(adu const& heard) noexcept
    {
        if constexpr (is_observed<Observer>) {
            bool const is_response = framer_.is_foreign_response() or heard.is_exception();
            bool const is_ours = units_.contains(heard.unit()) or heard.unit() == 0;
            frame_verdict const ours = is_response ? frame_verdict::stray : frame_verdict::good;
            observer_.on_bytes(heard.bytes(), is_response ? frame_role::response : frame_role::request,
                               is_ours ? ours : frame_verdict::foreign);
        }
    }

    /// Traces a damaged one.
    [[gnu::always_inline]] constexpr void pass_damaged() noexcept
    {
        if constexpr (is_observed<Observer>) {
            observer_.on_bytes(framer_.bytes(memory_), frame_role::unknown, frame_verdict::damaged);
        }
    }

    /// Bytes were taken: traces those that the framer ignored; gives a frame whose end was open its last byte.
    [[gnu::always_inline]] constexpr void pass_taken(byte_view bytes, bool was_open, instant now) noexcept
    {
        if constexpr (is_observed<Observer>) {
            if (bytes.empty()) {
                return;
            }
            observer_.on_arrival(now);
            if (was_open) {
                framer_.keep_zero(memory_);
            } else if (framer_.ignores_bytes()) {
                observer_.on_bytes(bytes, frame_role::unknown, frame_verdict::stray);
            }
        }
    }

    /// Traces a frame that silence ended before a damaged byte, and that is dropped with it.
    [[gnu::always_inline]] constexpr void pass_unpolled(instant now) noexcept
    {
        if constexpr (is_observed<Observer>) {
            if (framer_.begin_chunk(memory_, 1, now)) {
                bool const is_damaged = framer_.verdict(memory_) != errc::none;
                observer_.on_bytes(framer_.bytes(memory_), frame_role::unknown,
                                   is_damaged ? frame_verdict::damaged : frame_verdict::stray);
            }
            observer_.on_arrival(now);
        }
    }

    /// A response begins to leave; bytes arrive while it does; it has left.
    [[gnu::always_inline]] constexpr void pass_leaving() noexcept
    {
        if constexpr (is_observed<Observer>) {
            observer_.on_leaving();
        }
    }
    [[gnu::always_inline]] constexpr void pass_while_leaving(byte_view bytes, instant now) noexcept
    {
        if constexpr (is_observed<Observer>) {
            observer_.on_arrival(now);
            observer_.on_arrival_while_leaving(bytes, response_bytes(), frame_role::response);
        }
    }
    [[gnu::always_inline]] constexpr void pass_sent(instant now) noexcept
    {
        if constexpr (is_observed<Observer>) {
            observer_.on_sent(response_bytes(), frame_role::response, now);
        }
    }

    constexpr byte_view response_bytes() noexcept
    {
        return byte_view{memory_.bytes}.first(std::size_t{pdu_size_} + adu_overhead);
    }

    // Small first, as in the framer, and its memory last.
    phase phase_{phase::listening};
    Units units_;
    std::uint8_t pdu_size_{0}; ///< of the request, then of the response
    bool is_broadcast_{false}; ///< whether the request goes to every unit
    instant until_{0};         ///< when the phase ends by itself, unless it is listening
    server_profile const* profile_;
    [[no_unique_address]] Diagnostics diagnostics_{};
    [[no_unique_address]] Observer observer_{};
    framing framer_;
    typename framing::memory memory_;
};

} // namespace detail

/// A server whose function 08 is the loopback (sub-function 0) only, with functions 03, 06, 08, 16, 23 and 43.
using server = detail::basic_server<loopback_only>;

/// A server with the counters and the listen-only mode of function 08.
using counting_server = detail::basic_server<detail::serial_diagnostics>;

} // namespace RTUWIRE_BUILD
} // namespace rtuwire
