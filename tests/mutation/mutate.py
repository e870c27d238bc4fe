# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
"""Changes an operator or a constant in the portable headers and looks whether the tests see it.

    python3 tests/mutation/mutate.py [--since COMMIT [--most N]] [--jobs J] [--work DIR] [headers, or folders of them]

The tests are compiled once, with every change behind a switch; they run with one switch turned at a time, and
only those that come by it. What they do not see and survivors.txt does not explain is tried with the second engines
of tests/model and the lives of tests/lives, then compiled into a copy of the headers, with the tests of its room and
their proofs. A change that is no switch (a type, an array's size, what only the compiler evaluates) is compiled at
once. A change is killed by a test that fails, crashes or does not end in time, and by a build that fails.
survivors.txt says why no test can see a change; open.txt lists those that nobody has explained yet, and may only get
shorter. Survivors that stand in neither are printed as they are found, and rows that are for nothing at the end;
either is a failure. With --since only lines are changed that differ from that commit, of more than N (40) changes some
drawn by chance; the tests of their headers' rooms come first, and the others only for what those do not see. Without
it all changes are tried, in the order of the arguments. tried.txt keeps what whole runs found: a header that has changed
since is named. --note writes open.txt and tried.txt anew for the headers asked.
"""
import argparse
import collections
import concurrent.futures
import contextlib
import pathlib
import random
import re
import subprocess
import sys
import tempfile
import threading
import time

from changes import changes_of
from compiled import Compiler, rooms_of
from ledger import Ledger
from models import Models
from programs import PROJECT, ROOMS, Switchboard, precompiled
import switches

HEADERS = PROJECT / "include" / "rtuwire"
# What stands for a machine or for a drive's manual: the simulated devices, the host's port, the register tables.
LEFT_OUT = ("sim/", "port/", "altivar/device/atv", "altivar/device/compact_values", "altivar/atv", "altivar/parameters/atv",
            "altivar/parameters/compact_values", "altivar/parameters/family_words")
LIKELIEST = 12
# A start value that the compiler needs where it evaluates a table (GCC 12 fails to).
NO_SWITCH = {("core/literal.hpp", "std::size_t size_{1};")}


def headers(asked):
    """Those whose names begin as asked, in that order."""
    found = sorted(path.relative_to(HEADERS).as_posix() for path in HEADERS.rglob("*.hpp"))
    return [header for begin in asked for header in found
            if header.startswith(begin) and not header.startswith(LEFT_OUT)]


def lines_since(commit):
    """The lines of each header that differ from a commit."""
    said = subprocess.run(["git", "diff", "-U0", "--no-ext-diff", "--relative", commit, "--", "."], cwd=HEADERS,
                          text=True, check=True, stdout=subprocess.PIPE).stdout
    found, header = {}, None
    for line in said.splitlines():
        if line.startswith("+++ "):
            header = line.removeprefix("+++ b/")
        elif hunk := re.match(r"@@ \S+ \+(\d+)(?:,(\d+))? @@", line):
            found.setdefault(header, set()).update(range(int(hunk[1]), int(hunk[1]) + int(hunk[2] or 1)))
    return found


def switched_tests(folder, common, pool, changes, may_switch, rooms):
    """The tests with these changes behind switches. What the compiler refuses becomes none, by lines."""
    board = Switchboard(folder, common, pool, rooms, {change.header for change in changes})
    while True:
        switches.write(folder / "include", HEADERS, changes, sorted(may_switch))
        wrong = board.complaints_of_headers() or board.compile()
        if not board.waiting:
            break
        refused = {number for number in may_switch for header, line in wrong
                   if changes[number].header == header and line in changes[number].lines}
        if not refused:
            raise SystemExit(f"mutate.py: no change stands where the compiler complains: {sorted(wrong)[:5]}")
        may_switch -= refused
    board.link()
    return board


def outcomes(folder, pool, changes, is_explained, report, rooms=ROOMS, is_first=False):
    """Whether each change survives the tests of these rooms. The first of two times the engines and what only the
    compiler proves are not asked, and of a change that is no switch the likeliest tests alone."""
    folder.mkdir(parents=True, exist_ok=True)
    common = precompiled(folder)
    may_switch = {number for number, change in enumerate(changes) if change.first >= 0 and
                  (change.header, change.becomes) not in NO_SWITCH}
    board = switched_tests(folder, common, pool, changes, may_switch, rooms)
    cases = board.cases()
    report.say(f"{len(changes)} changes, {len(may_switch)} of them switches; {len(cases)} test cases of "
               f"{sum(case.seconds for case in cases):.1f} s")
    compiler = Compiler(folder, common, HEADERS, board.too_long, LIKELIEST if is_first else None)
    models = None if is_first else Models(folder, pool)

    def lives(number):
        change = changes[number]
        killed = board.kills(number, cases) if number in may_switch else None
        if killed is None and (is_first or rooms is ROOMS or number not in may_switch):
            killed = not compiler.survives(change)
        elif not killed and not is_first and not is_explained(change):
            killed = models.kills(number, change.header) or not compiler.survives(change, True)
        if not is_first:
            report.note(change, not killed)
        return not killed
    return list(pool.map(lives, range(len(changes))))


def outcomes_by_rooms(folder, pool, changes, is_explained, report):
    """The same for few changes: their own rooms first, and the others for what those do not see."""
    own = sorted({room for change in changes for room in rooms_of(change.header)})
    lives = outcomes(folder / "own", pool, changes, is_explained, report, own, True)
    left = [number for number, is_alive in enumerate(lives) if is_alive]
    if left:
        others = [room for room in ROOMS if room not in own]
        again = outcomes(folder / "others", pool, [changes[number] for number in left], is_explained, report, others)
        for number, is_alive in zip(left, again):
            lives[number] = is_alive
    return lives


class Report:
    """Tells of survivors as they are found, and counts."""

    def __init__(self, ledger):
        self.ledger, self.start, self.lock = ledger, time.monotonic(), threading.Lock()

    def say(self, what):
        print(f"{time.monotonic() - self.start:5.0f} s  {what}", flush=True)

    def note(self, change, is_alive):
        if is_alive and change.key not in self.ledger.explained:
            with self.lock:
                print(f"  survives: {change.header}:{change.line}: {change.becomes}", flush=True)

    def total(self, tried, survive):
        """Counts by header; what is new, and which rows are for nothing."""
        alive = [change for change, lives in zip(tried, survive) if lives]
        kinds, idle = self.ledger.sort([change.key for change in alive])
        counts = {}
        for change in tried:
            counts.setdefault(change.header, collections.Counter())["tried"] += 1
        for change, kind in zip(alive, kinds):
            counts[change.header][kind] += 1
        for header, count in counts.items():
            survived = count["explained"] + count["open"] + count["new"]
            print(f"{header}: {count['tried']} tried, {count['tried'] - survived} killed, {count['explained']} "
                  f"explained, {count['open']} open, {count['new']} new")
        return counts, [change for change, kind in zip(alive, kinds) if kind == "new"], idle


def main():
    options = argparse.ArgumentParser()
    options.add_argument("--since", help="change only lines that differ from this commit")
    options.add_argument("--most", type=int, default=40, help="so many of them")
    options.add_argument("--jobs", type=int, default=2)
    options.add_argument("--note", action="store_true", help="write open.txt and tried.txt for these headers")
    options.add_argument("--work", help="where to build; else a folder that is gone afterwards")
    options.add_argument("headers", nargs="*", default=[""])
    asked = options.parse_args()
    chosen = headers(asked.headers)
    lines = lines_since(asked.since) if asked.since else None
    chosen = [header for header in chosen if lines is None or header in lines]
    texts = {header: (HEADERS / header).read_text(encoding="utf-8") for header in chosen}
    possible = [change for header in chosen for change in changes_of(header, texts[header])]
    places = collections.Counter(change.key for change in possible)
    ledger = Ledger(chosen)
    report = Report(ledger)

    def is_explained(change):
        return ledger.explained[change.key] >= places[change.key]
    tried = possible
    if asked.since:
        there = [change for change in possible if change.line in lines[change.header]]
        random.seed(asked.since)
        tried = [change for change in there if not is_explained(change)]
        tried = random.sample(tried, min(asked.most, len(tried)))
        print(f"{len(there)} changes in the lines that differ from {asked.since}: {len(tried)} to be tried")
        if not tried:
            return 0
    changed = ledger.changed(texts)
    for header in changed:
        count = sum(change.header == header for change in tried)
        print(f"changed since all of its changes were tried: {header}, {count} to be tried")
    with contextlib.ExitStack() as stack:
        folder = pathlib.Path(asked.work or stack.enter_context(tempfile.TemporaryDirectory()))
        pool = stack.enter_context(concurrent.futures.ThreadPoolExecutor(asked.jobs))
        how = outcomes_by_rooms if asked.since else outcomes
        survive = how(folder, pool, tried, is_explained, report)
    counts, new, idle = report.total(tried, survive)
    idle = [] if asked.since else idle
    for change in new:
        print(f"nobody has explained: {change.header}:{change.line}: {change.becomes}")
    for header, line in idle:
        print(f"survivors.txt or open.txt names what is killed, or gone: {header} | {line}")
    if asked.note and not asked.since:
        ledger.write(texts, counts, [change.key for change, lives in zip(tried, survive) if lives])
    of = collections.Counter()
    for count in counts.values():
        of.update(count)
    killed = len(tried) - of["explained"] - of["open"] - of["new"]
    report.say(f"{killed} of {len(tried)} changes killed ({100 * killed / max(1, len(tried)):.1f} %), "
               f"{of['explained']} explained, {of['open']} open, {of['new']} new; {len(possible)} possible")
    return 1 if new or idle else 0


if __name__ == "__main__":
    sys.exit(main())
