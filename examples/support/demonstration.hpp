// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A drive is brought up, run, disturbed and stopped, and all of it is watched. The controller is a
// `cyclic` for the motor and a `poller` for the panel, on one bus.
#pragma once

#include <array>
#include <chrono>
#include <string>

#include <rtuwire/client.hpp>
#include <rtuwire/drives.hpp>
#include <rtuwire/port.hpp>

#include "../../tools/support/emergency_stop.hpp"
#include "../../tools/support/reason_to_end.hpp"
#include "logbook.hpp"
#include "panel_reading.hpp"

namespace examples {

using namespace tool;

using rtuwire::milliseconds;
using rtuwire::cia402::state;

template <rtuwire::device_type Device> class demonstration {
    using panel = panel_of<Device>;
    using plan = typename panel::template plan<Device>;
    static constexpr bool has_scanner = Device::scanner.words > 0;
    static constexpr rtuwire::client_options patient{.response_timeout = milliseconds(300)};

public:
    demonstration(demonstration const&) = delete;
    demonstration& operator=(demonstration const&) = delete;
    ~demonstration() { emergency.disarm(); }

    demonstration(rtuwire::posix_serial& port, rtuwire::line_timing const& timing,
                  rtuwire::station<Device> const& drive)
        : port_{port}, drive_{drive}, link_{timing, patient, {.silent_share = 50}}, loop_{drive}, panel_{drive},
          begin_{port.now()}, must_end_{to_chrono(Device::silence.factory) / 3}
    {}

    // What it does, step by step. Each tells whether it went as it should.

    bool identify()
    {
        rtuwire::altivar::identify<Device> who{drive_};
        if (not run(who)) {
            return false;
        }
        if constexpr (requires { who.outcome()->vendor; }) {
            auto const shown = [](rtuwire::byte_view bytes) {
                return std::string{reinterpret_cast<char const*>(bytes.data()), bytes.size()};
            };
            auto const& found = *who.outcome();
            say("   %s, %s, revision %s\n", shown(found.vendor).c_str(), shown(found.product).c_str(),
                shown(found.revision).c_str());
        } else {
            say("   no function 43; nominal drive current %.1f A\n", number(who.latest().template get<atv28::inv>()));
        }
        return true;
    }

    bool shorten_times()
    {
        return set_short_times(drive_, [this](auto conversation) { return this->run(conversation); });
    }

    /// One round of the monitor plan, in its units.
    bool read_panel()
    {
        ask();
        if (not run(panel_)) {
            return false;
        }
        read().tell();
        return true;
    }

    /// Whether the drive was in fault when the panel was read; says in which, and what resets it.
    bool is_in_fault() const
    {
        bool const is_so = rtuwire::cia402::is_in_fault(read().state());
        if (is_so) {
            say("   It is in fault: %s. A program before this one may have left it so; %s\n", read().fault().c_str(),
                what_resets().c_str());
        }
        return is_so;
    }

    /// What becomes of the drive from here on.
    void tell_what_is_left() const
    {
        say("Nobody asks the drive any more: it trips (SLF) at the end of its time-out, unless that is switched off; "
            "%s\n",
            what_resets().c_str());
    }

    bool watch(rtuwire::duration length)
    {
        rtuwire::instant const end = port_.now() + length;
        return until(
            "the time", [&] { return reached(port_.now(), end); }, length + length);
    }

    /// From here on the drive is commanded, first not to run.
    bool take_command()
    {
        is_commanding_ = true;
        emergency.arm(port_, drive_.unit(), Device::layout.cmd);
        if (not until(
                "first exchange", [this] { return not loop_.link_lost(); }, milliseconds(5'000))) {
            auto const& found = loop_.supervision();
            say("   %s (register %u holds %u)\n", words(name_of(found.finding)).c_str(), unsigned{found.address},
                unsigned{found.word});
            return false;
        }
        must_end_ = reason_to_end{to_chrono(loop_.supervision().period.timeout) / 3};
        return true;
    }

    bool start(rtuwire::altivar::run_direction way)
    {
        bool const is_able = until(
            "drive ready for an order", [this] { return loop_.control().is_able(); }, milliseconds(5'000));
        bool const was_running = loop_.control().is_running();
        seen_.mark();
        if (not is_able or not order(way)) {
            return false;
        }
        way_ = way;
        return until(
                   "operation enabled", [this] { return loop_.control().is_running(); }, milliseconds(5'000)) and
               (was_running or
                seen_.has_passed({state::ready_to_switch_on, state::switched_on, state::operation_enabled}));
    }

    bool reach_reference()
    {
        bool const is_reverse = way_ == rtuwire::altivar::run_direction::reverse;
        return until(
            "reference reached",
            [&] {
                auto const now = read();
                return now.has(rtuwire::altivar::reference_reached_bit) and
                       now.has(rtuwire::altivar::runs_backwards_bit) == is_reverse and now.output() != 0;
            },
            milliseconds(60'000));
    }

    /// Something is done to the drive, and it trips.
    bool see_fault()
    {
        return until(
                   "fault", [this] { return loop_.control().state() == state::fault; }, milliseconds(5'000)) and
               has_lost_order() and read_panel();
    }

    bool reset()
    {
        seen_.mark();
        loop_.reset_fault();
        return until(
                   "fault cleared", [this] { return loop_.control().state() == state::switch_on_disabled; },
                   milliseconds(5'000)) and
               seen_.has_passed({state::switch_on_disabled});
    }

    bool lose_link()
    {
        return until(
                   "link lost", [this] { return loop_.link_lost(); }, milliseconds(5'000)) and
               has_lost_order();
    }

    bool regain_link()
    {
        return until(
                   "link regained", [this] { return not loop_.link_lost(); }, milliseconds(10'000)) and
               until(
                   "panel", [this] { return panel_.outcome().has_value(); }, milliseconds(5'000)) and
               has_lost_order();
    }

    bool stop()
    {
        is_stopping_ = true;
        interrupts_before_ = noted.interrupts;
        loop_.stop();
        return until(
            "motor at rest",
            [this] {
                state const at = loop_.control().state();
                bool const has_power = rtuwire::cia402::has_power(at);
                return not loop_.link_lost() and at != state::unknown and at != state::switched_on and not has_power and
                       read().output() == 0;
            },
            milliseconds(60'000));
    }

    /// How often the line made the client ask once more, and how often in vain.
    void print_counts() const
    {
        using rtuwire::line_event;
        rtuwire::counters const& line = link_.statistics().line();
        say("%u requests, %u of them repeated; %u time-outs, %u damaged frames\n", unsigned{line[line_event::request]},
            unsigned{line[line_event::repetition]}, unsigned{line[line_event::timeout]},
            unsigned{line[line_event::crc]});
    }

    /// Tells, and marks where the states of the next step begin.
    void step(char const* what)
    {
        say("\n%d  %s\n", ++steps_, what);
        seen_.mark();
    }

    history const& seen() const { return seen_.samples(); }

private:
    // One pass, and what is shown of it.

    template <typename Conversation> bool pass(Conversation& conversation)
    {
        if (must_end_.look()) {
            say("   %s\n", must_end_.text().c_str());
        }
        if (must_end_ and not is_stopping_) {
            return false;
        }
        rtuwire::instant const now = port_.now();
        link_.advance(now);
        if (is_commanding_) {
            link_.converse(0, loop_, now);
        }
        link_.converse(1, conversation, now);
        auto const passed = finish_pass(link_, port_, input_, now + milliseconds(10));
        if (not passed) {
            say("   %s\n", port_.failure().c_str());
        }
        if (is_commanding_ and not loop_.link_lost()) {
            seen_.note(loop_.control().state(), time());
        }
        return passed.has_value();
    }

    /// Runs a conversation beside the cycle; whether it succeeded.
    template <typename Conversation> bool run(Conversation& conversation)
    {
        while (not conversation.settled()) {
            if (not pass(conversation)) {
                return false;
            }
        }
        if (not conversation.outcome()) {
            say("   %s\n", std::string{name(conversation.outcome().error())}.c_str());
        }
        return conversation.outcome().has_value();
    }

    /// Lives on until something is so; false, and says so, when it is not so in time.
    template <typename Condition> bool until(char const* what, Condition is_so, rtuwire::duration limit)
    {
        rtuwire::instant const end = port_.now() + limit;
        while (true) {
            if (is_stopping_ and noted.interrupts > interrupts_before_) {
                say("   interrupted again: the motor is left without power\n");
                emergency.stop_motor();
                return false;
            }
            if (panel_.settled()) {
                look();
                ask();
            }
            if (not pass(panel_)) {
                return false;
            }
            if (is_so()) {
                return true;
            }
            if (reached(port_.now(), end)) {
                say("   NOT within %u ms: %s\n", limit.microseconds / 1'000U, what);
                return false;
            }
        }
    }

    bool order(rtuwire::altivar::run_direction way)
    {
        using namespace rtuwire;
        if constexpr (has_scanner) {
            return loop_.run(1500_rpm, way); // 50 Hz for a motor of two pole pairs
        } else {
            return loop_.run(50_Hz, way);
        }
    }

    bool has_lost_order()
    {
        bool const is_lost = not loop_.control().is_ordered();
        auto const reason = loop_.control().reason();
        say("   the order to run is %s: %s\n", is_lost ? "dropped" : "STILL THERE",
            words(name_of(reason.kind)).c_str());
        return is_lost;
    }

    std::string what_resets() const
    {
        return "`rtuwire -p " + port_.device() + " -u " + std::to_string(drive_.unit().byte()) +
               " --write reset` resets it";
    }

    // What was seen.

    double time() const { return double((port_.now() - begin_).microseconds) / 1e6; }
    panel_reading<Device> read() const { return panel_reading<Device>{panel_.latest()}; }

    /// Begins the next round of the panel.
    void ask()
    {
        panel_.again();
        asked_at_ = time();
    }

    /// Takes a sample.
    void look()
    {
        auto const now = read();
        bool const is_reverse = way_ == rtuwire::altivar::run_direction::reverse;
        seen_.add(
            {time(), now.reference(is_reverse), now.output(), now.current(), now.state(), panel_.outcome().has_value()},
            asked_at_);
    }

    rtuwire::posix_serial& port_;
    rtuwire::station<Device> drive_;
    rtuwire::bus<2, rtuwire::observed_by<rtuwire::line_statistics>> link_;
    rtuwire::altivar::cyclic<Device> loop_;
    rtuwire::poller<plan> panel_;
    rtuwire::instant begin_;
    std::array<std::byte, rtuwire::max_adu_size> input_{};
    reason_to_end must_end_;
    logbook seen_{};
    rtuwire::altivar::run_direction way_{rtuwire::altivar::run_direction::forward};
    double asked_at_{0};
    int steps_{0};
    std::sig_atomic_t interrupts_before_{0}; ///< the stop
    bool is_commanding_{false};
    bool is_stopping_{false};
};

} // namespace examples
