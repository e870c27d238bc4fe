// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// Splits received bytes into frames by length and silence (SL 2.5.1.1). A frame ends where its length rule
// says, if the CRC is right there; otherwise, and where there is no rule, it ends by silence. A CRC match
// alone never ends a frame, and no frame is searched for inside other bytes. Needs memory for one frame.
//
//   state          byte                  damaged byte  t3.5   frame_end  poll_frame  restart  resynchronise
//   synchronising  dropped               stays         stays  idle       stays       idle     stays
//   idle           receiving             receiving     stays  stays      stays       stays    synchronising
//   receiving      kept; at the last     stays         stays  done       stays       idle     synchronising
//                  done or open end
//   open end       done                  receiving     done   done       stays       idle     synchronising
//   done           receiving             receiving     stays  stays      idle        idle     synchronising
//
// The last byte is the one where the rule is met and the CRC is right. An end is open where another unit's response
// may end there or one byte later: a byte 00 is then the last, any other begins the next frame. Done: a frame, or why
// the bytes are none; what was not polled when the next byte arrives is dropped.
//
// Apart are what the bytes tell of a frame's length, those between other stations too, which is wire/functions.hpp's, and
// its sum, which is core/crc16.hpp's.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

#include <rtuwire/core/bytes.hpp>
#include <rtuwire/core/crc16.hpp>
#include <rtuwire/core/result.hpp>
#include <rtuwire/core/time.hpp>
#include <rtuwire/core/version.hpp>
#include <rtuwire/rtu/line.hpp>
#include <rtuwire/wire/adu.hpp>
#include <rtuwire/wire/errc.hpp>
#include <rtuwire/wire/function.hpp>
#include <rtuwire/wire/functions.hpp>

namespace rtuwire {
inline namespace RTUWIRE_BUILD {

namespace detail {

/// Where a frame begins in the framer's memory: at its start. `Longest` is the size of the longest frame, 256 at most.
template <std::size_t Front, std::size_t Longest = max_adu_size> class frame_place {
public:
    static constexpr bool has_front = false;
    static constexpr std::size_t memory = Longest;
    [[nodiscard]] static constexpr std::uint16_t begin() noexcept { return 0; }
};

/// Behind other bytes at the front, up to 256: the frame begins at `Front`, or behind those bytes where they
/// are more. A frame has `Longest` bytes less what exceeds `Front`.
template <std::size_t Front, std::size_t Longest>
    requires(Front > 0)
class frame_place<Front, Longest> {
public:
    static constexpr bool has_front = true;
    static constexpr std::size_t memory = Longest + Front;
    [[nodiscard]] constexpr std::uint16_t begin() const noexcept { return begin_; }
    constexpr void leave_room_for(std::size_t size) noexcept
    {
        begin_ = static_cast<std::uint16_t>(size < Front ? Front : size);
    }

private:
    std::uint16_t begin_{0};
};

/// The times of a line, and memory for its frames.
template <typename Line, std::size_t Size> struct line_memory {
    explicit constexpr line_memory(line_timing const& its_timing) noexcept : line{its_timing} {}

    /// For compile-time timing. Zero-initialised, so a `constinit` holder lives in .bss.
    constexpr line_memory() noexcept requires is_constant<Line> : bytes{} {}

    [[nodiscard]] constexpr line_timing const& timing() const noexcept { return line.get(); }

    [[no_unique_address]] Line line{};
    std::array<std::byte, Size> bytes; ///< written up to the frame's end
};

/// A framer without its memory, which its holder keeps behind all other members and hands to each call: small processors
/// reach near members with short instructions. Server and client have one, and take a frame at the byte that ends it.
/// `Place` is the `frame_place`; the lengths of responses are known of `Functions`. What `framer` has, too, is told there.
template <direction Way, typename Place, typename Line, typename Functions = public_functions> class framer_state {
public:
    using memory = line_memory<Line, Place::memory>;

    constexpr std::size_t receive(memory& in, byte_view arrived, instant now) noexcept
    {
        if (arrived.empty() or begin_chunk(in, arrived.size(), now)) {
            return 0;
        }
        if (is_open_end()) {
            return takes_behind_open_end(arrived[0]) ? 1 : 0;
        }
        return take_many(in, arrived.data(), arrived.size());
    }

    /// Takes one byte. Returns whether it was taken.
    constexpr bool receive(memory& in, std::byte byte, instant now) noexcept
    {
        if (begin_chunk(in, 1, now)) {
            return false;
        }
        if (is_open_end()) {
            return takes_behind_open_end(byte);
        }
        static_cast<void>(push(in, byte));
        return true;
    }

    /// The second part of `receive`, after `begin_chunk`: takes bytes up to the end of one frame. Returns how many. Not
    /// inlined: a receiver that is given single bytes never calls it.
    [[gnu::noinline]] constexpr std::size_t take_many(memory& in, std::byte const* at, std::size_t count) noexcept
    {
        if (state_ == state::synchronising) {
            return count;
        }
        if (state_ != state::receiving) {
            begin();
            look_ahead({at, count});
        }
        for (std::size_t left = count; left != 0;) {
            std::size_t const taken = copy_to_look(in, at, left);
            if (taken == 0) {
                error_ = error_ == errc::none ? errc::frame_too_long : error_;
                break;
            }
            at += taken;
            left -= taken;
            if (end_ == rule_at_ and apply_length_rule(in)) {
                return count - left;
            }
        }
        return count;
    }

    /// The second part of `receive`, after `begin_chunk`: takes one byte. Returns whether it was the last of a frame.
    [[gnu::always_inline]] constexpr bool push(memory& in, std::byte byte) noexcept
    {
        if (state_ == state::synchronising) {
            return false;
        }
        if (state_ != state::receiving) {
            begin();
        }
        if (end_ == place_.memory) {
            if (error_ == errc::none) {
                error_ = errc::frame_too_long;
            }
            return false;
        }
        in.bytes[end_++] = byte;
        sum_.add(byte);
        return end_ == rule_at_ and apply_length_rule(in);
    }

    constexpr void receive_error(memory const& in, instant now) noexcept
    {
        static_cast<void>(begin_chunk(in, 1, now));
        spoil();
    }

    /// The second part of `receive_error`, after `begin_chunk`.
    constexpr void spoil() noexcept
    {
        if (state_ == state::synchronising) {
            return;
        }
        if (state_ != state::receiving) {
            begin();
        }
        error_ = errc::uart_error;
    }

    /// Whether the bytes so far of the frame that is being received, all of them good, tell that more are to come.
    [[nodiscard]] constexpr bool lacks_bytes() const noexcept
    {
        return state_ == state::receiving and error_ == errc::none and rule_at_ > end_;
    }

    /// Why the last frame is refused; none where it is good.
    [[nodiscard]] constexpr errc verdict(memory const& in) const noexcept
    {
        return error_ != errc::none           ? error_
               : size() < min_adu_size        ? errc::frame_too_short
               : not sum_.is_right(bytes(in)) ? errc::crc_mismatch
                                              : errc::none;
    }

    /// The last frame, where the verdict is none.
    [[nodiscard]] constexpr adu frame(memory const& in) const noexcept { return adu{bytes(in)}; }

    constexpr void note_foreign_request(std::uint8_t unit, std::uint8_t function) noexcept
        requires(Way == direction::request)
    {
        others_.expect(unit, function);
    }

    [[nodiscard]] constexpr bool is_foreign_response() const noexcept requires(Way == direction::request)
    {
        return others_.is_response();
    }

    /// Takes note of `bytes` bytes, one at least, that had arrived by `now`. Returns whether the silence before them
    /// ended a frame, whole or damaged, which must be polled before the first byte is taken.
    constexpr bool begin_chunk(memory const& in, std::size_t bytes, instant now) noexcept
    {
        // An unread frame is discarded, so receiving never stalls.
        if (state_ == state::done) {
            state_ = state::idle;
        }
        // The first byte of a chunk arrived earlier than the chunk was handed over.
        instant const at = within_reach_of_line(in, now);
        if (activity_ != activity::unknown and reached(at, last_ + end_silence(in) + in.timing().characters(bytes))) {
            on_silence(in);
        }
        keep_activity(now, at);
        return state_ == state::done;
    }

    constexpr void advance(memory const& in, instant now) noexcept
    {
        if (activity_ == activity::unknown) {
            note_activity(now);
        }
        instant const at = within_reach_of_line(in, now);
        if (reached(at, last_ + in.timing().silence())) {
            activity_ = activity::quiet;
        }
        if (ends_by_silence(in) and reached(at, last_ + end_silence(in))) {
            on_silence(in);
        }
    }

    /// The time by which what was in force at the latest activity is judged `now`: that may be the end of a frame that is
    /// being sent.
    [[nodiscard]] constexpr instant within_reach_of_line(memory const& in, instant now) const noexcept
    {
        constexpr duration latency = milliseconds(100); // of what sends it
        return within_reach(last_, now, in.timing().characters(max_adu_size) + latency);
    }

    /// Adds the time when `advance` has something to do to the earliest of several. `awaits_bytes` leaves the silence
    /// before sending out: nothing is to be sent before more has arrived, or a time limit is over.
    constexpr void add_to(memory const& in, earliest& next, bool awaits_bytes = false) const noexcept
    {
        if (activity_ == activity::busy and not awaits_bytes) {
            next.add(last_ + in.timing().silence());
        }
        if (activity_ != activity::unknown and ends_by_silence(in)) {
            next.add(last_ + end_silence(in));
        }
    }

    /// When a receiver that has nothing to send has something to do: when silence ends the frame being received, or the bytes
    /// being ignored; between frames, when the line counts as quiet. A separate plain form, which is smaller
    /// (docs/size-notes.md).
    [[nodiscard]] constexpr deadline poll_end_deadline(memory const& in) const noexcept
    {
        if (activity_ == activity::unknown or not(waits_for_silence() or activity_ == activity::busy)) {
            return {};
        }
        return last_ + (waits_for_silence() ? end_silence(in) : in.timing().silence());
    }

    /// Whether a frame ended, whole or damaged, once.
    [[nodiscard]] constexpr bool poll_end() noexcept
    {
        bool const is_end = state_ == state::done;
        if (is_end) {
            state_ = state::idle;
        }
        return is_end;
    }

    /// Drops what is being received where silence does not end it.
    constexpr void drop_unended(memory const& in) noexcept
    {
        state_ = waits_for_silence() and not ends_by_silence(in) ? state::idle : state_;
    }

    /// Drops what is being received: the next byte is the first of a frame.
    constexpr void drop_begun() noexcept { state_ = state::idle; }

    /// A frame that has ended by its length goes on: nothing but silence ends it.
    constexpr void go_on() noexcept { state_ = state_ == state::done ? state::receiving : state_; }

    constexpr void restart(instant now) noexcept
    {
        note_activity(now);
        state_ = state::idle;
    }

    constexpr void resynchronise() noexcept { state_ = state::synchronising; }

    [[nodiscard]] constexpr instant last_activity() const noexcept { return last_; }

    constexpr void note_activity(instant now) noexcept { keep_activity(now, now); }

    [[nodiscard]] constexpr bool is_quiet() const noexcept { return activity_ == activity::quiet; }

    /// Whether nothing has come for t3.5, or for the silence before sending where that is shorter.
    [[nodiscard]] constexpr bool is_at_rest(memory const& in, instant now) const noexcept
    {
        return is_quiet() or reached(now, last_ + in.timing().t3_5());
    }

    [[nodiscard]] constexpr bool is_at_start() const noexcept { return not waits_for_silence(); }

    /// Whether something is being received that silence ends. On a host, where no wire may lose bytes, it does not while a
    /// response tells that more of it is to come: the time limit of its request ends that. One with a number came whole.
    [[nodiscard]] constexpr bool ends_by_silence(memory const& in) const noexcept
    {
        if constexpr (has_system and Place::has_front) {
            if (not in.timing().has_wire() and not in.timing().has_numbers() and lacks_bytes()) {
                return false;
            }
        }
        return waits_for_silence();
    }

    /// Whether bytes are ignored until the line has been silent.
    [[nodiscard]] constexpr bool ignores_bytes() const noexcept { return state_ == state::synchronising; }

    /// Keeps the first `size` bytes of the memory, at most 256, free: later frames are received behind them. Of one that is
    /// being received nothing is known from here on but that silence ends it.
    constexpr void receive_behind(std::size_t size) noexcept requires(Place::has_front)
    {
        place_.leave_room_for(size);
        end_ = place_.begin();
        if constexpr (has_system) {
            state_ = state_ == state::receiving ? state::synchronising : state_;
        }
    }

    /// The largest frame that there is room for.
    [[nodiscard]] constexpr std::size_t room() const noexcept { return place_.memory - place_.begin(); }

    /// Whether the last frame has the size that its own bytes tell, where they tell one. Silence may have ended
    /// it at another size, where by chance its CRC is right, too.
    [[nodiscard]] constexpr bool matches_size_hint() const noexcept { return rule_at_ == 0 or rule_at_ == end_; }

    /// Whether the last frame had the smallest size of a frame or more, and began with this request's unit and function.
    [[nodiscard]] constexpr bool looks_addressed_to(memory const& in, byte_view request) const noexcept
    {
        std::byte const* const start = in.bytes.data() + place_.begin();
        return size() >= min_adu_size and start[0] == request[0] and (start[1] & std::byte{0x7F}) == request[1];
    }

    /// The bytes of the last frame, or of the one being received.
    [[nodiscard]] constexpr byte_view bytes(memory const& in) const noexcept
    {
        return {in.bytes.data() + place_.begin(), size()};
    }

    /// What has been received of a frame that has not ended.
    [[nodiscard]] constexpr byte_view begun(memory const& in) const noexcept
    {
        return state_ == state::receiving ? bytes(in) : byte_view{};
    }

    /// Whether the next byte may turn out to belong to the frame before it.
    [[nodiscard]] constexpr bool has_open_end() const noexcept { return is_open_end(); }

    /// Keeps the byte 00 that was taken behind an open end, where there is room.
    constexpr void keep_zero(memory& in) noexcept
    {
        if (end_ < place_.memory) {
            in.bytes[end_++] = std::byte{0};
        }
    }

private:
    enum class state : std::uint8_t { synchronising, receiving, open_end, idle, done };

    /// What the line did last; unknown before the first time is given.
    enum class activity : std::uint8_t { unknown, busy, quiet };

    /// Always false in a receiver of responses.
    constexpr bool is_open_end() const noexcept { return Way == direction::request and state_ == state::open_end; }

    constexpr bool waits_for_silence() const noexcept { return state_ < state::idle; }

    /// The silence that ends what is being received.
    constexpr duration end_silence(memory const& in) const noexcept
    {
        return is_open_end() ? in.timing().t3_5() : in.timing().frame_end();
    }

    /// `at`: the time by which the latest activity is judged, which is `within_reach_of_line` of bytes that have come now.
    constexpr void keep_activity(instant now, instant at) noexcept
    {
        if (activity_ != activity::busy or reached(at, last_)) {
            last_ = now;
        }
        activity_ = activity::busy;
    }

    constexpr void on_silence(memory const& in) noexcept
    {
        if (ends_by_silence(in)) {
            state_ = state_ == state::synchronising ? state::idle : state::done;
        }
    }

    constexpr bool takes_behind_open_end(std::byte next) noexcept
    {
        state_ = state::done;
        return others_.takes(next);
    }

    constexpr void begin() noexcept
    {
        state_ = state::receiving;
        others_.begin_frame();
        end_ = place_.begin();
        rule_at_ = static_cast<std::uint16_t>(place_.begin() + 2); // the first two bytes tell more
        sum_.begin();
        error_ = errc::none;
    }

    /// Spares looks at the first bytes of a frame that tell less than the next ones.
    constexpr void look_ahead(byte_view first) noexcept
    {
        if (first.size() < 3) {
            return;
        }
        if constexpr (default_crc_form == crc_form::host) {
            // 0 and 1 say that only silence ends it, and are no bytes to look at.
            if (std::size_t const told = size_hint<Functions>(Way, first);
                told > 3 and not others_.is_expected(first)) {
                return look_at(told);
            }
        }
        look_at(3); // no frame is so short, and most responses tell their size here
    }

    /// Copies bytes up to where the length rule is to be applied next. Returns how many; 0 where there is no room.
    constexpr std::size_t copy_to_look(memory& in, std::byte const* at, std::size_t count) noexcept
    {
        std::size_t const room = bytes_to_look();
        count = count < room ? count : room;
        sum_.copy(at, count, in.bytes.data() + end_);
        end_ = static_cast<std::uint16_t>(end_ + count);
        return count;
    }

    /// Applies the length rule at the byte where it is due. Returns whether the frame ends here. Force-inlined,
    /// which is smaller (docs/size-notes.md).
    [[gnu::always_inline]] constexpr bool apply_length_rule(memory const& in) noexcept
    {
        end_hint const told = others_.apply(bytes(in));
        // Past an end whose CRC is wrong only silence tells where the next frame starts.
        look_at(told.next);
        if (not told.is_here or error_ != errc::none or not sum_.is_right(bytes(in))) {
            return false;
        }
        sum_.note_right();
        others_.end_frame(told.is_response);
        state_ = told.is_open ? state::open_end : state::done;
        return true;
    }

    /// The length rule is due when the frame has `size` bytes; 0 where only silence tells the end.
    constexpr void look_at(std::size_t size) noexcept
    {
        rule_at_ = size == 0 ? std::uint16_t{0} : static_cast<std::uint16_t>(place_.begin() + size);
    }

    /// How many bytes there is room for, up to where the length rule is due.
    constexpr std::size_t bytes_to_look() const noexcept
    {
        bool const is_ahead = rule_at_ > end_ and rule_at_ < place_.memory;
        return (is_ahead ? std::size_t{rule_at_} : place_.memory) - end_;
    }

    constexpr std::size_t size() const noexcept { return std::size_t{end_} - place_.begin(); }

    instant last_{0};
    activity activity_{activity::unknown};
    state state_{state::synchronising};
    std::uint16_t end_{0};     ///< behind the last byte
    std::uint16_t rule_at_{0}; ///< where the length rule is due; no byte's position, 0, where it has nothing to say
    [[no_unique_address]] Place place_{};
    [[no_unique_address]] frame_sum<> sum_{};
    errc error_{errc::none};
    [[no_unique_address]] foreign_exchange<Way, Functions> others_{};
};

} // namespace detail

/// Splits a stream of bytes into frames. Call `receive` with the bytes that arrived until all are taken, and
/// `poll_frame` after each call; call `advance` when time has passed, at the latest at `poll_deadline`.
/// Ignores everything until the line has been silent once.
template <detail::direction Way, typename Line = detail::stored<line_timing>> class framer {
    using state = detail::framer_state<Way, detail::frame_place<0>, Line>;

public:
    /// With the silences of this line.
    explicit constexpr framer(line_timing const& timing) noexcept : memory_{timing} {}

    /// For compile-time timing. Zero-initialised, so a `constinit` framer lives in .bss.
    constexpr framer() noexcept requires(detail::is_constant<Line>) = default;

    /// Takes bytes that had arrived by `now`, in chunks of any size, up to the end of one frame; returns how
    /// many were taken. The bytes after that frame belong to the next call.
    constexpr std::size_t receive(byte_view bytes, instant now) noexcept { return state_.receive(memory_, bytes, now); }

    /// Reports a receive error (parity, framing, overrun): the frame that the damaged byte belongs to is
    /// refused even if its CRC is right. A frame that the silence before the byte ended, and that was not
    /// polled yet, is discarded.
    constexpr void receive_error(instant now) noexcept { state_.receive_error(memory_, now); }

    /// Applies the silence up to `now`. Must be called before the clock has run 35 minutes past a deadline.
    constexpr void advance(instant now) noexcept { state_.advance(memory_, now); }

    /// When `advance` has something to do.
    [[nodiscard]] constexpr deadline poll_deadline() const noexcept
    {
        detail::earliest next;
        state_.add_to(memory_, next);
        return next;
    }

    /// The frame that ended, once; or why the bytes that ended are no frame. The view is valid until bytes
    /// are taken again. Errors: `frame_too_short`, `frame_too_long`, `crc_mismatch`, `uart_error`; of a
    /// response also `wrong_length`, where silence ended it at another size than its own bytes tell.
    [[nodiscard]] constexpr std::optional<result<adu>> poll_frame() noexcept
    {
        if (not state_.poll_end()) {
            return std::nullopt;
        }
        errc const wrong = state_.verdict(memory_);
        if (wrong != errc::none) {
            return wrong;
        }
        if (Way == detail::direction::response and not state_.matches_size_hint()) {
            return errc::wrong_length;
        }
        return state_.frame(memory_);
    }

    /// Whether the silence before sending has passed, t3.5 where no other was given, so that sending is allowed.
    [[nodiscard]] constexpr bool is_quiet() const noexcept { return state_.is_quiet(); }

    /// Whether the next byte would be the first of a frame.
    [[nodiscard]] constexpr bool is_at_start() const noexcept { return state_.is_at_start(); }

    /// When the last byte arrived, or the time of a later `note_activity`.
    [[nodiscard]] constexpr instant last_activity() const noexcept { return state_.last_activity(); }

    /// By when to judge what was in force then. Internal.
    [[nodiscard]] constexpr instant within_reach_of_line(instant now) const noexcept
    {
        return state_.within_reach_of_line(memory_, now);
    }

    /// Records that the line was not silent at `now`, and leaves the frame alone. While the line is busy, a time
    /// before the latest recorded one changes nothing.
    constexpr void note_activity(instant now) noexcept { state_.note_activity(now); }

    /// Drops what is being received and takes the next byte as the first of a frame: for a line that the
    /// caller knows to be silent, because its own transmission just ended.
    constexpr void restart(instant now) noexcept { state_.restart(now); }

    /// Ignores everything until the line has been silent.
    constexpr void resynchronise() noexcept { state_.resynchronise(); }

    /// Records a request to another unit: the response of this unit and function may follow. Frames with
    /// these first two bytes (the function with or without 80) then end at the size by the request's rule or
    /// by the response's, the first of the two where the CRC is right. Where the other size is one byte more,
    /// a byte 00 that follows at once belongs to the frame, but is not kept: of such frames only the first
    /// two bytes are of use. A function of 80 or above ends this.
    constexpr void note_foreign_request(std::uint8_t unit, std::uint8_t function) noexcept
        requires(Way == detail::direction::request)
    {
        state_.note_foreign_request(unit, function);
    }

    /// Whether the last frame ended at the size of the response that `note_foreign_request` announced.
    [[nodiscard]] constexpr bool is_foreign_response() const noexcept requires(Way == detail::direction::request)
    {
        return state_.is_foreign_response();
    }

    /// The timing of its line.
    [[nodiscard]] constexpr line_timing const& line() const noexcept { return memory_.timing(); }

private:
    state state_{};
    typename state::memory memory_;
};

} // namespace RTUWIRE_BUILD
} // namespace rtuwire
