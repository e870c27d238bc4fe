// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// What stop asks and tells a drive, word by word, as the drive's status has it.
#include <rtuwire/altivar/procedure/motion/stop.hpp>

#include <utility>

#include "support/proof.hpp"

using namespace rtuwire;
using namespace rtuwire::altivar;
using kind = event::kind;

namespace {

constexpr std::uint16_t cmd = 8501, eta = 3201, lft = 7121, rfr = 3202;
constexpr drive_layout some_drive{.cmd = cmd, .eta = eta, .lft = lft, .cmi = 8504, .eti = 3206, .rfr = rfr};

// Status words under remote control.
constexpr std::uint16_t switched_on = 0x0233, enabled = 0x0237, quick_stop_active = 0x0217;

constexpr bool reads(action const& what, std::uint16_t address)
{
    return what.what == action::kind::read and what.address == address;
}
constexpr bool writes(action const& what, std::uint16_t address, std::uint16_t word)
{
    return what.what == action::kind::write and what.address == address and what.word == word;
}
constexpr bool ends(action const& what) { return what.what == action::kind::end; }
constexpr event word(std::uint16_t read) { return {kind::word_read, read}; }

constexpr auto known = word_meaning::cia402;

constexpr bool says_its_word_first()
{
    bool ok = true;
    for (auto const& [mode, first] : {std::pair{stop_by::ramp, 0x0007}, std::pair{stop_by::quick_stop, 0x0002},
                                      std::pair{stop_by::freewheel, 0x0000}}) {
        stop_procedure it{some_drive, mode, known};
        auto const expected = static_cast<std::uint16_t>(first);
        ok = ok and writes(it.step({kind::begun}), cmd, expected);
        ok = ok and it.step({kind::failed, 0, errc::timed_out}).what == action::kind::pause;
        ok = ok and writes(it.step({kind::pause_over}), cmd, expected);
        ok = ok and it.step({kind::failed, 0, errc::server_device_busy}).what == action::kind::pause;
        ok = ok and writes(it.step({kind::pause_over}), cmd, expected);
        ok = ok and reads(it.step({kind::written}), eta);
        ok = ok and reads(it.step(word(enabled)), rfr);
        ok = ok and it.step(word(300)).what == action::kind::pause;
        ok = ok and writes(it.step({kind::pause_over}), cmd, expected); // again at each look
    }
    return ok;
}
PROOF("a stop says its word first, and again, whatever fails", says_its_word_first)

constexpr bool takes_power_from_a_quick_stop()
{
    for (stop_by const mode : {stop_by::ramp, stop_by::quick_stop}) {
        stop_procedure it{some_drive, mode, known};
        static_cast<void>(it.step({kind::begun}));
        bool ok = reads(it.step({kind::written}), eta);
        ok = ok and reads(it.step(word(quick_stop_active)), rfr);
        ok = ok and it.step(word(120)).what == action::kind::pause;
        ok = ok and writes(it.step({kind::pause_over}), cmd, 0x0002); // the quick stop is not made a ramp
        ok = ok and reads(it.step({kind::written}), eta);
        ok = ok and reads(it.step(word(quick_stop_active)), rfr);
        ok = ok and it.step(word(0)).what == action::kind::pause; // once is not enough
        ok = ok and writes(it.step({kind::pause_over}), cmd, 0x0002);
        ok = ok and reads(it.step({kind::written}), eta);
        ok = ok and reads(it.step(word(quick_stop_active)), rfr);
        if (not ok or not writes(it.step(word(0)), cmd, 0)) {
            return false;
        }
    }
    return true;
}
PROOF("a motor that a quick stop brought to rest loses its power once it was seen to stand twice",
      takes_power_from_a_quick_stop)

constexpr bool halts_under_power()
{
    stop_procedure it{some_drive, stop_by::halt, known};
    bool ok = reads(it.step({kind::begun}), eta) and reads(it.step(word(enabled)), rfr);
    ok = ok and reads(it.step(word(300)), cmd);
    ok = ok and writes(it.step(word(0x080F)), cmd, 0x090F);
    ok = ok and reads(it.step({kind::written}), eta) and reads(it.step(word(enabled)), rfr);
    ok = ok and writes(it.step(word(300)), cmd, 0x090F); // not slower yet: once more, behind this look
    ok = ok and reads(it.step({kind::written}), eta) and reads(it.step(word(enabled)), rfr);
    ok = ok and it.step(word(0)).what == action::kind::pause;
    ok = ok and reads(it.step({kind::pause_over}), eta) and reads(it.step(word(enabled)), rfr);
    return ok and ends(it.step(word(0))) and it.reason().kind == outcome_kind::succeeded and
           it.reason().state == cia402::state::operation_enabled and not it.reason().is_other_stop;
}
PROOF("halt keeps the power, and ends when the motor was seen to stand twice", halts_under_power)

constexpr bool halts_no_drive_that_is_ready()
{
    stop_procedure it{some_drive, stop_by::halt, known};
    static_cast<void>(it.step({kind::begun}));
    static_cast<void>(it.step(word(enabled)));
    static_cast<void>(it.step(word(300)));
    bool ok = writes(it.step(word(0x000F)), cmd, 0x010F);
    ok = ok and it.step({kind::failed, 0, errc::server_device_busy}).what == action::kind::pause;
    // Meanwhile somebody shut the drive down: the word with bit 3 would enable it.
    ok = ok and reads(it.step({kind::pause_over}), eta);
    return ok and writes(it.step(word(0x0231)), cmd, 0x0000);
}
PROOF("a halt is not given again to a drive that has become ready", halts_no_drive_that_is_ready)

constexpr bool halts_no_drive_that_is_silent()
{
    stop_procedure it{some_drive, stop_by::halt, known};
    static_cast<void>(it.step({kind::begun}));
    static_cast<void>(it.step(word(enabled)));
    static_cast<void>(it.step(word(300)));
    bool const is_told = writes(it.step(word(0x000F)), cmd, 0x010F);
    return is_told and writes(it.step({kind::failed, 0, errc::timed_out}), cmd, 0x0007);
}
PROOF("a halt that is not answered becomes the ramp, which needs no look", halts_no_drive_that_is_silent)

constexpr bool goes_below_switched_on()
{
    bool ok = true;
    for (stop_by const mode : {stop_by::ramp, stop_by::halt}) {
        stop_procedure it{some_drive, mode, known};
        static_cast<void>(it.step({kind::begun}));
        if (mode == stop_by::ramp) {
            static_cast<void>(it.step({kind::written}));
        }
        ok = ok and writes(it.step(word(switched_on)), cmd, 0x0000);
        ok = ok and reads(it.step({kind::written}), eta);
        ok = ok and ends(it.step(word(0x0250))) and it.reason().kind == outcome_kind::succeeded;
    }
    return ok;
}
PROOF("every stop leaves \"switched on\", from where one word could start the motor", goes_below_switched_on)

constexpr bool is_blind_in_doubt()
{
    drive_layout with_io = some_drive;
    with_io.chcf = 8401;
    stop_procedure doubtful{with_io, stop_by::ramp, word_meaning::unknown};
    stop_procedure certain{with_io, stop_by::ramp, known};
    bool const is_zero = writes(doubtful.step({kind::begun}), cmd, 0x0000);
    return is_zero and doubtful.reason().is_other_stop and writes(certain.step({kind::begun}), cmd, 0x0007) and
           not certain.reason().is_other_stop;
}
PROOF("a drive that may have an I/O profile is told 0000, and the reason says so", is_blind_in_doubt)

constexpr bool is_blind_in_doubt_for_a_halt()
{
    drive_layout with_io = some_drive;
    with_io.chcf = 8401;
    stop_procedure doubtful{with_io, stop_by::halt, word_meaning::unknown};
    stop_procedure certain{with_io, stop_by::halt, known};
    bool ok = writes(doubtful.step({kind::begun}), cmd, 0x0000) and doubtful.reason().is_other_stop;
    ok = ok and reads(doubtful.step({kind::written}), eta) and reads(doubtful.step(word(enabled)), rfr);
    ok = ok and doubtful.step(word(300)).what == action::kind::pause;
    ok = ok and writes(doubtful.step({kind::pause_over}), cmd, 0x0000); // never with a bit that may be RUN
    return ok and reads(certain.step({kind::begun}), eta) and not certain.reason().is_other_stop;
}
PROOF("a halt of such a drive is 0000 at each look, too", is_blind_in_doubt_for_a_halt)

} // namespace
