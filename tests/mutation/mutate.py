# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
"""Changes an operator or a constant in the portable headers and looks whether the tests see it.

    python3 tests/mutation/mutate.py [--sample N] [--seed S] [--jobs J] [--work DIR] [headers, or folders of them]

The tests are compiled once, with every change behind a switch; they run with one switch turned at a time, and
only those that come by it; what they do not see is tried with the second engines of tests/model. A change that is no switch (a type, an array's size, what only the compiler
evaluates) is compiled into a copy of the headers, with the tests of its room and their proofs. A change is
killed by a test that fails, crashes or does not end in time, and by a build that fails. survivors.txt says why
no test can see a change; open.txt lists those that nobody has looked at yet, and may only get shorter. Survivors
that stand in neither are printed, and rows that are for nothing; either is a failure. Without --sample all changes
are tried. --open writes open.txt anew.
"""
import argparse
import concurrent.futures
import contextlib
import pathlib
import random
import sys
import tempfile
import time

from changes import changes_of
from compiled import Compiler
from models import Models
from programs import PROJECT, Switchboard, precompiled
import switches

HEADERS = PROJECT / "include" / "rtuwire"
SURVIVORS = pathlib.Path(__file__).with_name("survivors.txt")
OPEN = pathlib.Path(__file__).with_name("open.txt")
# What stands for a machine or for a drive's manual: the simulated devices, the host's port, the register tables.
LEFT_OUT = ("sim/", "port/", "altivar/atv", "altivar/compact_values")
# A start value that the compiler needs where it evaluates a table (GCC 12 fails to).
NO_SWITCH = {("core/text.hpp", "std::size_t size_{1};")}


def headers():
    found = sorted(path.relative_to(HEADERS).as_posix() for path in HEADERS.rglob("*.hpp"))
    return [header for header in found if not header.startswith(LEFT_OUT)]


def rows_of(path, chosen):
    """The rows about these headers, as lists of their columns."""
    rows = [row.split(" | ") for row in path.read_text(encoding="utf-8").splitlines()
            if row and not row.startswith("#")]
    return [row for row in rows if row[0] in chosen]


def explained(chosen):
    """The changes of these headers that no test can see."""
    return {(row[0], " | ".join(row[1:-1])) for row in rows_of(SURVIVORS, chosen)}


def still_open(chosen):
    return {(row[0], " | ".join(row[1:])) for row in rows_of(OPEN, chosen)}


def write_open(found):
    head = [row for row in OPEN.read_text(encoding="utf-8").splitlines() if row.startswith("#")]
    OPEN.write_text("\n".join(head + sorted(f"{header} | {line}" for header, line in found)) + "\n", encoding="utf-8")


def switched_tests(folder, common, pool, changes, may_switch):
    """The tests with these changes behind switches. What the compiler refuses becomes none, by lines."""
    board = Switchboard(folder, common, pool)
    while True:
        switches.write(folder / "include", HEADERS, changes, sorted(may_switch))
        wrong = board.complaints_of_headers() or board.compile()
        if not board.todo:
            break
        refused = {number for number in may_switch for header, line in wrong
                   if changes[number].header == header and line in changes[number].lines}
        if not refused:
            raise SystemExit(f"mutate.py: no change stands where the compiler complains: {sorted(wrong)[:5]}")
        may_switch -= refused
    board.link()
    return board


def outcomes(folder, pool, changes, texts, say):
    """Whether each change survives."""
    common = precompiled(folder)
    may_switch = {number for number, change in enumerate(changes) if change.first >= 0 and
                  (change.header, change.changed_line(texts[change.header])) not in NO_SWITCH}
    board = switched_tests(folder, common, pool, changes, may_switch)
    cases = board.cases()
    say(f"{len(may_switch)} switches, {len(cases)} test cases of {sum(case.seconds for case in cases):.1f} s")
    compiler = Compiler(folder, common, HEADERS, board.too_long)
    models = Models(folder, pool)

    def lives(number):
        killed = board.kills(number, cases) if number in may_switch else None
        if killed is None:
            return compiler.survives(changes[number]), "compiled"
        return not (killed or models.kills(number)), "switched"
    found = list(pool.map(lives, range(len(changes))))
    say(f"{sum(how == 'switched' for _, how in found)} switched, {sum(how == 'compiled' for _, how in found)} compiled")
    return [alive for alive, _ in found]


def main():
    options = argparse.ArgumentParser()
    options.add_argument("--sample", type=int)
    options.add_argument("--seed", type=int, default=1)
    options.add_argument("--jobs", type=int, default=2)
    options.add_argument("--open", action="store_true", help="write what survives unexplained to open.txt")
    options.add_argument("--work", help="where to build; else a folder that is gone afterwards")
    options.add_argument("headers", nargs="*", default=[""])
    asked = options.parse_args()
    start = time.monotonic()

    def say(what):
        print(f"{time.monotonic() - start:5.0f} s  {what}", flush=True)
    chosen = [header for header in headers() if header.startswith(tuple(asked.headers))]
    texts = {header: (HEADERS / header).read_text(encoding="utf-8") for header in chosen}
    possible = tried = [change for header in chosen for change in changes_of(header, texts[header])]
    if asked.sample:
        tried = random.Random(asked.seed).sample(possible, min(asked.sample, len(possible)))
    known = explained(chosen)
    with contextlib.ExitStack() as stack:
        folder = pathlib.Path(asked.work or stack.enter_context(tempfile.TemporaryDirectory()))
        folder.mkdir(parents=True, exist_ok=True)
        pool = stack.enter_context(concurrent.futures.ThreadPoolExecutor(asked.jobs))
        survive = outcomes(folder, pool, tried, texts, say)
    alive = [(change.header, change.changed_line(texts[change.header]), change.line)
             for change, lives in zip(tried, survive) if lives]
    if asked.open and not asked.sample and chosen == headers():
        write_open({each[:2] for each in alive} - known)
    unseen = still_open(chosen)
    new = [each for each in alive if each[:2] not in known | unseen]
    for header, line, number in new:
        print(f"survives: {header}:{number}: {line}")
    idle = [] if asked.sample else sorted((known | unseen) - {each[:2] for each in alive})
    for header, line in idle:
        print(f"survivors.txt or open.txt names what is killed, or gone: {header} | {line}")
    killed, why = len(tried) - len(alive), sum(each[:2] in known for each in alive)
    say(f"{killed} of {len(tried)} changes killed ({100 * killed / max(1, len(tried)):.1f} %), {why} explained, "
        f"{len(alive) - why - len(new)} open, {len(new)} new; {len(possible)} possible")
    return 1 if new or idle else 0


if __name__ == "__main__":
    sys.exit(main())
