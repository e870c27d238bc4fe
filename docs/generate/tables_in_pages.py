# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
"""Holds what pages keep between `<!-- made: ... -->` and `<!-- end -->`, for git hosts, to what it is made of: the drives' descriptors,
errc.hpp, the tables of the state machines. The site makes its own from the same sources. PROGRAM is made of tables.cpp.

    python3 tables_in_pages.py PROJECT PROGRAM           reports what differs
    python3 tables_in_pages.py PROJECT PROGRAM --write   puts it into the pages
"""
import dataclasses
import pathlib
import re
import subprocess
import sys

import diagrams
import gallery
import mutation
import registers
import tables

KEPT = re.compile(r"^(?P<begin><!-- made: (?P<name>.+?) -->\n)(?P<text>.*?)(?P<end>^<!-- end -->$)", re.MULTILINE | re.DOTALL)
MARK = re.compile(r"^<!-- (?:made: .+?|end) -->$", re.MULTILINE)


def rest_of(name, drive, shown):
    """Where the registers are that a page of a drive leaves to the tool and the site."""
    left = int(drive["size"]) - shown
    return f"\n\nThe {left} others: `rtuwire list --drive {name}` prints them, and the site that `sh docs/build.sh` makes has them in this " \
        "table." if left else ""


def of_drives(facts):
    """The registers that any program for a drive has, and their bits and values."""
    base = {name: [each for each in all_of_it if each["table"] == "base"] for name, all_of_it in facts.registers.items()}
    made = registers.pages(dataclasses.replace(facts, registers=base))
    for name, drive in facts.drives.items():
        made[f"registers {name}"] += rest_of(name, drive, len(base[name]))
    return made


def flowchart(edges):
    """The picture of (from, to, words) in the language that git hosts draw."""
    names = {name: f"s{at}" for at, name in enumerate(dict.fromkeys(each for begin, end, _ in edges for each in (begin, end)))}
    lines = [f'    {short}["{name}"]' for name, short in names.items()]
    lines += [f'    {names[begin]} -->|"{words}"| {names[end]}'.replace("\\n", "<br>") for begin, end, words in edges]
    return "\n".join(["```mermaid", "flowchart TD", *lines, "```"])


def of_machines(facts):
    made = {"transitions of the drives": diagrams.profile_table(facts),
            "diagram of a drive": flowchart(diagrams.merged(diagrams.profile_edges(facts.profile)))}
    for machine, steps in facts.steps.items():
        made[f"table of {machine}"] = diagrams.grid(steps)
        made[f"diagram of {machine}"] = flowchart(diagrams.joined(steps))
    return made


REFUSED = """Each is a file of [tests/fail](../tests/fail): what it does, the sentence to look for (`// EXPECT:`), and the refused lines behind
`#ifdef REFUSED`. The site has what GCC and Clang say of each."""


def kept(project, facts):
    """What a page keeps, by its name."""
    return {**of_drives(facts), **of_machines(facts), **mutation.pages(project), "errors": gallery.errors_page(gallery.errors(project), place=""),
            "refused acts": REFUSED}


def renewed(text, made):
    """The page as it has to be, and the names of what it keeps."""
    found = list(KEPT.finditer(text))
    if len(MARK.findall(text)) != 2 * len(found):
        raise ValueError("a mark `made:` without its `end`, or the other way round")
    names = [each["name"] for each in found]
    unknown = [name for name in names if name not in made]
    if unknown:
        raise ValueError(f"nothing makes {', '.join(unknown)}")
    return KEPT.sub(lambda each: f"{each['begin']}{made[each['name']]}\n{each['end']}", text), names


def main(place, program, option=""):
    project = pathlib.Path(place).resolve()
    done = subprocess.run([program], check=True, capture_output=True, text=True)
    made = kept(project, tables.sorted_lines(done.stdout.splitlines()))
    seen, wrong = [], []
    for path in [project / "README.md", *sorted((project / "docs").rglob("*.md"))]:
        text = path.read_text(encoding="utf-8")
        try:
            new, names = renewed(text, made)
        except ValueError as error:
            wrong.append(f"{path.relative_to(project)}: {error}")
            continue
        seen += names
        if new != text and option == "--write":
            path.write_text(new, encoding="utf-8")
        elif new != text:
            wrong.append(f"{path.relative_to(project)}: {', '.join(names)}: not what it is made of (--write)")
    wrong += [f"no page has {each}" for each in made if each.split()[0] in ("limits", "registers", "meanings", "errors") and each not in seen]
    print("\n".join(wrong) or f"{len(seen)} tables and pictures")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
