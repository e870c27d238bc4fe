# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
"""Holds the examples to the form of a course: each says which lesson it is and on which earlier ones it builds, and the
page lists them so, in order.

    python3 course.py PROJECT
"""
import pathlib
import re
import sys

PAGE = "docs/examples.md"
FIRST = re.compile(r"^// Lesson (\d+): \S")
BUILDS_ON = re.compile(r"Builds on lessons? ([\d, and]+)\.")
ROW = re.compile(r"^\| \[(\d\d_\w+)\]\(\.\./examples/\1\.cpp\) \|[^|]+\|([^|]*)\|$", re.MULTILINE)


def head(text):
    """The first comment behind the licence, as one line."""
    lines = text.split("\n")[2:]
    end = next((at for at, line in enumerate(lines) if not line.startswith("//")), len(lines))
    return "// " + " ".join(line[3:] for line in lines[:end])


def lesson(name, text):
    """What a program says of itself: the lessons it builds on, and what is wrong about that."""
    said = head(text)
    number = int(name[:2])
    first, builds = FIRST.match(said), BUILDS_ON.search(said)
    on = [int(each) for each in re.findall(r"\d+", builds[1])] if builds else []
    if not first or int(first[1]) != number:
        yield f"examples/{name}.cpp does not begin with `// Lesson {number}: `"
    if not on and number != 1:
        yield f"examples/{name}.cpp does not say on which lessons it builds"
    if on != sorted(set(on)) or any(not 0 < each < number for each in on):
        yield f"examples/{name}.cpp builds on what is no earlier lesson"
    yield on


def wrong(programs, page):
    """Complaints of all: `programs` by name."""
    rows = [(name, [int(each) for each in re.findall(r"\d+", on)]) for name, on in ROW.findall(page)]
    names = sorted(programs)
    if [name for name, _ in rows] != names:
        yield f"{PAGE} does not list {', '.join(names)} in this order"
    if [int(name[:2]) for name in names] != list(range(1, len(names) + 1)):
        yield "the lessons are not numbered from 1 on"
    for name in names:
        *complaints, on = lesson(name, programs[name])
        yield from complaints
        if name in dict(rows) and dict(rows)[name] != on:
            yield f"{PAGE} lets {name} build on {dict(rows)[name]}, the program says {on}"


def main(project):
    root = pathlib.Path(project)
    programs = {path.stem: path.read_text(encoding="utf-8") for path in (root / "examples").glob("[0-9][0-9]_*.cpp")}
    found = list(wrong(programs, (root / PAGE).read_text(encoding="utf-8")))
    print("\n".join(found) or f"{len(programs)} lessons are a course")
    return 1 if found or not programs else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1]))
