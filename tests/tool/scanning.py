# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
"""A scan of a whole line: what it finds, what it costs, and how it goes on where it was ended.

    python3 scanning.py TOOL
"""
import os
import re
import signal
import time

from support import DONE, NO_ANSWER, REFUSED, Simulator, Tool, Units, runs

THERE = {3: "atv12", 7: "atv320", 130: "atv310"}
ADDRESSES = 247
TIMEOUT = 0.03  # s
RATE = 19_200
REQUEST = (8 + 3.5) * 11 / RATE  # s on the wire, with its silence


def allowed(units):
    """At most 1.15 of what the time-outs alone cost, and the requests themselves."""
    return (1.15 * TIMEOUT + REQUEST) * units


def check_whole_line(program, tool, check):
    with Simulator(program, *(f"{drive}:{unit}" for unit, drive in THERE.items())) as device:
        how = ["--port", device, "--no-listen", "--timeout", TIMEOUT]
        began = time.monotonic()
        ended = tool.run(*how, "--json", "scan")
        spent = time.monotonic() - began
        found = {row["unit"]: row["drive"] for row in ended.objects()}
        check(ended.status == DONE and found == THERE, "three drives among 247 addresses, and nothing else", ended)
        most = allowed(ADDRESSES)
        check(spent < most, f"the scan takes {spent:.2f} s, allowed {most:.2f} s")
        lines = ended.errors.splitlines()
        check(5 < len(lines) < 20 and all(re.match(r"\d+ of 247, unit \d+, \d found", line) for line in lines),
              "a line of progress now and then, where it is no terminal", lines)
        check("\r" not in ended.errors and "\x1b" not in ended.errors, "without a terminal's characters")
        shown = tool.on_terminal(*how, "scan", "--units", "1-20").output
        check("\r" in shown and "left" in shown, "a line that changes on a terminal, with the time left")
        check(tool.run(*how, "scan", "--units", "8-12").status == NO_ANSWER, "nobody there: status 3")
        many = tool.run(*how, "--csv", "scan", "--units", "7", "--bauds", "9600,19200", "--formats", "8E1,8N1").rows()
        check([(row["baud"], row["format"]) for row in many]
              == [("9600", "8E1"), ("9600", "8N1"), ("19200", "8E1"), ("19200", "8N1")], "each bit rate and format", many)


def check_resume(program, tool, check):
    with Simulator(program, *(f"{drive}:{unit}" for unit, drive in THERE.items())) as device:
        words = ["--port", device, "--no-listen", "--timeout", TIMEOUT, "--json", "scan", "--units", "1-40,130", "--resume", "found"]
        process = tool.start(*words)
        first = process.stdout.readline()
        second = process.stdout.readline()
        process.send_signal(signal.SIGINT)
        rest, errors = process.communicate()
        check(process.returncode == 128 + signal.SIGINT and '"unit":3' in first and '"unit":7' in second and not rest,
              "Ctrl-C leaves what was found", (first, second, rest))
        check("goes on from there" in errors, "and says how it goes on", errors)
        seen = len((tool.place / "found").read_text().splitlines()) - 1
        began = time.monotonic()
        ended = tool.run(*words)
        spent = time.monotonic() - began
        check([row["unit"] for row in ended.objects()] == sorted(THERE), "it goes on, and shows all", ended)
        most = allowed(41 - seen) + 0.2
        check(seen >= 7 and spent < most, f"without asking again: {spent:.2f} s, allowed {most:.2f} s")
        began = time.monotonic()
        again = tool.run(*words)
        check(again.output == ended.output and time.monotonic() - began < 0.3, "and asks nobody when it is through")
        os.remove(tool.place / "found")
        (tool.place / "found").write_text("something else\n")
        check(tool.run(*words).status != DONE and (tool.place / "found").read_text() == "something else\n",
              "a file of another kind is left alone")


def check_listening(tool, check):
    """A line on which another master speaks is not scanned."""
    with Units({}) as line:
        process = tool.start("--port", line.name, "--listen", "0.6", "scan")
        time.sleep(0.2)
        line.say(bytes.fromhex("07030C820001270C"))
        output, errors = process.communicate(timeout=10)
        check(process.returncode == REFUSED and "talking" in errors and not output, "a line in use is not scanned", errors)
        check(not line.heard, "nothing was sent", line.heard)
        began = time.monotonic()
        process = tool.start("--port", line.name, "--timeout", TIMEOUT, "scan", "--units", "1-3")
        while not line.heard and time.monotonic() - began < 5:
            time.sleep(0.01)
        check(time.monotonic() - began > 0.95, "it listens for a second before it speaks")
        process.communicate(timeout=10)
    with Units({9: {}}) as line:
        rows = tool.run("--port", line.name, "--no-listen", "--timeout", TIMEOUT, "--json", "scan", "--units", "5-12").objects()
        check([(row["unit"], row["drive"]) for row in rows] == [(9, "")], "a unit that only refuses is one", rows)


def main(check, program):
    with Tool(program) as tool:
        check_whole_line(program, tool, check)
        check_resume(program, tool, check)
        check_listening(tool, check)


runs(main)
