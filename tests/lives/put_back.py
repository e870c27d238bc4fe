# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
"""Puts defects that were mended back into a copy of the headers, one at a time, and looks whether the random lives report it.

    /usr/bin/python3 tests/lives/put_back.py [--lives N] [--first SEED] [--jobs J] [--compiler C] [NAME...]

Each is an exact change of texts that stand in the headers once. It fails where one does not, where no life of N breaks the law,
or where the law that breaks is none of those that this defect has to break. D22 is the tool's: its list's test holds it.
"""
import argparse
import pathlib
import re
import subprocess
import sys
import tempfile
from typing import NamedTuple

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "support"))
from changed_headers import PROJECT, changed_copy, try_all  # noqa: E402

RUNNER = "altivar/procedure/procedure_runner.hpp"
DIRECT = "altivar/procedure/motion/direct_control.hpp"
START = "altivar/procedure/motion/start.hpp"
STOP = "altivar/procedure/motion/stop.hpp"
ORDERS, UNIT_ORDER, BLOCKING, BUS = "client/orders.hpp", "ask/unit_order.hpp", "client/blocking.hpp", "client/bus.hpp"

MOVED = {"a motor got power without an order", "a word that enables left"}
POWER = {"power too long"}
LEFT = {"power too long where"}


class Defect(NamedTuple):
    name: str
    changes: list  # header below include/rtuwire, text, what it becomes
    breaks: set    # one of these has to be reported: its first words
    times: int = 1 # as many lives as others take


DEFECTS = [
    Defect("D18 a stop that is used again says done and sends nothing", [
        (RUNNER, """        procedure_ = procedure_.anew();
        this->begin_again();
""", ""),
    ], {"a stop that was done", "a stop whose word"}),
    Defect("D19 a start runs behind a stop of the same client", [
        (RUNNER, "return is_done() and is_order_in_force();", "return is_done();"),
    ], {"a start that says that the motor runs"}),
    Defect("D20 a reference of 0 in reverse is one forward", [
        ("altivar/device/reference.hpp", "has_no_other ? ~unsigned{word} : 0U - word", "0U - word"),
        ("altivar/device/reference.hpp", "        bool const has_no_other = (word & 0x7FFFU) == 0;\n", ""),
    ], {"a motor turned faster"}),
    Defect("D21 the words of a stop rest on the declared type", [
        ("altivar/device/drive_layout.hpp", "return layout.cmd == later_control_word;",
         "return layout.cmd == later_control_word and layout.cmd == 0;"),
    ], {"a motor got power without an order"}),
    Defect("D23 what was in force lies ahead after half the counter: the client", [
        ("core/time.hpp", "return (now - before).microseconds - half < reach ? instant{before.microseconds + reach} : now;",
         "return reach == 0 ? before : now;"),
        ("rtu/framer.hpp", "return within_reach(last_, now, in.timing().characters(max_adu_size) + latency);",
         "duration const ahead = in.timing().characters(max_adu_size) + latency; std::uint32_t const reach = 0x8000'0000U - "
         "ahead.microseconds; return (now - last_).microseconds - 0x8000'0000U < reach ? instant{last_.microseconds + reach} "
         ": now;"),
    ], {"a stop whose word", "a unit that hears", *POWER}),
    Defect("D24 what was in force lies ahead after half the counter: the line", [
        ("rtu/framer.hpp", "return within_reach(last_, now, in.timing().characters(max_adu_size) + latency);",
         "static_cast<void>(latency); return now;"),
        ("rtu/framer.hpp", "not(waits_for_silence() or activity_ == activity::busy)", "not waits_for_silence()"),
    ], {"a unit that hears", "a stop whose word", *POWER}),
    Defect("D25 a reference beyond the drive's limits is taken", [
        ("altivar/procedure/inspection/reference_limits.hpp",
         "if (has_scale and size * step >= highest * scale + step) {", "if (has_scale and size > 0x8000U) {"),
    ], {"a reference beyond"}),
    Defect("D26 the status that ends a cycle's check is not judged", [
        ("altivar/cyclic/cycle_agenda.hpp",
         "position_.go_to(judge(status, false) ? step::look_for_fault : position_.first());",
         "static_cast<void>(status); position_.go_to(position_.first());"),
    ], MOVED),
    Defect("D27 a stop of everyone forgets a drive that it does not name", [
        ("client/client.hpp", "orders_.lose_all_but_its_own(conversation, now);", ""),
        ("altivar/procedure/motion/broadcast_stop.hpp",
         "bool is_done = settled() and not this->is_used_already() and not leaves_ordered();",
         "bool is_done = settled() and not this->is_used_already();"),
    ], {*POWER, "a stop that was done"}),
    Defect("D28 a cycle goes on behind a sleep longer than the drive's time-out", [
        ("altivar/cyclic/cyclic.hpp", "if (is_heard_ and not is_asking_ and since_heard_ > drive_timeout()) {",
         "if (is_heard_ and is_asking_ and since_heard_ > drive_timeout()) {"),
        ("client/orders.hpp", """            own.last_fault = ++count_;
            own.leave(now);
""", ""),
    ], {*MOVED, *POWER}, 2),
    Defect("A a stop that is given up before its end holds on", [
        (UNIT_ORDER, "if (is_held and (is_over or", "if (false and is_held and (is_over or")], LEFT),
    Defect("B a stop that is given up and released at once leaves its motor to reads", [
        (UNIT_ORDER, "        withdraw(++count);\n        leave(on_line);\n", "        withdraw(++count);\n"),
        (ORDERS, """            all_.let_go();
            note_none_counts();
            leave_all();
""", "            all_.let_go();\n            note_none_counts();\n"),
    ], LEFT, 3),
    Defect("B broadcast_freewheel that is not heard leaves a motor to reads", [
        (ORDERS, """            each.silence_end = asked_ + each.silence;
        }
        leave_all();
""", """            each.silence_end = asked_ + each.silence;
        }
""")], LEFT, 3),
    Defect("the loss of a motor that is left is put off", [
        (UNIT_ORDER, "if (answers_left == 0) { // else it was left before", "{")], LEFT, 3),
    Defect("any answer ends a loss", [
        (ORDERS, "own->is_lost = own->is_lost and not is_stop_asked_;", "own->is_lost = false;")], LEFT | {"power too long after"}, 3),
    Defect("a request under way that fed a motor is noted behind the look at whether it has stopped", [
        (ORDERS, "            each.on_line = is_under_way ? now : each.on_line; // it may feed a motor that runs\n", ""),
        (ORDERS, "            each.heed_absence(is_all_left, now);\n",
         "            each.heed_absence(is_all_left, now);\n            each.on_line = is_under_way ? now : each.on_line;\n"),
    ], LEFT, 3),
    Defect("broadcast_freewheel waits while a unit is lost", [
        ("ask/commander.hpp", "return frees_all_units<T> and not conversation.settled() ? effect::stopping : effect::none;",
         "return effect::none;")],
        {"a stop whose word"}),
    Defect("broadcast_freewheel waits in a slot of a silent unit", [
        (BUS, "return not detail::frees_all_units<Conversation> and must_wait(index, now);", "return must_wait(index, now);")],
        {"a stop whose word"}),
    Defect("a stop that the drive does not have sends nothing", [
        (STOP, """        if (not detail::has_stop(layout(), mode_)) {
            return stop_blind();
""", """        if (not detail::has_stop(layout(), mode_)) {
            return end(outcome_kind::misconfigured);
""")], {"a stop whose word"}),
    Defect("C a time that is over for half the counter lies ahead: a pass that waits", [
        (BLOCKING, "engine.judged_at(now));\n    return receive_from(port, engine, place, *earlier",
         "now);\n    return receive_from(port, engine, place, *earlier")], {"a wait of a blocking client"}),
    Defect("D a pause of the program is a line that is jammed", [
        (BLOCKING, "part_of(limit, until - std::exchange(now, until))", "(until - std::exchange(now, until))")], {"a stop whose word"}),
    Defect("E a read that fails ends a stop before its word", [
        (BLOCKING, "has_to_stop(conversation) and passed != errc::bus_jam;", "false;")], {"a stop whose word"}),
    Defect("a pause of the program ends a stop before its word", [
        (BLOCKING, "part_of(longest_wait, now - std::exchange(seen, now))", "(now - std::exchange(seen, now))")], {"a stop whose word"}),
    Defect("D29 a direct start reads the command before the status", [
        (DIRECT, "read(may_run_ ? stage::confirming : stage::looking_again, layout().eta)",
         "(may_run_ ? read(stage::confirming, layout().eta) : read(stage::reading_command, layout().cmd))"),
        (DIRECT, "case stage::reading_command: return word == 0 ? run() : abort(outcome_kind::overwritten);",
         "case stage::reading_command:\n            return word == 0 ? read(stage::looking_again, layout().eta)\n"
         "                             : abort(outcome_kind::overwritten);"),
        (DIRECT, "        return read(stage::reading_command, layout().cmd);\n    }", "        return run();\n    }"),
        (DIRECT, "        case stage::writing_reference:\n        case stage::running: return read(stage::reading_reference, reference_.address);",
         "        case stage::writing_reference: return read(stage::reading_reference, reference_.address);\n"
         "        case stage::running: return read(stage::confirming, layout().eta);"),
    ], {"a start that was done", "a motor turned faster"}),
    Defect("a start goes by its reference as it wrote it", [
        (START, "if (control != control_ or standing != told_.word) {", "static_cast<void>(standing);\n        if (control != control_) {"),
    ], {"a start sent its word", "a start that was done"}),
    Defect("what has ended says more where something befell its unit", [
        (RUNNER, """        if (settled()) {
            return std::nullopt; // whatever befell its unit since
        }
""", "")], {"what had ended", "a frame left"}),
    Defect("an order enables a unit while a stop of everyone is under way", [
        (ORDERS, "if (own.holder != 0 or all_.stamp() != 0 or is_late) {", "if (own.holder != 0 or is_late) {")],
        {"a word that enables left while"}),
    Defect("an order that is given twice in one pass is older than nothing", [
        ("ask/commander.hpp", "ordered_behind_ = newer_of(former.seen_, former.ordered_behind_);", "ordered_behind_ = former.seen_;"),
        ("ask/commander.hpp", "        known_ = former.known_;\n", ""),
    ], MOVED, 3),
]


def attempt(defect, options):
    """Whether it was reported, and a line that says how."""
    with tempfile.TemporaryDirectory() as place:
        headers, program = pathlib.Path(place, "include"), pathlib.Path(place, "lives")
        if wrong := changed_copy(defect.changes, headers):
            return False, wrong
        made = subprocess.run([options.compiler, "-std=c++20", "-Og", f"-I{headers}", f"-I{PROJECT / 'tests'}", "-w",
                               str(PROJECT / "tests" / "lives" / "random_lives.cpp"), "-o", str(program)],
                              capture_output=True, text=True, check=False)
        if made.returncode != 0:
            return False, made.stderr
        done = subprocess.run([program, str(options.lives * defect.times), str(options.first)],
                              capture_output=True, text=True, check=False)
    seeds = re.findall(r"^seed (\d+): (.+)$", done.stdout, re.MULTILINE)
    of_it = [(int(seed), law) for seed, law in seeds if any(law.startswith(each) for each in defect.breaks)]
    if not of_it:
        return False, "not reported; broken were: " + (", ".join(sorted({law for _, law in seeds})) or "no laws")
    seed, law = min(of_it)
    return True, f"after {seed - options.first + 1} lives: {law}"


def main():
    arguments = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    arguments.add_argument("--lives", type=int, default=10_000, help="as many as CI has with each build")
    arguments.add_argument("--first", type=int, default=1)
    arguments.add_argument("--jobs", type=int, default=2)
    arguments.add_argument("--compiler", default="g++")
    arguments.add_argument("names", nargs="*", help="the first words of those to try")
    options = arguments.parse_args()
    wanted = [each for each in DEFECTS if not options.names or any(each.name.startswith(name) for name in options.names)]
    if not wanted:
        sys.exit("no defect has such a name")
    return try_all(wanted, lambda each: attempt(each, options), options.jobs, "defects")


if __name__ == "__main__":
    sys.exit(main())
