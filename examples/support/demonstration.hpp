// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A drive is brought up, run, disturbed and stopped, and all of it is watched. The controller is a
// `cyclic` for the motor and a `poller` for the panel, on one bus.
#pragma once

#include <array>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <string>
#include <vector>

#include <rtuwire/altivar/cyclic.hpp>
#include <rtuwire/altivar/identify.hpp>
#include <rtuwire/client/blocking.hpp>
#include <rtuwire/client/bus.hpp>
#include <rtuwire/client/poller.hpp>
#include <rtuwire/client/statistics.hpp>
#include <rtuwire/port/posix_serial.hpp>
#include <rtuwire/wire/errc_name.hpp>

#include "drive_panel.hpp"
#include "emergency_stop.hpp"
#include "plot.hpp"

namespace examples {

using rtuwire::milliseconds;
using rtuwire::cia402::state;

/// How often somebody pressed Ctrl-C.
inline volatile std::sig_atomic_t interruptions = 0;

inline std::string words(rtuwire::text characters)
{
    return {characters.begin(), characters.end()};
}

template <rtuwire::device_type Device> class demonstration {
    using panel = panel_of<Device>;
    using plan = typename panel::template plan<Device>;
    static constexpr bool has_scanner = Device::profile.scanner_words > 0;
    static constexpr rtuwire::client_options patience{.response_timeout = milliseconds(300)};

public:
    demonstration(demonstration const&) = delete;
    demonstration& operator=(demonstration const&) = delete;
    ~demonstration() { emergency = {}; }

    demonstration(rtuwire::posix_serial& port, rtuwire::line_timing const& timing,
                  rtuwire::station<Device> const& drive, rtuwire::duration drive_timeout)
        : port_{port}, drive_{drive}, link_{timing, patience, {.silent_share = 50}},
          loop_{drive, {.drive_timeout = drive_timeout}}, panel_{drive}, begin_{port.now()}
    {}

    // What it does, step by step. Each tells whether it went as it should.

    bool identify()
    {
        rtuwire::altivar::identify<Device> who{drive_};
        if (not run(who)) {
            return false;
        }
        if constexpr (requires { who.outcome()->vendor; }) {
            auto const shown = [](rtuwire::byte_view octets) {
                return std::string{reinterpret_cast<char const*>(octets.data()), octets.size()};
            };
            auto const& found = *who.outcome();
            std::printf("   %s, %s, revision %s\n", shown(found.vendor).c_str(),
                        shown(found.product).c_str(), shown(found.revision).c_str());
        } else {
            std::printf("   no function 43; nominal drive current %.1f A\n",
                        number(who.latest().template get<atv28::inv>()));
        }
        return true;
    }

    bool shorten_times()
    {
        return set_short_times(drive_, [this](auto talk) { return this->run(talk); });
    }

    /// One round of the monitor plan, in its units.
    bool read_panel()
    {
        panel_.begin();
        if (not run(panel_)) {
            return false;
        }
        auto const& now = panel_.latest();
        std::printf(
            "   ETA %04X (%s), RFR %.1f Hz, FRH %.1f Hz, LCR %.1f A, ULN %.0f V, THR %.0f %%, "
            "LFT %s; %zu registers in %zu requests\n",
            status(), words(name_of(seen_state())).c_str(), number(now.template get<panel::rfr>()),
            number(now.template get<panel::frh>()), number(now.template get<panel::lcr>()),
            number(now.template get<panel::uln>()), number(now.template get<panel::thr>()),
            fault().c_str(), std::size_t{7}, std::size_t{plan::request_count});
        return true;
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
        emergency.arm(port_, drive_);
        return until(
            "first exchange", [this] { return not loop_.link_lost(); }, milliseconds(5'000));
    }

    bool start(rtuwire::altivar::heading way)
    {
        bool const is_able = until(
            "drive ready for an order", [this] { return loop_.control().is_able(); },
            milliseconds(5'000));
        bool const was_running = loop_.control().is_running();
        mark();
        if (not is_able or not order(way)) {
            return false;
        }
        way_ = way;
        return until(
                   "operation enabled", [this] { return loop_.control().is_running(); },
                   milliseconds(5'000)) and
               (was_running or has_passed({state::ready_to_switch_on, state::switched_on,
                                           state::operation_enabled}));
    }

    bool reach_reference()
    {
        bool const is_reverse = way_ == rtuwire::altivar::heading::reverse;
        return until(
            "reference reached",
            [&] {
                std::uint32_t const word = status();
                bool const is_reached = (word & rtuwire::altivar::reference_reached_bit) != 0;
                bool const is_back = (word & rtuwire::altivar::runs_backwards_bit) != 0;
                return is_reached and is_back == is_reverse and output() != 0;
            },
            milliseconds(60'000));
    }

    /// Something is done to the drive, and it trips.
    bool see_fault()
    {
        return until(
                   "fault", [this] { return loop_.control().state() == state::fault; },
                   milliseconds(5'000)) and
               has_lost_order() and read_panel();
    }

    bool reset()
    {
        mark();
        loop_.reset_fault();
        return until(
                   "fault cleared",
                   [this] { return loop_.control().state() == state::switch_on_disabled; },
                   milliseconds(5'000)) and
               has_passed({state::switch_on_disabled});
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
                   "link regained", [this] { return not loop_.link_lost(); },
                   milliseconds(10'000)) and
               until(
                   "panel", [this] { return panel_.outcome().has_value(); },
                   milliseconds(5'000)) and
               has_lost_order();
    }

    bool stop()
    {
        is_stopping_ = true;
        loop_.stop();
        return until(
            "motor at rest",
            [this] {
                state const at = loop_.control().state();
                bool const has_power = rtuwire::cia402::has_power(at);
                return not loop_.link_lost() and at != state::unknown and
                       at != state::switched_on and not has_power and output() == 0;
            },
            milliseconds(60'000));
    }

    /// How often the line made the client ask once more, and how often in vain.
    void print_counts() const
    {
        using rtuwire::line_event;
        rtuwire::counters const& line = link_.statistics().line();
        std::printf("%u requests, %u of them repeated; %u time-outs, %u damaged frames\n",
                    unsigned{line[line_event::request]}, unsigned{line[line_event::repetition]},
                    unsigned{line[line_event::timeout]}, unsigned{line[line_event::crc]});
    }

    /// Tells, and marks where the states of the next step begin.
    void step(char const* what)
    {
        std::printf("\n%d  %s\n", ++steps_, what);
        mark();
    }

    history const& seen() const { return history_; }

private:
    // One pass, and what is shown of it.

    template <typename Talk> bool pass(Talk& talk)
    {
        rtuwire::instant const now = port_.now();
        link_.advance(now);
        if (is_commanding_) {
            link_.converse(0, loop_, now);
        }
        link_.converse(1, talk, now);
        auto const passed = pump(link_, port_, input_, now + milliseconds(10));
        if (not passed) {
            std::printf("   %s\n", port_.failure().c_str());
        }
        note_state();
        return passed.has_value();
    }

    /// Runs a conversation beside the cycle; whether it succeeded.
    template <typename Talk> bool run(Talk& talk)
    {
        while (not talk.settled()) {
            if (not pass(talk)) {
                return false;
            }
        }
        if (not talk.outcome()) {
            std::printf("   %s\n", std::string{name(talk.outcome().error())}.c_str());
        }
        return talk.outcome().has_value();
    }

    /// Lives on until something is so; false, and says so, when it is not so in time.
    template <typename Condition>
    bool until(char const* what, Condition is_so, rtuwire::duration limit)
    {
        rtuwire::instant const end = port_.now() + limit;
        while (true) {
            if (interruptions > (is_stopping_ ? 1 : 0)) {
                std::puts("   interrupted");
                return false;
            }
            if (panel_.settled()) {
                look();
                panel_.begin();
            }
            if (not pass(panel_)) {
                return false;
            }
            if (is_so()) {
                return true;
            }
            if (reached(port_.now(), end)) {
                std::printf("   NOT within %u ms: %s\n", limit.microseconds / 1'000U, what);
                return false;
            }
        }
    }

    bool order(rtuwire::altivar::heading way)
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
        std::printf("   the order to run is %s: %s\n", is_lost ? "dropped" : "STILL THERE",
                    words(name_of(reason.how)).c_str());
        return is_lost;
    }

    // What was seen.

    double time() const { return double((port_.now() - begin_).microseconds) / 1e6; }
    double output() const
    {
        double const value = number(panel_.latest().template get<panel::rfr>());
        bool const is_back = (status() & rtuwire::altivar::runs_backwards_bit) != 0;
        return is_back and value > 0 ? -value : value;
    }
    std::uint16_t status() const { return panel_.latest().template get<panel::eta>().bits; }
    state seen_state() const { return rtuwire::cia402::decode(status()); }
    std::string fault() const
    {
        return words(rtuwire::name_of(panel_.latest().template get<panel::lft>()));
    }

    /// Takes a sample, and shows it twice a second.
    void look()
    {
        bool const is_known = panel_.outcome().has_value();
        auto const& now = panel_.latest();
        double const frh = number(now.template get<panel::frh>());
        bool const is_back = way_ == rtuwire::altivar::heading::reverse and frh > 0;
        history_.push_back({time(), is_back ? -frh : frh, output(),
                            number(now.template get<panel::lcr>()), seen_state(), is_known});
        if (time() >= next_row_) {
            next_row_ = time() + 0.5;
            show(history_.back());
        }
    }

    void show(sample const& at)
    {
        if (rows_++ == 0) {
            std::puts("     time   state                   reference     output    current");
        }
        if (at.is_known) {
            std::printf("  %6.2f s  %-22s  %6.1f Hz  %6.1f Hz  %6.1f A\n", at.time,
                        words(name_of(at.state)).c_str(), at.reference, at.output, at.current);
        } else {
            std::printf("  %6.2f s  no answer\n", at.time);
        }
        std::fflush(stdout);
    }

    void note_state()
    {
        if (is_commanding_ and not loop_.link_lost() and loop_.control().state() != last_state_) {
            last_state_ = loop_.control().state();
            states_.push_back(last_state_);
            std::printf("  %6.2f s  -> %s\n", time(), words(name_of(last_state_)).c_str());
        }
    }

    void mark() { states_.clear(); }

    /// Whether the states since the mark were just these.
    bool has_passed(std::vector<state> const& expected) const
    {
        bool const is_right = states_ == expected or
                              // A drive may begin higher up.
                              (states_.size() < expected.size() and not states_.empty() and
                               std::equal(states_.rbegin(), states_.rend(), expected.rbegin()));
        if (not is_right) {
            std::puts("   NOT the states that the manual tells");
        }
        return is_right;
    }

    rtuwire::posix_serial& port_;
    rtuwire::station<Device> drive_;
    rtuwire::bus<2, rtuwire::line_statistics> link_;
    rtuwire::altivar::cyclic<Device> loop_;
    rtuwire::poller<plan> panel_;
    rtuwire::instant begin_;
    std::array<std::byte, rtuwire::max_adu_size> input_{};
    history history_{};
    std::vector<state> states_{};
    state last_state_{state::unknown};
    rtuwire::altivar::heading way_{rtuwire::altivar::heading::forward};
    double next_row_{0};
    int rows_{0};
    int steps_{0};
    bool is_commanding_{false};
    bool is_stopping_{false};
};

} // namespace examples
