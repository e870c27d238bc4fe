// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// The other end of a line for who has none: a drive at address 1 and an energy meter at address 2. Bytes and times come in, as
// they would at an adapter.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include <rtuwire/rtuwire.hpp>

#include "asked_line.hpp"

namespace line_page {

/// A meter whose values move, with the registers of an SDM630: floats, the high register first.
class simulated_meter {
public:
    simulated_meter(rtuwire::line_timing const& timing, rtuwire::instant now);

    void receive(rtuwire::byte_view bytes, rtuwire::instant now) { node_.receive(bytes, now); }
    rtuwire::byte_view pass(microseconds now);

private:
    struct inputs {
        rtuwire::word_bank<82> values{};

        auto& input_registers() noexcept { return values; }
    };

    void set(std::uint16_t address, float value);

    inputs bank_{};
    rtuwire::server::with<rtuwire::function_list<rtuwire::read_input_registers>> node_;
};

class simulated_units {
public:
    simulated_units(line_setting how, microseconds now);
    simulated_units(simulated_units const&) = delete;
    simulated_units& operator=(simulated_units const&) = delete;
    ~simulated_units();

    void receive(rtuwire::byte_view bytes, microseconds now);
    /// The bytes of a response, valid until the next call; empty for none.
    rtuwire::byte_view pass(microseconds now);

private:
    struct drive;

    std::unique_ptr<drive> drive_;
    simulated_meter meter_;
    std::vector<std::byte> output_{};
};

} // namespace line_page
