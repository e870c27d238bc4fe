// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// The request that a client's transaction is for (SL 2.4.1): its phases; its bytes, and how long they and its longest response
// are on the line; what of it comes back before a response; how often it was sent, and whether it may be sent once more; and until when its unit
// gets no other. Here are the parts: client/line/transaction.hpp says when which of them does what.
//
// The phases, and where each input leads, for a request that may be repeated once more; a dot: the phase stays. `visits`: the
// asker does, on a quiet line; `transmit`: `poll_transmit`.
//
//                visits transmit   sent       bytes    response busy    damaged advance      time_over    cancel
//   idle         ready  .          .          .        .        .       .       .            .            .
//   waiting      ready  .          .          .        .        .       .       .            settled      settled
//   ready        .      handed_out .          waiting  waiting  waiting waiting .            settled      settled
//   handed_out   .      .          awaiting   .        .        .       .       transmitting transmitting .
//   transmitting .      .          awaiting   .        .        .       .       .            settled      .
//   awaiting     .      .          .          .        settled  pausing waiting .            waiting      settled
//   pausing      .      .          .          .        .        .       .       .            waiting      settled
//   turnaround   .      .          .          .        .        .       .       .            settled      .
//   settled      idle   .          .          .        .        .       .       .            .            .
//
// Where no repetition is left, awaiting ends as settled instead of pausing and waiting. Where the request may not be
// repeated at all, bytes settle it in ready, too. After a broadcast, `sent` and the end of the time of transmitting
// lead to turnaround. Where the request was cancelled while it left, `sent` settles it.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <type_traits>

#include <rtuwire/client/needs.hpp>
#include <rtuwire/core/bytes.hpp>
#include <rtuwire/core/time.hpp>
#include <rtuwire/core/version.hpp>
#include <rtuwire/rtu/line.hpp>
#include <rtuwire/wire/errc.hpp>
#include <rtuwire/wire/function.hpp>
#include <rtuwire/wire/functions.hpp>
#include <rtuwire/wire/response.hpp>

namespace rtuwire {
inline namespace RTUWIRE_BUILD {

namespace detail {

/// What ends each phase of a client.
enum class client_phase : std::uint8_t {
    idle,         ///< a conversation's request -> waiting
    settled,      ///< its asker takes the outcome or has given it up, or the next in turn finds it missing -> idle
    waiting,      ///< t3.5 of silence, and its asker visits -> ready; not in time -> settled (bus_jam)
    ready,        ///< poll_transmit -> handed_out; bytes -> waiting, or settled where the request
                  ///< may not wait; too late -> settled
    handed_out,   ///< advance -> transmitting, whose time limit starts here; sent: as in transmitting
    transmitting, ///< sent -> awaiting, or turnaround after a broadcast, or settled where it was cancelled
                  ///< or came back; too late -> settled
    awaiting,     ///< the response -> settled; time over or a damaged response of our unit -> waiting, or settled;
                  ///< exception 06, or 05 to a read -> pausing, or settled
    pausing,      ///< time over -> waiting
    turnaround,   ///< time over -> settled
};

/// The phase of a client. That of a copy, which nobody has asked: what was ready does not leave.
class kept_phase {
public:
    constexpr kept_phase(client_phase at) noexcept : at_{at} {}
    constexpr kept_phase(kept_phase const& original) noexcept
        : at_{original.at_ == client_phase::ready ? client_phase::waiting : original.at_}
    {}
    constexpr kept_phase& operator=(kept_phase const& original) noexcept { return *this = kept_phase{original}.at_; }
    constexpr kept_phase& operator=(client_phase at) noexcept
    {
        at_ = at;
        return *this;
    }
    [[nodiscard]] constexpr operator client_phase() const noexcept { return at_; }

private:
    client_phase at_;
};

/// Whether a request is between its start and its outcome.
[[nodiscard, gnu::always_inline]] constexpr bool is_under_way(client_phase at) noexcept
{
    return at > client_phase::settled;
}

/// Whether the request is with the transmitter.
[[nodiscard]] constexpr bool is_leaving(client_phase at) noexcept
{
    return at == client_phase::handed_out or at == client_phase::transmitting;
}

/// The last request, to these functions. Its bytes stand in front of the response's, in the memory of the frame.
template <typename Functions> class kept_request {
public:
    /// Copies a request to the front of the memory; the framer receives behind it. Errors: those of `check_request`;
    /// `buffer_too_small` where the request and its response do not fit together.
    template <typename Cutter>
    [[gnu::always_inline]] constexpr errc keep(byte_view frame, Cutter& framer, typename Cutter::memory& in) noexcept
    {
        if (errc const wrong = check_request<Functions>(frame); wrong != errc::none) {
            return wrong;
        }
        constexpr std::size_t room = sizeof(in.bytes);
        if (room < max_adu_size and frame.size() > room) {
            return errc::buffer_too_small;
        }
        framer.receive_behind(frame.size());
        longest_ = longest_response<Functions>(frame);
        if (longest_.size() > framer.room()) {
            return errc::buffer_too_small;
        }
        std::size_t i = frame.size();
        do { // backwards: 8 bytes less
            --i;
            in.bytes[i] = frame[i];
        } while (i != 0);
        size_ = static_cast<std::uint16_t>(frame.size());
        return errc::none;
    }

    template <typename Memory> [[nodiscard]] constexpr byte_view bytes(Memory const& in) const noexcept
    {
        return {in.bytes.data(), size_};
    }

    /// How long it takes to leave.
    [[nodiscard]] constexpr duration time_to_send(line_timing const& line) const noexcept
    {
        return line.characters(size_);
    }

    /// How long its longest response takes on the line; with the silence that ends it, where only silence does.
    [[nodiscard]] constexpr duration time_to_respond(line_timing const& line) const noexcept
    {
        duration const silence = longest_.is_final() ? duration{} : line.frame_end();
        return line.with_characters(silence, longest_.size());
    }

private:
    std::uint16_t size_{0};
    length_hint longest_{}; ///< of its responses; stored, which saves 57 instructions of a read
};

/// Compares the received bytes with the bytes of one transmission, in their order, and keeps what the transmissions before
/// have shown: a line that has given back a whole one echoes, until a response comes without.
class line_echo {
public:
    /// A transmission begins.
    constexpr void begin() noexcept { next_ = 1; }

    /// Expects no echo from here on.
    constexpr void end() noexcept { next_ = 0; }

    /// All of it has come, and is the beginning of a frame that may be a response; or the response repeats it as a whole.
    constexpr void begin_frame(bool goes_on) noexcept { next_ = goes_on ? in_front : std::uint16_t{0}; }

    /// Whether the frame that is being received is an echo where it is no response.
    [[nodiscard]] constexpr bool is_in_front() const noexcept { return next_ == in_front; }

    /// Something else has come that may have been an echo, damaged or in part. Not inlined: it is called in several places.
    [[gnu::noinline]] constexpr void suspect() noexcept { next_ = next_ == 0 ? suspected : next_; }

    /// Whether nothing has come of an echo.
    [[nodiscard]] constexpr bool is_absent() const noexcept { return next_ == 0; }

    /// Whether the next byte may belong to the echo.
    [[nodiscard]] constexpr bool is_open() const noexcept { return next_ != 0 and next_ < in_front; }

    /// Whether this transmission has come back whole.
    [[nodiscard]] constexpr bool is_whole() const noexcept { return next_ == whole; }

    /// How many bytes have come, while more are to come.
    [[nodiscard]] constexpr std::size_t taken() const noexcept { return is_open() ? next_ - 1U : 0U; }

    /// Takes bytes while the echo is open. Returns how many of them equal what was sent; after one that differs, and after
    /// the last one, the echo is over.
    constexpr std::size_t take(byte_view bytes, byte_view sent) noexcept
    {
        std::size_t same = 0;
        while (is_open() and same < bytes.size()) {
            if (bytes[same] != sent[next_ - 1U]) {
                end();
                break;
            }
            ++same;
            next_ = next_ == sent.size() ? whole : static_cast<std::uint16_t>(next_ + 1);
        }
        return same;
    }

    /// Whether the line has echoed.
    [[nodiscard]] constexpr bool is_known() const noexcept { return seen_ != 0; }
    /// Whether it has done so twice.
    [[nodiscard]] constexpr bool is_proven() const noexcept { return seen_ == twice; }
    constexpr void note_seen() noexcept { seen_ = is_known() ? twice : std::uint16_t{1}; }
    /// What comes next decides again.
    constexpr void doubt() noexcept { seen_ = is_known() ? std::uint16_t{1} : std::uint16_t{0}; }
    constexpr void forget() noexcept { seen_ = 0; }

private:
    static constexpr std::uint16_t in_front = 0xFFFD;
    static constexpr std::uint16_t suspected = 0xFFFE;
    static constexpr std::uint16_t whole = 0xFFFF;
    static constexpr std::uint16_t twice = 2;

    std::uint16_t next_{0}; ///< the next byte's number, from 1; 0 where none is expected
    std::uint16_t seen_{0};
};

/// How many bytes of noise may still be skipped before a response; constant options that allow none take no memory.
template <typename Options> class noise_allowance {
public:
    constexpr void begin(std::uint8_t most) noexcept { left_ = most; }
    [[nodiscard]] constexpr bool is_left() const noexcept { return left_ != 0; }
    constexpr void take() noexcept { --left_; }

private:
    std::uint8_t left_{0};
};
template <typename Options>
    requires(is_constant<Options>and Options::get().max_leading_noise == 0)
class noise_allowance<Options> {
public:
    static constexpr void begin(std::uint8_t) noexcept {}
    [[nodiscard]] static constexpr bool is_left() noexcept { return false; }
    static constexpr void take() noexcept {}
};

/// Whether a request to address 0 has a response; where no client's needs say so, it is a broadcast and takes no memory.
template <bool HasOnlyUnit> class address_0 {
public:
    constexpr void expect(bool response) noexcept { has_response_ = response; }
    [[nodiscard]] constexpr bool has_response() const noexcept { return has_response_; }

private:
    bool has_response_{}; ///< said with each request
};
template <> class address_0<false> {
public:
    static constexpr void expect(bool) noexcept {}
    [[nodiscard]] static constexpr bool has_response() noexcept { return false; }
};

// Until when a unit gets no new request, because an outstanding response could be taken for the response to the new
// request: RTU responses carry no number.
//
// The account: each sending owes one answer, and the answer to another request pays for none. The rule holds for a unit that
// answers its requests in their order and each within W = R + L of the moment at which it could begin (R: response time-out with
// the response's own characters, L: late_response); on a system also for one that is later, or answers in another order, if
// its first late answer comes while it is held:
//
//   ended by                              held until      why
//   the response to the only sending      not held        there is no other
//   a response at s, while k sendings     s + k (s-f+L)   whichever was answered, k may follow, each within what
//   have none, the first at f                             the first may have taken, s - f, and L; of s - f no more
//                                                         counts than what all sendings and their waits may take:
//                                                         the program may have been stopped for the rest
//   no response, or given up              b               at each sending at t: b = max(b, t) + W, for the unit
//                                                         begins when it has answered all before it
//   on a system: a late answer at s       s + k (s-f+L)   the same for the k that are owed still, and no longer than
//   while it is held                                      all their sendings and waits may take, and L: a unit that
//                                                         babbles is held so long once for each sending
//
// Of several ends the latest counts, and what is owed is forgotten with the hold. A late answer is what begins on a quiet line
// with the address of a held unit, or is a whole frame of it with a right CRC that answers something else. A stop passes a hold:
// what it owes is added. A damaged response, or an exception that asks for time, counts as a response.
//
// No rule of time can tell apart the responses of a unit whose first late answer comes behind its hold, while another request
// to it is under way: that gets it, where it has the form of its response. Of a late answer that nobody heard nothing is known.

/// Sendings that have no response: since when, how long all of them with their waits may take, and how many.
struct owed_responses {
    instant first{0};
    duration longest{};
    std::uint32_t count{0};

    /// A pause, and how long all others may take, once one has come at `now`: each as long as the first may have taken, plus
    /// `late`. A program that was stopped meanwhile counts no longer than its request may take.
    [[nodiscard]] constexpr duration all_that_follow(instant now, duration late, duration pause = {}) const noexcept
    {
        duration const each = shorter_of(now - first, longest) + late;
        duration length = pause;
        for (std::uint32_t left = count; left != 0; --left) {
            length = length + each;
        }
        return length;
    }

    /// Those of a later request are owed, too.
    constexpr void add(owed_responses const& later) noexcept
    {
        if (count == 0) {
            *this = later;
        } else if (later.count != 0) {
            count += later.count;
            longest = longest + later.longest;
        }
    }

    /// A late one has come. Returns how long the others may take, no longer than all together.
    [[nodiscard]] constexpr duration take_late(instant now, duration late) noexcept
    {
        --count;
        return shorter_of(all_that_follow(now, late), longest + late);
    }
};

/// The attempts at one request.
class retry_state {
public:
    /// A new request; one that may not be repeated gets a single attempt.
    constexpr void begin(retry_policy const& with, bool may_repeat) noexcept
    {
        retries_ = may_repeat ? with.retries : std::uint16_t{0};
        busy_retries_ = may_repeat ? with.busy_retries : std::uint16_t{0};
        failures_ = 0;
        pauses_ = 0;
        unanswered_ = 0;
        response_timeout_ = with.response_timeout;
        pause_ = with.pause;
        busy_pause_ = with.busy_pause < with.pause ? with.pause : with.busy_pause;
    }

    /// Takes one repetition after silence or damage; returns false where none is left.
    constexpr bool take_retry() noexcept
    {
        bool const is_left = failures_ < retries_;
        failures_ = static_cast<std::uint16_t>(failures_ + (is_left ? 1 : 0));
        return is_left;
    }

    /// Allows no further repetition.
    constexpr void end_retries() noexcept
    {
        retries_ = 0;
        busy_retries_ = 0;
    }

    /// Whether the unit asks for time, and a pause is left.
    [[nodiscard, gnu::always_inline]] constexpr bool may_pause(errc response) const noexcept
    {
        bool const asks = response == errc::acknowledge or response == errc::server_device_busy;
        return asks and pauses_ < busy_retries_;
    }

    /// Takes one repetition after a pause, and returns the pause. The next one is twice as long.
    constexpr duration take_pause() noexcept
    {
        constexpr std::uint8_t most_doublings = 6;
        duration const pause = busy_pause_;
        if (pauses_ < most_doublings and pause < duration{longest_duration.microseconds / 2}) {
            busy_pause_.microseconds *= 2;
        }
        ++pauses_;
        return pause;
    }

    /// The request has left once more, which takes `sending` on the line. Its unit answers it at most `each` after it could
    /// begin: from here on, or when it has answered the requests before.
    [[gnu::always_inline]] constexpr void note_sent(instant at, duration sending, duration each) noexcept
    {
        if (unanswered_ == 0) {
            first_sent_ = at;
            owed_until_ = at;
            longest_ = duration{};
        }
        owed_until_ = at + ((owed_until(at) - at) + each);
        // The two sums of 35 minutes fit.
        longest_ = longest_ + duration{response_timeout_.microseconds + sending.microseconds + each.microseconds};
        ++unanswered_;
    }

    /// Lets time pass: what was owed by then is not owed later.
    constexpr void advance(instant now, instant at) noexcept { keep_over(owed_until_, now, at); }

    /// Until when responses may come, where none has come. Never before `now`, so that it can be compared with other
    /// times that lie ahead, nor longer than for all sendings together, whatever the clock shows.
    [[nodiscard]] constexpr instant owed_until(instant now) const noexcept
    {
        return reached(now, owed_until_) ? now : now + shorter_of(owed_until_ - now, longest_);
    }

    /// A response to one of the sendings has come, whole or damaged.
    constexpr void note_response() noexcept { --unanswered_; }

    /// The unit's pause, and how long the responses to all other sendings may take, once one has come at `now`.
    [[nodiscard]] constexpr duration all_that_follow(instant now, duration late) const noexcept
    {
        return owed().all_that_follow(now, late, pause_);
    }

    /// The sendings that have no response.
    [[nodiscard]] constexpr owed_responses owed() const noexcept { return {first_sent_, longest_, unanswered_}; }

    [[nodiscard]] constexpr bool is_first() const noexcept { return failures_ + pauses_ == 0; }

    [[nodiscard]] constexpr duration response_timeout() const noexcept { return response_timeout_; }

    /// What its unit gets behind a response, and before a repetition.
    [[nodiscard]] constexpr duration pause() const noexcept { return pause_; }

private:
    // Not of one byte: small processors reach two where they do not reach one.
    std::uint16_t retries_{0};
    std::uint16_t busy_retries_{0};
    std::uint16_t failures_{0};
    std::uint16_t pauses_{0};
    std::uint16_t unanswered_{0};
    duration response_timeout_{};
    duration busy_pause_{}; ///< the next one
    duration pause_{};
    instant first_sent_{0};
    instant owed_until_{0};
    duration longest_{}; ///< what the time limits leave from the first of the unanswered sendings on
};

/// Stands for all units, in the place of a unit's address. No other unit has it: a reserved one is kept apart from none.
inline constexpr std::uint8_t any_unit = 0xFF;

/// One unit (0: none), until when it gets no new request, and what it owes. Where there is no system nothing is kept of that: it
/// would take 470 bytes of flash.
template <bool HasSystem> struct unit_in_quarantine {
    instant end;
    std::uint32_t unit; ///< small processors reach a word where they do not reach a byte
    owed_responses owed{};

    /// Besides, or nothing else.
    constexpr void owe(owed_responses const& more, bool is_all) noexcept
    {
        owed.count = is_all ? 0 : owed.count;
        owed.add(more);
    }
    [[nodiscard]] constexpr bool owes() const noexcept { return owed.count != 0; }
    [[nodiscard]] constexpr duration take_late(instant now, duration late) noexcept
    {
        return owed.take_late(now, late);
    }
};
template <> struct unit_in_quarantine<false> {
    instant end;
    std::uint32_t unit;

    static constexpr void owe(owed_responses const&, bool) noexcept {}
    [[nodiscard]] static constexpr bool owes() noexcept { return false; }
    [[nodiscard]] static constexpr duration take_late(instant, duration) noexcept { return {}; }
};
using quarantine_entry = unit_in_quarantine<has_system>;

/// The places of several units, and how many are in use: nobody looks at the others. The only place of one counts as used, and
/// leaves its padding to its holder.
template <std::size_t Units> struct quarantine_places {
    constexpr quarantine_entry* data() noexcept { return entries.data(); }
    constexpr quarantine_entry const* data() const noexcept { return entries.data(); }

    std::array<quarantine_entry, Units> entries{filled<Units>(quarantine_entry{instant{0}, 0})};
    std::size_t count{0};
};
template <> struct quarantine_places<1> {
    constexpr quarantine_entry* data() noexcept { return &entry; }
    constexpr quarantine_entry const* data() const noexcept { return &entry; }

    [[no_unique_address]] quarantine_entry entry{instant{0}, 0};
    static constexpr std::size_t count = 1;
};

/// The times of up to `Units` units at once; where more have an outstanding response, the last place stands for every
/// unit.
template <std::size_t Units> class quarantine {
public:
    /// A unit gets no new request until `end`, or until the later end that it has already, and owes this besides.
    constexpr void begin(std::uint8_t unit, instant end, owed_responses const& owed = {}) noexcept
    {
        quarantine_entry& own = place_of(unit);
        if (own.unit == nobody or reached(end, own.end)) {
            own.end = end;
        }
        own.owe(owed, own.unit == nobody);
        own.unit = own.unit == nobody or own.unit == unit ? unit : any_unit;
    }

    /// A late answer of a unit has come: where it is held, what it owes besides may take as long again.
    constexpr void note_late(std::uint8_t unit, instant now, duration late) noexcept
    {
        for (quarantine_entry& each : used()) {
            if (each.unit != nobody and unit != nobody and stands_for(each, unit) and each.owes()) {
                instant const end = now + each.take_late(now, late);
                each.end = reached(end, each.end) ? end : each.end;
                return;
            }
        }
    }

    /// Lets time pass. Returns whether one of the times was over.
    constexpr bool advance(instant now) noexcept
    {
        bool is_over = false;
        for (quarantine_entry& each : used()) {
            if (each.unit != nobody and reached(now, each.end)) {
                each.unit = nobody;
                is_over = true;
            }
        }
        if constexpr (Units > 1) {
            while (entries_.count > 0 and entries_.data()[entries_.count - 1].unit == nobody) {
                --entries_.count;
            }
        }
        return is_over;
    }

    /// Whether no unit is held.
    [[nodiscard]] constexpr bool is_empty() const noexcept
    {
        for (quarantine_entry const& each : used()) {
            if (each.unit != nobody) {
                return false;
            }
        }
        return true;
    }

    /// Whether a unit may not be asked yet; never for 0, the broadcast, which has no response.
    [[nodiscard, gnu::always_inline]] constexpr bool covers(std::uint8_t unit) const noexcept
    {
        if constexpr (Units == 1) {
            return unit != nobody and stands_for(*entries_.data(), unit);
        } else {
            return is_among(unit);
        }
    }

    /// Adds the times that are not over yet.
    constexpr void add_to(earliest& next) const noexcept
    {
        for (quarantine_entry const& each : used()) {
            if (each.unit != nobody) {
                next.add(each.end);
            }
        }
    }

private:
    static constexpr std::uint8_t nobody = 0;

    static constexpr bool stands_for(quarantine_entry const& each, std::uint8_t unit) noexcept
    {
        return each.unit == unit or each.unit == any_unit;
    }

    /// `covers` for several units. A function of its own: it is called in several places, and in more for each kind of
    /// conversation.
    constexpr bool is_among(std::uint8_t unit) const noexcept
    {
        for (quarantine_entry const& each : used()) {
            if (unit != nobody and stands_for(each, unit)) {
                return true;
            }
        }
        return false;
    }

    /// The unit's own place, or a free one, or the last.
    constexpr quarantine_entry& place_of(std::uint8_t unit) noexcept
    {
        if constexpr (Units == 1) {
            return *entries_.data();
        } else {
            std::size_t const used = entries_.count;
            std::size_t found = used < Units ? used : Units - 1;
            for (std::size_t i = used; i-- > 0;) {
                if (entries_.data()[i].unit == unit) {
                    return entries_.data()[i];
                }
                found = entries_.data()[i].unit == nobody ? i : found;
            }
            entries_.count = found < used ? used : found + 1;
            return entries_.data()[found];
        }
    }

    /// The entries up to the last one in use.
    constexpr std::span<quarantine_entry> used() noexcept { return std::span{entries_.data(), entries_.count}; }
    constexpr std::span<quarantine_entry const> used() const noexcept
    {
        return std::span{entries_.data(), entries_.count};
    }

    [[no_unique_address]] quarantine_places<Units> entries_{};
};

} // namespace detail

} // namespace RTUWIRE_BUILD
} // namespace rtuwire
