// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// Keeps a drive running: one exchange a period, by function 23 over the scanner where the device moves
// its words so, by functions 03 and 16 elsewhere. Before the first order it checks that the drive would stop by itself
// (altivar/supervision.hpp).
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>

#include <rtuwire/altivar/cycle_steps.hpp>
#include <rtuwire/altivar/cyclic_options.hpp>
#include <rtuwire/altivar/reference.hpp>
#include <rtuwire/client/commander.hpp>
#include <rtuwire/core/time.hpp>
#include <rtuwire/core/version.hpp>
#include <rtuwire/table/device.hpp>

namespace rtuwire::inline RTUWIRE_BUILD::altivar {

/// A conversation without an end: give it to a client or a bus in each pass. It needs the scanner's first
/// two slots as delivered, or set so by `configure_scanner`, and no output slots beyond but those that
/// `set_output` names. Before the first exchange, after each loss, and after each conversation of this client that
/// could have changed it, it reads the drive's safeguards and the scanner's addresses, some twelve questions; where they
/// are not what they have to be it writes nothing but the word that stops a motor it ordered, and `control().reason()`
/// says what is wrong.
template <device_type Device> class cyclic : public commander {
    using words = cycle_words<Device>;

public:
    explicit constexpr cyclic(station<Device> const& drive,
                              cyclic_options const& options = {}) noexcept
        : steps_{drive.unit(), options}, climb_limit_{options.climb_limit},
          tolerated_misses_{options.tolerated_misses}
    {}

    /// Orders operation at a speed (a frequency on a device without scanner), below zero in reverse. False, with
    /// nothing changed, until the drive was checked, before the first exchange and after a loss; in a fault, in local
    /// control, in a quick stop, while a stop has not come to its end, behind another's stop until the drive was read
    /// again, and for a reference below zero together with `heading::reverse`.
    constexpr bool run(setting<words::reference> reference, heading way = heading::forward) noexcept
    {
        reference_write const asked{0, reference.word()};
        bool const is_reverse = way == heading::reverse;
        if ((is_reverse and asked.is_reverse()) or this->was_stopped()) {
            return false;
        }
        bool const was_ordered = control().is_ordered();
        // The direction goes with the reference, in one word: no write of several is relied on to arrive whole.
        bool const is_taken = steps_.run(is_reverse ? asked.reversed().word : asked.word);
        if (is_taken and not was_ordered) {
            climb_end_ = now_ + climb_limit_;
            this->note_order_to_run();
        }
        return is_taken;
    }

    /// Takes the order back: the motor stops, on its ramp or as said; on the ramp, too, where the device has no halt. The
    /// word that stops goes at once, before all that others ask and before anything is read; that of a halt goes behind
    /// a look. `run` gives the order back once the motor stands.
    constexpr void stop(stop_by how = stop_by::ramp) noexcept
    {
        steps_.stop(how);
        this->note_stop();
        is_due_ = has_begun_;
    }

    /// Orders one fault reset. False, with nothing changed, where the drive is not known to be in fault, and while a
    /// reset is under way: so it may be called in each pass.
    constexpr bool reset_fault() noexcept
    {
        bool const is_taken = steps_.reset_fault();
        if (is_taken) {
            this->note_order();
        }
        return is_taken;
    }

    /// Sets an output word beyond the first two, where the device has it. It is written in each cycle
    /// from then on, to whatever register the scanner's slot stands for.
    constexpr void set_output(std::size_t slot, std::uint16_t word) noexcept
    {
        steps_.frames().set_output(slot, word);
    }

    /// An input word of the last exchange; 0 before it.
    [[nodiscard]] constexpr std::uint16_t input(std::size_t slot) const noexcept
    {
        return steps_.frames().input(slot);
    }

    /// The motor's speed in rpm at the last exchange.
    [[nodiscard]] constexpr std::int16_t speed() const noexcept { return steps_.frames().speed(); }

    /// What was found before the first order: the register that is against it, the time-out that was read.
    [[nodiscard]] constexpr supervision_report const& supervision() const noexcept
    {
        return steps_.report();
    }

    /// State, order, and why the last order was dropped.
    [[nodiscard]] constexpr cyclic_control const& control() const noexcept { return steps_.control(); }

    /// Whether more exchanges in a row failed than are tolerated, none was made yet, or the drive was not found as it
    /// has to be.
    [[nodiscard]] constexpr bool link_lost() const noexcept { return steps_.is_lost(); }

    [[nodiscard]] constexpr unit_id unit() const noexcept { return steps_.frames().unit(); }

    /// For the client: what the next question does to the motor, and how a loss is told.
    [[nodiscard]] constexpr effect intent() const noexcept
    {
        return is_due_ ? this->effect_now(steps_.intent(this->was_rearranged())) : effect::none;
    }
    [[nodiscard]] constexpr duration drive_timeout() const noexcept
    {
        duration const read = supervision().period.timeout;
        return read != duration{} ? read : Device::profile.longest_silence;
    }
    [[nodiscard]] constexpr std::uint8_t tolerated_misses() const noexcept
    {
        return tolerated_misses_;
    }

    constexpr void note_loss() noexcept
    {
        has_lost_ = true;
        heed_loss();
    }

    constexpr void advance(instant now) noexcept
    {
        now_ = now;
        bool const climbs = control().is_ordered() and not control().is_running();
        if (climbs and reached(now, climb_end_)) {
            steps_.note_late();
        }
        if (not has_begun_) {
            has_begun_ = true;
            due_ = now;
        }
        is_due_ = is_due_ or reached(now, due_);
    }

    constexpr std::optional<request> next() noexcept
    {
        if (not is_due_) {
            return std::nullopt;
        }
        bool const was_rearranged = this->was_rearranged();
        this->note_arrangement();
        if (this->was_stopped()) {
            this->heed_stop();
            steps_.note_stopped();
        }
        is_asking_ = true;
        return request{steps_.ask(was_rearranged), repetition::never};
    }

    constexpr void accept(result<response> const& outcome) noexcept
    {
        is_asking_ = false;
        if (outcome) {
            steps_.take(*outcome);
        } else {
            steps_.miss(outcome.error());
        }
        if (steps_.take_rest()) {
            this->note_rest();
        }
        if (steps_.take_fault()) {
            this->note_fault();
        }
        if (steps_.take_end_of_stop()) {
            this->note_stop_over();
        }
        if (steps_.take_pause()) {
            is_due_ = false;
            due_ = now_ + steps_.period();
        }
        heed_loss();
    }

    [[nodiscard]] constexpr deadline poll_deadline() const noexcept
    {
        return has_begun_ and not is_due_ ? deadline{due_} : deadline{};
    }

    /// Never: the cycle goes on until it is no longer asked.
    [[nodiscard]] static constexpr bool settled() noexcept { return false; }

private:
    /// Somebody's question to the drive was not answered: it is told to stop as long as it may be told anything.
    constexpr void heed_loss() noexcept
    {
        if (has_lost_ and not is_asking_) {
            has_lost_ = false;
            steps_.lose(errc::unit_lost);
            is_due_ = has_begun_;
        }
    }

    cycle_steps<Device> steps_;
    duration climb_limit_;
    instant now_{0};
    instant due_{0};
    instant climb_end_{0};
    std::uint8_t tolerated_misses_;
    bool has_begun_{false};
    bool is_due_{false};
    bool is_asking_{false};
    bool has_lost_{false};
};

} // namespace rtuwire::altivar
