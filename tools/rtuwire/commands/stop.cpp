// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Stops a motor, whoever runs it. Nobody is asked for a permission, nothing is listened to before.
//
// Whatever names the drive's type, the command line, the configuration or nobody: no word rests on that name. At 8501, where
// all Altivars but the ATV28 have their control word, only 0000 stops each of them: every other word that stops would run an
// ATV320 whose CHCF is IO. So one read of CHCF goes first, 100 ms at most: where it is the drive profile, the word that was
// asked for follows, else 0000, and the motor coasts. An ATV28 has no CHCF: exception 02. No other Altivar takes a word at
// 400, and nobody names a device that is none when a motor has to be stopped. What confirms the stop is the same in the four
// others, so that nothing has to be identified.
#include <atomic>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include <rtuwire/altivar/all.hpp>
#include <rtuwire/client.hpp>
#include <rtuwire/drives.hpp>

#include "../support/platform.hpp"
#include "../support/signals.hpp"
#include "catalog/value_text.hpp"
#include "commands/commands.hpp"
#include "line/line_words.hpp"
#include "line/who_is_it.hpp"
#include "motion/motor.hpp"
#include "output/passing_text.hpp"
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

/// CHCF of a drive that nobody named: read once, 100 ms at most.
class short_look : public rtuwire::single_request<rtuwire::read_holding_registers> {
    using base = rtuwire::single_request<rtuwire::read_holding_registers>;

public:
    explicit short_look(rtuwire::unit_id unit)
        : base{unit, rtuwire::read_holding_registers{.start = rtuwire::altivar::atv320::chcf.address, .count = 1}}
    {}

    std::optional<rtuwire::request_frame> next() const& noexcept
    {
        auto const asked = base::next();
        return asked ? std::optional{rtuwire::request_frame{asked->frame(), rtuwire::repetition::never}} : std::nullopt;
    }
    std::optional<rtuwire::request_frame> next() const&& = delete;

    /// How long the response may take.
    rtuwire::duration limited(rtuwire::duration timeout) const noexcept
    {
        constexpr rtuwire::duration longest = rtuwire::milliseconds(100);
        return longest < timeout ? longest : timeout;
    }
};

/// Whether the drive is known to have got its word; a signal may come before.
std::atomic<bool> has_got_its_word{false};

/// The drive follows its word without this program; whoever ends it is told how far it came.
void tell_and_end(int number)
{
    std::string_view const text = has_got_its_word
                                      ? "\nrtuwire: told to stop, not seen to stand\n"
                                      : "\nrtuwire: ended before the drive was known to have been told to stop\n";
    static_cast<void>(write_at_once(STDERR_FILENO, text));
    end_by(number);
}

/// A line on the terminal that changes while a motor takes its time.
class waiting_line {
public:
    void show(std::string const& text) const
    {
        if (is_terminal_) {
            tell_at_once('\r' + text + "\x1b[K");
        }
    }
    void clear() const { show({}); }

private:
    bool is_terminal_{is_terminal(STDERR_FILENO)};
};

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
        call_before_end(tell_and_end);
        waiting_.show("stops the motor of unit " + std::to_string(who_.unit.byte()));
        // A drive without a name says by its answer whether it is an ATV28; all the others are stopped alike.
        std::string drive = not who_.drive.empty() ? who_.drive : is_atv28() ? "atv28" : "atv320";
        rtuwire::altivar::reason why = stop_as(drive);
        if (why.kind == outcome_kind::other_family and why.error == errc::none) {
            // It has taken 0000; as a drive of its own family it can be seen to stand.
            is_other_family_ = true;
            way_ = stop_by::freewheel;
            drive = drive == "atv28" ? "atv320" : "atv28";
            why = stop_as(drive);
        }
        ending const end = judge(why, catalog_chosen(drive));
        waiting_.clear();
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
        line.is_trace_optional = true;
        line.pause = 0;
        line.response_timeout = line.response_timeout.value_or(stop_response);
        return line;
    }

    errc write_zero(std::uint16_t address)
    {
        return line_.ask(who_.unit, rtuwire::write_single_register{address, 0}).error();
    }

    rtuwire::altivar::reason stop_as(std::string const& drive)
    {
        rtuwire::altivar::reason why{};
        with_drive(drive, [&](auto device) { why = stop_of<typename decltype(device)::type>(drive); });
        return why;
    }

    /// Whether a drive that nobody named is an ATV28. Where nobody answers in time, the power of the motor is taken away.
    bool is_atv28()
    {
        auto look = line_.with(short_look{who_.unit});
        errc const found = line_.run(look).error();
        if (found == errc::none or rtuwire::is_exception(found)) {
            return found == errc::illegal_data_address;
        }
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
            rtuwire::altivar::stop conversation{station, way_, rtuwire::milliseconds(one_stop),
                                                rtuwire::altivar::stop_begin::look_first};
            why = line_.command(conversation);
            unobeyed = why.kind == outcome_kind::state_timeout ? unobeyed + 1 : 0;
            if (why.kind != outcome_kind::unconfirmed and unobeyed == 0) {
                break;
            }
            has_got_its_word = true;
            show_output(catalog_chosen(drive));
        }
        return why;
    }

    void show_output(drive_catalog const& drive)
    {
        auto const read = line_.ask(who_.unit, rtuwire::read_holding_registers{.start = drive.layout.rfr, .count = 1});
        register_entry const* const rfr = drive.at(drive.layout.rfr);
        waiting_.show("told to stop" +
                      (read and rfr != nullptr ? ", at " + text_of(*rfr, read->registers[0]) : std::string{}) +
                      "; waits until it stands");
    }

    /// What was read, in words.
    ending judge(rtuwire::altivar::reason const& why, drive_catalog const& drive)
    {
        std::string const other =
            is_other_family_
                ? "; it is no drive of the type that was named: 0000 was taken elsewhere, and a motor that turns "
                  "coasts"
            : is_blind_ or why.is_other_stop
                ? "; a motor that turns coasts: CHCF was not read to be the drive profile, and then only 0000 stops it"
                : "";
        if (why.kind == outcome_kind::succeeded) {
            bool const coasts = way_ == stop_by::freewheel or why.is_other_stop;
            return {exit_status::done, (coasts ? no_power_text : "the motor stands") + other};
        }
        if (status_of(why.error) == exit_status::port) {
            return port_failed(other);
        }
        if (why.kind == outcome_kind::unconfirmed) {
            return {exit_status::differs, "the motor slows, not confirmed to stand" + other};
        }
        if (why.kind == outcome_kind::silent) {
            return not_reached(why.error);
        }
        if (why.kind == outcome_kind::other_family) {
            return {exit_status::differs, "the drive takes no word that stops it, neither at 8501 nor at 400"};
        }
        if (why.kind == outcome_kind::state_timeout) {
            return {exit_status::differs, "the stop was taken, and is not obeyed"};
        }
        if (why.kind == outcome_kind::in_fault) {
            return in_fault(why, drive, other);
        }
        return {exit_status::differs,
                "the motor was not seen to stop: " + std::string{std::string_view{name_of(why.kind)}} +
                    way_past_server(why.error)};
    }

    /// How far the word has come.
    ending port_failed(std::string const& other)
    {
        std::string word = "no word that stops the motor was sent before";
        if (line_.exchange().written() == written_word::sent) {
            word = "the word that stops the motor was sent, and no answer confirmed it" + other;
        } else if (line_.exchange().written() == written_word::confirmed) {
            word = "the drive has confirmed the word that stops the motor, which was not seen to stand" + other;
        }
        return {exit_status::port, line_.port().failure() + "; " + word + "; " + way_to_stop(chosen_.line)};
    }

    /// A drive may hear and be mute: its motor has got the word then, and nobody knows it.
    ending not_reached(errc why)
    {
        exit_status const status = why == errc::none ? exit_status::no_answer : status_of(why);
        std::string const sent =
            line_.exchange().written() == written_word::unsent
                ? "no word that stops the motor was sent"
                : "the word that stops the motor was sent, and nothing confirmed it: a drive that "
                  "hears and cannot answer follows it, one that does not hear runs on; look at the "
                  "motor, and where it turns take the power from the drive";
        return {status, (why == errc::none ? "no response" : line_.words_of_failure(why)) + "; " + sent + "; `" +
                            shown_command(chosen_.line, "stop") + "` sends it again"};
    }

    /// What has the line for many clients lets no other word pass than the one that stops every drive, or none.
    std::string way_past_server(errc why)
    {
        if (why != errc::illegal_function or not line_.port().is_connection()) {
            return {};
        }
        return way_ != stop_by::freewheel
                   ? "; what serves this line may let 0000 alone pass, by which the motor coasts: `" +
                         shown_command(chosen_.line, "stop --freewheel") + "` sends it"
                   : "; what serves this line may let no word pass: end it, and stop at the port that it has";
    }

    ending in_fault(rtuwire::altivar::reason const& why, drive_catalog const& drive, std::string const& other)
    {
        register_entry const* const lft = drive.at(drive.layout.lft);
        std::string const fault = lft == nullptr ? std::string{} : text_of(*lft, why.fault);
        auto const output =
            line_.ask(who_.unit, rtuwire::read_holding_registers{.start = drive.layout.rfr, .count = 1});
        if (status_of(output.error()) == exit_status::port) {
            return port_failed(other);
        }
        if (not output or output->registers[0] != 0) {
            return {exit_status::differs, "in fault, not confirmed to stand: " + fault};
        }
        return {exit_status::done, no_power_text + (", in fault: " + fault)};
    }

    choices const& chosen_;
    named_unit who_;
    stop_by way_;
    open_line line_;
    waiting_line waiting_{};
    bool is_blind_{false};        ///< another stop than the one that was asked for went first
    bool is_other_family_{false}; ///< than that of the type that was named
};

} // namespace

exit_status run_stop(choices const& chosen)
{
    named_unit who = unit_in(chosen.line);
    if (who.drive == no_drive) { // a motor may turn there all the same
        who.drive.clear();
    }
    if (not who.drive.empty()) {
        static_cast<void>(catalog_chosen(who.drive)); // refuses one that there is not
    }
    return stop_command{chosen, who}.run();
}

} // namespace tool
