// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Stops a motor, whoever runs it. Nobody is asked for a permission, nothing is listened to before, and the word that
// stops leaves before anything is read.
//
// Where nobody says which drive it is, the first frame is 0000 at 8501 by function 06, whatever stop was asked for. All
// Altivars but the ATV28 have their control word there, and 0000 takes the power away in each of them: every other word
// that stops would run an ATV320 whose CHCF is IO, and to ask first who it is takes five requests and more, on a line that
// may be failing. The price is that the motor coasts. An ATV28 answers exception 02, and takes its word at 400; no other
// Altivar does, and nobody names a device that is none when a motor has to be stopped. What confirms the stop is the same
// in the four others, so that nothing has to be identified at all.
#include <cstdint>
#include <string>

#include <rtuwire/altivar/all.hpp>
#include <rtuwire/client.hpp>
#include <rtuwire/drives.hpp>

#include "catalog/value_text.hpp"
#include "commands/commands.hpp"
#include "line/line_words.hpp"
#include "line/who_is_it.hpp"
#include "port/named_drives.hpp"

namespace tool {

namespace {

using rtuwire::errc;
using rtuwire::altivar::outcome_kind;
using rtuwire::altivar::stop_by;

constexpr double stop_response = 0.3;     ///< seconds: a word that was lost is sent again soon
constexpr std::uint32_t one_stop = 3'000; ///< ms: longer than the library tries to reach a drive
constexpr int most_stops = 40;            ///< while the motor slows: two minutes
constexpr int most_unobeyed = 10;         ///< while it does not: a long ramp takes its time to be seen

stop_by way_in(std::string const& word)
{
    return word == "freewheel" ? stop_by::freewheel : word == "quick" ? stop_by::quick_stop : stop_by::ramp;
}

struct ending {
    exit_status status;
    std::string sentence;
};

class stop_command {
public:
    stop_command(choices const& chosen, named_unit who)
        : chosen_{chosen}, who_{std::move(who)}, way_{way_in(chosen.motion.stop_by)}, line_{line_to_stop(chosen.line)}
    {}

    exit_status run()
    {
        // A drive without a name says by its answer whether it is an ATV28; all the others are stopped alike.
        std::string const drive = not who_.drive.empty() ? who_.drive : is_atv28() ? "atv28" : "atv320";
        rtuwire::altivar::reason why{};
        with_drive(drive, [&](auto device) { why = stop_of<typename decltype(device)::type>(drive); });
        ending const end = judge(why, catalog_chosen(drive));
        output results{chosen_.form, false};
        results.put({{"unit", std::int64_t{who_.unit.byte()}},
                     {"outcome", end.sentence + of_which_unit()},
                     {"error", why.error == errc::none ? cell{} : cell{words_of(why.error)}}});
        results.finish();
        return end.status;
    }

private:
    std::string of_which_unit() const
    {
        return chosen_.line.is_unit_named ? "" : "; that was unit 1, because nobody said --unit";
    }

    static line_choices line_to_stop(line_choices line)
    {
        line.must_not_listen = true;
        line.response_timeout = line.response_timeout.value_or(stop_response);
        return line;
    }

    errc write_zero(std::uint16_t address)
    {
        return line_.ask(who_.unit, rtuwire::write_single_register{address, 0}).error();
    }

    /// Takes the power of the motor away; whether it is that of an ATV28.
    bool is_atv28()
    {
        errc const first = write_zero(rtuwire::altivar::atv320::device::layout.cmd);
        if (first == errc::none) {
            way_ = rtuwire::altivar::stop_by::freewheel;
            is_blind_ = chosen_.motion.stop_by != "freewheel";
            return false;
        }
        if (first == errc::illegal_data_address) {
            return true;
        }
        // Nobody answered, or a drive that does not take it now: it may be either.
        return write_zero(rtuwire::altivar::atv28::device::layout.cmd) == errc::none;
    }

    template <rtuwire::device_type Device> rtuwire::altivar::reason stop_of(std::string const& drive)
    {
        auto const station = station_at<Device>(who_.unit.byte(), drive);
        rtuwire::altivar::reason why{};
        int unobeyed = 0;
        // Short stops one after the other: one that nobody answers ends the command soon, and a long ramp does not.
        for (int i = 0; i < most_stops and unobeyed < most_unobeyed; ++i) {
            rtuwire::altivar::stop conversation{station, way_, rtuwire::milliseconds(one_stop)};
            why = line_.run(conversation);
            unobeyed = why.kind == outcome_kind::state_timeout ? unobeyed + 1 : 0;
            if (why.kind != outcome_kind::unconfirmed and unobeyed == 0) {
                break;
            }
        }
        return why;
    }

    bool is_at_zero(drive_catalog const& drive)
    {
        auto const read = line_.ask(who_.unit, rtuwire::read_holding_registers{.start = drive.layout.rfr, .count = 1});
        return read and read->registers[0] == 0;
    }

    /// What was read, in words.
    ending judge(rtuwire::altivar::reason const& why, drive_catalog const& drive)
    {
        std::string const other =
            is_blind_ ? "; 0000 went first, because nobody said which drive it is: a motor that turns coasts (--drive "
                        "says it)"
            : why.is_other_stop
                ? "; a motor that turns coasts: until its CHCF is read, an ATV320 gets no other word than 0000"
                : "";
        if (why.kind == outcome_kind::succeeded) {
            return {exit_status::done, "the motor stands" + other};
        }
        if (why.kind == outcome_kind::unconfirmed) {
            return {exit_status::differs, "the motor slows, not confirmed to stand" + other};
        }
        if (why.kind == outcome_kind::silent) {
            return not_reached(why.error);
        }
        if (why.kind == outcome_kind::state_timeout) {
            return {exit_status::differs, "the stop was taken, and is not obeyed"};
        }
        if (why.kind == outcome_kind::in_fault) {
            return in_fault(why, drive);
        }
        return {exit_status::differs,
                "the motor was not seen to stop: " + std::string{std::string_view{name_of(why.kind)}}};
    }

    ending not_reached(errc why) const
    {
        exit_status const status = why == errc::none ? exit_status::no_answer : status_of(why);
        return {status, "the drive was not reached: " + words_of(why)};
    }

    ending in_fault(rtuwire::altivar::reason const& why, drive_catalog const& drive)
    {
        register_entry const* const lft = drive.at(drive.layout.lft);
        std::string const fault = lft == nullptr ? std::string{} : text_of(*lft, why.fault);
        bool const stands = is_at_zero(drive);
        return {stands ? exit_status::done : exit_status::differs,
                (stands ? "the motor stands, in fault: " : "in fault, not confirmed to stand: ") + fault};
    }

    choices const& chosen_;
    named_unit who_;
    stop_by way_;
    open_line line_;
    bool is_blind_{false}; ///< another stop than the one that was asked for went first
};

} // namespace

exit_status run_stop(choices const& chosen)
{
    named_unit const who = unit_in(chosen.line);
    if (not who.drive.empty()) {
        static_cast<void>(catalog_chosen(who.drive)); // refuses one that there is not
    }
    return stop_command{chosen, who}.run();
}

} // namespace tool
