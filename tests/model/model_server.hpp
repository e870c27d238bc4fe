// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A second server that counts, written from the comments of server/server.hpp and server/respond.hpp, and from
// the specification of function 08. Shares no code with the headers.
#pragma once

#include <array>

#include "model_line.hpp"

namespace model {

/// Unit with words from address 0, without identification.
class server {
public:
    enum class phase { listening, asked, responding, transmitting };
    static constexpr microseconds response_limit = 100'000;
    static constexpr std::size_t registers = 16;

    server(std::uint8_t unit, line_times const& times) : line_{times}, unit_{unit} {}

    void receive(bytes const& chunk, microseconds now)
    {
        if (phase_ == phase::transmitting and not chunk.empty()) {
            return damage(now, false);
        }
        if (not hear(chunk.size(), now)) {
            return;
        }
        for (std::uint8_t const byte : chunk) {
            if (phase_ == phase::asked or phase_ == phase::responding) {
                drop();
            }
            if (phase_ == phase::transmitting) {
                continue;
            }
            take(byte, now);
        }
    }

    void receive_error(microseconds now) { damage(now, false); }
    void receive_overrun(microseconds now) { damage(now, true); }

    void sent(microseconds now)
    {
        if (phase_ != phase::transmitting) {
            end_overdue(now);
        }
        if (line_.is_quiet or not is_long(now - line_.last)) { // else, by the clock, it was before the latest byte
            line_.note_activity(now);
        }
        if (phase_ == phase::transmitting) {
            phase_ = phase::listening;
            line_.begin();
            is_open_end_ = false;
        }
    }

    void advance(microseconds now)
    {
        if (not line_.is_known) {
            line_.is_known = true;
            line_.last = now;
            line_.is_quiet = false;
        }
        if (not line_.is_quiet and now >= line_.last + line_.times.silence) {
            line_.is_quiet = true;
        }
        if (phase_ == phase::transmitting and now >= until_) {
            phase_ = phase::listening;
            line_.at = receiver::state::unheard;
        }
        end_by_silence(0, now);
        end_overdue(now); // what the silence has ended, too
    }

    void serve(microseconds now)
    {
        advance(now);
        if (phase_ != phase::asked) {
            return;
        }
        bool const is_everyone = request_[0] == 0;
        bytes const pdu(request_.begin() + 1, request_.end() - 2);
        ++cpt[4];
        if (is_listening_only_) {
            bool const is_restart = pdu.size() == 5 and pdu[0] == 8 and pdu[1] == 0 and pdu[2] == 1 and
                                    (pdu[3] == 0 or pdu[3] == 0xFF) and pdu[4] == 0;
            if (is_restart and not is_everyone) {
                cpt.fill(0);
                is_listening_only_ = false;
            }
            ++cpt[5]; // 1 behind a restart, which is not answered
            phase_ = phase::listening;
            return;
        }
        bytes said;
        bool is_silent = is_everyone;
        fault const found =
            is_everyone and pdu[0] != 6 and pdu[0] != 16 ? illegal_function : respond(pdu, said, is_silent);
        if (found != none) {
            ++cpt[3];
            said = {static_cast<std::uint8_t>(pdu[0] | 0x80), static_cast<std::uint8_t>(found)};
        }
        if (is_silent) {
            ++cpt[5];
            phase_ = phase::listening;
            return;
        }
        response_ = {unit_};
        response_.insert(response_.end(), said.begin(), said.end());
        response_ = with_crc(response_);
        phase_ = phase::responding;
    }

    bytes poll_transmit()
    {
        if (phase_ != phase::responding or not line_.is_quiet) {
            return {};
        }
        phase_ = phase::transmitting;
        until_ += line_.times.characters(response_.size()) + response_limit;
        return response_;
    }

    std::optional<microseconds> poll_deadline() const
    {
        if (phase_ == phase::listening) {
            if (not line_.is_known) {
                return std::nullopt;
            }
            if (line_.at == receiver::state::between) {
                return line_.is_quiet ? std::nullopt : std::optional{line_.last + line_.times.silence};
            }
            return line_.last + (is_open_end_ ? line_.times.t3_5 : line_.times.frame_end);
        }
        microseconds const quiet = line_.last + line_.times.silence;
        return not line_.is_quiet ? std::min(quiet, until_) : until_;
    }

    bool is_asked() const { return phase_ == phase::asked; }
    phase now_in() const { return phase_; }
    microseconds until() const { return until_; }
    receiver const& line() const { return line_; }

    std::array<std::uint16_t, registers> words{};
    /// CPT1 to CPT8 of the specification, at 1 to 8.
    std::array<std::uint16_t, 9> cpt{};

private:
    /// Silence before so many characters at `now`, which ends what was begun.
    void end_by_silence(std::size_t count, microseconds now, bool is_kept = true)
    {
        if (not line_.is_known or line_.at == receiver::state::between) {
            return;
        }
        microseconds const silence = is_open_end_ ? line_.times.t3_5 : line_.times.frame_end;
        if (now < line_.last + silence + line_.times.characters(count)) {
            return;
        }
        bool const was_inside = line_.at == receiver::state::inside;
        line_.at = receiver::state::between;
        if (was_inside and is_kept and phase_ != phase::transmitting) {
            if (is_open_end_) {
                end_open(true);
            } else {
                end_frame(false);
            }
        }
        is_open_end_ = false;
    }

    bool hear(std::size_t size, microseconds now)
    {
        if (size == 0) {
            return false;
        }
        end_by_silence(size, now);
        line_.note_activity(now);
        return true;
    }

    void damage(microseconds now, bool is_overrun)
    {
        bool const was_listening = phase_ == phase::listening;
        if (is_long(now - line_.last)) {
            end_overdue(now);
        }
        end_by_silence(1, now, false);
        line_.note_activity(now);
        if (is_overrun) {
            ++cpt[8];
        }
        if (not was_listening) {
            line_.at = receiver::state::unheard; // bytes behind it are ignored
        } else {
            is_open_end_ = false; // the byte belongs to the frame, which is refused
            line_.damage();
        }
    }

    /// Whether a time limit that was over before such a pause looks as if it lay ahead behind it.
    static bool is_long(microseconds pause) { return static_cast<std::int32_t>(pause) < 0; }

    void end_overdue(microseconds now)
    {
        if (phase_ != phase::listening and now >= until_) {
            drop();
        }
    }

    void drop()
    {
        if (phase_ == phase::responding) {
            ++cpt[5];
        }
        phase_ = phase::listening;
    }

    void take(std::uint8_t byte, microseconds)
    {
        if (line_.at == receiver::state::unheard) {
            return;
        }
        if (is_open_end_) {
            is_open_end_ = false;
            bool const is_zero = byte == 0;
            line_.at = receiver::state::between;
            end_open(not is_zero);
            if (is_zero) {
                return;
            }
        }
        bool const by_request = line_.take(byte, true);
        if (line_.error != none) {
            return;
        }
        bytes const& frame = line_.frame;
        bool const is_expected = expected_unit_ >= 0 and frame.size() >= 2 and frame[0] == expected_unit_ and
                                 (frame[1] & 0x7F) == expected_function_;
        if (not is_expected) {
            if (by_request) {
                line_.at = receiver::state::between;
                end_frame(false);
            }
            return;
        }
        bool may_be_request = frame[1] < 0x80;
        if (frame.size() >= 5 and frame[1] <= 4 and frame[1] >= 1) {
            may_be_request = frame[4] <= (frame[1] <= 2 ? 7 : 0);
        }
        auto const request_size = may_be_request ? size_hint(frame, true) : std::nullopt;
        auto const response_size = size_hint(frame, false);
        bool const is_request = by_request and may_be_request;
        bool const is_response = response_size == frame.size() and is_whole(frame);
        if (not is_request and not is_response) {
            return;
        }
        if (is_request and is_response) {
            line_.at = receiver::state::between;
            end_frame(false);
            return;
        }
        bool const is_other_next = frame.size() < 256 and ((is_request and response_size == frame.size() + 1) or
                                                           (is_response and request_size == frame.size() + 1));
        if (is_other_next) {
            is_open_end_ = true;
            is_open_response_ = is_response;
            return;
        }
        line_.at = receiver::state::between;
        end_frame(is_response);
    }

    /// The end that was open: here, or behind the byte 00.
    void end_open(bool is_here)
    {
        is_open_end_ = false;
        end_frame(is_here ? is_open_response_ : not is_open_response_);
    }

    void end_frame(bool is_response)
    {
        bytes const& frame = line_.frame;
        fault const found = line_.verdict();
        if (found != none) {
            ++cpt[2];
            return;
        }
        ++cpt[1];
        expected_unit_ = -1;
        if (frame[1] >= 0x80 or (is_response and frame[0] != unit_ and frame[0] != 0)) {
            return;
        }
        if (frame[0] == unit_ or frame[0] == 0) {
            request_ = frame;
            phase_ = phase::asked;
            until_ = line_.last + std::max(line_.times.frame_end, line_.times.silence) + response_limit;
        } else {
            expected_unit_ = frame[0];
            expected_function_ = frame[1];
        }
    }

    fault respond(bytes const& pdu, bytes& said, bool& is_silent)
    {
        auto const word = [&](std::size_t at) { return 256U * pdu[at] + pdu[at + 1]; };
        auto const is_inside = [](std::size_t start, std::size_t count) { return start + count <= registers; };
        auto const store = [&](std::size_t start, std::size_t count, std::size_t at) {
            for (std::size_t i = 0; i < count; ++i) {
                words[start + i] = static_cast<std::uint16_t>(word(at + 2 * i));
            }
        };
        auto const load = [&](std::size_t start, std::size_t count) {
            said = {pdu[0], static_cast<std::uint8_t>(2 * count)};
            for (std::size_t i = 0; i < count; ++i) {
                said.push_back(static_cast<std::uint8_t>(words[start + i] >> 8U));
                said.push_back(static_cast<std::uint8_t>(words[start + i] & 0xFFU));
            }
        };
        switch (pdu[0]) {
        case 3:
            if (pdu.size() != 5 or word(3) == 0 or word(3) > 125) {
                return illegal_data_value;
            }
            if (not is_inside(word(1), word(3))) {
                return illegal_data_address;
            }
            load(word(1), word(3));
            return none;
        case 6:
            if (pdu.size() != 5) {
                return illegal_data_value;
            }
            if (not is_inside(word(1), 1)) {
                return illegal_data_address;
            }
            store(word(1), 1, 3);
            said = pdu;
            return none;
        case 16:
            if (pdu.size() < 6 or pdu.size() != 6U + pdu[5] or word(3) == 0 or word(3) > 123 or pdu[5] != 2 * word(3)) {
                return illegal_data_value;
            }
            if (not is_inside(word(1), word(3))) {
                return illegal_data_address;
            }
            store(word(1), word(3), 6);
            said.assign(pdu.begin(), pdu.begin() + 5);
            return none;
        case 23:
            if (pdu.size() < 10 or pdu.size() != 10U + pdu[9] or word(3) == 0 or word(3) > 125 or word(7) == 0 or
                word(7) > 121 or pdu[9] != 2 * word(7)) {
                return illegal_data_value;
            }
            if (not is_inside(word(1), word(3)) or not is_inside(word(5), word(7))) {
                return illegal_data_address;
            }
            store(word(5), word(7), 10);
            load(word(1), word(3));
            return none;
        case 8: return diagnose(pdu, said, is_silent);
        default: return illegal_function;
        }
    }

    fault diagnose(bytes const& pdu, bytes& said, bool& is_silent)
    {
        if (pdu.size() < 3) {
            return illegal_data_value;
        }
        unsigned const sub = 256U * pdu[1] + pdu[2];
        if (sub == 0) {
            if (pdu.size() % 2 == 0) { // words
                return illegal_data_value;
            }
            said = pdu;
            return none;
        }
        bool const is_known = sub <= 4 or (sub >= 0x0A and sub <= 0x12) or sub == 0x14;
        if (not is_known) {
            return illegal_function;
        }
        if (pdu.size() != 5) {
            return illegal_data_value;
        }
        bool const is_zero = pdu[3] == 0 and pdu[4] == 0;
        said = pdu;
        if (sub == 1) {
            if (pdu[4] != 0 or (pdu[3] != 0 and pdu[3] != 0xFF)) {
                return illegal_data_value;
            }
            cpt.fill(0);
            return none;
        }
        if (sub == 3) {
            return pdu[4] == 0 ? none : illegal_data_value;
        }
        if (not is_zero) {
            return illegal_data_value;
        }
        if (sub == 4) {
            is_listening_only_ = true;
            is_silent = true;
        } else if (sub == 0x0A) {
            cpt.fill(0);
        } else if (sub == 0x14) {
            cpt[8] = 0;
        } else if (sub >= 0x0B) {
            std::uint16_t const value = cpt[sub - 0x0A];
            said[3] = static_cast<std::uint8_t>(value >> 8U);
            said[4] = static_cast<std::uint8_t>(value & 0xFFU);
        }
        return none;
    }

    receiver line_;
    std::uint8_t unit_;
    phase phase_{phase::listening};
    microseconds until_{0};
    bytes request_{};
    bytes response_{};
    bool is_open_end_{false};
    bool is_open_response_{false};
    bool is_listening_only_{false};
    int expected_unit_{-1};
    int expected_function_{0};
};

} // namespace model
