// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// One simulated drive that gets each request, or answers each, later by a time that stays the same: in their order, none is
// lost. What the drive does is looked at in the drive itself.
#pragma once

#include "support/catch.hpp"
#include "support/simulated_bus.hpp"

#include <array>
#include <cstdint>
#include <deque>
#include <initializer_list>
#include <utility>

#include <rtuwire/altivar/device/drive_type.hpp>
#include <rtuwire/ask/single_request.hpp>

namespace rtuwire::test {

/// How late: on the way there, and on the way back.
struct lateness {
    duration there{};
    duration back{};
};

template <typename Device> class late_line : public simulated_bus<drive_client<4>, Device> {
    using base = simulated_bus<drive_client<4>, Device>;

public:
    static constexpr station<Device> drive{unit_id{3}};
    static constexpr altivar::drive_layout const& layout = Device::layout;

    explicit late_line(client_options const& options) : base{drive_client<4>{bus_timing, options}}
    {
        this->add(unit_id{3});
        this->idle(milliseconds(20));
        this->disturb([this](frame_bytes& frame, bool is_request) {
            requests_ += is_request ? 1U : 0U;
            duration const more = is_request ? late_.there : late_.back;
            if (more != duration{}) {
                waiting_.push_back({frame, is_request, this->now() + more});
                frame.clear();
            }
        });
    }

    void be_late(lateness by) { late_ = by; }
    simulated_drive<Device>& far() { return this->unit(0).drive(); }

    /// What another master does, which nobody hears here.
    void tell(std::uint16_t address, std::uint16_t value)
    {
        std::array<std::byte, 2> words{};
        put_u16(words.data(), value);
        register_view const view{words};
        REQUIRE(far().check_write(address, view) == errc::none);
        far().note_contact();
        REQUIRE(far().write(address, view) == errc::none);
    }
    /// In 0.1 s.
    void set_ramps(std::uint16_t up, std::uint16_t down)
    {
        constexpr std::uint16_t acc = layout.cmd == altivar::later_control_word ? 9001 : 252;
        tell(acc, up);
        tell(acc + 1, down);
    }
    void run_motor(std::uint16_t tenths_of_hertz)
    {
        tell(layout.cmd, 0x0006);
        tell(layout.cmd, 0x0007);
        tell(Device::frequency_reference.address, tenths_of_hertz);
        tell(layout.cmd, 0x000F);
    }

    bool has_power() { return cia402::has_power(far().state_machine().state()); }
    bool turns() { return far().motor().frequency() != 0; }
    unsigned requests() const { return requests_; }

    /// Lets conversations run until the last one has settled, or for so long; whether it has. `look` is called in each pass.
    template <typename Look, typename Last, typename... Others>
    bool run_late(duration most, Look look, Last& last, Others&... others)
    {
        instant const end = this->now() + most;
        while (not last.settled() and not reached(this->now(), end)) {
            pass(end, [&](instant now) {
                (this->link().converse(others, now), ...);
                this->link().converse(last, now);
            });
            look();
        }
        return last.settled();
    }
    template <typename Last> bool run_late(duration most, Last& last)
    {
        return run_late(
            most, [] {}, last);
    }
    /// One that has no end.
    template <typename Endless> void run_until(instant end, Endless& endless)
    {
        while (not reached(this->now(), end)) {
            pass(end, [&](instant now) { this->link().converse(endless, now); });
        }
    }
    void idle_late(duration length)
    {
        instant const end = this->now() + length;
        while (not reached(this->now(), end)) {
            pass(end, [](instant) {});
        }
    }

private:
    struct frame_under_way {
        frame_bytes frame;
        bool is_request;
        instant due;
    };

    template <typename Converse> void pass(instant end, Converse converse)
    {
        constexpr duration longest = milliseconds(20);
        deliver();
        duration most = end - this->now() < longest ? end - this->now() : longest;
        if (not waiting_.empty() and not reached(this->now(), waiting_.front().due)) {
            duration const rest = waiting_.front().due - this->now();
            most = rest < most ? rest : most;
        }
        this->step(converse, most == duration{} ? microseconds(1) : most);
    }

    /// Onto a line that is free.
    void deliver()
    {
        bool const is_busy = is_leaving(this->link().phase_now()) or this->wire().poll_deadline();
        if (is_busy or waiting_.empty() or not reached(this->now(), waiting_.front().due)) {
            return;
        }
        frame_under_way const next = waiting_.front();
        waiting_.pop_front();
        static_cast<void>(this->wire().sim::line::transmit(next.is_request ? 0 : 1, next.frame, this->now()));
    }

    lateness late_{};
    std::deque<frame_under_way> waiting_{};
    unsigned requests_{0};
};

} // namespace rtuwire::test
