// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Settings that are written into a drive, whichever it is. Behind it is a conversation of the library for one type of
// drive, all of them in one file.
#pragma once

#include <functional>
#include <optional>
#include <string_view>

#include <rtuwire/client.hpp>
#include <rtuwire/drives.hpp>
#include <rtuwire/maintenance.hpp>

#include "backup/saved_settings.hpp"
#include "line/exchange_log.hpp"
#include "port/any_port.hpp"

namespace tool {

/// What becomes of a parameter, each time that something is known of it; the last counts.
using restore_told = std::function<void(register_entry const&, rtuwire::altivar::restore_report const&)>;

/// What a restore needs.
struct restore_work {
    any_port& port;
    rtuwire::client_options line_options;
    exchange_log& exchange;
    rtuwire::unit_id unit;
    drive_catalog const& drive;
    saved_settings const& settings;
    rtuwire::altivar::restore_options options;
    restore_told told;
};

/// How it ended.
struct restored {
    rtuwire::altivar::reason reason{};
    bool was_ended{false}; ///< by a signal: once a parameter was done
    rtuwire::errc port_error{rtuwire::errc::none};
    bool is_saved{false}; ///< to the EEPROM
};

using restore_function = restored (*)(restore_work const& work);

/// The function for a drive's name; null where this program restores no settings of that drive.
restore_function restore_for(std::string_view drive) noexcept;

} // namespace tool
