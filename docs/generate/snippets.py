# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
"""Holds each block of code that a page takes from a program to what stands there, between two lines `//! [name]`. A git host shows
the block, the site takes the region itself.

    python3 snippets.py PROJECT           reports blocks that differ
    python3 snippets.py PROJECT --write   puts the regions into the pages
"""
import pathlib
import re
import sys
import textwrap

BLOCK = re.compile(r"^<!-- snippet: (?P<file>\S+) (?P<name>\S+) -->\n```cpp\n(?P<code>.*?)^```$", re.MULTILINE | re.DOTALL)
MARK = re.compile(r"^<!-- snippet:.*$", re.MULTILINE)


def region(project, file, name):
    path = project / file
    if not path.exists():
        raise ValueError(f"there is no {file}")
    found = re.findall(rf"^ *//! \[{re.escape(name)}\]\n(.*?)^ *//! \[{re.escape(name)}\]$", path.read_text(encoding="utf-8"),
                       re.MULTILINE | re.DOTALL)
    if len(found) != 1:
        raise ValueError(f"{file} has {len(found)} regions [{name}]")
    return textwrap.dedent(found[0])


def pages(project):
    return [project / "README.md", *sorted((project / "docs").rglob("*.md"))]


def renewed(project, text):
    """The page with each block as its program has it."""
    return BLOCK.sub(lambda found: found[0].replace(f"```cpp\n{found['code']}```", "```cpp\n" +
                                                    region(project, found["file"], found["name"]) + "```"), text)


def check(project, path):
    text = path.read_text(encoding="utf-8")
    if len(MARK.findall(text)) != len(BLOCK.findall(text)):
        yield f"{path.relative_to(project)}: a mark of a snippet has no block of C++ behind it"
    for found in BLOCK.finditer(text):
        line = text.count("\n", 0, found.start()) + 1
        try:
            if region(project, found["file"], found["name"]) != found["code"]:
                yield f"{path.relative_to(project)}:{line}: the block is not what {found['file']} has as [{found['name']}]"
        except ValueError as wrong:
            yield f"{path.relative_to(project)}:{line}: {wrong}"


def main(place, option=""):
    project = pathlib.Path(place).resolve()
    if option == "--write":
        for path in pages(project):
            text = path.read_text(encoding="utf-8")
            if (new := renewed(project, text)) != text:
                path.write_text(new, encoding="utf-8")
    found = [each for path in pages(project) for each in check(project, path)]
    blocks = sum(len(BLOCK.findall(path.read_text(encoding="utf-8"))) for path in pages(project))
    print("\n".join(found) or f"{blocks} blocks are regions of programs")
    return 1 if found or not blocks else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
