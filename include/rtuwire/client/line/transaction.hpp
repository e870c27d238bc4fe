// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// One request of a client, from its start to its outcome (SL 2.4.1): silence before it, the bytes to send, their echo, the
// response, repetitions, time limits. Knows no conversation. client/line/request.hpp has its parts, the table of its phases, and
// the rule how long a unit that did not respond in time gets no new request.
#pragma once

#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <type_traits>

#include <rtuwire/ask/conversation.hpp>
#include <rtuwire/client/line/request.hpp>
#include <rtuwire/client/needs.hpp>
#include <rtuwire/core/bytes.hpp>
#include <rtuwire/core/result.hpp>
#include <rtuwire/core/time.hpp>
#include <rtuwire/core/version.hpp>
#include <rtuwire/rtu/framer.hpp>
#include <rtuwire/rtu/line.hpp>
#include <rtuwire/trace/observer.hpp>
#include <rtuwire/trace/traced_frame.hpp>
#include <rtuwire/wire/errc.hpp>
#include <rtuwire/wire/functions.hpp>
#include <rtuwire/wire/response.hpp>

namespace rtuwire {
inline namespace RTUWIRE_BUILD {

namespace detail {

/// A frame that was refused as the response to a request.
struct refused_frame {
    byte_view bytes;
    byte_view asked; ///< the request
    std::size_t due; ///< how many bytes it should have had; 0 where neither the request nor the frame gives that
};

// On a microcontroller, a client that is copied copies the bytes of its frame that were never written, too, as std::byte
// may be. GCC warns of it.
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wuninitialized"
#if not defined(__clang__)
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"
#endif

/// Runs a client's request under way; `basic_client` decides whose it is.
template <auto const& Needs> class transaction {
    using phase = client_phase;
    using Observer = typename told_by<Needs>::observer;
    using Options = typename told_by<Needs>::options;
    using Line = typename told_by<Needs>::line;
    using Functions = typename told_by<Needs>::functions;
    using place = frame_place<Needs.request_room, Needs.longest_frame>;
    using response_framer = framer_state<direction::response, place, Line, Functions>;

public:
    explicit constexpr transaction(line_timing const& its_timing, client_options const& its_options = {}) noexcept
        : options_{its_options}, memory_{its_timing}
    {
        // Written before it is read. A constant has no part without a value; a microcontroller would call memset for it.
        if (std::is_constant_evaluated() or default_crc_form == crc_form::host) {
            memory_.bytes.fill(std::byte{0});
        }
    }

    /// For a constant line and constant options. Zero-initialised, so a `constinit` client lives in .bss.
    constexpr transaction() noexcept requires(is_constant<Line>) = default;

    // The line: what `basic_client` says of it is not said again.

    constexpr void receive(byte_view const& bytes, instant now) noexcept
    {
        if (bytes.empty()) {
            return;
        }
        bool const is_start = is_quiet();
        begin_chunk(bytes.size(), now);
        std::size_t taken = take_echo(bytes, now);
        while (taken < bytes.size()) {
            if (phase_ == phase::awaiting and not may_skip()) {
                taken += framer_.take_many(memory_, bytes.data() + taken, bytes.size() - taken);
                end_frame(now);
            } else if (take(bytes[taken], now)) {
                ++taken;
            } else {
                return drop_stray(bytes.subspan(taken), is_start and taken == 0, now);
            }
        }
    }

    constexpr void receive(std::same_as<std::byte> auto byte, instant now) noexcept
    {
        bool const is_start = is_quiet();
        begin_chunk(1, now);
        if (take_echo({&byte, 1}, now) == 0 and not take(byte, now)) {
            drop_stray({&byte, 1}, is_start, now);
        }
    }

    constexpr void receive_error(instant now) noexcept
    {
        begin_chunk(1, now);
        if (phase_ != phase::awaiting) {
            on_line_activity(now);
        } else if (may_skip()) {
            skip_noise();
        } else {
            framer_.spoil();
        }
    }

    constexpr void sent(instant at) noexcept
    {
        if (not is_leaving(phase_)) {
            framer_.note_activity(at);
            return;
        }
        framer_.restart(at);
        observer_.on_sent(request(), frame_role::request, at);
        noise_.begin(options().max_leading_noise);
        if (is_broadcast()) {
            return turn_around(at);
        }
        phase_ = phase::awaiting;
        deadline_ = at + note_sent(at);
        if (error_ == errc::cancelled or error_ == errc::line_echo) {
            settle(error_, at);
        }
    }

    /// Lets time pass. Returns whether a unit may be asked again from here on. `at` is `within_reach` of the latest call.
    [[gnu::always_inline]] constexpr bool advance(instant now, instant at) noexcept
    {
        is_woken_ = false;
        framer_.advance(memory_, now);
        retries_.advance(now, at);
        if (phase_ == phase::awaiting) {
            take_frame(now);
        }
        if (phase_ == phase::handed_out) {
            limit_sending(now);
            phase_ = phase::transmitting;
        } else if (is_under_way(phase_) and reached(at, deadline_)) {
            on_timeout(now);
        }
        return quarantine_.advance(at);
    }

    [[nodiscard]] constexpr byte_view poll_transmit() noexcept
    {
        if (phase_ != phase::ready) {
            return {};
        }
        observer_.on_event(retries_.is_first() ? line_event::request : line_event::repetition, unit());
        phase_ = phase::handed_out;
        echo_.begin();
        return request();
    }

    /// When the next pass has something to do. `seen`: the latest `advance`.
    constexpr void add_to(earliest& next, bool is_reserved, instant seen) const noexcept
    {
        // A stop for which the line is reserved may cut the request as soon as the line is silent.
        framer_.add_to(memory_, next, phase_ == phase::awaiting and not is_reserved);
        quarantine_.add_to(next);
        if (is_woken_ or is_under_way(phase_)) {
            // After `wake` while a request waits: a time that has come already, so that the loop comes back at once. Not the
            // latest activity: that may be an hour ago.
            bool const is_past = is_woken_ and phase_ == phase::waiting;
            next.add(is_past ? seen : deadline_);
        }
    }

    constexpr void cancel(instant now) noexcept
    {
        if (is_leaving(phase_) or phase_ == phase::turnaround) {
            error_ = errc::cancelled;
        } else if (phase_ != phase::idle and phase_ != phase::settled) {
            settle(errc::cancelled, now);
        }
    }

    [[nodiscard]] constexpr bool is_busy() const noexcept { return phase_ != phase::idle; }
    [[nodiscard]] constexpr bool has_left() const noexcept { return phase_ > phase::handed_out; }
    [[nodiscard]] constexpr bool is_quiet() const noexcept { return framer_.is_quiet(); }
    [[nodiscard]] constexpr std::uint8_t asked_unit() const noexcept { return unit_; }
    /// Whom its outcome concerns: where a unit answers at address 0, any.
    [[nodiscard]] constexpr std::uint8_t held_unit() const noexcept { return at_0_.has_response() ? any_unit : unit(); }
    [[nodiscard]] constexpr duration time_to_send() const noexcept { return request_.time_to_send(line()); }
    [[nodiscard]] constexpr client_phase phase_now() const noexcept { return phase_; }

    [[nodiscard]] constexpr std::optional<refused_frame> refused() const noexcept
    {
        bool const has_failed = error_ != errc::none and not is_exception(error_) and not is_under_way(phase_);
        if (not has_failed or not framer_.begun(memory_).empty() or framer_.bytes(memory_).empty() or
            judged() != error_) {
            return std::nullopt;
        }
        return refused_frame{framer_.bytes(memory_), request(), due_size<Functions>(request(), framer_.bytes(memory_))};
    }

    constexpr void keep_away(unit_id unit, instant end) noexcept { quarantine_.begin(unit.byte(), end); }
    [[nodiscard]] constexpr bool is_kept_away(std::uint8_t unit) const noexcept { return quarantine_.covers(unit); }
    [[nodiscard]] constexpr bool has_seen_echo() const noexcept { return echo_.is_known(); }
    [[nodiscard]] constexpr line_timing const& line() const noexcept { return memory_.timing(); }
    [[nodiscard]] constexpr client_options const& options() const noexcept { return options_.get(); }
    [[nodiscard]] constexpr Observer& observer() noexcept { return observer_; }
    [[nodiscard]] constexpr Observer const& observer() const noexcept { return observer_; }

    // The request under way.

    /// Whether the next request, to address 0, has a response.
    constexpr void expect(bool response_at_0) noexcept { at_0_.expect(response_at_0); }

    /// Takes a request: copies its frame to the front of the memory. Errors: those of `kept_request::keep`.
    constexpr errc start(request_frame const& asked, instant now, retry_policy const& with) noexcept
    {
        if (errc const wrong = request_.keep(asked.frame(), framer_, memory_); wrong != errc::none) {
            return wrong;
        }
        unit_ = to_u8(asked.frame()[0]);
        may_not_wait_ = not asked.may_be_repeated();
        is_woken_ = false;
        retries_.begin(with, asked.may_be_repeated() and not is_broadcast());
        wait_for_silence(now);
        if (is_quiet()) {
            get_ready(now);
        }
        return errc::none;
    }

    /// Lets the request leave.
    constexpr void get_ready(instant now) noexcept
    {
        phase_ = phase::ready;
        limit_sending(now);
    }

    /// Whether only the asker is missing: the line would let the request leave, or its outcome is there. A stop's request
    /// does not wait for what its unit owes.
    constexpr bool awaits_asker(bool is_of_stop) const noexcept
    {
        if (phase_ != phase::waiting) {
            return phase_ == phase::settled;
        }
        return is_quiet() and (is_of_stop or not quarantine_.covers(held_unit()));
    }

    /// Gives up a request that waits for its asker.
    constexpr void drop(instant now) noexcept
    {
        if (phase_ == phase::waiting) {
            settle(errc::cancelled, now);
        }
    }

    /// A stop request needs the line. The request under way is not repeated. It is given up where it may be dropped before
    /// it has left, as a repetition always is, and where it may be cut, unless its response has begun to arrive. Returns
    /// whether it is, and was not before.
    constexpr bool make_way(bool may_cut, bool may_drop, instant now) noexcept
    {
        retries_.end_retries();
        bool const has_not_left = phase_ == phase::waiting or phase_ == phase::ready or phase_ == phase::pausing;
        // Between the lumps of a response its line may rest for longer than before a request: the frame is not over.
        bool const is_arriving = phase_ == phase::awaiting and (not is_quiet() or framer_.ends_by_silence(memory_));
        bool const gives_up = has_not_left ? may_drop or not retries_.is_first() : may_cut and not is_arriving;
        if (not gives_up or not is_under_way(phase_) or error_ == errc::cancelled) {
            return false;
        }
        cancel(now);
        return true;
    }

    /// Ends the request of a program that never calls `advance`, without which the line never falls silent, at its limit.
    constexpr void end_never_advanced(instant now) noexcept
    {
        if (phase_ == phase::waiting and reached(now, deadline_)) {
            settle(errc::never_advanced, now);
        }
    }

    /// Whether the request was given up and its asker was not told yet.
    constexpr bool is_given_up() const noexcept { return phase_ == phase::settled and error_ == errc::cancelled; }

    /// Whether a repetition of the request that ended was begun, and it was not given up.
    constexpr bool was_repeated() const noexcept { return not retries_.is_first() and error_ != errc::cancelled; }

    /// How the request ended for its unit: one that left and was given up without a response counts as timed out.
    constexpr errc heard_of_unit() const noexcept
    {
        return error_ == errc::cancelled and retries_.owed().count != 0 ? errc::timed_out : error_;
    }

    /// Takes the outcome of a settled request.
    [[gnu::always_inline]] constexpr result<response> take_outcome() noexcept
    {
        phase_ = phase::idle;
        return error_ != errc::none ? result<response>{error_}
                                    : response{is_broadcast() ? byte_view{} : framer_.frame(memory_).pdu()};
    }

    /// The next pass has something to do at once.
    [[gnu::always_inline]] constexpr void wake(instant now) noexcept
    {
        is_woken_ = true;
        if (not is_under_way(phase_)) {
            deadline_ = now;
        }
    }

private:
    // The request.

    constexpr std::uint8_t unit() const noexcept { return unit_; }
    /// Whether no unit answers it.
    constexpr bool is_broadcast() const noexcept { return unit() == 0 and not at_0_.has_response(); }
    constexpr byte_view request() const noexcept { return request_.bytes(memory_); }

    /// Constructed anew: GCC would read a constant's copy from memory.
    constexpr duration late_response() const noexcept { return options().late_response; }

    // The steps: each enters a phase and sets the time that limits it.

    /// The request waits for a silent line, for a response time-out and the silence at most; one that has left already first
    /// waits for its unit's pause. Not inlined: it is called in several places.
    [[gnu::noinline]] constexpr void wait_for_silence(instant now) noexcept
    {
        leave_begun();
        error_ = errc::none;
        deadline_ = now + retries_.pause();
        if (phase_ == phase::awaiting and deadline_ != now) {
            phase_ = phase::pausing;
            return;
        }
        phase_ = phase::waiting;
        // Both fit: see `longest_duration`.
        deadline_ = now + retries_.response_timeout() + memory_.timing().silence();
    }

    /// The transmitter has the time that the request takes, plus the response time-out.
    [[gnu::noinline]] constexpr void limit_sending(instant now) noexcept
    {
        deadline_ = now + retries_.response_timeout() + time_to_send();
    }

    /// The request left once more. Returns how long its response may take, up to its last byte.
    constexpr duration note_sent(instant at) noexcept
    {
        duration const limit = retries_.response_timeout() + request_.time_to_respond(line());
        retries_.note_sent(at, time_to_send(), limit + late_response());
        return limit;
    }

    /// A broadcast has left: units need time to act.
    constexpr void turn_around(instant at) noexcept
    {
        phase_ = phase::turnaround;
        deadline_ = at + options().turnaround;
    }

    /// The time of a phase is over.
    constexpr void on_timeout(instant now) noexcept
    {
        if (phase_ == phase::awaiting) {
            // Elsewhere silence has ended it.
            if (has_system and is_echo_in_front()) {
                observer_.on_event(line_event::mismatch, unit());
                echo_.note_seen();
                return settle(errc::line_echo, now);
            }
            if (error_ == errc::none) {
                bool const is_silent = framer_.is_at_rest(memory_, now);
                error_ = is_silent ? errc::timed_out : errc::bus_jam;
                observer_.on_event(is_silent ? line_event::timeout : line_event::jam, unit());
            }
            attempt_failed(now);
        } else if (phase_ == phase::pausing) {
            wait_for_silence(now);
        } else {
            if (phase_ != phase::turnaround) {
                error_ = phase_ == phase::waiting ? errc::bus_jam : errc::transmit_stalled;
            }
            if (is_leaving(phase_)) { // it may have left just now
                if (is_broadcast()) {
                    return turn_around(now);
                }
                static_cast<void>(note_sent(now));
            }
            settle(error_, now);
        }
    }

    /// The line was not silent when a request was to leave.
    constexpr void on_line_activity(instant now) noexcept
    {
        if (phase_ != phase::ready) {
            return;
        }
        if (may_not_wait_) {
            settle(errc::bus_jam, now);
        } else {
            wait_for_silence(now);
        }
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
    /// be: client/line/request.hpp gives the rule and its reasons.
    constexpr void settle(errc error, instant now) noexcept
    {
        leave_begun();
        error_ = error;
        if constexpr (has_system) {
            if (line().has_numbers()) { // no response is taken for another's, whenever it comes
                return settle_with_number(now);
            }
        }
        bool const owes = retries_.owed().count != 0;
        if (owes or (retries_.pause() != duration{} and not is_broadcast())) {
            bool const has_response = not owes or error_ == errc::none or is_exception(error_);
            duration const late = late_response();
            quarantine_.begin(held_unit(),
                              has_response ? now + retries_.all_that_follow(now, late) : retries_.owed_until(now),
                              retries_.owed());
        }
        phase_ = phase::settled;
        deadline_ = now;
    }

    /// The end of `settle` on a line with numbers: its unit may have a pause, and owes nothing that matters.
    constexpr void settle_with_number(instant now) noexcept
    {
        if (retries_.pause() != duration{} and not is_broadcast()) {
            quarantine_.begin(held_unit(), now + retries_.pause());
        }
        phase_ = phase::settled;
        deadline_ = now;
    }

    /// Neither the rest of an echo nor that of a response is awaited any longer. What silence would not have ended is
    /// dropped: nothing else would end it in time.
    constexpr void leave_begun() noexcept
    {
        end_echo();
        if constexpr (is_observed<Observer>) {
            byte_view const begun = phase_ == phase::awaiting ? framer_.begun(memory_) : byte_view{};
            if (not begun.empty()) {
                observer_.on_response_cut(begun, to_u8(begun[0]) == unit());
            }
        }
        if constexpr (has_system) {
            framer_.drop_unended(memory_);
        }
    }

    // What arrives.

    /// Bytes arrived by `now`: first takes the frame that the silence before them ended.
    constexpr void begin_chunk(std::size_t bytes, instant now) noexcept
    {
        if (framer_.begin_chunk(memory_, bytes, now) and phase_ == phase::awaiting) {
            take_frame(now);
        }
        observer_.on_arrival(now);
    }

    /// Takes a byte of a response or before it; returns false where none is expected. Inlined, it would save 2 % of the
    /// instructions of a read, and cost 24 bytes of stack.
    constexpr bool take(std::byte byte, instant now) noexcept
    {
        if (phase_ != phase::awaiting) {
            return false;
        }
        // Bytes before the unit's address are skipped, as far as `max_leading_noise` allows.
        if (may_skip() and to_u8(byte) != unit()) {
            skip_noise();
            observer_.on_bytes({&byte, 1}, frame_role::unknown, frame_verdict::stray);
            echo_.suspect();
        } else if (framer_.push(memory_, byte)) {
            end_frame(now);
        }
        return true;
    }

    /// Whether a byte before the response may be skipped. Constant options that allow none leave no code of this.
    constexpr bool may_skip() const noexcept { return noise_.is_left() and framer_.is_at_start(); }

    constexpr void skip_noise() noexcept
    {
        noise_.take();
        observer_.on_event(line_event::noise, unit());
    }

    /// Counts bytes that nobody expected, one at least.
    constexpr void drop_stray(byte_view bytes, bool is_start, instant now) noexcept
    {
        constexpr std::uint8_t highest_unit = 247;
        std::uint8_t const first = to_u8(bytes[0]);
        bool const is_late = is_start and first <= highest_unit and quarantine_.covers(first);
        observer_.on_stray(bytes, is_start, is_late ? first : std::uint8_t{0});
        if constexpr (has_system) {
            if (is_start or check_frame(bytes) == errc::none) {
                note_late(first, now);
            }
        }
        on_line_activity(now);
    }

    /// What begins with this byte may be a late answer. At address 0 any held unit may be the one that answers there.
    constexpr void note_late(std::uint8_t first, instant now) noexcept
    {
        quarantine_.note_late(Needs.has_only_unit and first == 0 ? any_unit : first, now, late_response());
    }

    /// A frame may have ended by its length. One that is the beginning of the request goes on: what looks like a response of
    /// 7 bytes may be 7 of the 8 bytes of an echo.
    constexpr void end_frame(instant now) noexcept
    {
        if (echo_.is_open()) {
            framer_.go_on();
        } else {
            take_frame(now);
        }
    }

    /// Takes a response that has ended, by its length or by silence, and judges it.
    constexpr void take_frame(instant now) noexcept
    {
        if (not framer_.poll_end()) {
            return;
        }
        if (error_ == errc::collision) {
            return tell_frame(errc::collision);
        }
        if (echo_.is_open() and not expects_echo()) {
            end_echo(); // silence has ended a beginning of it
        }
        errc const wrong = judged();
        line_event const event = event_of(wrong);
        tell_frame(wrong);
        observer_.on_response(event, wrong, unit(), now);
        bool const is_response = event == line_event::reply or event == line_event::exception;
        bool const is_damaged =
            event == line_event::crc and framer_.looks_addressed_to(memory_, request()) and framer_.matches_size_hint();
        // While another unit's response is outstanding, a damaged one may be that: none of its bytes can be relied on.
        if (is_response or (is_damaged and quarantine_.is_empty())) {
            retries_.note_response();
        }
        if (not is_response) {
            echo_.suspect();
            if constexpr (has_system) {
                if (event == line_event::foreign or (event == line_event::mismatch and wrong != errc::line_echo)) {
                    note_late(to_u8(framer_.bytes(memory_)[0]), now);
                }
            }
        } else if (echo_.is_absent()) {
            echo_.forget();
        }
        // Behind `acknowledge` a unit does what it was asked to do: nothing but a read of bits or registers goes again.
        bool const is_under_way =
            wrong == errc::acknowledge and request()[1] > static_cast<std::byte>(function_code::read_input_registers);
        if (not is_under_way and retries_.may_pause(wrong)) {
            deadline_ = now + retries_.take_pause();
            phase_ = phase::pausing;
            error_ = errc::none;
        } else if (is_response) {
            settle(wrong, now);
        } else if (wrong == errc::line_echo or is_echo_in_front()) {
            echo_.note_seen();
            settle(errc::line_echo, now);
        } else if (event != line_event::foreign and wrong != errc::frame_too_short) {
            // A damaged response of our unit is worth an early repetition. Anything else may be noise
            // before the response or a response to an older request, so the timer runs on.
            error_ = wrong;
            if (is_damaged) {
                attempt_failed(now);
            }
        }
    }

    /// What the frame that has ended is as a response to the request.
    [[gnu::always_inline]] constexpr errc judged() const noexcept
    {
        errc wrong = framer_.verdict(memory_);
        if (wrong == errc::none) {
            wrong = check_response<Functions>(request(), framer_.frame(memory_));
        }
        if (wrong == errc::none and not framer_.matches_size_hint()) {
            wrong = errc::wrong_length;
        }
        return wrong;
    }

    // The echo of the request.

    static constexpr bool may_ask_alone = length_rules::may_be_alone(Functions{});

    /// Whether the frame that is being received is an echo where it is no response.
    constexpr bool is_echo_in_front() const noexcept { return may_ask_alone and echo_.is_in_front(); }

    /// Whether what is sent has to come back before a response.
    constexpr bool expects_echo() const noexcept { return options().has_line_echo or echo_.is_proven(); }

    /// Compares bytes with those that were sent. Returns how many are accounted for: on a line that is known to echo up to
    /// the first that differs, elsewhere those that come back while the request leaves, and a whole request where the
    /// response would be something else. All others may be a response.
    constexpr std::size_t take_echo(byte_view bytes, instant now) noexcept
    {
        if (not echo_.is_open()) {
            return 0;
        }
        bool const expects = expects_echo();
        bool const may_be_response = phase_ == phase::awaiting and not expects;
        std::size_t const before = echo_.taken();
        std::size_t const same = echo_.take(bytes, request());
        if (echo_.is_whole()) {
            // What came behind the request as a whole may be the response to it; what came before `sent`, to an earlier one,
            // or to this one where `sent` is late. Neither shows what the line does.
            bool const is_mirrored = check_response<Functions>(request(), adu{request()}) != errc::line_echo;
            // The response to a function alone may begin with all of it: its first byte may be the first of the request's CRC.
            bool const is_alone = may_ask_alone and request().size() == min_adu_size;
            bool const is_first = may_be_response and framer_.begun(memory_).size() == before;
            bool const is_doubtful = is_first and (is_mirrored or is_alone);
            if (is_doubtful and not echo_.is_known()) {
                echo_.begin_frame(not is_mirrored);
                return 0;
            }
            tell_echo(before + same, true);
            if (may_be_response) {
                framer_.drop_begun();
            }
            if (not is_doubtful) {
                note_echo(not is_mirrored, now);
            }
            return same;
        }
        if (not echo_.is_open()) {
            tell_echo(may_be_response ? before : before + same, false);
        }
        if (phase_ != phase::awaiting or framer_.begun(memory_).size() != before) {
            echo_.suspect(); // what came while the request left is no response
        }
        if (expects and not echo_.is_open()) {
            observer_.on_bytes(bytes.subspan(same, 1), frame_role::unknown, frame_verdict::damaged);
            observer_.on_event(line_event::collision, unit());
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
            observer_.on_event(line_event::mismatch, unit());
            error_ = errc::line_echo;
            if (phase_ == phase::awaiting) {
                settle(errc::line_echo, now);
            }
        }
    }

    /// No more of an echo is awaited.
    constexpr void end_echo() noexcept
    {
        tell_echo(echo_.taken(), false);
        echo_.end();
    }

    // What an observer is told of the bytes that arrive; without one these functions are empty.

    /// Tells of a frame that ended while a response was awaited, by what was found in it.
    constexpr void tell_frame(errc found) noexcept
    {
        if constexpr (is_observed<Observer>) {
            byte_view const bytes = framer_.bytes(memory_);
            bool const is_whole = framer_.verdict(memory_) == errc::none and framer_.matches_size_hint();
            bool const is_owed = is_whole and quarantine_.covers(to_u8(bytes[0]));
            observer_.on_bytes(bytes, is_whole ? frame_role::response : frame_role::unknown,
                               verdict_on_response(found, is_whole, is_owed));
        }
    }

    /// Tells what has come back of the request, or looked like it. Of a part, what may be a response is left to that; on a line
    /// that is not known to echo, a part is none.
    constexpr void tell_echo(std::size_t taken, bool is_whole) noexcept
    {
        if constexpr (is_observed<Observer>) {
            bool const may_be_response = phase_ == phase::awaiting and not expects_echo() and not is_whole;
            std::size_t const inside = may_be_response ? framer_.begun(memory_).size() : 0;
            byte_view const bytes = request().first(inside < taken ? taken - inside : 0);
            if (expects_echo() or bytes.size() == request().size()) {
                observer_.on_echo(bytes, frame_role::request);
            } else {
                observer_.on_bytes(bytes, frame_role::unknown, frame_verdict::stray);
            }
        }
    }

    // All zero at the start. In front of the frame, members of one byte that are used often first: small processors reach
    // what is near with short instructions, on a Cortex-M0+ a byte in the first 32 bytes. Members of classes have no `{}`,
    // for which GCC would first make zeros by a call of memset (docs/size-notes.md). No byte is left between the members.
    [[no_unique_address]] response_framer framer_; ///< cuts the response out of the bytes that arrive
    kept_phase phase_{client_phase::idle};
    errc error_{errc::none};
    bool is_woken_{false};     ///< the next pass has something to do at once
    bool may_not_wait_{false}; ///< bytes on the line end the request once it is ready
    std::uint8_t unit_{0};     ///< of the last request; 0 for a broadcast
    [[no_unique_address]] kept_request<Functions> request_;
    [[no_unique_address]] line_echo echo_;
    [[no_unique_address]] noise_allowance<Options> noise_{};
    [[no_unique_address]] address_0<Needs.has_only_unit> at_0_;
    [[no_unique_address]] retry_state retries_;
    instant deadline_{0};
    [[no_unique_address]] quarantine<Needs.quarantine_places> quarantine_{};
    [[no_unique_address]] Options options_{};
    [[no_unique_address]] Observer observer_{};
    typename response_framer::memory memory_; ///< its line; the request, and behind it its response
};

} // namespace detail

#pragma GCC diagnostic pop

} // namespace RTUWIRE_BUILD
} // namespace rtuwire
