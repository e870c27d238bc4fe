# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
"""The page of public servers and clients says of each clause that its tables have failing what it comes of, once, and of no other.
What the tables say is held against the servers and clients by tests/interop/public_servers.sh.

    python3 public_servers_page.py PROJECT
"""
import collections
import pathlib
import re
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "interop"))

from public_servers import KINDS, of_page  # noqa: E402

CLAUSE = re.compile(r'^    \{"([A-Z]\d+(?:\.\d+)?)", ', re.MULTILINE)
TABLES = ("clause_table.cpp", "client_table.cpp")  # of tools/rtuwire/check
HEADING = {"server": "## ", "client": "### Client of "}
NONE = ["none"]


def causes_of(text, kind, name):
    """The clauses in the first column of a server's or a client's own table."""
    _, heading, section = text.partition(f"\n{HEADING[kind]}{name}\n")
    rows = re.findall(r"^\| ([A-Z]\d[^|]*) \|", re.split(r"\n##+ ", section)[0], re.MULTILINE)
    return heading, [clause for row in rows for clause in row.split()]


def complaints(text, known):
    for kind in KINDS:
        for name, (*_, musts, shoulds) in of_page(text, kind).items():
            failing = [clause for cell in (musts, shoulds) for clause in cell.split() if cell.split() != NONE]
            heading, told = causes_of(text, kind, name)
            who = f"{name}, {kind}"
            if not heading and (failing or kind == "server"):
                yield f"{who}: no heading"
            for clause in sorted(set(failing) - set(told)):
                yield f"{who}: {clause} fails, and nothing says why"
            for clause in sorted(set(told) - set(failing)):
                yield f"{who}: {clause} does not fail in the table"
            for clause, times in collections.Counter(told).items():
                if times > 1:
                    yield f"{who}: {clause} has {times} causes"
            for clause in sorted(set(failing) - known):
                yield f"{who}: {clause} is no clause"


def main(place):
    project = pathlib.Path(place)
    tables = [set(CLAUSE.findall((project / "tools/rtuwire/check" / name).read_text(encoding="utf-8"))) for name in TABLES]
    text = (project / "docs/public-servers.md").read_text(encoding="utf-8")
    found = list(complaints(text, set().union(*tables)))
    counts = [len(of_page(text, kind)) for kind in KINDS]
    print("\n".join(found) or f"{counts[0]} servers and {counts[1]} clients, of {' and '.join(str(len(each)) for each in tables)} clauses")
    return 1 if found or not all(tables) or not all(counts) else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
