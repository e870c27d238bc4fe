# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
"""The second engines of tests/model, held against changed ones: what no single test sees, a schedule may."""
from programs import TESTS, complaints, runs

ENGINES = ["client", "bus", "server"]
COMPILE = ["g++", "-std=c++20", "-w", "-O1", f"-I{TESTS}"]
SCHEDULES = "2000"
# Of the processor of a busy machine; unchanged they need one or two.
LONGEST_S = 60


class Models:
    """One program for each engine, with every change behind its switch."""

    def __init__(self, folder, pool):
        self.places = [folder / f"compare_{engine}" for engine in ENGINES]
        sources = [TESTS / "model" / f"compare_{engine}.cpp" for engine in ENGINES]
        said = pool.map(lambda pair: complaints([*COMPILE, f"-I{folder / 'include'}", "-o", *pair]),
                        zip(self.places, sources))
        for source, each in zip(sources, said):
            if each:
                raise SystemExit(f"mutate.py: {source} does not compile:\n{each}")
        for place in self.places:
            if not runs([place, SCHEDULES], LONGEST_S):
                raise SystemExit(f"mutate.py: {place} finds a difference without any change")

    def kills(self, number):
        return not all(runs([place, SCHEDULES], LONGEST_S, RTUWIRE_CHANGE=str(number)) for place in self.places)
