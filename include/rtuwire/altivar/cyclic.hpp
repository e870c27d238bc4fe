// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// Keeps a drive running: one exchange a period, by function 23 over the scanner where the device moves
// its words so, by functions 03 and 16 elsewhere. A drive that must not run is told to stop by function 06 and only read
// besides. After a loss it is told to stop, as long as the client lets it, and looked at before anything else is written.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

#include <rtuwire/altivar/cycle_words.hpp>
#include <rtuwire/altivar/cyclic_control.hpp>
#include <rtuwire/altivar/reference.hpp>
#include <rtuwire/client/commander.hpp>
#include <rtuwire/core/time.hpp>
#include <rtuwire/core/version.hpp>
#include <rtuwire/table/device.hpp>
#include <rtuwire/wire/pdu/read_holding_registers.hpp>
#include <rtuwire/wire/pdu/read_write_multiple_registers.hpp>
#include <rtuwire/wire/pdu/write_multiple_registers.hpp>
#include <rtuwire/wire/pdu/write_single_register.hpp>

namespace rtuwire::inline RTUWIRE_BUILD::altivar {

/// How often, and against which time-out of the drive.
struct cyclic_options {
    /// From one exchange to the next; at most a third of the drive's time-out is used.
    duration period{milliseconds(100)};
    /// TTO as it is set in the drive; zero stands for the device's factory value.
    duration drive_timeout{};
    /// From an order to "operation enabled".
    duration climb_limit{milliseconds(3'000)};
    /// How many exchanges in a row may fail before the link counts as lost. None is repeated as it was:
    /// the next one says what is ordered then.
    std::uint8_t tolerated_misses{1};
    /// Whether function 23 is used where the device's words fit into it.
    bool by_function_23{true};
};

/// A conversation without an end: give it to a client or a bus in each pass. It needs the scanner's first
/// two slots as delivered, or set so by `configure_scanner`, and no output slots beyond but those that
/// `set_output` names. Before the first exchange, and after each loss, it reads the scanner's addresses;
/// where they are others it writes nothing, and says `misconfigured`.
template <device_type Device> class cyclic : public commander {
    using words = cycle_words<Device>;

public:
    explicit constexpr cyclic(station<Device> const& drive,
                              cyclic_options const& options = {}) noexcept
        : options_{options}, period_{safe_period(options)}, unit_{drive.unit()}
    {}

    /// Orders operation at a speed (a frequency on a device without scanner), below zero in reverse. False, with
    /// nothing changed, before the drive was heard, after a loss until it is heard again, in a fault, in local control,
    /// in a quick stop, while a stop has not come to its end, and for a reference below zero together with
    /// `heading::reverse`.
    constexpr bool run(setting<words::reference> reference, heading way = heading::forward) noexcept
    {
        reference_write const asked{0, reference.word()};
        bool const is_reverse = way == heading::reverse;
        if (is_reverse and asked.is_reverse()) {
            return false;
        }
        bool const was_ordered = control_.is_ordered();
        // The direction goes with the reference, in one word: no write of several is relied on to arrive whole.
        bool const is_taken = control_.run(is_reverse ? asked.reversed().word : asked.word);
        if (is_taken and not was_ordered) {
            climb_end_ = now_ + options_.climb_limit;
            this->note_order();
        }
        return is_taken;
    }

    /// Takes the order back: the motor stops, on its ramp or as said; on the ramp, too, where the device has no halt. The
    /// word that stops goes at once, before all that others ask. `run` gives the order back once the motor stands.
    constexpr void stop(stop_by how = stop_by::ramp) noexcept
    {
        bool const has_none = how == stop_by::halt and Device::profile.halt == 0;
        control_.stop(has_none ? stop_by::ramp : how);
        this->note_stop();
        is_due_ = has_begun_;
        stops_first_ = true;
    }

    /// Orders one fault reset; nothing, and no order is renewed by it, where the drive is in no fault.
    constexpr void reset_fault() noexcept
    {
        if (control_.state() == cia402::state::fault) {
            control_.reset_fault();
            this->note_order();
        }
    }

    /// Sets an output word beyond the first two, where the device has it. It is written in each cycle
    /// from then on, to whatever register the scanner's slot stands for.
    constexpr void set_output(std::size_t slot, std::uint16_t word) noexcept
    {
        if (slot >= 2 and slot < words::outputs) {
            outputs_[slot] = word;
            slots_in_use_ |= 1U << slot;
        }
    }

    /// An input word of the last exchange; 0 before it.
    [[nodiscard]] constexpr std::uint16_t input(std::size_t slot) const noexcept
    {
        return slot < words::inputs ? inputs_[slot] : std::uint16_t{0};
    }

    /// The motor's speed in rpm at the last exchange.
    [[nodiscard]] constexpr std::int16_t speed() const noexcept
    {
        return static_cast<std::int16_t>(inputs_[words::speed_at]);
    }

    /// State, order, and why the last order was dropped.
    [[nodiscard]] constexpr cyclic_control const& control() const noexcept { return control_; }

    /// Whether more exchanges in a row failed than are tolerated, none was made yet, or the scanner was
    /// not found as it has to be.
    [[nodiscard]] constexpr bool link_lost() const noexcept { return is_lost_; }

    [[nodiscard]] constexpr unit_id unit() const noexcept { return unit_; }

    /// For the client: what the next question does to the motor, and how a loss is told.
    [[nodiscard]] constexpr effect intent() const noexcept
    {
        if (not is_due_) {
            return effect::none;
        }
        step const next = due_step();
        if (next == step::say_stop) {
            return effect::stopping;
        }
        bool const writes = next == step::exchange or next == step::write;
        return writes and control_.moves() ? effect::enabling : effect::none;
    }
    [[nodiscard]] constexpr duration drive_timeout() const noexcept
    {
        bool const is_told = options_.drive_timeout.microseconds != 0;
        return is_told ? options_.drive_timeout : Device::profile.longest_silence;
    }
    [[nodiscard]] constexpr std::uint8_t tolerated_misses() const noexcept
    {
        return options_.tolerated_misses;
    }

    constexpr void advance(instant now) noexcept
    {
        now_ = now;
        bool const climbs = control_.is_ordered() and not control_.is_running();
        if (climbs and reached(now, climb_end_)) {
            control_.note_late();
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
        step_ = due_step();
        stops_first_ = false;
        return request{byte_view{frame_}.first(make_frame()), repetition::never};
    }

    constexpr void accept(result<response> const& outcome) noexcept
    {
        if (not outcome) {
            return miss(outcome.error());
        }
        misses_ = 0;
        take(*outcome);
        if (control_.take_rest()) {
            this->note_rest();
        }
        if (control_.take_end_of_stop()) {
            this->note_stop_over();
        }
    }

    [[nodiscard]] constexpr deadline poll_deadline() const noexcept
    {
        return has_begun_ and not is_due_ ? deadline{due_} : deadline{};
    }

    /// Never: the cycle goes on until it is no longer asked.
    [[nodiscard]] static constexpr bool settled() noexcept { return false; }

private:
    enum class step : std::uint8_t {
        look,
        look_for_fault,
        check_inputs,
        check_outputs,
        exchange,
        read,              ///< the first half of an exchange by functions 03 and 16
        write,             ///< and the second
        say_stop,          ///< the word that stops, by function 06
        observe,           ///< reads as an exchange does, and writes nothing
        check_control,     ///< the control word, before the command to run
        compare_control,   ///< and from time to time while it runs
        compare_reference, ///< the reference, in the same way
    };

    /// The step that is asked now: whatever was to follow, a drive that must not run is told to stop; one that is halted
    /// is looked at first, because the halt's word could enable it in another state.
    constexpr step due_step() const noexcept
    {
        bool const is_exchange = step_ == step::exchange or step_ == step::read;
        bool const writes = is_exchange or step_ == step::write;
        if (stops_first_ and control_.must_stop()) { // whatever was to be read; a halt alone looks at the drive
            return control_.is_halting() ? step::observe : step::say_stop;
        }
        if (step_ == step::say_stop and control_.moves()) {
            return step::look; // an order came behind a stop that was not answered
        }
        if (writes and control_.must_stop()) {
            return control_.is_halting() ? step::observe : step::say_stop;
        }
        if (writes and repeats_itself()) {
            return step::observe;
        }
        bool const is_enabling = step_ != step::read and writes and control_.is_about_to_enable();
        if (is_enabling and not is_control_checked_) {
            return step::check_control;
        }
        if (is_exchange and exchanges_ >= exchanges_between_looks and control_.is_ordered() and
            control_.is_running()) {
            return compares_reference_ ? step::compare_reference : step::compare_control;
        }
        return step_;
    }

    /// Whether a word would go once more that the drive took and does not follow. One that fell back behind it, because its
    /// STOP key was pressed or its power was gone for a moment, would: it is only looked at.
    constexpr bool repeats_itself() const noexcept
    {
        return was_taken_ and control_.would_repeat(outputs_[0]);
    }

    static constexpr duration safe_period(cyclic_options const& options) noexcept
    {
        duration const limit = options.drive_timeout.microseconds != 0 ? options.drive_timeout
                                                                       : Device::silence.factory;
        duration const third{limit.microseconds / 3};
        return options.period < third ? options.period : third;
    }

    /// Whether the scanner is known to hold the words of the cycle.
    constexpr step step_after_look() const noexcept
    {
        return words::has_scanner and not is_checked_ ? step::check_inputs : first_step();
    }

    constexpr step first_step() const noexcept
    {
        return words_by_function_23() ? step::exchange : step::read;
    }

    constexpr bool words_by_function_23() const noexcept
    {
        return words::fits_function_23 and options_.by_function_23;
    }

    /// Puts the question of this step into the frame; its size.
    constexpr std::size_t make_frame() noexcept
    {
        constexpr drive_profile const& profile = Device::profile;
        switch (step_) {
        case step::look: return encoded(read_holding_registers{profile.eta, 1});
        case step::look_for_fault: return encoded(read_holding_registers{profile.lft, 1});
        case step::check_inputs:
            return encoded(read_holding_registers{scanner_input_addresses, words::inputs});
        case step::check_outputs:
            return encoded(read_holding_registers{scanner_output_addresses, words::outputs});
        case step::read:
        case step::observe:
            return encoded(read_holding_registers{words::read_from, words::inputs});
        case step::say_stop:
            was_taken_ = false;
            outputs_[0] = control_.next_command();
            return encoded(write_single_register{profile.cmd, outputs_[0]});
        case step::check_control:
        case step::compare_control: return encoded(read_holding_registers{profile.cmd, 1});
        case step::compare_reference:
            return encoded(read_holding_registers{words::reference.address, 1});
        case step::write: return encoded(write_multiple_registers{words::write_to, output()});
        case step::exchange: break;
        }
        return encoded(read_write_multiple_registers{words::read_from, words::inputs,
                                                     words::write_to, output()});
    }

    template <pdu Question> constexpr std::size_t encoded(Question const& question) noexcept
    {
        auto const frame = encode_into(frame_, unit_, question);
        return frame ? frame->size() : 0;
    }

    constexpr register_view output() noexcept
    {
        was_taken_ = false;
        outputs_[0] = control_.next_command();
        outputs_[1] = control_.reference();
        for (std::size_t i = 0; i < words::outputs; ++i) {
            output_block_.set(i, outputs_[i]);
        }
        return output_block_;
    }

    constexpr void miss(errc error) noexcept
    {
        wait_a_period();
        if (error == errc::cancelled) {
            return; // another conversation, or its owner, came before it
        }
        if (error == errc::overruled) {
            return yield();
        }
        if (step_ == step::say_stop) { // again, as long as the client lets it
            step_ = control_.is_halting() ? step::observe : step_;
            return;
        }
        bool const is_tolerated = misses_ < options_.tolerated_misses and error != errc::unit_lost and
                                  not is_exception(error);
        if (is_tolerated) {
            ++misses_;
            return start_over();
        }
        bool const may_run = control_.may_run();
        control_.note_loss(error);
        is_checked_ = false;
        is_lost_ = true;
        has_written_ = false;
        step_ = may_run ? step::say_stop : step::look;
    }

    /// An attempt of a drive that does not run yet was not answered: it may have lost its power meanwhile. All that was
    /// known of it is read again.
    constexpr void start_over() noexcept
    {
        if (control_.is_ordered() and not control_.is_running()) {
            is_checked_ = false;
            is_control_checked_ = false;
            step_ = step::look;
        }
    }

    /// A stop by another conversation has the drive: it is looked at, and nothing is written.
    constexpr void yield() noexcept
    {
        control_.note_overruled();
        has_written_ = false;
        step_ = step::look;
    }

    constexpr void wait_a_period() noexcept
    {
        is_due_ = stops_first_;
        due_ = now_ + period_;
    }

    constexpr void take(response const& answer) noexcept
    {
        if (step_ == step::write) {
            return end_exchange();
        }
        if (step_ == step::say_stop) {
            step_ = is_lost_ ? step::look : step::observe;
            return is_lost_ ? void() : wait_a_period();
        }
        constexpr std::size_t words_from = 2;
        register_view const read{answer.pdu().subspan(words_from)};
        switch (step_) {
        case step::look: return take_look(read[0]);
        case step::look_for_fault:
            control_.note_fault(read[0]);
            step_ = step_after_look();
            return;
        case step::check_inputs:
        case step::check_outputs: return check_scanner(read);
        case step::check_control:
        case step::compare_control: return compare(read[0], outputs_[0]);
        case step::compare_reference: return compare(read[0], outputs_[1]);
        case step::exchange:
        case step::read:
        case step::observe:
        case step::write:
        case step::say_stop: break;
        }
        take_inputs(read);
    }

    constexpr void take_look(std::uint16_t status) noexcept
    {
        is_lost_ = false;
        control_.note_status(status, false);
        step_ = step::look_for_fault;
    }

    constexpr void take_inputs(register_view read) noexcept
    {
        for (std::size_t i = 0; i < words::inputs; ++i) {
            inputs_[i] = read[i];
        }
        bool const was_in_fault = cia402::is_in_fault(control_.state());
        control_.note_status(inputs_[words::status_at], speed() == 0);
        if (step_ == step::read) {
            step_ = step::write;
        } else if (step_ == step::exchange) {
            end_exchange();
        } else if (control_.must_stop()) {
            step_ = step::say_stop; // right behind the look
        } else {
            step_ = first_step();
            wait_a_period();
        }
        if (not was_in_fault and cia402::is_in_fault(control_.state())) {
            step_ = step::look_for_fault;
        }
        is_control_checked_ = is_control_checked_ and control_.is_about_to_enable();
    }

    /// The drive has taken what was written.
    constexpr void end_exchange() noexcept
    {
        has_written_ = true;
        was_taken_ = true;
        exchanges_ = static_cast<std::uint8_t>(exchanges_ + (exchanges_ < exchanges_between_looks ? 1 : 0));
        step_ = first_step();
        wait_a_period();
    }

    /// What stands in the drive is what was written last, or somebody else commands it, or it lost its power.
    constexpr void compare(std::uint16_t found, std::uint16_t written) noexcept
    {
        bool const is_before_enabling = step_ == step::check_control;
        compares_reference_ = step_ == step::compare_control;
        exchanges_ = 0;
        if (found != written or not has_written_) {
            control_.note_overwritten();
            wait_a_period();
        }
        is_control_checked_ = is_before_enabling;
        step_ = is_before_enabling and not words_by_function_23() ? step::write : first_step();
    }

    constexpr void check_scanner(register_view addresses) noexcept
    {
        constexpr drive_profile const& profile = Device::profile;
        bool const is_input = step_ == step::check_inputs;
        std::uint16_t const second = is_input ? profile.rfrd : words::reference.address;
        bool is_right =
            addresses[0] == (is_input ? profile.eta : profile.cmd) and addresses[1] == second;
        for (std::size_t slot = 2; slot < words::outputs and not is_input; ++slot) {
            bool const is_in_use = ((slots_in_use_ >> slot) & 1U) != 0;
            is_right = is_right and (is_in_use or addresses[slot] == 0);
        }
        if (not is_right) {
            control_.note_misconfigured();
            wait_a_period();
        }
        is_checked_ = is_right and not is_input;
        is_lost_ = not is_right;
        step_ = not is_right ? step::look : is_input ? step::check_outputs : first_step();
    }

    static constexpr std::uint8_t exchanges_between_looks = 10;

    static constexpr std::size_t frame_size =
        13 + 2 * (words::outputs > 2 ? words::outputs : std::size_t{2});

    cyclic_control control_{};
    cyclic_options options_;
    duration period_;
    instant now_{0};
    instant due_{0};
    instant climb_end_{0};
    std::array<std::byte, frame_size> frame_{};
    std::array<std::uint16_t, words::outputs> outputs_{};
    std::array<std::uint16_t, words::inputs> inputs_{};
    register_block<words::outputs> output_block_{};
    unit_id unit_;
    step step_{step::look};
    std::uint32_t slots_in_use_{0};
    std::uint8_t misses_{0};
    std::uint8_t exchanges_{0}; ///< since the control word or the reference was read back
    bool is_lost_{true};
    bool is_checked_{false};         ///< the scanner holds the words that it has to
    bool is_control_checked_{false}; ///< the control word before the command to run is the one written last
    bool has_written_{false};        ///< the words in `outputs_`, as far as the drive said so
    bool was_taken_{false};          ///< the words in `outputs_`: the drive answered the write
    bool stops_first_{false};        ///< a stop was ordered, and nothing asked since
    bool compares_reference_{false};
    bool has_begun_{false};
    bool is_due_{false};
};

} // namespace rtuwire::altivar
