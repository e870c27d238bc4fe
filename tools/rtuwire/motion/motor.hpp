// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A motor that is kept running, whichever drive it has. Behind it is a cycle of the library for one type of drive, in a
// file of its own: five of them in one file compile for long.
#pragma once

#include <cstdint>
#include <memory>
#include <string_view>

#include <rtuwire/client.hpp>
#include <rtuwire/drives.hpp>

#include "line/exchange_log.hpp"
#include "motion/asked_motion.hpp"
#include "port/any_port.hpp"

namespace tool {

/// What is known of a motor whose power was taken away: its output is 0 Hz at once, while it may turn on.
inline constexpr char const no_power_text[] = "the motor has no power, and coasts if it turned";

/// What was read last. It may be old where `is_linked` is false.
struct motor_sight {
    rtuwire::cia402::state state{rtuwire::cia402::state::unknown};
    bool is_old{false};       ///< the program was paused since, and nothing was read behind that
    bool is_linked{false};    ///< the drive answers, and was found fit to be commanded
    bool is_able{false};      ///< it takes an order
    bool is_ordered{false};   ///< it has one
    bool has_output{false};   ///< `output` and `current` were read since the motor was last told to run or to stop
    std::int16_t output{0};   ///< 0.1 Hz; without its sign on an ATV28
    std::uint16_t current{0}; ///< in steps of LCR
    bool is_backwards{false};
    bool is_limited{false}; ///< it does not take the reference, but its LSP or HSP
    std::uint16_t fault{0}; ///< LFT, once it was read in fault; 0 otherwise
};

class motor {
public:
    motor() = default;
    motor(motor const&) = delete;
    motor& operator=(motor const&) = delete;
    virtual ~motor() = default;

    /// One pass of the line, some 10 ms at most while the port takes what is written. Errors: those of the port.
    virtual rtuwire::result<void> pass() = 0;

    /// Orders it to run at what was asked; false where the drive takes no order now.
    virtual bool run() = 0;

    /// Orders a motor that runs to go on otherwise. False where the drive's limits do not allow it, and then it goes on as
    /// before; `reason` names the limit.
    virtual bool change(asked_motion const& asked) = 0;

    /// Stops it. A freewheel may follow another stop.
    virtual void stop(rtuwire::altivar::stop_by how) = 0;

    /// The program was paused: what was read before tells nothing of now.
    virtual void note_pause() = 0;

    [[nodiscard]] virtual motor_sight sight() const = 0;

    /// Why it has no order any more, or cannot have one.
    [[nodiscard]] virtual rtuwire::altivar::reason reason() const = 0;

    /// The check before the first order.
    [[nodiscard]] virtual rtuwire::altivar::supervision_report const& supervision() const = 0;
};

/// What a motor needs of its line.
struct motor_line {
    any_port& port;
    rtuwire::client_options options;
    exchange_log& exchange; ///< which outlives the motor
};

using motor_maker = std::unique_ptr<motor> (*)(motor_line const& line, rtuwire::unit_id unit,
                                               asked_motion const& asked);

/// The maker for a drive's name; null where there is none.
motor_maker maker_of(std::string_view drive) noexcept;

} // namespace tool
