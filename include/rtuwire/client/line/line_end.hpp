// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// A client's line and the request on it: one memory for the bytes of the request and, behind them, of its response;
// how long both take.
// Internal: may change with any version.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <type_traits>

#include <rtuwire/ask/conversation.hpp>
#include <rtuwire/client/line/line_echo.hpp>
#include <rtuwire/client/line/phase.hpp>
#include <rtuwire/client/line/retry_state.hpp>
#include <rtuwire/client/options.hpp>
#include <rtuwire/client/statistics.hpp>
#include <rtuwire/client/turns.hpp>
#include <rtuwire/core/constant.hpp>
#include <rtuwire/core/time.hpp>
#include <rtuwire/core/version.hpp>
#include <rtuwire/rtu/frame_cutter.hpp>
#include <rtuwire/rtu/frame_place.hpp>
#include <rtuwire/rtu/line.hpp>
#include <rtuwire/trace/tracing.hpp>
#include <rtuwire/wire/errc.hpp>
#include <rtuwire/wire/frame_length.hpp>
#include <rtuwire/wire/response.hpp>

namespace rtuwire::inline RTUWIRE_BUILD {

/// How many bytes precede the room for a response on a microcontroller: as many as most requests have. A longer
/// request takes room from its response.
inline constexpr std::size_t shared_memory = 8;

/// The same on a host: requests and responses of every size.
inline constexpr std::size_t separate_memory = max_adu_size;

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

// On a microcontroller, a client that is copied copies the bytes of its frame that were never written, too, as std::byte
// may be. GCC warns of it.
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wuninitialized"
#if not defined(__clang__)
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"
#endif

/// The base of a client's transaction.
template <typename Statistics, typename Line, typename Options, typename Debts, std::size_t Front>
class line_end
    : private detail::frame_cutter<line_end<Statistics, Line, Options, Debts, Front>, direction::response, Front> {
    using cutter = detail::frame_cutter<line_end, direction::response, Front>;
    friend cutter;
    friend detail::line_silence<line_end, direction::response>;
    friend detail::frame_bytes<line_end, direction::response, Front>;

public:
    explicit constexpr line_end(line_timing const& its_timing, client_options const& its_options = {}) noexcept
        : options_{its_options}, line_{its_timing}
    {
        // Written before it is read. A constant has no part without a value; a microcontroller would call memset for it.
        if (std::is_constant_evaluated() or default_crc_form == crc_form::host) {
            bytes_.fill(std::byte{0});
        }
    }

    /// For a constant line and constant options. Zero-initialised, so a `constinit` client lives in .bss.
    constexpr line_end() noexcept requires is_constant<Line> : bytes_{} {}

    /// What was counted.
    [[nodiscard]] constexpr counted_by<Statistics>& statistics() noexcept { return statistics_; }
    [[nodiscard]] constexpr counted_by<Statistics> const& statistics() const noexcept { return statistics_; }

    /// Hands the frames that pass from here on to a sink, which must outlive the client. For a client `traced_by` it.
    template <typename Sink>
        requires is_traced_by<Statistics, Sink>
    constexpr void trace_to(Sink& frames) noexcept { statistics_.trace_to(frames); }

    /// Whether the line has fallen silent since the last byte.
    [[nodiscard]] constexpr bool is_quiet() const noexcept { return framer().is_quiet(); }

    /// Sends no request of any conversation to a unit from here until `end`, at most 35 minutes away. A request that
    /// is leaving or waits for its response is not ended. The latest of several ends counts.
    constexpr void hold(unit_id unit, instant end) noexcept { quarantine_.begin(unit.byte(), end); }

    /// Whether no new request goes to a unit now: its response is outstanding, or `hold` says so.
    [[nodiscard]] constexpr bool is_held(unit_id unit) const noexcept { return is_held(unit.byte()); }
    [[nodiscard]] constexpr bool is_held(std::uint8_t unit) const noexcept { return quarantine_.covers(unit); }

    /// Whether the line has given back what was sent, and echoes are taken out by themselves: `client_options::has_line_echo`
    /// says how.
    [[nodiscard]] constexpr bool has_seen_echo() const noexcept { return echo_.is_known(); }

    /// The unit of the last request; 0 for a broadcast.
    [[nodiscard]] constexpr std::uint8_t asked_unit() const noexcept { return unit_; }

    /// The timing of its line.
    [[nodiscard]] constexpr line_timing const& line() const noexcept { return framer().line(); }

protected:
    /// Cuts the response out of the bytes that arrive.
    constexpr cutter& framer() noexcept { return *this; }
    constexpr cutter const& framer() const noexcept { return *this; }

    constexpr client_options const& options() const noexcept { return options_.get(); }

    /// Copies a request to the front of the memory. Errors: `frame_too_short`, `frame_too_long`;
    /// `buffer_too_small` where the request and its longest response do not fit together.
    [[gnu::always_inline]] constexpr errc keep(byte_view frame) noexcept
    {
        if (frame.size() < min_adu_size) {
            return errc::frame_too_short;
        }
        if (frame.size() > max_adu_size) {
            return errc::frame_too_long;
        }
        framer().receive_behind(frame.size());
        longest_ = longest_response(frame);
        if (longest_.size() > framer().room()) {
            return errc::buffer_too_small;
        }
        byte_span const place = framer().storage();
        std::size_t i = frame.size();
        do { // backwards: 8 bytes less
            --i;
            place[i] = frame[i];
        } while (i != 0);
        size_ = static_cast<std::uint16_t>(frame.size());
        unit_ = to_u8(frame[0]);
        return errc::none;
    }

    /// Whether what is sent has to come back before a response.
    constexpr bool expects_echo() const noexcept { return options().has_line_echo or echo_.is_proven(); }

    constexpr byte_view request() const noexcept { return {framer().storage().data(), size_}; }

    /// How long the request takes to leave.
    constexpr duration time_to_send() const noexcept { return framer().line().characters(size_); }

    /// How long the longest response takes on the line; with the silence that ends it, where only silence does.
    constexpr duration time_to_respond() const noexcept
    {
        duration const silence = longest_.is_final() ? duration{} : framer().line().frame_end();
        return framer().line().with_characters(silence, longest_.size());
    }

    /// Whether a byte before the response may be skipped. Constant options that allow none leave no code of this.
    constexpr bool may_skip() const noexcept { return noise_.is_left() and framer().is_at_start(); }

    constexpr void drop_leading_noise() noexcept
    {
        noise_.take();
        statistics_.note(line_event::noise, asked_unit());
    }

    /// Counts bytes that belong to no response; `bytes` is not empty.
    constexpr void count_stray(byte_view bytes, bool is_start) noexcept
    {
        constexpr std::uint8_t highest_unit = 247;
        std::uint8_t const first = to_u8(bytes[0]);
        bool const is_late = is_start and first <= highest_unit and quarantine_.covers(first);
        statistics_.note_stray(bytes.size(), is_start, is_late ? first : std::uint8_t{0});
        if constexpr (is_traced<Statistics>) {
            statistics_.pass_stray(bytes, is_start, is_late);
        }
    }

    // All zero at the start. In front of the frame, members of one byte that are used often first: small processors reach
    // what is near with short instructions, on a Cortex-M0+ a byte in the first 32 bytes. Members of classes have no `{}`,
    // for which GCC would first make zeros by a call of memset (docs/size-notes.md). No byte is left between the members.
    client_phase phase_{client_phase::idle};
    errc error_{errc::none};
    bool is_woken_{false}; ///< the next pass has something to do at once
    std::uint8_t unit_{0}; ///< that was asked last; 0 for everyone
    [[no_unique_address]] turns turns_;
    bool must_send_now_{false}; ///< the request must leave at once or not at all
    [[no_unique_address]] retry_state retries_;
    std::uint16_t size_{0}; ///< of the request
    length_hint longest_{}; ///< of its responses; stored, which saves 57 instructions of a read
    instant deadline_{0};
    instant seen_{0}; ///< the latest `advance`
    [[no_unique_address]] Debts quarantine_{};
    bool is_held_back_{false}; ///< a conversation waits for a unit that gets no request now
    line_echo echo_;
    [[no_unique_address]] noise_allowance<Options> noise_{};
    [[no_unique_address]] Options options_{};
    [[no_unique_address]] Statistics statistics_{};

private:
    /// Whether a response tells that more of it is to come. The time limit of the request ends this.
    constexpr bool awaits_rest() const noexcept { return phase_ == client_phase::awaiting and framer().lacks_bytes(); }

    [[no_unique_address]] Line line_{};
    std::array<std::byte, frame_place<Front>::memory> bytes_; ///< the request, and behind it its response
};

#pragma GCC diagnostic pop

} // namespace rtuwire
