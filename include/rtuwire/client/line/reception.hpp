// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// The steps of one request: each enters a phase of client/line/phase.hpp and sets the time that limits it. And what a client
// does with the bytes that arrive: its own echo, noise before a response, the response itself and what that means for the
// request under way.
// Internal: may change with any version.
#pragma once

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <optional>

#include <rtuwire/client/line/line_end.hpp>
#include <rtuwire/client/line/phase.hpp>
#include <rtuwire/client/statistics.hpp>
#include <rtuwire/core/bytes.hpp>
#include <rtuwire/core/time.hpp>
#include <rtuwire/core/version.hpp>
#include <rtuwire/trace/tracing.hpp>
#include <rtuwire/wire/errc.hpp>
#include <rtuwire/wire/response.hpp>

namespace rtuwire::inline RTUWIRE_BUILD {

/// A frame that was refused as the response to a request.
struct refused_frame {
    byte_view bytes;
    std::size_t due; ///< how many bytes it should have had; 0 where neither the request nor the frame gives that
};

/// The base of a client's transaction.
template <typename Statistics, typename Line, typename Options, typename Debts, std::size_t Front>
class reception : public line_end<Statistics, Line, Options, Debts, Front> {
    using end_of_line = line_end<Statistics, Line, Options, Debts, Front>;

protected:
    using phase = client_phase;
    using end_of_line::deadline_;
    using end_of_line::echo_;
    using end_of_line::error_;
    using end_of_line::framer;
    using end_of_line::options;
    using end_of_line::phase_;
    using end_of_line::quarantine_;
    using end_of_line::request;
    using end_of_line::retries_;
    using end_of_line::statistics_;

public:
    using end_of_line::end_of_line;

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
    constexpr std::uint8_t unit() const noexcept { return this->asked_unit(); }

    /// The request waits for the line: for others to end no longer than for a response, and for the silence besides; where
    /// it has left already, first for its unit's pause. Not inlined: it is called in several places.
    [[gnu::noinline]] constexpr void wait_for_silence(instant now) noexcept
    {
        leave_begun();
        error_ = errc::none;
        echo_.end();
        deadline_ = now + retries_.pause();
        if (phase_ == phase::awaiting and deadline_ != now) {
            phase_ = phase::pausing;
            return;
        }
        phase_ = phase::waiting;
        // Both fit: see `longest_duration`.
        deadline_ = now + retries_.response_timeout() + framer().line().silence();
    }

    /// The transmitter has the time that the request takes, plus the response time-out.
    [[gnu::noinline]] constexpr void limit_sending(instant now) noexcept
    {
        deadline_ = now + retries_.response_timeout() + this->time_to_send();
    }

    /// A broadcast has left: units need time to act.
    constexpr void turn_around(instant at) noexcept
    {
        phase_ = phase::turnaround;
        deadline_ = at + options().turnaround;
    }

    /// The request left once more. Returns how long its response may take, up to its last byte.
    constexpr duration note_sent(instant at) noexcept
    {
        duration const limit = retries_.response_timeout() + this->time_to_respond();
        retries_.note_sent(at, this->time_to_send(), limit + late_response());
        return limit;
    }

    /// One sending has failed: another one follows, or the transaction ends. Inlined at both its places: 8 bytes less,
    /// and its callers use less stack.
    [[gnu::always_inline]] constexpr void attempt_failed(instant now) noexcept
    {
        if (retries_.take_retry()) {
            wait_for_silence(now);
        } else {
            settle(error_, now);
        }
    }

    /// Ends the transaction. Where responses may still be on their way, its unit gets no new request until none can
    /// be: client/line/quarantine.hpp gives the rule and its reasons.
    constexpr void settle(errc error, instant now) noexcept
    {
        leave_begun();
        error_ = error;
        bool const owes = retries_.unanswered() != 0;
        if (owes or (retries_.pause() != duration{} and unit() != 0)) {
            bool const has_response = not owes or error_ == errc::none or is_exception(error_);
            duration const late = late_response();
            quarantine_.begin(unit(),
                              has_response ? now + retries_.all_that_follow(now, late) : retries_.owed_until(now));
        }
        phase_ = phase::settled;
        deadline_ = now;
        echo_.end();
    }

    /// The time of a phase is over.
    constexpr void on_timeout(instant now) noexcept
    {
        if (phase_ == phase::awaiting) {
            if (error_ == errc::none) {
                bool const is_silent = framer().is_at_rest(now);
                error_ = is_silent ? errc::timed_out : errc::bus_jam;
                statistics_.note(is_silent ? line_event::timeout : line_event::jam, unit());
            }
            attempt_failed(now);
        } else if (phase_ == phase::pausing) {
            wait_for_silence(now);
        } else {
            if (phase_ != phase::turnaround) {
                error_ = phase_ == phase::waiting ? errc::bus_jam : errc::transmit_stalled;
            }
            if (is_leaving(phase_)) { // it may have left just now
                if (unit() == 0) {
                    return turn_around(now);
                }
                static_cast<void>(note_sent(now));
            }
            settle(error_, now);
        }
    }

    /// What has come of an echo and of a response is traced; neither is awaited any longer. What silence would not have
    /// ended is dropped: nothing else would end it in time.
    [[gnu::always_inline]] constexpr void leave_begun() noexcept
    {
        if constexpr (is_traced<Statistics>) {
            pass_begun_echo();
            byte_view const begun = phase_ == phase::awaiting ? framer().begun() : byte_view{};
            if (not begun.empty()) {
                statistics_.pass_stray(begun, true, to_u8(begun[0]) == unit());
            }
        }
        if constexpr (has_system) {
            framer().drop_unended();
        }
    }

    /// Traces bytes that were taken for the beginning of an echo: on another line than one that echoes, they are none.
    constexpr void pass_begun_echo() noexcept requires is_traced<Statistics>
    {
        pass_echo(outside_frame(echo_.taken()));
    }

    /// Of so many bytes that came back, those that belong to no frame that may be a response.
    constexpr std::size_t outside_frame(std::size_t taken) const noexcept
    {
        std::size_t const inside = phase_ == phase::awaiting and not this->expects_echo() ? framer().begun().size() : 0;
        return inside < taken ? taken - inside : 0;
    }

    /// Traces the request that has left.
    constexpr void pass_request(instant at) noexcept requires is_traced<Statistics>
    {
        statistics_.pass_own(this->request(), frame_role::request, at);
    }

    constexpr void pass_echo(std::size_t taken) noexcept requires is_traced<Statistics>
    {
        byte_view const bytes = this->request().first(taken);
        if (this->expects_echo() or taken == this->size_) {
            statistics_.pass_echo(bytes, frame_role::request);
        } else {
            statistics_.pass(bytes, frame_role::unknown, frame_verdict::stray);
        }
    }

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
            return pass_collision(is_end);
        }
        if (echo_.is_open() and not this->expects_echo()) {
            end_echo(); // silence has ended a beginning of it
        }
        errc const wrong = judged();
        line_event const event = event_of(wrong);
        note_frame(statistics_, event, wrong, unit(), now);
        if constexpr (is_traced<Statistics>) {
            pass_frame(framer().bytes(), wrong);
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
        pass_heard(now);
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
            pass_noise(byte);
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
            pass_echoed(before, same, {});
            if (may_be_response) {
                framer().drop_begun();
            }
            if (not is_doubtful) {
                note_echo(not is_mirrored, now);
            }
            return same;
        }
        pass_echoed(before, same, bytes.subspan(same));
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
            pass_echo(outside_frame(echo_.taken()));
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

    /// Bytes have arrived.
    [[gnu::always_inline]] constexpr void pass_heard(instant now) noexcept
    {
        if constexpr (is_traced<Statistics>) {
            statistics_.note_heard(now);
        }
    }

    /// Traces a byte that is skipped before a response.
    [[gnu::always_inline]] constexpr void pass_noise(std::byte byte) noexcept
    {
        if constexpr (is_traced<Statistics>) {
            statistics_.pass({&byte, 1}, frame_role::unknown, frame_verdict::stray);
        }
    }

    /// Traces a frame that arrived while a response was awaited, by the error that was found in it.
    [[gnu::always_inline]] constexpr void pass_frame(byte_view bytes, errc wrong) noexcept
    {
        if constexpr (is_traced<Statistics>) {
            if (not bytes.empty()) {
                bool const has_end = framer().verdict() == errc::none and framer().matches_size_hint();
                statistics_.pass(bytes, has_end ? frame_role::response : frame_role::unknown, verdict_of(bytes, wrong));
            }
        }
    }

    /// Traces a frame that ended in a collision.
    [[gnu::always_inline]] constexpr void pass_collision(bool is_end) noexcept
    {
        if constexpr (is_traced<Statistics>) {
            pass_frame(is_end ? framer().bytes() : byte_view{}, errc::collision);
        }
    }

    /// Traces an echo that has come back whole, or up to a byte that differs, which begins `rest`; `before` bytes had come
    /// before.
    [[gnu::always_inline]] constexpr void pass_echoed(std::size_t before, std::size_t same, byte_view rest) noexcept
    {
        if constexpr (is_traced<Statistics>) {
            if (echo_.is_open()) {
                return;
            }
            bool const is_all = echo_.is_whole() or this->expects_echo() or phase_ != phase::awaiting;
            pass_echo(is_all ? before + same : outside_frame(before));
            if (not echo_.is_whole() and this->expects_echo()) {
                statistics_.pass(rest.first(1), frame_role::unknown, frame_verdict::damaged);
            }
        }
    }

    constexpr frame_verdict verdict_of(byte_view bytes, errc wrong) const noexcept
    {
        if (framer().verdict() != errc::none or not framer().matches_size_hint()) {
            return frame_verdict::damaged;
        }
        if (wrong == errc::none or is_exception(wrong)) {
            return frame_verdict::good;
        }
        if (wrong == errc::wrong_unit) {
            return quarantine_.covers(to_u8(bytes[0])) ? frame_verdict::late : frame_verdict::foreign;
        }
        return wrong == errc::line_echo ? frame_verdict::echo : frame_verdict::stray;
    }

    /// Constructed anew: GCC would read a constant's copy from memory.
    constexpr duration late_response() const noexcept { return options().late_response; }
};

} // namespace rtuwire
