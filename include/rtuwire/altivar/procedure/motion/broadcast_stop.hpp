// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// Stops all drives of a line: by broadcasts, which reach every drive at once and get no response, then each drive by
// its own address, until its state shows that it stands. No emergency stop: it uses a line that can fail.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

#include <rtuwire/altivar/device/drive_type.hpp>
#include <rtuwire/altivar/procedure/motion/stop.hpp>
#include <rtuwire/ask/commander.hpp>
#include <rtuwire/core/version.hpp>
#include <rtuwire/table/device.hpp>
#include <rtuwire/wire/function.hpp>
#include <rtuwire/wire/registers.hpp>

namespace rtuwire {
inline namespace RTUWIRE_BUILD {
namespace altivar {

/// How all drives are stopped.
struct broadcast_stop_options {
    /// Whether all motors coast. Else they do a quick stop, where the control words of each drive that is given or ordered
    /// to run are known, as for a `stop`: else all coast.
    bool freewheel{false};
    /// Whether the first broadcast is sent even while the response of an ATV28 is missing. That drive then reports a
    /// communication fault, and stops because of it.
    bool cuts_short{false};
    /// A control word's address that is not broadcast to, because something else on the line has another register there
    /// (8501; an ATV28's is 400). The drives that have it there are stopped by their own addresses alone. 0: none.
    std::uint16_t left_out{0};
    /// From the first broadcast to the last; at least the longest response time-out on the line, so that a response
    /// that was cut short cannot collide with all of them.
    duration last_after{milliseconds(1'000)};
    /// How long each drive may take to stand.
    duration limit{milliseconds(30'000)};
};

/// The broadcasts of a line's families of drives, three rounds of them.
///
/// | drives            | freewheel | word |
/// |-------------------|-----------|------|
/// | one not confirmed | any       | 0000 |
/// | all confirmed     | no        | 0002 |
/// | all confirmed     | yes       | 0000 |
///
/// Each address gets it once in a round, in the order of the drives; without an address there is no round.
/// Internal.
class broadcast_rounds {
public:
    explicit constexpr broadcast_rounds(broadcast_stop_options const& options) noexcept
        : left_out_{options.left_out}, coasts_{options.freewheel}
    {}

    /// Adds the control word's address of one more drive that has to stop; 0 adds nothing.
    constexpr void add(std::uint16_t address) noexcept
    {
        bool is_there = address == 0 or address == left_out_ or size_ == families_.size();
        for (std::size_t i = 0; i < size_; ++i) {
            is_there = is_there or families_[i] == address;
        }
        if (not is_there) {
            families_[size_] = address;
            ++size_;
        }
    }

    [[nodiscard]] constexpr bool is_over() const noexcept { return round_ == rounds or size_ == 0; }
    [[nodiscard]] constexpr bool is_last_round() const noexcept { return round_ + 1 == rounds; }
    [[nodiscard]] constexpr bool coasts() const noexcept { return coasts_; }
    constexpr void coast() noexcept { coasts_ = true; }

    /// The broadcast that is due.
    [[nodiscard]] constexpr write_single_register request() const noexcept
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
    bool coasts_;
};

/// Stops the drives that it is given, and every other on the line that has its control word where one of them, or a drive
/// that this client ordered to run, has it: `broadcast_stop all{press, pump, fan}`, or with options in front. Give it to
/// `bus::run_urgent`, or to a client's `converse` before all others. A request under way on the line is given up, unless its
/// response is arriving. No request enables a drive of this line until its user gives a new order after the end. `reason(i)`
/// tells how the i-th drive's stop ended, as for `stop`.
///
/// A drive that this client ordered to run and that is not given counts as lost while the broadcasts go out: after them it
/// gets words that stop it, from a `start` or `cyclic` that visits, or no request at all, until its own time-out is over. Until
/// it is read without power this stop has not succeeded: `leaves_ordered`.
///
/// | stage      | sends        | sent, or lost                        | last_after over                      | urgent |
/// |------------|--------------|--------------------------------------|--------------------------------------|--------|
/// | round 1    | a broadcast  | the next; after the last: round 2    |                                      | yes    |
/// | round 2    | a broadcast  | the next; after the last: wait       | goes on, then round 3 without a wait | yes    |
/// | wait       | nothing      |                                      | round 3                              | yes    |
/// | round 3    | a broadcast  | the next; after the last: each drive |                                      | yes    |
/// | each drive | its own stop | as in its own stop                   |                                      | no     |
template <std::size_t Drives> class broadcast_stop : public detail::commander {
public:
    static constexpr conversation_properties properties{.urgency = detail::urgency::stop_of_all};
    static constexpr function_set asks{function_code::read_holding_registers, function_code::write_single_register};
    static constexpr frame_sizes longest_frames = procedure_conversation::longest_frames;

    /// Stops these drives, by the options, which are copied.
    template <device_type... Device>
    explicit constexpr broadcast_stop(broadcast_stop_options const& options, station<Device> const&... drives) noexcept
        : commander{broadcast}, stops_{stop{drives, options.freewheel ? stop_by::freewheel : stop_by::quick_stop,
                                            options.limit}...},
          fails_when_cut_{drive_check<Device>::layout.fails_when_cut_short...}, options_{options}
    {
        begin_rounds();
    }
    /// Stops these drives, by the options' defaults.
    template <device_type... Device>
    explicit constexpr broadcast_stop(station<Device> const&... drives) noexcept
        : broadcast_stop{broadcast_stop_options{}, drives...}
    {}

    /// Begins anew with the first broadcast, as it was made. One under way is given up first, as if it had been destroyed.
    constexpr void again() noexcept
    {
        asker const former{*this};
        static_cast<detail::commander&>(*this) = detail::commander{broadcast};
        this->replace(former);
        for (stop& each : stops_) {
            each.again();
        }
        begin_rounds();
        at_ = 0;
        has_begun_ = false;
        is_first_visit_ = false;
        is_last_due_ = false;
    }

    constexpr void advance(instant now) noexcept
    {
        instant const at = has_begun_ ? detail::within_reach(now_, now) : now;
        now_ = now;
        is_first_visit_ = not has_begun_;
        if (not has_begun_) {
            has_begun_ = true;
            last_at_ = now + options_.last_after;
            this->note_stop();
        }
        is_last_due_ = is_last_due_ or reached(at, last_at_);
        if (rounds_.is_over()) {
            for (stop& each : stops_) {
                each.advance(now);
            }
            note_end();
        }
    }

    constexpr std::optional<request_frame> next() noexcept
    {
        is_first_visit_ = false;
        if (not rounds_.is_over()) {
            return is_waiting() ? std::nullopt : ask_everyone();
        }
        at_ = candidate();
        return stops_[at_].is_silenced() ? std::nullopt : stops_[at_].next();
    }

    constexpr void accept(result<response> const& outcome) noexcept
    {
        if (not rounds_.is_over()) {
            return rounds_.next(); // lost or not: a broadcast has no response
        }
        stops_[at_].accept(outcome);
        note_end();
    }

    [[nodiscard]] constexpr deadline poll_deadline() const noexcept
    {
        detail::earliest next;
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

    /// Whether a drive that this client ordered to run, given or not, was not read without power since.
    [[nodiscard]] constexpr bool leaves_ordered() const noexcept { return this->is_unit_ordered(); }

    /// Whether every drive's state showed that it stands, and that of every other that was ordered. To be read in the pass in which it settles: not from the next
    /// visit on.
    [[nodiscard]] constexpr bool succeeded() const noexcept
    {
        bool is_done = settled() and not this->is_used_already() and not leaves_ordered();
        for (stop const& each : stops_) {
            is_done = is_done and each.succeeded();
        }
        return is_done;
    }

    /// How the stop of a drive ended; `pending` before, and from `Drives` on; `used_already` from the visit on that follows
    /// the one in which this conversation settles.
    [[nodiscard]] constexpr altivar::reason reason(std::size_t drive) const noexcept
    {
        if (this->is_used_already() and drive < Drives) {
            return {outcome_kind::used_already};
        }
        altivar::reason found = drive < Drives ? stops_[drive].reason() : altivar::reason{};
        found.is_other_stop = found.is_other_stop or
                              (rounds_.coasts() and not options_.freewheel and found.kind != outcome_kind::pending);
        return found;
    }

    /// For the client: see ask/commander.hpp.
    [[nodiscard]] constexpr detail::effect intent() const noexcept
    {
        if (not rounds_.is_over()) {
            return has_begun_ and not is_waiting() ? detail::effect::stopping : detail::effect::none;
        }
        return stops_[candidate()].intent();
    }
    [[nodiscard]] constexpr bool is_urgent() const noexcept { return is_first_visit_ or not rounds_.is_over(); }
    constexpr void note_unlisted(std::uint16_t control_word) noexcept
    {
        if (not is_first_visit_) {
            return; // what counts was told; meanwhile it may be lost
        }
        if (control_word != 0 and control_word != detail::other_meaning) {
            return rounds_.add(control_word);
        }
        for (stop const& each : stops_) { // it is of either family
            rounds_.add(each.layout().other_cmd);
        }
    }
    [[nodiscard]] constexpr std::uint8_t unit_told() const noexcept
    {
        return rounds_.is_over() ? stops_[candidate()].unit().byte() : std::uint8_t{0};
    }
    [[nodiscard]] constexpr bool may_cut(std::uint8_t unit) const noexcept
    {
        if (rounds_.is_over()) {
            return unit == unit_told();
        }
        for (std::size_t i = 0; i < Drives; ++i) {
            if (fails_when_cut_[i] and stops_[i].unit().byte() == unit) {
                return options_.cuts_short;
            }
        }
        return true;
    }
    [[nodiscard]] constexpr std::array<stop, Drives>& stops() noexcept { return stops_; }

private:
    /// To the families of the drives that were given.
    constexpr void begin_rounds() noexcept
    {
        rounds_ = broadcast_rounds{options_};
        for (stop const& each : stops_) {
            rounds_.add(each.layout().cmd);
        }
    }

    /// The last round waits until no response can still be on the line.
    constexpr bool is_waiting() const noexcept { return rounds_.is_last_round() and not is_last_due_; }

    constexpr std::optional<request_frame> ask_everyone() noexcept
    {
        // What counted when it began goes on to count: a quick stop is not cut short, whatever its own silence lasts. What did
        // not count then is read before a word of each drive's own stop rests on it.
        bool is_known = this->confirmed() != 0 or (has_told_ and this->was_confirmed() != 0);
        for (stop& each : stops_) {
            is_known = is_known and not each.may_run_on_a_stop();
        }
        has_told_ = true;
        if (not is_known) {
            rounds_.coast();
        }
        for (stop& each : stops_) {
            each.count_old_readings(not rounds_.coasts());
        }
        static_cast<void>(encode_into(frame_, broadcast, rounds_.request()));
        return request_frame{frame_};
    }

    /// The stop that sends next: words that stop come first, then the others in turn.
    constexpr std::size_t candidate() const noexcept
    {
        std::size_t found = at_;
        bool has_found = false;
        for (std::size_t i = 1; i <= Drives; ++i) {
            std::size_t const at = (at_ + i) % Drives;
            if (stops_[at].intent() == detail::effect::stopping) {
                return at;
            }
            if (not has_found and stops_[at].has_request() and not stops_[at].is_silenced()) {
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
    broadcast_stop_options options_;
    broadcast_rounds rounds_{options_};
    std::array<std::byte, 8> frame_{};
    instant now_{0};
    instant last_at_{0};
    std::size_t at_{0};
    bool has_begun_{false};
    bool is_first_visit_{false};
    bool is_last_due_{false};
    bool has_told_{false}; ///< everyone, once at least
};

template <device_type... Device>
broadcast_stop(broadcast_stop_options const&, station<Device> const&...) -> broadcast_stop<sizeof...(Device)>;
template <device_type... Device> broadcast_stop(station<Device> const&...) -> broadcast_stop<sizeof...(Device)>;

} // namespace altivar
} // namespace RTUWIRE_BUILD
} // namespace rtuwire
