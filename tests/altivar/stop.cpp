// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// What stop asks and tells a drive, word by word, as the drive's status has it.
#include <rtuwire/altivar/stop.hpp>

#include "support/proof.hpp"

using namespace rtuwire;
using namespace rtuwire::altivar;
using kind = event::kind;

namespace {

constexpr std::uint16_t cmd = 8501, eta = 3201, lft = 7121, rfr = 3202;
constexpr drive_profile some_drive{
    .cmd = cmd, .eta = eta, .lft = lft, .cmi = 8504, .eti = 3206, .rfr = rfr};

// Status words under remote control.
constexpr std::uint16_t switched_on = 0x0233, enabled = 0x0237, quick_stop_active = 0x0217;

constexpr bool reads(wish const& what, std::uint16_t address)
{
    return what.what == wish::kind::read and what.address == address;
}
constexpr bool writes(wish const& what, std::uint16_t address, std::uint16_t word)
{
    return what.what == wish::kind::write and what.address == address and what.word == word;
}
constexpr bool ends(wish const& what) { return what.what == wish::kind::end; }
constexpr event word(std::uint16_t read) { return {kind::word_read, read}; }

constexpr bool takes_power_from_a_quick_stop()
{
    for (stop_by const mode : {stop_by::halt, stop_by::ramp, stop_by::quick_stop}) {
        stop_script it{some_drive, mode};
        bool ok = reads(it.step({kind::begun}), eta);
        ok = ok and reads(it.step(word(quick_stop_active)), rfr);
        ok = ok and it.step(word(120)).what == wish::kind::pause;
        ok = ok and reads(it.step({kind::pause_over}), eta);
        ok = ok and reads(it.step(word(quick_stop_active)), rfr);
        if (not ok or not writes(it.step(word(0)), cmd, 0)) {
            return false;
        }
    }
    return true;
}
PROOF("a motor that a quick stop brought to rest loses its power, whatever was asked for",
      takes_power_from_a_quick_stop)

constexpr bool halts_under_power()
{
    stop_script it{some_drive, stop_by::halt};
    bool ok = reads(it.step({kind::begun}), eta) and reads(it.step(word(enabled)), cmd);
    ok = ok and writes(it.step(word(0x080F)), cmd, 0x090F);
    ok = ok and it.step({kind::written}).length == milliseconds(50);
    ok = ok and reads(it.step({kind::pause_over}), eta) and reads(it.step(word(enabled)), rfr);
    return ok and ends(it.step(word(0))) and it.reason().how == ending::succeeded and
           it.reason().state == cia402::state::operation_enabled;
}
PROOF("halt keeps the power, and ends when the motor stands", halts_under_power)

constexpr bool goes_below_switched_on()
{
    stop_script ramp{some_drive, stop_by::ramp};
    static_cast<void>(ramp.step({kind::begun}));
    bool const is_shut_down = writes(ramp.step(word(switched_on)), cmd, 0x0006);
    stop_script halt{some_drive, stop_by::halt};
    static_cast<void>(halt.step({kind::begun}));
    return is_shut_down and ends(halt.step(word(switched_on))) and
           halt.reason().how == ending::succeeded;
}
PROOF("a stop that is no halt leaves \"switched on\", too", goes_below_switched_on)

} // namespace
