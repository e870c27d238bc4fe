# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
"""Compares what the module exports with the page of public names, in both directions.

    python3 exports.py PROJECT [--write]

With --write the list of the module is made anew from the page and the headers.
"""
import pathlib
import re
import sys

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent / "structure"))

import declarations  # noqa: E402
import names  # noqa: E402
import rules  # noqa: E402

MODULE = "include/rtuwire/rtuwire.cppm"
# Needs an operating system: a program includes this door beside the module.
LEFT_OUT = {"port.hpp"}
# Nor does it have the full maps of the drives, and what is done with them: a program includes their doors beside it, too.
OF_A_MAP = re.compile(r"_parameters\.hpp|^altivar/parameters/|maintenance\.hpp")
# The page leaves out operators; those that no class has as a friend are found only where they are exported.
OPERATOR = re.compile(r"\boperator\s*(<=>|==|[-+*/])\s*\(")
LIST = re.compile(r"^export namespace (?P<space>[\w:]+) \{\n(?P<body>.*?)^\} //", re.MULTILINE | re.DOTALL)
USING = re.compile(r"^using (?P<path>[^;]+);$", re.MULTILINE)
ANY_USING = re.compile(r"\busing\b")


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
    """What the module has to export, by full path."""
    listed = names.sections(page)
    found = {f"rtuwire::{name}" for heading, each in listed.items()
             if heading not in LEFT_OUT and not OF_A_MAP.search(heading) for name in each}
    of_drives = {each.path() for header, held in house.held.items() if not OF_A_MAP.search(header) for each in held
                 if names.is_of_a_drive(header, each) and not house.is_marked(header, each)}
    return found | of_drives | set(free_operators(house))


def exported(module):
    """What the module file exports, by full path; a line that this reader does not know ends the program."""
    found, known = [], 0
    for part in LIST.finditer(module):
        for line in USING.finditer(part["body"]):
            found.append(f"{part['space']}::{line['path'].rpartition('::')[2]}")
            known += 1
    others = len(ANY_USING.findall(declarations.code_of(module))) - known
    return found, [f"{MODULE}: {others} lines with `using` are not in the form of the list"] if others else []


def written(paths):
    """The list as the module file has it: a namespace at a time, in order."""
    spaces = {}
    for path in paths:
        space, _, name = path.rpartition("::")
        spaces.setdefault(space, []).append(name)
    text = []
    for space in sorted(spaces):
        inner = space.rpartition("::")[2]
        lines = "".join(f"using {inner}::{name};\n" for name in sorted(spaces[space]))
        text.append(f"export namespace {space} {{\n{lines}}} // namespace {space}\n")
    return "\n".join(text)


def differences(public, module):
    has, found = exported(module)
    found += [f"{MODULE}: {path} stands there twice" for path in sorted({path for path in has if has.count(path) > 1})]
    found += [f"{MODULE}: {path} is public and not exported" for path in sorted(public - set(has))]
    found += [f"{MODULE}: {path} is exported and not public" for path in sorted(set(has) - public)]
    return found


def main(project, *options):
    root = pathlib.Path(project)
    public = public_names(names.House(rules.Tree.read(root)), (root / names.PAGE).read_text(encoding="utf-8"))
    place = root / MODULE
    module = place.read_text(encoding="utf-8")
    if "--write" in options:
        module = module[:LIST.search(module).start()] + written(public)
        place.write_text(module, encoding="utf-8")
    found = differences(public, module)
    print("\n".join(found) or f"{len(public)} names exported")
    return 1 if found or not public else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
