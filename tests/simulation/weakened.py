# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
"""Weakens one constant of the engines at a time, and looks whether the simulation reports it.

    /usr/bin/python3 tests/simulation/weakened.py [PART_OF_A_NAME...]

Each weakening is an exact change of one text in a copy of the headers. It fails where that text is not there
exactly once, where the simulation finds nothing wrong within a million requests, or where nothing of what it finds
is of the kind that this weakening must show; and where there are faults without it.
"""
import pathlib
import re
import subprocess
import sys
import tempfile
from typing import NamedTuple

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "support"))
from changed_headers import PROJECT, changed_copy, try_all  # noqa: E402

PROGRAM = PROJECT / "tests" / "simulation" / "slow_units.cpp"
# Requests, the first seed, which units, and how many seeds with a fault are enough.
HOW = ("1000000", "1", "any", "200")
JOBS = 2


class Weakening(NamedTuple):
    name: str
    header: str  # below include/rtuwire
    text: str    # stands there once
    becomes: str
    shows: set   # one of these has to be reported


WEAKENINGS = [
    Weakening("response time-out without the response's own characters", "client/line/transaction.hpp",
              "duration const limit = retries_.response_timeout() + request_.time_to_respond(line());",
              "duration const limit = retries_.response_timeout();",
              {"early time-outs", "refused responses"}),
    Weakening("response time-out counted from the start of the request", "client/line/transaction.hpp",
              "deadline_ = at + note_sent(at);",
              "deadline_ = at - request_.time_to_send(line()) + note_sent(at);",
              {"early time-outs", "refused responses"}),
    Weakening("response time-out counted from when the request was handed out",
              "client/line/transaction.hpp",
              "deadline_ = at + note_sent(at);", "static_cast<void>(note_sent(at));",
              {"early time-outs", "late time-outs", "refused responses"}),
    Weakening("late_response halved where there was no answer", "client/line/transaction.hpp",
              "retries_.note_sent(at, time_to_send(), limit + late_response());",
              "retries_.note_sent(at, time_to_send(), limit + microseconds(late_response().microseconds / 2));",
              {"foreign responses"}),
    Weakening("a debt without an answer halved", "client/line/transaction.hpp",
              ": retries_.owed_until(now),",
              ": now + microseconds((retries_.owed_until(now) - now).microseconds / 2),",
              {"foreign responses"}),
    Weakening("a debt without an answer as if each sending began at once", "client/line/request.hpp",
              "owed_until_ = at + ((owed_until(at) - at) + each);",
              "owed_until_ = at + each;",
              {"foreign responses"}),
    Weakening("a debt after an answer halved", "client/line/transaction.hpp",
              "now + retries_.all_that_follow(now, late)",
              "now + microseconds(retries_.all_that_follow(now, late).microseconds / 2)",
              {"foreign responses"}),
    Weakening("a debt after an answer does not count the time-outs", "client/line/request.hpp",
              "return {first_sent_, longest_, unanswered_};",
              "return {first_sent_, longest_, unanswered_ > 0 ? 1U : 0U};",
              {"foreign responses"}),
    Weakening("a debt after an answer counted from the last sending", "client/line/request.hpp",
              "if (unanswered_ == 0) {", "first_sent_ = at; if (unanswered_ == 0) {", {"foreign responses"}),
    Weakening("t3.5 as t1.5 before a frame", "rtu/framer.hpp",
              "if (reached(at, last_ + in.timing().silence())) {",
              "if (reached(at, last_ + in.timing().t1_5())) {",
              {"short silences"}),
    Weakening("t3.5 of 2.5 characters", "rtu/line.hpp", "bit_times(7,", "bit_times(5,",
              {"short silences"}),
    Weakening("t3.5 of 1.25 ms on a fast line", "rtu/line.hpp", "? microseconds(1750)",
              "? microseconds(1250)", {"short silences"}),
    Weakening("turnaround ignored", "client/line/transaction.hpp",
              "deadline_ = at + options().turnaround;", "deadline_ = at;",
              {"short turnarounds"}),
    Weakening("frame_end of a host halved", "rtu/line.hpp",
              "format,\n                                                    duration frame_end = milliseconds(50)",
              "format,\n                                                    duration frame_end = milliseconds(25)",
              {"refused responses"}),
    Weakening("silent share ignored", "client/bus.hpp",
              "std::uint32_t const others = 100U - share_.silent_share;",
              "std::uint32_t const others = 0;", {"shares exceeded"}),
    Weakening("silent share doubled", "client/bus.hpp",
              "std::uint32_t const others = 100U - share_.silent_share;",
              "std::uint32_t const others = (100U - share_.silent_share) / 2;",
              {"shares exceeded"}),
    Weakening("one retry too many", "client/line/request.hpp",
              "bool const is_left = failures_ < retries_;",
              "bool const is_left = failures_ <= retries_;", {"too many transmissions"}),
    Weakening("one retry too few", "client/line/request.hpp",
              "bool const is_left = failures_ < retries_;",
              "bool const is_left = failures_ + 1 < retries_;", {"too few transmissions"}),
    Weakening("one retry too many for a busy unit", "client/line/request.hpp",
              "return asks and pauses_ < busy_retries_;",
              "return asks and pauses_ <= busy_retries_;", {"too many transmissions"}),
    Weakening("pause for a busy unit ignored", "client/line/transaction.hpp",
              "deadline_ = now + retries_.take_pause();",
              "deadline_ = now + retries_.take_pause() * 0;", {"short pauses"}),
]


def simulate(headers, place):
    """The simulation with these headers: what it printed and whether it was content."""
    program = pathlib.Path(place, "simulation")
    made = subprocess.run(["g++", "-std=c++20", "-O2", f"-I{headers}", PROGRAM, "-o", program], capture_output=True,
                          text=True, check=False)
    if made.returncode != 0:
        return made
    return subprocess.run([program, *HOW], capture_output=True, text=True, check=False)


def attempt(weakening):
    """What became of a weakening: whether it was reported, and a line that says how."""
    with tempfile.TemporaryDirectory() as place:
        headers = pathlib.Path(place, "include")
        if wrong := changed_copy([(weakening.header, weakening.text, weakening.becomes)], headers):
            return False, wrong
        run = simulate(headers, place)
        if run.stderr:
            return False, run.stderr
    found = {name: int(after) for name, after in
             re.findall(r"^\d+ (.+), the first after (\d+) requests$", run.stdout, re.MULTILINE)}
    shown = {name: after for name, after in found.items() if name in weakening.shows}
    if run.returncode == 0 or not shown:
        return False, "not reported; found were " + (", ".join(found) or "no faults") + "\n" + run.stdout
    name = min(shown, key=shown.get)
    return True, f"{name} after {shown[name]} requests"


def main(names):
    wanted = [each for each in WEAKENINGS if not names or any(name in each.name for name in names)]
    if not wanted:
        sys.exit("no weakening has such a name")
    with tempfile.TemporaryDirectory() as place:
        run = simulate(PROJECT / "include", place)
    if run.returncode != 0:
        sys.exit("without any weakening there are faults already:\n" + run.stdout + run.stderr)
    return try_all(wanted, attempt, JOBS, "weakenings")


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
