# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
"""Compiles the tests and runs them, unchanged and with a change."""
import collections
import functools
import os
import pathlib
import re
import signal
import subprocess
import sys

PROJECT = pathlib.Path(__file__).resolve().parents[2]
TESTS = PROJECT / "tests"
sys.path.insert(0, str(TESTS / "support"))
import join  # noqa: E402  pylint: disable=wrong-import-position

ROOMS = ["core", "wire", "rtu", "table", "ask", "client", "server", "cia402", "altivar", "sim", "scenario", "defect",
         "motion_law"]
LISTENER = TESTS / "mutation" / "listener.cpp"
# The port is not portable, threads come in any order, and real time goes on under a debugger as well.
LEFT_OUT = re.compile(r"/port_|/interrupt_threads|/an_hour_of_noise")
# A place too far ends the program, as far as that is seen cheaply.
COMPILE = ["g++", "-std=c++20", "-w", "-O0", "-D_GLIBCXX_ASSERTIONS", "-fsanitize=bounds",
           "-fsanitize-undefined-trap-on-error", f"-I{TESTS}"]
OWN_FILE = "own_file.cpp"
# In seconds of the processor: of a test case that is asked at once, and of one that is asked at all.
FAST, LONGEST = 0.2, 2.0
COMMON = ["algorithm", "array", "bit", "chrono", "compare", "concepts", "cstddef", "cstdint", "functional", "map",
          "optional", "ratio", "span", "string", "type_traits", "utility", "vector", "support/catch.hpp"]
INCLUDE = re.compile(r"#include [<\"](\w+/[\w/]+\.hpp)[>\"]")
ERROR = re.compile(r"^(?:\S*/include/rtuwire/)?([a-z0-9_/]+\.hpp):(\d+):\d+: (?:fatal )?error", re.MULTILINE)

Case = collections.namedtuple("Case", "program name seconds reached")


def sources(rooms):
    found = [path for room in rooms for path in sorted((TESTS / room).rglob("*.cpp"))]
    return [path for path in found if not LEFT_OUT.search(str(path))]


@functools.cache
def included(path):
    """Which headers a file includes, also through others."""
    found = set()
    for name in INCLUDE.findall(path.read_text(encoding="utf-8")):
        if name.startswith("rtuwire/"):
            found |= {name.removeprefix("rtuwire/")} | included(PROJECT / "include" / name)
        elif (TESTS / name).exists():
            found |= included(TESTS / name)
    return found


@functools.cache
def words_of(path):
    """The longer words of a file."""
    return set(re.findall(r"[a-z_]{5,}", path.read_text(encoding="utf-8")))


def complaints(command, limit=300):
    """What a compiler says; an empty string where it takes the code."""
    try:
        done = subprocess.run(command, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True,
                              errors="replace", timeout=limit, check=False)
    except subprocess.TimeoutExpired:
        return "takes too long"
    return done.stderr or "error" if done.returncode != 0 else ""


def places(said):
    """Where in the headers a compiler complains: (header, line)."""
    return {(header, int(line)) for header, line in ERROR.findall(said)}


def exit_of(command, limit, **more):
    """How a program ends; None: not in time."""
    try:
        return subprocess.run(command, stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL,
                              stderr=subprocess.DEVNULL, timeout=limit, check=False,
                              env={**os.environ, **more}).returncode
    except subprocess.TimeoutExpired:
        return None


def runs(command, limit, **more):
    return exit_of(command, limit, **more) == 0


def escaped(name):
    return re.sub(r'([,\[\]\\"*])', r"\\\1", name)


def precompiled(folder):
    """What every test includes and no change touches, translated once; and where the lists are that tests read."""
    (folder / OWN_FILE).write_text('#include "support/own_file.hpp"\n'
                                   f'char const* const rtuwire::test::folder_of_tests = "{TESTS}";\n', encoding="utf-8")
    header = folder / "common.hpp"
    header.write_text("".join(f"#include <{name}>\n" for name in COMMON), encoding="utf-8")
    subprocess.run([*COMPILE, "-x", "c++-header", "-o", f"{header}.gch", header], check=True)
    return ["-include", str(header)]


class Switchboard:
    """Programs of tests with every change behind its switch; `name` is that of the one which `add` made last."""

    def __init__(self, folder, common, pool):
        self.folder, self.common, self.pool = folder, common, pool
        self.parts, self.slow, self.name = {}, {}, ""
        self.waiting = [("", LISTENER), ("", folder / OWN_FILE)]  # each program has these

    def add(self, tests):
        """A program more, of these tests."""
        self.name = f"tests{len(self.parts)}"
        self.parts[self.name] = list(join.in_files(tests, self.folder / "joined", self.name))
        self.waiting += [(self.name, path) for path in self.parts[self.name]]

    def place_of(self, name, path):
        below = path.relative_to(TESTS if path.is_relative_to(TESTS) else self.folder)
        return self.folder / f"{name}-{'-'.join(below.parts)}.o"

    def complaints_of_headers(self):
        """Where a compiler complains without any test: (header, line)."""
        whole = self.folder / "include" / "rtuwire" / "rtuwire.hpp"
        return places(complaints([*COMPILE, f"-I{self.folder / 'include'}", "-fsyntax-only", "-x", "c++", whole]))

    def compile(self):
        """Compiles what is not yet; where it complains in the headers."""
        def one(part):
            name, path = part
            common = [] if path == LISTENER else self.common
            return complaints([*COMPILE, *common, "-DRTUWIRE_NO_STATIC_TESTS",
                               f"-I{self.folder / 'include'}", "-c", "-o", self.place_of(name, path), path])
        said = list(self.pool.map(one, self.waiting))
        wrong = {place for each in said for place in places(each)}
        failed = [part for part, each in zip(self.waiting, said) if each]
        if failed and not wrong:
            raise SystemExit(f"mutate.py: {failed[0][1]} does not compile:\n" + next(each for each in said if each))
        self.waiting = failed
        return wrong

    def link(self):
        objects = [self.place_of(self.name, path) for path in self.parts[self.name]]
        objects += [self.place_of("", path) for path in (LISTENER, self.folder / OWN_FILE)]
        subprocess.run(["g++", "-o", self.folder / self.name, *objects, "-lCatch2WithMain", "-pthread"], check=True)

    def cases(self):
        """The fast test cases of the program that was made last."""
        return self.cases_of(self.name, self.names(self.name), FAST)

    def slow_cases(self):
        """Those of all programs that are not; what is then left in `slow` takes too long to be asked often."""
        found = self.pool.map(lambda program: self.cases_of(program, self.slow[program], LONGEST), list(self.slow))
        return sorted((case for each in found for case in each), key=lambda case: case.seconds)

    def too_long(self):
        return [name for names in self.slow.values() for name in names]

    def cases_of(self, program, names, limit):
        """How long each of these test cases takes, and which changes it comes by; where one takes longer than the limit, the
        listener ends the program."""
        report, chosen = self.folder / f"{program}.reached", self.folder / f"{program}.names"
        left, found = names, []
        while left:
            chosen.write_text("".join(f"{escaped(name)}\n" for name in left), encoding="utf-8")
            ended = exit_of([self.folder / program, "-f", chosen], 300, RTUWIRE_REACHED=str(report),
                            RTUWIRE_MICROSECONDS=str(int(1e6 * limit)))
            if ended not in (0, -signal.SIGPROF):
                raise SystemExit(f"mutate.py: {self.folder / program} fails without any change")
            rows = [row.split("\t") for row in report.read_text(encoding="utf-8").splitlines()]
            found += [Case(program, row[1], float(row[0]), frozenset(map(int, row[2].split()))) for row in rows]
            if ended == 0:
                break
            done = {row[1] for row in rows}
            left = [name for name in left if name not in done][1:]
        asked = {case.name for case in found}
        self.slow[program] = [name for name in names if name not in asked]
        return sorted(found, key=lambda case: case.seconds)

    def names(self, program):
        """In the order in which they run."""
        done = subprocess.run([self.folder / program, "--list-test-names-only"], stdout=subprocess.PIPE, text=True,
                              check=False)  # says how many, not whether it worked
        return [name for name in done.stdout.splitlines() if name]

    def kills(self, number, cases):
        """Whether one of these test cases fails with this change."""
        asked = [case for case in cases if number in case.reached]
        for program in dict.fromkeys(case.program for case in asked):
            here = [case for case in asked if case.program == program]
            if any(some and not self.passes(program, number, some) for some in (here[:20], here[20:])):
                return True
        return False

    def passes(self, program, number, cases):
        names = [escaped(case.name) for case in cases]
        # For each case, of the processor; a program that sleeps ends by the clock.
        seconds = 0.3 + 5 * max(case.seconds for case in cases)
        return runs([self.folder / program, "--abort", ",".join(names)], 120,
                    RTUWIRE_CHANGE=str(number), RTUWIRE_MICROSECONDS=str(int(1e6 * seconds)))
