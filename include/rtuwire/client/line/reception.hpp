// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// What a client does with the bytes that arrive: its own echo, noise before a response, the response itself and what
// that means for the request under way.
// Internal: may change with any version.
#pragma once

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <optional>

#include <rtuwire/client/line/frame_trace.hpp>
#include <rtuwire/client/line/phase.hpp>
#include <rtuwire/client/statistics.hpp>
#include <rtuwire/core/bytes.hpp>
#include <rtuwire/core/time.hpp>
#include <rtuwire/core/version.hpp>
#include <rtuwire/wire/response.hpp>

namespace rtuwire::inline RTUWIRE_BUILD {

/// A frame that was refused as the response to a request.
struct refused_frame {
    byte_view bytes;
    std::size_t due; ///< how many bytes it should have had; 0 where neither the request nor the frame gives that
};

/// The base of a client's transaction.
template <typename Statistics, typename Line, typename Options, typename Debts, std::size_t Front>
class reception : public frame_trace<Statistics, Line, Options, Debts, Front> {
    using steps = frame_trace<Statistics, Line, Options, Debts, Front>;

protected:
    using phase = client_phase;
    using steps::attempt_failed;
    using steps::deadline_;
    using steps::echo_;
    using steps::error_;
    using steps::framer;
    using steps::options;
    using steps::phase_;
    using steps::quarantine_;
    using steps::request;
    using steps::retries_;
    using steps::settle;
    using steps::statistics_;
    using steps::unit;
    using steps::wait_for_silence;

public:
    using steps::steps;

    /// Takes bytes that had arrived by `now`, in any chunking. While no response is awaited they are noise: dropped,
    /// but the line was not silent. A response that is passed in before `advance` has seen the time-out is in time.
    constexpr void receive(byte_view const& bytes, instant now) noexcept
    {
        if (bytes.empty()) {
            return;
        }
        bool const is_start = framer().is_quiet();
        begin_chunk(bytes.size(), now);
        std::size_t taken = take_echo(bytes, now);
        while (taken < bytes.size()) {
            if (takes_all()) {
                taken += framer().take_many(bytes.data() + taken, bytes.size() - taken);
                end_frame(now);
            } else if (take(bytes[taken], now)) {
                ++taken;
            } else {
                return drop(bytes.subspan(taken), is_start and taken == 0, now);
            }
        }
    }

    /// The same of one byte, for a receiver that hands over each as it arrives: a program that calls only this has no code
    /// for chunks.
    constexpr void receive(std::same_as<std::byte> auto byte, instant now) noexcept
    {
        bool const is_start = framer().is_quiet();
        begin_chunk(1, now);
        if (take_echo({&byte, 1}, now) == 0 and not take(byte, now)) {
            drop({&byte, 1}, is_start, now);
        }
    }

    /// Reports a receive error (parity, framing, overrun).
    constexpr void receive_error(instant now) noexcept
    {
        begin_chunk(1, now);
        if (phase_ != phase::awaiting) {
            on_line_activity(now);
        } else if (this->may_skip()) {
            this->drop_leading_noise();
        } else {
            framer().spoil();
        }
    }

    /// The frame for which the last request failed, with `wrong_length`, `crc_mismatch` and the like; nothing where it was
    /// no frame, or where more has arrived behind it. Valid until bytes are taken or the next request begins.
    [[nodiscard]] constexpr std::optional<refused_frame> refused() const noexcept
    {
        bool const has_failed = error_ != errc::none and not is_exception(error_) and not is_under_way(phase_);
        if (not has_failed or not framer().begun().empty() or framer().bytes().empty() or judged() != error_) {
            return std::nullopt;
        }
        return refused_frame{framer().bytes(), due_size(request(), framer().bytes())};
    }

protected:
    /// What the frame that has ended is as a response to the request.
    [[gnu::always_inline]] constexpr errc judged() const noexcept
    {
        errc wrong = framer().verdict();
        if (wrong == errc::none) {
            wrong = check_response(request(), framer().frame());
        }
        if (wrong == errc::none and not framer().matches_size_hint()) {
            wrong = errc::wrong_length;
        }
        return wrong;
    }

    /// Takes a response that has ended, by its length or by silence, and judges it.
    constexpr void take_frame(instant now) noexcept
    {
        bool const is_end = framer().poll_end();
        if (not is_end or error_ == errc::collision) {
            return this->pass_collision(is_end);
        }
        if (echo_.is_open() and not this->expects_echo()) {
            end_echo(); // silence has ended a beginning of it
        }
        errc const wrong = judged();
        line_event const event = event_of(wrong);
        note_frame(statistics_, event, wrong, unit(), now);
        if constexpr (is_traced<Statistics>) {
            this->pass_frame(framer().bytes(), wrong);
        }
        bool const is_response = event == line_event::reply or event == line_event::exception;
        bool const is_damaged =
            event == line_event::crc and framer().looks_addressed_to(request()) and framer().matches_size_hint();
        // While another unit's response is outstanding, a damaged one may be that: none of its bytes can be relied on.
        if (is_response or (is_damaged and quarantine_.is_empty())) {
            retries_.note_response();
        }
        if (not is_response) {
            echo_.suspect();
        } else if (echo_.is_absent()) {
            echo_.forget();
        }
        if (retries_.may_pause(wrong)) {
            deadline_ = now + retries_.take_pause();
            phase_ = phase::pausing;
            error_ = errc::none;
        } else if (is_response) {
            settle(wrong, now);
        } else if (wrong == errc::line_echo) {
            echo_.note_seen();
            settle(wrong, now);
        } else if (event != line_event::foreign and wrong != errc::frame_too_short) {
            // A damaged response of our unit is worth an early repetition. Anything else may be noise
            // before the response or a response to an older request, so the timer runs on.
            error_ = wrong;
            if (is_damaged) {
                attempt_failed(now);
            }
        }
    }

private:
    /// Bytes arrived by `now`: first takes the frame that the silence before them ended.
    constexpr void begin_chunk(std::size_t bytes, instant now) noexcept
    {
        if (framer().begin_chunk(bytes, now) and phase_ == phase::awaiting) {
            take_frame(now);
        }
        this->pass_heard(now);
    }

    /// Takes a byte of a response or before it; returns false where none is expected. Inlined, it would save 2 % of the
    /// instructions of a read, and cost 24 bytes of stack.
    constexpr bool take(std::byte byte, instant now) noexcept
    {
        if (phase_ != phase::awaiting) {
            return false;
        }
        // Bytes before the unit's address are skipped, as far as `max_leading_noise` allows.
        if (this->may_skip() and to_u8(byte) != unit()) {
            this->drop_leading_noise();
            this->pass_noise(byte);
            echo_.suspect();
        } else if (framer().push(byte)) {
            end_frame(now);
        }
        return true;
    }

    /// A frame may have ended by its length. One that is the beginning of the request goes on: what looks like a response of
    /// 7 bytes may be 7 of the 8 bytes of an echo.
    constexpr void end_frame(instant now) noexcept
    {
        if (echo_.is_open()) {
            framer().go_on();
        } else {
            take_frame(now);
        }
    }

    /// Bytes that nobody expected.
    constexpr void drop(byte_view bytes, bool is_start, instant now) noexcept
    {
        this->count_stray(bytes, is_start);
        on_line_activity(now);
    }

    /// Whether the next bytes are those of a response, whatever they are.
    constexpr bool takes_all() const noexcept { return phase_ == phase::awaiting and not this->may_skip(); }

    /// Compares bytes with those that were sent. Returns how many are accounted for: on a line that is known to echo up to
    /// the first that differs, elsewhere those that come back while the request leaves, and a whole request where the
    /// response would be something else. All others may be a response.
    constexpr std::size_t take_echo(byte_view bytes, instant now) noexcept
    {
        if (not echo_.is_open()) {
            return 0;
        }
        bool const expects = this->expects_echo();
        bool const may_be_response = phase_ == phase::awaiting and not expects;
        std::size_t const before = echo_.taken();
        std::size_t const same = echo_.take(bytes, request());
        if (echo_.is_whole()) {
            // What came behind the request as a whole may be the response to it; what came before `sent`, to an earlier one,
            // or to this one where `sent` is late. Neither shows what the line does.
            bool const is_mirrored = check_response(request(), adu{request()}) != errc::line_echo;
            bool const is_doubtful = is_mirrored and may_be_response and framer().begun().size() == before;
            if (is_doubtful and not echo_.is_known()) {
                echo_.end();
                return 0;
            }
            this->pass_echoed(before, same, {});
            if (may_be_response) {
                framer().drop_begun();
            }
            if (not is_doubtful) {
                note_echo(not is_mirrored, now);
            }
            return same;
        }
        this->pass_echoed(before, same, bytes.subspan(same));
        if (phase_ != phase::awaiting or framer().begun().size() != before) {
            echo_.suspect(); // what came while the request left is no response
        }
        if (expects and not echo_.is_open()) {
            statistics_.note(line_event::collision, unit());
            error_ = error_ == errc::none ? errc::collision : error_;
            echo_.doubt();
            return same + 1;
        }
        return may_be_response ? 0 : same;
    }

    /// The request has come back. Where it was not known that the line echoes, it ends; a broadcast that has left has done
    /// what it should.
    constexpr void note_echo(bool is_sure, instant now) noexcept
    {
        bool const is_news = not options().has_line_echo and not echo_.is_known() and phase_ != phase::turnaround;
        if (is_sure) {
            echo_.note_seen();
        }
        if (is_news) {
            statistics_.note(line_event::mismatch, unit());
            error_ = errc::line_echo;
            if (phase_ == phase::awaiting) {
                settle(errc::line_echo, now);
            }
        }
    }

    /// What had begun like an echo is none.
    constexpr void end_echo() noexcept
    {
        if constexpr (is_traced<Statistics>) {
            this->pass_echo(this->outside_frame(echo_.taken()));
        }
        echo_.end();
    }

    /// The line was not silent when a request was to leave.
    constexpr void on_line_activity(instant now) noexcept
    {
        if (phase_ != phase::ready) {
            return;
        }
        if (this->must_send_now_) {
            settle(errc::bus_jam, now);
        } else {
            wait_for_silence(now);
        }
    }
};

} // namespace rtuwire
