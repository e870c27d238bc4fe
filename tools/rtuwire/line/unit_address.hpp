// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Who is asked: a unit; or what answers at address 0, which is only read, and where anything else would be a broadcast.
#pragma once

#include <cstdint>
#include <optional>

#include <rtuwire/client.hpp>

#include "exit_status.hpp"

namespace tool {

class unit_address {
public:
    unit_address(rtuwire::unit_id unit) : unit_{unit} {}

    /// Address 0, of the only unit of its line.
    static unit_address zero() { return unit_address{}; }

    bool is_zero() const { return not unit_; }
    std::uint8_t byte() const { return unit_ ? unit_->byte() : std::uint8_t{0}; }

    /// For what does more than read: it asks no unit at address 0.
    operator rtuwire::unit_id() const
    {
        if (not unit_) {
            refuse_word("at address 0 a unit is only read");
        }
        return *unit_;
    }

    friend bool operator==(unit_address const&, unit_address const&) = default;

private:
    unit_address() = default;

    std::optional<rtuwire::unit_id> unit_{};
};

} // namespace tool
