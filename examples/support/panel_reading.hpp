// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// One round of the panel's plan as people read it: in units, with signs and names.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

#include <rtuwire/drives.hpp>

#include "../../tools/support/say.hpp"
#include "drive_panel.hpp"

namespace examples {

using namespace tool;

/// Borrows the values that were read.
template <rtuwire::device_type Device> class panel_reading {
    using panel = panel_of<Device>;
    using plan = typename panel::template plan<Device>;
    using values = typename plan::snapshot;

public:
    explicit panel_reading(values const& seen) : seen_{seen} {}

    std::uint16_t status() const { return seen_.template get<panel::eta>().bits; }
    rtuwire::cia402::state state() const { return rtuwire::cia402::decode(status()); }
    bool has(std::uint16_t status_bit) const { return (status() & status_bit) != 0; }

    /// In Hz, below zero backwards: some drives tell the direction by the status alone.
    double output() const
    {
        double const value = number(seen_.template get<panel::rfr>());
        return has(rtuwire::altivar::runs_backwards_bit) and value > 0 ? -value : value;
    }

    /// In Hz; whether it is meant backwards, only whoever gave it knows on some drives.
    double reference(bool is_reverse) const
    {
        double const value = number(seen_.template get<panel::frh>());
        return is_reverse and value > 0 ? -value : value;
    }

    /// In A.
    double current() const { return number(seen_.template get<panel::lcr>()); }

    /// "SLF1: Modbus interrupted"; the last one, where the drive is in none.
    std::string fault() const { return shown<panel::lft>(); }

    void tell() const
    {
        say("   ETA %04X (%s), RFR %s, FRH %s, LCR %s, ULN %s, THR %s, LFT %s; %zu registers in %zu requests\n",
            status(), words(state()).c_str(), shown<panel::rfr>().c_str(), shown<panel::frh>().c_str(),
            shown<panel::lcr>().c_str(), shown<panel::uln>().c_str(), shown<panel::thr>().c_str(), fault().c_str(),
            std::size_t{7}, std::size_t{plan::request_count});
    }

private:
    template <auto const& R> std::string shown() const
    {
        return std::string{rtuwire::text_of(seen_.template get<R>())};
    }

    values const& seen_;
};

} // namespace examples
