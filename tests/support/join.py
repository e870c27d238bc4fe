# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
"""Writes a source file that includes others, each in a namespace of its own, so that their names don't clash and what
they share is compiled once.

    python3 join.py FILE SOURCE...      writes it
    python3 join.py --alone SOURCE...   prints those that can't be joined, with ";" between

Everything that they include comes first: within a namespace nothing is left to include. A source that defines macros,
specialises or defines what a header declares, or opens a namespace by its name can't be joined.
"""
import pathlib
import re
import sys

INCLUDE = re.compile(r'#include [<"](.*)[>"]')
OBSTACLE = re.compile(r"^(# *define|# *if.*include|# *if defined|extern|namespace [a-z]|template <>|void rtuwire::)",
                      re.MULTILINE)
MOST = 14  # as in join.cmake


def is_alone(source):
    return OBSTACLE.search(source.read_text(encoding="utf-8")) is not None


def included(source):
    """Its includes, with those that are relative to it made absolute."""
    for line in source.read_text(encoding="utf-8").splitlines():
        if found := INCLUDE.match(line):
            beside = source.parent / found[1]
            yield f'#include "{beside}"' if line.endswith('"') and beside.exists() else line


def in_files(sources, folder, room):
    """The same tests in fewer files, which are written where they are joined."""
    sources = list(sources)
    together = [source for source in sources if not is_alone(source)]
    files = [source for source in sources if source not in together]
    folder.mkdir(parents=True, exist_ok=True)
    for number, first in enumerate(range(0, len(together), MOST)):
        file = folder / f"{room}_{number}.cpp"
        file.write_text(joined(together[first:first + MOST]), encoding="utf-8")
        files.append(file)
    return files


def joined(sources):
    lines = dict.fromkeys(line for source in sources for line in included(source))
    for number, source in enumerate(sources):
        name = re.sub(r"\W", "_", source.stem)
        lines |= dict.fromkeys([f"namespace {name}_{number} {{", f'#include "{source}"', f"}} // {number}"])
    return "\n".join(lines) + "\n"


if __name__ == "__main__":
    if sys.argv[1] == "--alone":
        print(";".join(each for each in sys.argv[2:] if is_alone(pathlib.Path(each))), end="")
        sys.exit()
    pathlib.Path(sys.argv[1]).write_text(joined([pathlib.Path(each) for each in sys.argv[2:]]), encoding="utf-8")
