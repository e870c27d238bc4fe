// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// A client's line and the request that is on it: one memory for the octets of the request and, behind them, of
// its answer; how long both take.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include <rtuwire/client/client_state.hpp>
#include <rtuwire/client/conversation.hpp>
#include <rtuwire/client/options.hpp>
#include <rtuwire/client/statistics.hpp>
#include <rtuwire/core/fixed.hpp>
#include <rtuwire/core/time.hpp>
#include <rtuwire/core/version.hpp>
#include <rtuwire/rtu/frame_place.hpp>
#include <rtuwire/rtu/framer.hpp>
#include <rtuwire/rtu/line.hpp>
#include <rtuwire/wire/answer.hpp>

namespace rtuwire::inline RTUWIRE_BUILD {

/// How many octets stand in front of the room for an answer on a microcontroller: as many as most requests
/// have. A longer request takes room from its answer.
inline constexpr std::size_t shared_memory = 8;

/// The same on a host: requests and answers of every size.
inline constexpr std::size_t separate_memory = max_adu_size;

/// The base of a client's transaction.
template <typename Statistics, typename Line, typename Options, typename Debts, std::size_t Front>
class line_end : private frame_cutter<line_end<Statistics, Line, Options, Debts, Front>,
                                      direction::response, Front>,
                 public client_state {
    using cutter = frame_cutter<line_end, direction::response, Front>;
    friend cutter;

public:
    explicit constexpr line_end(line_timing const& timing,
                                client_options const& options = {}) noexcept
        : options_{options}, line_{timing}, octets_{}
    {}

    /// With a line and options that are fixed: all zero, so that a `constinit` one needs no flash.
    constexpr line_end() noexcept requires is_fixed<Line> : octets_{} {}

    /// What was counted.
    [[nodiscard]] constexpr Statistics& statistics() noexcept { return statistics_; }
    [[nodiscard]] constexpr Statistics const& statistics() const noexcept { return statistics_; }

    /// Whether the line has fallen silent since the last octet.
    [[nodiscard]] constexpr bool is_quiet() const noexcept { return framer().is_quiet(); }

    /// Asks a unit nothing from here until `end`, at most 35 minutes away, whichever conversation wants to. A
    /// request that is leaving or waits for its answer is not ended. The later of several ends counts.
    constexpr void hold(unit_id unit, instant end) noexcept { quarantine_.begin(unit.octet(), end); }

    /// Whether a unit is asked nothing new now: it owes an answer, or `hold` says so.
    [[nodiscard]] constexpr bool is_held(unit_id unit) const noexcept
    {
        return is_held(unit.octet());
    }
    [[nodiscard]] constexpr bool is_held(std::uint8_t unit) const noexcept
    {
        return quarantine_.covers(unit);
    }

    /// The unit that was asked last; 0 for everyone.
    [[nodiscard]] constexpr std::uint8_t asked_unit() const noexcept { return unit_; }

    /// The times of its line.
    [[nodiscard]] constexpr line_timing const& line() const noexcept { return framer().line(); }

protected:
    /// What cuts the answer out of the octets that arrive.
    constexpr cutter& framer() noexcept { return *this; }
    constexpr cutter const& framer() const noexcept { return *this; }

    constexpr client_options const& options() const noexcept { return options_.get(); }

    /// Copies a request to the front of the memory. Errors: `frame_too_short`, `frame_too_long`;
    /// `buffer_too_small` where the request and its longest answer do not fit together.
    [[gnu::always_inline]] constexpr errc keep(byte_view frame) noexcept
    {
        if (frame.size() < min_adu_size) {
            return errc::frame_too_short;
        }
        if (frame.size() > max_adu_size) {
            return errc::frame_too_long;
        }
        framer().receive_behind(frame.size());
        longest_ = longest_answer(frame);
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

    constexpr byte_view question() const noexcept { return {framer().storage().data(), size_}; }

    /// How long the request takes to leave.
    constexpr duration time_to_send() const noexcept { return framer().line().characters(size_); }

    /// How long the longest answer takes on the line; with the silence that ends it, where nothing else does.
    constexpr duration time_to_answer() const noexcept
    {
        duration const silence = longest_.is_final() ? duration{} : framer().line().frame_end();
        return framer().line().with_characters(silence, longest_.size());
    }

    /// Whether an octet before the answer may be left out. Options that are fixed at none leave all of this out.
    constexpr bool may_skip() const noexcept
    {
        bool const is_wanted = not is_fixed<Options> or options().skip_noise != 0;
        return is_wanted and skip_left_ > 0 and framer().is_at_start();
    }

    constexpr void skip_noise() noexcept
    {
        --skip_left_;
        statistics_.note(line_event::noise, asked_unit());
    }

    /// Counts octets that belong to no answer, one at least.
    constexpr void count_stray(byte_view octets, bool is_start) noexcept
    {
        constexpr std::uint8_t highest_unit = 247;
        std::uint8_t const first = to_u8(octets[0]);
        bool const is_late = is_start and first <= highest_unit and quarantine_.covers(first);
        statistics_.note_stray(octets.size(), is_start, is_late ? first : std::uint8_t{0});
    }

    Debts quarantine_{};
    [[no_unique_address]] Options options_{};
    [[no_unique_address]] Statistics statistics_{};

private:
    [[no_unique_address]] Line line_{};
    std::array<std::byte, frame_place<Front>::memory> octets_; ///< the request, and behind it its answer
};

} // namespace rtuwire
