# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
"""Holds each table that a page keeps, for git hosts as well, to what the drives' descriptors say. PROGRAM is made of tables.cpp.

    python3 tables_in_pages.py PROJECT PROGRAM           reports tables that differ
    python3 tables_in_pages.py PROJECT PROGRAM --write   puts them into the pages
"""
import pathlib
import re
import subprocess
import sys

import registers
import tables

KEPT = re.compile(r"^<!-- table: (?P<name>.+?) -->\n(?P<table>(?:\|.*\n)*)", re.MULTILINE)


def checked(text, made):
    """The page as it has to be, and the names of its tables."""
    names = [found["name"] for found in KEPT.finditer(text)]
    return KEPT.sub(lambda found: f"<!-- table: {found['name']} -->\n{made[found['name']]}\n", text), names


def main(place, program, option=""):
    project = pathlib.Path(place).resolve()
    done = subprocess.run([program], check=True, capture_output=True, text=True)
    made = registers.pages(tables.sorted_lines(done.stdout.splitlines()))
    seen, wrong = [], []
    for path in sorted((project / "docs").rglob("*.md")):
        text = path.read_text(encoding="utf-8")
        new, names = checked(text, made)
        seen += names
        if new != text and option == "--write":
            path.write_text(new, encoding="utf-8")
        elif new != text:
            wrong.append(f"{path.relative_to(project)}: {', '.join(names)}: not what the descriptors say (--write)")
    wrong += [f"no page has {each}" for each in made if each.startswith("limits ") and each not in seen]
    print("\n".join(wrong) or f"{len(seen)} tables")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
