# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
"""The second engines of tests/model and the judge of tests/lives, held against changed headers: what no single test
sees, a schedule or a life may."""
from programs import TESTS, complaints, runs

# How many schedules, or lives; unchanged each takes one or two seconds.
JUDGES = {"model/compare_client": 2000, "model/compare_bus": 2000, "model/compare_server": 2000,
          "lives/random_lives": 2000}
# Of these rooms only the lives include anything.
ONLY = {"altivar": ["lives/random_lives"], "cia402": ["lives/random_lives"], "table": ["lives/random_lives"]}
COMPILE = ["g++", "-std=c++20", "-w", "-O1", f"-I{TESTS}"]
# Of the processor of a busy machine.
LONGEST_S = 60


def judges_of(header):
    return ONLY.get(header.split("/")[0], JUDGES)


class Models:
    """One program for each judge that changes of these headers need, with every change behind its switch."""

    def __init__(self, folder, pool, headers):
        judges = {judge for header in headers for judge in judges_of(header)}
        self.programs = {judge: folder / judge.split("/")[1] for judge in judges}
        said = pool.map(lambda judge: complaints([*COMPILE, f"-I{folder / 'include'}", "-o", self.programs[judge],
                                                  TESTS / f"{judge}.cpp"]), judges)
        for judge, each in zip(judges, said):
            if each:
                raise SystemExit(f"mutate.py: {judge}.cpp does not compile:\n{each}")
        for judge in judges:
            if not self.passes(judge):
                raise SystemExit(f"mutate.py: {judge} finds something without any change")

    def passes(self, judge, **more):
        return runs([self.programs[judge], str(JUDGES[judge])], LONGEST_S, **more)

    def kills(self, number, header):
        """Whether one of those that include the header finds something with this change."""
        return not all(self.passes(judge, RTUWIRE_CHANGE=str(number)) for judge in judges_of(header))
