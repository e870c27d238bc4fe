# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
"""Writes the interface of the module `rtuwire`: it exports the public names of everything that needs no operating system.

    /usr/bin/python3 -B packaging/module_interface.py OUTPUT

The names are those of docs/names.md, and of the headers operators and what the drives have, which the page leaves out.
"""
import pathlib
import re
import sys

PROJECT = pathlib.Path(__file__).resolve().parents[1]
sys.path.insert(0, str(PROJECT / "tests" / "structure"))

import declarations  # noqa: E402
import names  # noqa: E402
import rules  # noqa: E402

# Needs an operating system: a program includes this door beside the module.
LEFT_OUT = {"port.hpp"}
# Nor does it have rows: the full maps of the drives, what is done with them, and devices of its own. A program includes their
# doors beside it, too.
OF_A_MAP = re.compile(r"_parameters\.hpp|^altivar/parameters/|maintenance\.hpp|\brows\.hpp")
# The page leaves out operators; those that no class has as a friend are found only where they are exported.
OPERATOR = re.compile(r"\boperator\s*(<=>|==|[-+*/])\s*\(")
HEAD = """\
// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// The module `rtuwire`: the public names of everything that needs no operating system, as `rtuwire.hpp` has them. It
// exports no macros and no internal names. docs/modules.md tells how to build it and what a program does without the
// macros. Made by packaging/module_interface.py of the headers of the same version.
module;

#include <rtuwire/rtuwire.hpp>

export module rtuwire;

"""


def free_operators(house):
    """Operators that a namespace of public names holds."""
    for header in house.tree.reached("rtuwire.hpp"):
        code = declarations.code_of(house.tree.texts[header])
        for space, begin, end in declarations.statements(code):
            head = declarations.declared(code[begin:end])
            found = OPERATOR.search(head.partition("{")[0])
            if space in names.SPACES and found and not head.startswith(("class", "struct", "union")):
                yield f"{space}::operator{found[1]}"


def public_names(house, page):
    """What the module exports, by full path."""
    listed = names.sections(page)
    found = {f"rtuwire::{name}" for heading, each in listed.items()
             if heading not in LEFT_OUT and not OF_A_MAP.search(heading) for name in each}
    of_drives = {each.path() for header, held in house.held.items() if not OF_A_MAP.search(header) for each in held
                 if names.is_of_a_drive(header, each) and not house.is_marked(header, each)}
    return found | of_drives | set(free_operators(house))


def interface(paths):
    """The text that exports these: a namespace at a time, in order."""
    spaces = {}
    for path in paths:
        space, _, name = path.rpartition("::")
        spaces.setdefault(space, []).append(name)
    lists = []
    for space, held in sorted(spaces.items()):
        inner = space.rpartition("::")[2]
        lines = "".join(f"using {inner}::{name};\n" for name in sorted(held))
        lists.append(f"export namespace {space} {{\n{lines}}} // namespace {space}\n")
    return HEAD + "\n".join(lists)


def of_project():
    """The text for the headers beside this program."""
    page = (PROJECT / names.PAGE).read_text(encoding="utf-8")
    return interface(public_names(names.House(rules.Tree.read(PROJECT)), page))


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    pathlib.Path(sys.argv[1]).write_text(of_project(), encoding="utf-8", newline="\n")
