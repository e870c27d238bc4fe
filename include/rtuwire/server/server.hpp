// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// A unit's end of a line (SL 2.4.2): takes requests to this unit and to everyone, answers the former,
// and is silent on anything else. Owns neither the wire, nor a clock, nor the registers.
//
//   phase         leaves it
//   listening     a frame for this unit or everyone -> asked
//   asked         serve -> answering, or listening after a broadcast
//   answering     t3.5 of silence -> ready; none in time -> listening
//   ready         poll_transmit -> transmitting; octets -> answering
//   transmitting  sent -> listening
#pragma once

#include <cstdint>

#include <rtuwire/core/time.hpp>
#include <rtuwire/rtu/framer.hpp>
#include <rtuwire/rtu/line.hpp>
#include <rtuwire/server/respond.hpp>
#include <rtuwire/wire/unit_id.hpp>

namespace rtuwire {

/// Serves one unit address. In each pass call `receive` with what arrived, `sent` when the last stop
/// bit of an answer has left, `advance`, `serve`; then send what `poll_transmit` gives. Sleep no longer
/// than `poll_deadline` says. Hears nothing until the line has been silent once.
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

    /// Takes octets that had arrived by `now`, in any chunking. Octets after a request to this unit and
    /// before its answer has left are noise.
    constexpr void receive(byte_view octets, instant now) noexcept
    {
        while (not octets.empty() and phase_ == phase::listening) {
            octets = octets.subspan(framer_.receive(octets, now));
            take_frame();
        }
        if (not octets.empty()) {
            note_noise(now);
        }
    }

    /// Takes the receiver's word that an octet arrived damaged (parity, framing, overrun).
    constexpr void receive_error(instant now) noexcept
    {
        if (phase_ == phase::listening) {
            framer_.receive_error(now);
        } else {
            note_noise(now);
        }
    }

    /// The same, where the receiver says that it lost an octet.
    constexpr void receive_overrun(instant now) noexcept
    {
        diagnostics_.note_overrun();
        receive_error(now);
    }

    /// Takes note that the last stop bit of what `poll_transmit` gave has left at `now`.
    constexpr void sent(instant now) noexcept
    {
        framer_.note_activity(now);
        if (phase_ != phase::transmitting) {
            return;
        }
        framer_.restart(now);
        phase_ = phase::listening;
    }

    /// Lets time pass.
    constexpr void advance(instant now) noexcept
    {
        framer_.advance(now);
        if (phase_ == phase::listening) {
            take_frame();
        }
        if (phase_ == phase::answering and framer_.is_quiet()) {
            phase_ = phase::ready;
        }
        if ((phase_ == phase::answering or phase_ == phase::ready) and reached(now, too_late_)) {
            listen_after_silence();
        }
    }

    /// Does what a request asks of the registers, and prepares the answer.
    template <register_bank Bank> constexpr void serve(Bank& bank, instant now) noexcept
    {
        if (phase_ != phase::asked) {
            return;
        }
        diagnostics_.note_request();
        pdu_place pdu{framer_.storage().subspan(1).first<max_pdu_size>(), asked_size_};
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
        answer_size_ = static_cast<std::uint16_t>(seal(framer_.storage(), pdu.size).size());
        phase_ = phase::answering;
        too_late_ = now + answer_limit;
        advance(now);
    }

    /// The octets to send now, once; empty when there is nothing. Valid until `sent`.
    [[nodiscard]] constexpr byte_view poll_transmit() noexcept
    {
        if (phase_ != phase::ready) {
            return {};
        }
        phase_ = phase::transmitting;
        return framer_.storage().first(answer_size_);
    }

    /// When `advance` has something to do. Who only waits for a request does not care for silence.
    [[nodiscard]] constexpr deadline poll_deadline() const noexcept
    {
        if (phase_ == phase::answering or phase_ == phase::ready) {
            return earlier(framer_.poll_deadline(), too_late_);
        }
        return framer_.is_at_start() ? deadline{} : framer_.poll_deadline();
    }

    /// Whether a request waits for `serve`.
    [[nodiscard]] constexpr bool is_asked() const noexcept { return phase_ == phase::asked; }

    /// How long an answer waits for the line to fall silent. Later, its client has given up, and the
    /// answer could pass for one to its next question.
    static constexpr duration answer_limit = milliseconds(100);

private:
    enum class phase : std::uint8_t { listening, asked, answering, ready, transmitting };

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
        if (framer_.is_overheard()) {
            return;
        }
        bool const is_for_us = heard.unit() == unit_ or heard.unit() == 0;
        if (not is_for_us and not heard.is_exception()) {
            framer_.overhear(heard.unit(), heard.wire_code());
        } else if (is_for_us and not heard.is_exception()) {
            asked_size_ = static_cast<std::uint8_t>(heard.pdu().size());
            phase_ = phase::asked;
        } else {
            // An answer to a question that was not heard: what it belongs to is unknown.
            framer_.resynchronise();
        }
    }

    constexpr void count(byte_view answer) noexcept
    {
        if (not answer.empty() and (to_u8(answer[0]) & exception_bit) != 0) {
            diagnostics_.note_exception(exception_error(to_u8(answer[1])));
        }
    }

    constexpr void note_noise(instant now) noexcept
    {
        framer_.note_activity(now);
        if (phase_ == phase::ready) {
            phase_ = phase::answering;
        }
    }

    constexpr void listen_after_silence() noexcept
    {
        framer_.resynchronise();
        phase_ = phase::listening;
    }

    // Small first, as in the framer.
    phase phase_{phase::listening};
    std::uint8_t unit_;
    std::uint8_t asked_size_{0};
    std::uint16_t answer_size_{0};
    instant too_late_{};
    server_profile const* profile_;
    framer<direction::request> framer_;
    [[no_unique_address]] Diagnostics diagnostics_{};
};

/// A server that answers of function 08 the loop-back only.
using server = basic_server<loop_back>;

/// A server that counts, and can be told to listen only.
using counting_server = basic_server<serial_diagnostics>;

} // namespace rtuwire
