// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A motor of one type of drive. Included by one file, which makes those of all.
#pragma once

#include <array>
#include <chrono>
#include <memory>
#include <optional>

#include <rtuwire/client.hpp>
#include <rtuwire/drives.hpp>

#include "motion/motor.hpp"

namespace tool {

/// The same drive, commanded by a frequency: command and LFR stand side by side in each, and are written by function
/// 16; status and output frequency are read by function 03. It needs no scanner.
template <typename Device> struct by_frequency : Device {
    static constexpr rtuwire::altivar::scanner_registers scanner{};
    static constexpr rtuwire::altivar::cycle_registers cycle{
        .by = rtuwire::function_code::write_multiple_registers,
        .reads = {Device::layout.eta, Device::layout.rfr},
        .writes = {Device::layout.cmd, Device::frequency_reference.address},
        .speed = Device::layout.rfr};
    static_assert(Device::layout.rfr == Device::layout.eta + 1);
    static_assert(Device::frequency_reference.address == Device::layout.cmd + 1);
};

template <rtuwire::device_type Device> class motor_of final : public motor {
    /// What the drive's cycle writes: a speed, or a frequency.
    static constexpr auto const& written = []() -> auto const&
    {
        if constexpr (Device::cycle.writes.has(Device::speed_reference.address)) {
            return Device::speed_reference;
        } else {
            return Device::frequency_reference;
        }
    }
    ();
    using setting = rtuwire::setting<written>;
    using clock = std::chrono::steady_clock;
    static constexpr unsigned shown_words = 3; ///< RFR, another, LCR
    static constexpr std::chrono::milliseconds shown_every{200};

public:
    motor_of(motor_line const& line, rtuwire::unit_id unit, asked_motion const& asked)
        : port_{line.port}, bus_{line.port.timing(), line.options, {.silent_share = 50}},
          cycle_{station_of(unit), {.supervision = {.longest_gap = longest_gap(line)}}},
          reference_{setting::checked(typename setting::value_type{asked.count})},
          direction_{direction_of(asked)}, unit_{unit}, owed_{line.exchange.owed()}, shown_at_{clock::now()}
    {
        bus_.trace_to(line.exchange);
    }

    rtuwire::result<void> pass() override
    {
        rtuwire::instant const now = port_.now();
        bus_.advance(now);
        bus_.converse(0, cycle_, now);
        if (not shown_ and cycle_.supervision().finding == rtuwire::altivar::outcome_kind::succeeded and
            clock::now() >= shown_at_) {
            bool const is_in_fault = cycle_.control().state() == rtuwire::cia402::state::fault;
            asked_ = sight_.is_old ? look::state : is_in_fault and sight_.fault == 0 ? look::fault : look::output;
            shown_.emplace(owed_, rtuwire::single_request{unit_, request_of(asked_)});
        }
        if (shown_) {
            bus_.converse(1, *shown_, now);
            take_shown();
        }
        return finish_pass(bus_, port_, input_, now + rtuwire::milliseconds(10));
    }

    bool run() override
    {
        sight_.has_output = false;
        return reference_ and cycle_.run(*reference_, direction_);
    }

    bool change(asked_motion const& asked) override
    {
        auto const reference = setting::checked(typename setting::value_type{asked.count});
        return reference and cycle_.run(*reference, direction_of(asked));
    }

    void stop(rtuwire::altivar::stop_by how) override
    {
        look_again();
        cycle_.stop(how);
    }

    void note_pause() override
    {
        look_again();
        sight_.is_old = true;
    }

    motor_sight sight() const override
    {
        auto const& control = cycle_.control();
        motor_sight seen = sight_;
        seen.state = control.state();
        seen.is_linked = not cycle_.link_lost();
        seen.is_able = control.is_able();
        seen.is_ordered = control.is_ordered();
        seen.is_limited = (control.status() & rtuwire::altivar::reference_limited_bit) != 0;
        seen.is_backwards = seen.is_backwards or turns_back();
        return seen;
    }

    rtuwire::altivar::reason reason() const override { return cycle_.control().reason(); }
    rtuwire::altivar::supervision_report const& supervision() const override { return cycle_.supervision(); }

private:
    enum class look { output, fault, state };

    static constexpr rtuwire::read_holding_registers request_of(look what) noexcept
    {
        switch (what) {
        case look::fault: return {.start = Device::layout.lft, .count = 1};
        case look::state: return {.start = Device::layout.eta, .count = 1};
        case look::output: break;
        }
        return {.start = Device::layout.rfr, .count = shown_words};
    }

    static rtuwire::altivar::run_direction direction_of(asked_motion const& asked)
    {
        return asked.is_reverse ? rtuwire::altivar::run_direction::reverse : rtuwire::altivar::run_direction::forward;
    }

    static rtuwire::station<Device> station_of(rtuwire::unit_id unit)
    {
        auto const found = rtuwire::station<Device>::checked(unit.byte());
        if (not found) {
            refuse_word("unit " + std::to_string(unit.byte()) + " is no address of this drive: it has one from " +
                        std::to_string(Device::units.first) + " to " + std::to_string(Device::units.last));
        }
        return *found;
    }

    /// An exchange and a read that got no answer, the silence before each, and the period.
    static rtuwire::duration longest_gap(motor_line const& line)
    {
        rtuwire::duration const each = line.options.response_timeout + line.port.timing().silence();
        return each * (1U + line.options.retries) + rtuwire::milliseconds(30);
    }

    bool turns_back() const noexcept { return (cycle_.control().status() & rtuwire::altivar::runs_backwards_bit) != 0; }

    void look_again() noexcept
    {
        sight_.has_output = false;
        is_old_ = shown_.has_value();
    }

    void take_shown()
    {
        if (not shown_->settled()) {
            return;
        }
        auto const outcome = shown_->outcome();
        auto const read = outcome ? outcome->template to<rtuwire::read_holding_registers>() : outcome.error();
        if (read and asked_ == look::fault) {
            sight_.fault = read->registers[0];
        } else if (read and asked_ == look::state) { // the cycle may know an older one yet
            sight_.is_old = is_old_ or rtuwire::cia402::decode(read->registers[0]) != cycle_.control().state();
        } else if (read and not is_old_) {
            sight_.output = static_cast<std::int16_t>(read->registers[0]);
            sight_.current = read->registers[shown_words - 1];
            sight_.has_output = true;
            sight_.is_backwards = turns_back(); // at the end of a ramp the next status says that it stands
        }
        is_old_ = false;
        shown_.reset();
        shown_at_ = asked_ == look::output ? clock::now() + shown_every : clock::now();
    }

    any_port& port_;
    rtuwire::bus<2>::traced_by<exchange_log> bus_;
    rtuwire::altivar::cyclic<Device> cycle_;
    rtuwire::result<setting> reference_;
    rtuwire::altivar::run_direction direction_;
    rtuwire::unit_id unit_;
    owed_answers& owed_;
    std::optional<in_step<rtuwire::single_request<rtuwire::read_holding_registers>>> shown_{};
    clock::time_point shown_at_; ///< counts 64 bits: a link may be lost for an hour
    motor_sight sight_{};
    std::array<std::byte, rtuwire::max_adu_size> input_{};
    look asked_{look::output};
    bool is_old_{false}; ///< what is on its way was asked before the stop
};

/// By a speed over the drive's scanner, or by a frequency without it.
template <rtuwire::device_type Device>
std::unique_ptr<motor> make_motor(motor_line const& line, rtuwire::unit_id unit, asked_motion const& asked)
{
    if constexpr (Device::cycle.writes.has(Device::speed_reference.address)) {
        if (not asked.is_speed) {
            return std::make_unique<motor_of<by_frequency<Device>>>(line, unit, asked);
        }
    }
    return std::make_unique<motor_of<Device>>(line, unit, asked); // a cycle of frequencies has them in each case
}

} // namespace tool
