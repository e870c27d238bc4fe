# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
"""The page of public servers says of each clause that its table has failing what it comes of, once, and of no other. What the table
says is held against the servers by tests/interop/public_servers.sh.

    python3 public_servers_page.py PROJECT
"""
import collections
import pathlib
import re
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "interop"))

from public_servers import of_page  # noqa: E402

CLAUSE = re.compile(r'^    \{"([A-Z]\d+(?:\.\d+)?)", ', re.MULTILINE)
NONE = ["none"]


def causes_of(text, server):
    """The clauses in the first column of a server's own table."""
    _, heading, section = text.partition(f"\n## {server}\n")
    rows = re.findall(r"^\| ([A-Z]\d[^|]*) \|", section.partition("\n## ")[0], re.MULTILINE)
    return heading, [clause for row in rows for clause in row.split()]


def complaints(text, known):
    for server, (*_, musts, shoulds) in of_page(text).items():
        failing = [clause for cell in (musts, shoulds) for clause in cell.split() if cell.split() != NONE]
        heading, told = causes_of(text, server)
        if not heading:
            yield f"{server}: no heading"
        for clause in sorted(set(failing) - set(told)):
            yield f"{server}: {clause} fails, and nothing says why"
        for clause in sorted(set(told) - set(failing)):
            yield f"{server}: {clause} does not fail in the table"
        for clause, times in collections.Counter(told).items():
            if times > 1:
                yield f"{server}: {clause} has {times} causes"
        for clause in sorted(set(failing) - known):
            yield f"{server}: {clause} is no clause"


def main(place):
    project = pathlib.Path(place)
    known = set(CLAUSE.findall((project / "tools/rtuwire/check/clause_table.cpp").read_text(encoding="utf-8")))
    text = (project / "docs/public-servers.md").read_text(encoding="utf-8")
    found = list(complaints(text, known))
    print("\n".join(found) or f"{len(of_page(text))} servers, of {len(known)} clauses")
    return 1 if found or not known or not of_page(text) else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
