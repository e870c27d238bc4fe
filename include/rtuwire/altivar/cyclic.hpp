// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// Keeps a drive running: one exchange a period, by function 23 over the scanner where the device moves
// its words so, by functions 03 and 16 elsewhere. After a loss it looks at the status and the last fault
// before it writes anything.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

#include <rtuwire/altivar/configure_scanner.hpp>
#include <rtuwire/altivar/cyclic_control.hpp>
#include <rtuwire/altivar/reference.hpp>
#include <rtuwire/client/conversation.hpp>
#include <rtuwire/core/time.hpp>
#include <rtuwire/core/version.hpp>
#include <rtuwire/table/device.hpp>
#include <rtuwire/wire/pdu/read_holding_registers.hpp>
#include <rtuwire/wire/pdu/read_write_multiple_registers.hpp>
#include <rtuwire/wire/pdu/write_multiple_registers.hpp>

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

/// The words that a device's cycle moves. Scanner slots 1 and 2 hold, as delivered, ETA and RFRD one
/// way and CMD and LFRD the other.
template <device_type Device> struct cycle_words {
    static constexpr bool has_scanner = Device::profile.scanner_words > 0;
    static constexpr bool needs_two = Device::limits.exchange_read < Device::profile.scanner_words;
    static constexpr bool is_long = has_scanner and needs_two and Device::profile.scanner_words > 4;
    static constexpr std::uint16_t inputs = not has_scanner ? 7 : is_long ? 8 : 4;
    static constexpr std::uint16_t outputs = not has_scanner ? 2 : is_long ? 8 : 4;
    /// Without a scanner: CMD and LFR; and the seven words that end with ETA.
    static constexpr std::uint16_t read_from =
        has_scanner ? scanner_input_words
                    : static_cast<std::uint16_t>(Device::profile.eta - inputs + 1);
    static constexpr std::uint16_t write_to =
        has_scanner ? scanner_output_words : Device::profile.cmd;
    static constexpr std::size_t status_at = has_scanner ? 0 : inputs - 1U;
    static constexpr std::size_t speed_at = has_scanner ? 1 : 0;
    static constexpr bool fits_function_23 =
        inputs <= Device::limits.exchange_read and outputs <= Device::limits.exchange_write;

    static constexpr auto const& reference = []() -> auto const&
    {
        if constexpr (has_scanner) {
            return Device::speed_reference;
        } else {
            return Device::frequency_reference;
        }
    }
    ();
};

/// A conversation without an end: give it to a client or a bus in each pass. It needs the scanner's first
/// two slots as delivered, or set so by `configure_scanner`, and no output slots beyond but those that
/// `set_output` names. Before the first exchange, and after each loss, it reads the scanner's addresses;
/// where they are others it writes nothing, and says `misconfigured`.
template <device_type Device> class cyclic : public asker {
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
        }
        return is_taken;
    }

    /// Takes the order back: the motor stops, on its ramp or as said; on the ramp, too, where the device has no halt.
    /// `run` gives it back once the motor stands.
    constexpr void stop(stop_by how = stop_by::ramp) noexcept
    {
        bool const has_none = how == stop_by::halt and Device::profile.halt == 0;
        control_.stop(has_none ? stop_by::ramp : how);
    }

    /// Orders one fault reset.
    constexpr void reset_fault() noexcept { control_.reset_fault(); }

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
    [[nodiscard]] constexpr bool link_lost() const noexcept { return step_ == step::look; }

    [[nodiscard]] constexpr unit_id unit() const noexcept { return unit_; }

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
        return request{byte_view{frame_}.first(make_frame()), repetition::never};
    }

    constexpr void accept(result<response> const& outcome) noexcept
    {
        if (not outcome) {
            return miss(outcome.error());
        }
        misses_ = 0;
        take(*outcome);
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
        read,
        write
    };

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
        return words::fits_function_23 and options_.by_function_23 ? step::exchange : step::read;
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
        case step::read: return encoded(read_holding_registers{words::read_from, words::inputs});
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
        bool const is_tolerated = misses_ < options_.tolerated_misses and not is_exception(error);
        if (is_tolerated) {
            ++misses_;
            return;
        }
        control_.note_loss(error);
        is_checked_ = false;
        step_ = step::look;
    }

    constexpr void wait_a_period() noexcept
    {
        is_due_ = false;
        due_ = now_ + period_;
    }

    constexpr void take(response const& answer) noexcept
    {
        if (step_ == step::write) {
            step_ = first_step();
            return wait_a_period();
        }
        constexpr std::size_t words_from = 2;
        byte_view const pdu = answer.pdu();
        register_view const read{pdu.subspan(words_from)};
        if (step_ == step::look) {
            control_.note_status(read[0], false);
            step_ = step::look_for_fault;
            return;
        }
        if (step_ == step::look_for_fault) {
            control_.note_fault(read[0]);
            step_ = step_after_look();
            return;
        }
        if (step_ == step::check_inputs or step_ == step::check_outputs) {
            return check_scanner(read);
        }
        for (std::size_t i = 0; i < words::inputs; ++i) {
            inputs_[i] = read[i];
        }
        bool const was_in_fault = cia402::is_in_fault(control_.state());
        control_.note_status(inputs_[words::status_at], speed() == 0);
        if (step_ == step::read) {
            step_ = step::write;
        } else {
            wait_a_period();
        }
        if (not was_in_fault and cia402::is_in_fault(control_.state())) {
            step_ = step::look_for_fault;
        }
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
        step_ = not is_right ? step::look : is_input ? step::check_outputs : first_step();
    }

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
    bool is_checked_{false};
    bool has_begun_{false};
    bool is_due_{false};
};

} // namespace rtuwire::altivar
