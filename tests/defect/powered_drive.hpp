// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A client and a drive that loses its power, and with it what was set and not saved.
#pragma once

#include "support/catch.hpp"
#include "support/simulated_bus.hpp"

#include <cstdint>
#include <vector>

#include <rtuwire/altivar/atv320.hpp>
#include <rtuwire/altivar/procedure/commissioning/channel.hpp>
#include <rtuwire/altivar/procedure/inspection/supervision.hpp>
#include <rtuwire/ask/single_request.hpp>

namespace rtuwire::test {

using namespace detail;

inline constexpr unit_id powered_unit{3};
inline constexpr client_options quick{.response_timeout = milliseconds(100), .retries = 0};

/// A client and a drive of which all requests are kept.
template <typename Device> struct powered_drive : simulated_bus<drive_client<4>, Device> {
    static constexpr station<Device> drive_at{powered_unit};

    struct written {
        std::uint8_t function;
        std::uint16_t address;
        std::uint16_t word;
    };
    std::vector<written> requests_of_unit{};
    bool is_off{false};
    int fastest{0};

    explicit powered_drive(client_options const& options = quick)
        : simulated_bus<drive_client<4>, Device>{drive_client<4>{bus_timing, options}}
    {
        this->add(powered_unit);
        this->idle(milliseconds(20));
        this->disturb([this](frame_bytes& frame, bool is_request) {
            if (is_request and frame.size() == 8) {
                requests_of_unit.push_back({to_u8(frame[1]), u16_at(byte_view{frame}, 2), u16_at(byte_view{frame}, 4)});
            }
            if (is_off) {
                frame.clear();
            }
        });
    }

    void set(std::uint16_t address, std::uint16_t word)
    {
        register_block<1> const one{word};
        REQUIRE(this->drive().write(address, one) == errc::none);
    }
    void save()
    {
        set(Device::layout.cmi, 2);
        this->idle(milliseconds(500));
        set(Device::layout.cmi, 0);
    }

    template <typename Conversation> void pass(Conversation& whom, duration length)
    {
        instant const end = this->now() + length;
        while (not reached(this->now(), end)) {
            this->step(
                [&](instant now) {
                    if (not whom.settled()) {
                        this->link().converse(whom, now);
                    }
                },
                milliseconds(5));
            int const now = this->drive().motor().frequency();
            fastest = fastest < now ? now : fastest;
        }
    }
    template <typename Conversation> void finish(Conversation& whom)
    {
        for (int i = 0; i < 4'000 and not whom.settled(); ++i) {
            pass(whom, milliseconds(10));
        }
        REQUIRE(whom.settled());
    }

    /// Reads the status now and then for some time, so that the drive is not silent; none of these requests is kept.
    void poll(duration length, duration every)
    {
        instant const end = this->now() + length;
        while (not reached(this->now(), end)) {
            single_request look{powered_unit, read_holding_registers{Device::layout.eta, 1}};
            REQUIRE(this->run(look));
            this->idle(every);
        }
        requests_of_unit.clear();
    }
};

/// A drive that was saved in its I/O profile, with a reference of 30 Hz at its terminals; this client has taken it over, and
/// has read that. Nothing of that is saved.
struct taken_over : powered_drive<altivar::atv320::device> {
    explicit taken_over(client_options const& options = quick) : powered_drive<altivar::atv320::device>{options}
    {
        set(altivar::atv320::chcf.address, 3);
        set(altivar::atv320::cd1.address, 10);
        set(altivar::atv320::fr1.address, 1);
        save();
        drive().set_analog_reference(30'000);
        altivar::set_channel take{drive_at, altivar::channel_settings<altivar::atv320::device>::by_modbus()};
        finish(take);
        REQUIRE(take.succeeded());
        altivar::check_supervision check{drive_at};
        finish(check);
        REQUIRE(check.ready());
        requests_of_unit.clear();
        fastest = 0;
    }
};

} // namespace rtuwire::test
