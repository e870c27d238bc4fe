# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
"""Writes a source file that includes others, each in a namespace of its own, so that their names don't clash and what
they share is compiled once.

    python3 join.py FILE SOURCE...       writes it
    python3 join.py --groups SOURCE...   prints what is compiled together, a line each, with ";" between

Everything that they include comes first: within a namespace nothing is left to include. A source that defines macros,
specialises or defines what a header declares, or opens a namespace by its name is a group alone, and not joined. The
project's files are named from tests/: the joined file is the same in every clone.
"""
import os
import pathlib
import re
import sys

INCLUDE = re.compile(r'#include [<"](.*)[>"]')
OBSTACLE = re.compile(r"^(# *define|# *if.*include|# *if defined|extern|namespace [a-z]|template <>|void rtuwire::)",
                      re.MULTILINE)
TESTS = pathlib.Path(__file__).resolve().parents[1]
MOST = 14  # so many that two processors share a room


def is_alone(source):
    return OBSTACLE.search(source.read_text(encoding="utf-8")) is not None


def named(file):
    return os.path.relpath(file.resolve(), TESTS) if file.resolve().is_relative_to(TESTS.parent) else file


def included(source):
    """Its includes, with those that are relative to it named from tests/."""
    for line in source.read_text(encoding="utf-8").splitlines():
        if found := INCLUDE.match(line):
            beside = source.parent / found[1]
            yield f'#include "{named(beside)}"' if line.endswith('"') and beside.exists() else line


def groups(sources, most=MOST):
    together = []
    for source in sources:
        if is_alone(source):
            yield [source]
        else:
            together.append(source)
    for first in range(0, len(together), most):
        yield together[first:first + most]


def in_files(sources, folder, room):
    """The same tests in fewer files, which are written where they are joined."""
    folder.mkdir(parents=True, exist_ok=True)
    for number, group in enumerate(groups(sources)):
        if len(group) == 1:
            yield group[0]
            continue
        file = folder / f"{room}_{number}.cpp"
        file.write_text(joined(group), encoding="utf-8")
        yield file


def joined(sources):
    lines = dict.fromkeys(line for source in sources for line in included(source))
    for number, source in enumerate(sources):
        name = re.sub(r"^(?=\d)|\W", "_", source.stem)
        lines |= dict.fromkeys([f"namespace {name}_{number} {{", f'#include "{named(source)}"', f"}} // {number}"])
    return "\n".join(lines) + "\n"


if __name__ == "__main__":
    files = [pathlib.Path(each) for each in sys.argv[2:]]
    if sys.argv[1] == "--groups":
        for each in groups(files):
            print(*each, sep=";")
    else:
        pathlib.Path(sys.argv[1]).write_text(joined(files), encoding="utf-8")
