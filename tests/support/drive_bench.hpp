// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A simulated drive and its clock, a word at a time, as its bank sees them.
#pragma once

#include "support/catch.hpp"

#include <array>
#include <cstdint>

#include <rtuwire/sim/drive/drive.hpp>

namespace rtuwire::test {

template <typename Device> class drive_bench {
public:
    using device = Device;

    drive_bench() { wait(10); }

    detail::simulated_drive<Device>& drive() { return drive_; }

    /// Time without a request, in one step and the next look.
    void wait(std::uint32_t time_ms)
    {
        now_ = now_ + milliseconds(time_ms);
        drive_.advance(now_);
        drive_.advance(now_);
    }
    void cycle_power() { drive_.power_cycle(now_), wait(10); }

    errc tell(std::uint16_t address, std::uint16_t word)
    {
        register_block const value{word};
        errc const wrong = drive_.check_write(address, value);
        return wrong == errc::none ? drive_.write(address, value) : wrong;
    }
    errc command(std::uint16_t word) { return tell(Device::layout.cmd, word); }
    errc refer(std::int16_t tenths)
    {
        return tell(Device::frequency_reference.address, static_cast<std::uint16_t>(tenths));
    }

    std::uint16_t word(literal code) const { return drive_.word(code); }
    std::int16_t number(literal code) const { return static_cast<std::int16_t>(drive_.word(code)); }
    std::uint16_t eta() const { return word("ETA"); }
    cia402::state state() const { return cia402::decode(eta()); }
    std::int32_t frequency() const { return drive_.motor().frequency(); }

    /// In operation at a reference in 0.1 Hz, and there.
    void run(std::int16_t tenths)
    {
        REQUIRE(refer(tenths) == errc::none);
        for (std::uint16_t const word : std::array<std::uint16_t, 3>{0x0006, 0x0007, 0x000F}) {
            REQUIRE(command(word) == errc::none);
        }
        wait(4'000);
    }

private:
    instant now_{0};
    detail::simulated_drive<Device> drive_{now_};
};

} // namespace rtuwire::test
