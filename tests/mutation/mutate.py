# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
"""Changes an operator or a constant in the portable headers and looks whether the tests see it.

    python3 tests/mutation/mutate.py [--since COMMIT [--most N]] [--jobs J] [--work DIR] [headers, or folders of them]

The tests are compiled once, with every change behind a switch; they run with one switch turned at a time, and
only those that come by it. With --since the nearest tests come first, and others only for what those do not see.
What they do not see and survivors.txt does not explain is tried with the second engines
of tests/model and the lives of tests/lives, then compiled into a copy of the headers, with the tests of its room and
their proofs. A change that is no switch (a type, an array's size, what only the compiler evaluates) is compiled at
once. A change is killed by a test that fails, crashes or does not end in time, and by a build that fails.
survivors.txt says why no test can see a change; open.txt lists those that nobody has explained yet, and may only get
shorter. Survivors that stand in neither are printed as they are found, and rows that are for nothing at the end;
either is a failure. With --since only lines are changed that differ from that commit, of more than N (40) changes some
drawn by chance. Without it all changes are tried, in the order of the arguments. tried.txt keeps what whole runs found: a header that has changed
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
from programs import PROJECT, ROOMS, TESTS, Switchboard, included, precompiled, sources, words_of
import switches

HEADERS = PROJECT / "include" / "rtuwire"
# What stands for a machine or for a drive's manual: the simulated devices, the host's port, the register tables.
LEFT_OUT = ("sim/", "port/", "altivar/device/atv", "altivar/device/compact_values", "altivar/atv", "altivar/parameters/atv",
            "altivar/parameters/compact_choices", "altivar/parameters/family_words")
STEP = 28  # tests: two files of joined ones, for two processors
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


def tests_that_changed(commit):
    """The tests that differ from a commit: likely those of what changed with them."""
    said = subprocess.run(["git", "diff", "--name-only", "--relative", commit, "--", "."], cwd=TESTS, text=True, check=True,
                          stdout=subprocess.PIPE).stdout
    return {TESTS / name for name in said.splitlines()}


def nearest(header, fresh):
    """All tests that include a header: first those of its own rooms, of its name, that changed with it, and that share the
    words which are rare in other tests."""
    tests = [path for path in sources(ROOMS) if header in included(path)]
    common = collections.Counter(word for path in tests for word in words_of(path))
    own, words, name = rooms_of(header), words_of(HEADERS / header), pathlib.Path(header).stem.split("_")[0]

    def distance(path):
        shared = sum(1 / common[word] for word in words & words_of(path)) / len(words_of(path)) ** 0.5
        return path.relative_to(TESTS).parts[0] not in own, path.stem.split("_")[0] != name, path not in fresh, -shared
    return sorted(tests, key=distance)


def steps(left, fresh, most):
    """The tests that are asked together, one time after the other: the nearest to the headers in `left()`, whose changes no
    test has seen by then."""
    seen = set()
    while headers_left := left():
        ranks = {}
        for header in sorted(headers_left):
            for rank, path in enumerate(each for each in nearest(header, fresh) if each not in seen):
                ranks[path] = min(rank, ranks.get(path, rank))
        tests = sorted(ranks, key=ranks.get)[:most]
        if not tests:
            break
        seen |= set(tests)
        yield sorted(tests)


def write_switched(folder, changes, may_switch, wrong=()):
    """The headers with these changes behind switches. What the compiler refuses becomes none, by lines."""
    refused = {number for number in may_switch for header, line in wrong
               if changes[number].header == header and line in changes[number].lines}
    if wrong and not refused:
        raise SystemExit(f"mutate.py: no change stands where the compiler complains: {sorted(wrong)[:5]}")
    may_switch -= refused
    switches.write(folder / "include", HEADERS, changes, sorted(may_switch))


def outcomes(folder, pool, changes, is_explained, report, fresh=(), most=None):
    """Whether each change survives. `most` tests at a time are compiled, until all changes are killed."""
    common = precompiled(folder)
    may_switch = {number for number, change in enumerate(changes) if change.first >= 0 and
                  (change.header, change.becomes) not in NO_SWITCH}
    board = Switchboard(folder, common, pool)
    write_switched(folder, changes, may_switch)
    while wrong := board.complaints_of_headers():
        write_switched(folder, changes, may_switch, wrong)
    killed, cases = set(), []

    def try_cases(some):
        left = sorted(may_switch - killed)
        killed.update(number for number, is_killed in zip(left, pool.map(lambda each: board.kills(each, some), left))
                      if is_killed)
        report.say(f"{len(may_switch - killed)} of {len(may_switch)} switches left by {len(some)} test cases of "
                   f"{sum(case.seconds for case in some):.1f} s")
    for tests in steps(lambda: {changes[number].header for number in may_switch - killed}, fresh, most):
        board.add(tests)
        while board.waiting:
            if wrong := board.compile():
                write_switched(folder, changes, may_switch, wrong)
        board.link()
        cases.append(board.cases())
        try_cases(cases[-1])
    if may_switch - killed:
        # These take nine tenths of the time, and see little that the fast ones do not.
        cases.append(board.slow_cases())
        try_cases(cases[-1])
    reached = set().union(*(case.reached for some in cases for case in some))
    compiler = Compiler(folder, common, HEADERS, board.too_long())
    to_judge = {number for number in reached & may_switch - killed if not is_explained(changes[number])}
    models = Models(folder, pool, {changes[number].header for number in to_judge})

    def lives(number):
        change, is_alive = changes[number], number not in killed
        if number in to_judge:
            is_alive = not models.kills(number, change.header) and compiler.survives(change, True)
        elif is_alive and number not in reached & may_switch:
            is_alive = compiler.survives(change)
        report.note(change, is_alive)
        return is_alive
    return list(pool.map(lives, range(len(changes))))


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
        folder.mkdir(parents=True, exist_ok=True)
        pool = stack.enter_context(concurrent.futures.ThreadPoolExecutor(asked.jobs))
        nearest_first = (tests_that_changed(asked.since), STEP) if asked.since else ()
        survive = outcomes(folder, pool, tried, is_explained, report, *nearest_first)
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
