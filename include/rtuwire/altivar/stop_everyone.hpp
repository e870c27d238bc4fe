// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// Stops all drives of a line: by broadcasts, which reach every drive at once and are answered by none, then each one by
// its own address, until it is seen to stand. No emergency stop: it goes over a line that can fail.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

#include <rtuwire/altivar/stop.hpp>
#include <rtuwire/client/commander.hpp>
#include <rtuwire/core/version.hpp>
#include <rtuwire/table/device.hpp>
#include <rtuwire/wire/pdu/write_single_register.hpp>

namespace rtuwire::inline RTUWIRE_BUILD::altivar {

/// How everyone is stopped.
struct everyone_options {
    /// Whether all motors coast. Else they take their quick stop, but for an ATV320 whose words may mean something else:
    /// where one is among the drives, all coast.
    bool freewheel{false};
    /// What is known of the control words of all ATV320s on the line: see `stop`.
    word_meaning known{word_meaning::unknown};
    /// Whether the first broadcast also leaves behind a request that an ATV28 has not answered yet. It then reports a
    /// communication fault, and stops by that.
    bool cuts_short{false};
    /// A control word's address that is not broadcast to, because something else on the line has another register there
    /// (8501; an ATV28's is 400). The drives that have it there are stopped by their own addresses alone. 0: none.
    std::uint16_t left_out{0};
    /// From the first broadcast to the last; at least the longest response time-out on the line, so that an answer that was
    /// cut short cannot meet all of them.
    duration last_after{milliseconds(1'000)};
    /// How long each drive may take to stand.
    duration limit{milliseconds(30'000)};
};

/// The broadcasts of a line's families of drives, three rounds of them.
class broadcast_rounds {
public:
    explicit constexpr broadcast_rounds(everyone_options const& options) noexcept
        : left_out_{options.left_out}, known_{options.known}, coasts_{options.freewheel}
    {}

    /// One more drive is among those that have to stop.
    constexpr void add(drive_profile const& profile) noexcept
    {
        coasts_ = coasts_ or (profile.chcf != 0 and known_ == word_meaning::unknown);
        bool is_there = profile.cmd == left_out_ or size_ == families_.size();
        for (std::size_t i = 0; i < size_; ++i) {
            is_there = is_there or families_[i] == profile.cmd;
        }
        if (not is_there) {
            families_[size_] = profile.cmd;
            ++size_;
        }
    }

    [[nodiscard]] constexpr bool is_over() const noexcept { return round_ == rounds or size_ == 0; }
    [[nodiscard]] constexpr bool is_last_round() const noexcept { return round_ + 1 == rounds; }
    [[nodiscard]] constexpr bool coasts() const noexcept { return coasts_; }

    /// The broadcast that is due.
    [[nodiscard]] constexpr write_single_register question() const noexcept
    {
        auto const command = coasts_ ? cia402::command::disable_voltage : cia402::command::quick_stop;
        return {families_[at_], cia402::word_of(command)};
    }
    constexpr void next() noexcept
    {
        at_ = at_ + 1 == size_ ? 0 : at_ + 1;
        round_ = static_cast<std::uint8_t>(round_ + (at_ == 0 ? 1 : 0));
    }

private:
    static constexpr std::uint8_t rounds = 3;

    std::array<std::uint16_t, 4> families_{};
    std::size_t size_{0};
    std::size_t at_{0};
    std::uint16_t left_out_;
    std::uint8_t round_{0};
    word_meaning known_;
    bool coasts_;
};

/// Stops the drives that it is given, and every other on the line that has its control word where one of them has it:
/// `stop_everyone all{press, pump, fan}`, or with options in front. Give it to `bus::converse_first`, or to a client's
/// `converse` before all others. What is under way on the line is given up, unless its answer is arriving. Nothing
/// enables a drive of this line until its user orders again behind the end. `reason(i)` tells how the i-th drive's stop
/// ended, as for `stop`.
template <std::size_t Drives> class stop_everyone : public commander {
public:
    template <device_type... Device>
    explicit constexpr stop_everyone(everyone_options const& options,
                                     station<Device> const&... drives) noexcept
        : stop_everyone{options, rounds_of<Device...>(options), drives...}
    {}
    template <device_type... Device>
    explicit constexpr stop_everyone(station<Device> const&... drives) noexcept
        : stop_everyone{everyone_options{}, drives...}
    {}

    constexpr void advance(instant now) noexcept
    {
        if (not has_begun_) {
            has_begun_ = true;
            last_at_ = now + options_.last_after;
            this->note_stop();
        }
        is_last_due_ = is_last_due_ or reached(now, last_at_);
        if (rounds_.is_over()) {
            for (stop& each : stops_) {
                each.advance(now);
            }
            note_end();
        }
    }

    constexpr std::optional<request> next() noexcept
    {
        if (not rounds_.is_over()) {
            return is_waiting() ? std::nullopt : ask_everyone();
        }
        at_ = candidate();
        return stops_[at_].is_silenced() ? std::nullopt : stops_[at_].next();
    }

    constexpr void accept(result<response> const& outcome) noexcept
    {
        if (not rounds_.is_over()) {
            return rounds_.next(); // lost or not: nobody answers
        }
        stops_[at_].accept(outcome);
        note_end();
    }

    [[nodiscard]] constexpr deadline poll_deadline() const noexcept
    {
        earliest next;
        if (has_begun_ and not rounds_.is_over()) {
            if (is_waiting()) {
                next.add(last_at_);
            }
            return next;
        }
        for (stop const& each : stops_) {
            next.add(each.poll_deadline());
        }
        return next;
    }

    /// Whether every drive's stop has ended.
    [[nodiscard]] constexpr bool settled() const noexcept
    {
        bool is_settled = rounds_.is_over();
        for (stop const& each : stops_) {
            is_settled = is_settled and each.settled();
        }
        return is_settled;
    }

    /// Whether every drive was seen to stand.
    [[nodiscard]] constexpr bool succeeded() const noexcept
    {
        bool is_done = settled();
        for (stop const& each : stops_) {
            is_done = is_done and each.succeeded();
        }
        return is_done;
    }

    /// How the stop of a drive ended; `pending` before, and from `Drives` on.
    [[nodiscard]] constexpr altivar::reason reason(std::size_t drive) const noexcept
    {
        return drive < Drives ? stops_[drive].reason() : altivar::reason{};
    }

    /// For the client: see client/commander.hpp.
    [[nodiscard]] constexpr effect intent() const noexcept
    {
        if (not rounds_.is_over()) {
            return has_begun_ and not is_waiting() ? effect::stopping : effect::none;
        }
        return stops_[candidate()].intent();
    }
    [[nodiscard]] constexpr bool is_urgent() const noexcept { return not rounds_.is_over(); }
    [[nodiscard]] constexpr bool may_cut(std::uint8_t unit) const noexcept
    {
        if (rounds_.is_over()) {
            return stops_[candidate()].unit().octet() == unit;
        }
        for (std::size_t i = 0; i < Drives; ++i) {
            if (fails_when_cut_[i] and stops_[i].unit().octet() == unit) {
                return options_.cuts_short;
            }
        }
        return true;
    }
    [[nodiscard]] constexpr std::array<stop, Drives>& stops() noexcept { return stops_; }

private:
    template <device_type... Device>
    constexpr stop_everyone(everyone_options const& options, broadcast_rounds const& rounds,
                            station<Device> const&... drives) noexcept
        : stops_{stop{drives, rounds.coasts() ? stop_by::freewheel : stop_by::quick_stop,
                      options.limit, options.known}...},
          fails_when_cut_{Device::profile.fails_when_cut_short...}, rounds_{rounds},
          options_{options}
    {}

    template <device_type... Device>
    static constexpr broadcast_rounds rounds_of(everyone_options const& options) noexcept
    {
        broadcast_rounds rounds{options};
        (rounds.add(Device::profile), ...);
        return rounds;
    }

    /// The last round waits until no answer can be on its way.
    constexpr bool is_waiting() const noexcept { return rounds_.is_last_round() and not is_last_due_; }

    constexpr std::optional<request> ask_everyone() noexcept
    {
        static_cast<void>(encode_into(frame_, broadcast, rounds_.question()));
        return request{frame_};
    }

    /// The stop that asks next: words that stop come first, then in turn.
    constexpr std::size_t candidate() const noexcept
    {
        std::size_t found = at_;
        bool has_found = false;
        for (std::size_t i = 1; i <= Drives; ++i) {
            std::size_t const at = (at_ + i) % Drives;
            if (stops_[at].intent() == effect::stopping) {
                return at;
            }
            if (not has_found and stops_[at].has_question() and not stops_[at].is_silenced()) {
                has_found = true;
                found = at;
            }
        }
        return found;
    }

    constexpr void note_end() noexcept
    {
        if (settled()) {
            this->note_stop_over();
        }
    }

    std::array<stop, Drives> stops_;
    std::array<bool, Drives> fails_when_cut_;
    broadcast_rounds rounds_;
    everyone_options options_;
    std::array<std::byte, 8> frame_{};
    instant last_at_{0};
    std::size_t at_{0};
    bool has_begun_{false};
    bool is_last_due_{false};
};

template <device_type... Device>
stop_everyone(everyone_options const&, station<Device> const&...) -> stop_everyone<sizeof...(Device)>;
template <device_type... Device>
stop_everyone(station<Device> const&...) -> stop_everyone<sizeof...(Device)>;

} // namespace rtuwire::altivar
