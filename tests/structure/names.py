# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
"""Compares the page of public names with the headers, and holds programs and pages to these names.

    python3 names.py PROJECT
"""
import pathlib
import re
import sys

import declarations
import rules

PAGE = "docs/names.md"
# Who uses public names only.
PROGRAMS, PAGES = ("examples", "tools", "docs/snippets"), ("README.md", "docs/**/*.md")
# A program with many names of its own, in a namespace of its own: the library's stand behind `rtuwire::` there.
OWN_NAMES = {"tools"}
USES_ALL = re.compile(r"\busing\s+namespace\s+rtuwire\b")
QUALIFIED = re.compile(r"\brtuwire(::\w+)*::\Z")
# Pages about the inside of the library.
LEFT_OUT = {"engine-rules.md", "size-notes.md"}
# A name of every door has to be in each of these.
MAIN_DOORS = ("client.hpp", "server.hpp", "drives.hpp", "sim.hpp", "port.hpp")
EVERY_DOOR = "Every public header"
# Namespaces with public names; those of one drive are public by its manual, all others are internal.
SPACES = {"rtuwire", "rtuwire::altivar", "rtuwire::altivar::roles", "rtuwire::row_words", "rtuwire::cia402", "rtuwire::sim", "rtuwire::units", "rtuwire::literals"}
OF_A_DRIVE = re.compile(r"rtuwire::altivar::(atv\d+\w*|compact)\b")
# Here a comment may say that a name is internal; everywhere else it stands in rtuwire::detail.
BY_COMMENT = "altivar/"
INTERNAL_HEADER = re.compile(r"^// Internal\b", re.MULTILINE)
INTERNAL = re.compile(r"\bInternal\b")
IN_DETAIL = re.compile(r"(?<!::)\bdetail::\w+|\brtuwire::detail\b(::\w+)?")
# A refused act: a function or type whose name is a sentence that the compiler shows.
SENTENCE = re.compile(r"[^\W_]+(_[^\W_]+){4,}")
DOOR = re.compile(r"[\w/]+\.hpp")
ROW = re.compile(r"^\|(?P<names>[^|]*`[^|]*)\|", re.MULTILINE)
NAME = re.compile(r'`([\w:]+(?:"")?\w*)`')
WORD = re.compile(r"(?<![\w.])(?<!->)[A-Za-z_]\w*")
CODE = re.compile(r"```.*?```", re.DOTALL)
TRANSCRIPT = re.compile(r"```(console)?\n\$ ")  # what a terminal shows
INCLUDE = re.compile(r"#\s*include\s*<rtuwire/([^>]+)>")


def sections(page):
    """The names that the page lists, by the heading above them."""
    found = {}
    for part in re.split(r"^## ", page, flags=re.MULTILINE)[1:]:
        heading, _, body = part.partition("\n")
        found[heading.strip()] = [name for row in ROW.finditer(body) for name in NAME.findall(row["names"])]
    return found


def path_of(declaration):
    """As the page spells it: without the outer namespace, and without that of literals."""
    return re.sub(r"^rtuwire::(literals::)?", "", declaration.path())


class House:
    """What the headers declare: by header, whether the header is internal, and what it holds."""

    def __init__(self, tree):
        self.tree = tree
        self.held = {header: list(declarations.declarations(text)) for header, text in self.tree.texts.items()}
        self.internal = {header for header, text in self.tree.texts.items()
                         if INTERNAL_HEADER.search(text.partition("#pragma once")[0])}

    def named(self):
        """Every name outside of internal namespaces: its header, and its declaration."""
        for header, held in self.held.items():
            for each in held:
                if each.space in SPACES or each.space == "rtuwire::altivar::atv28":
                    yield header, each

    def is_marked(self, header, declaration):
        said = header in self.internal or INTERNAL.search(declaration.comment) is not None
        return said and header.startswith(BY_COMMENT)


def is_of_a_drive(header, declaration):
    return header.startswith(("altivar/device/", "altivar/parameters/")) and OF_A_DRIVE.match(declaration.space) is not None


def unlisted(house, public):
    """Names that are neither public nor marked."""
    for header, each in house.named():
        if path_of(each) in public or is_of_a_drive(header, each):
            continue
        if not house.is_marked(header, each) and not SENTENCE.fullmatch(each.name):
            yield f"{header}:{each.line}: {path_of(each)} is neither in {PAGE} nor marked internal"


def wrongly_listed(house, listed):
    """Names on the page that no header declares, that are marked internal, or that their door does not have."""
    places = {}
    for header, each in house.named():
        places.setdefault(path_of(each), []).append((header, each))
    for heading, names in listed.items():
        doors = MAIN_DOORS if heading == EVERY_DOOR else DOOR.findall(heading) or ("rtuwire.hpp",)
        for name in names:
            if name not in places:
                yield f"{PAGE}: {name} is declared in no header"
                continue
            if any(house.is_marked(*place) for place in places[name]):
                yield f"{PAGE}: {name} is marked internal"
            for door in doors:
                reached = house.tree.reached(door)
                if not any(header in reached for header, _ in places[name]):
                    yield f"{PAGE}: {door} does not have {name}"


def twice(listed):
    names = [name for each in listed.values() for name in each]
    for name in sorted({name for name in names if names.count(name) > 1}):
        yield f"{PAGE}: {name} stands there twice"


def internal_names(house, public):
    """Last parts of internal names that no public name has, too."""
    known = {path.split("::")[-1] for path in public}
    known |= {each.name for header, held in house.held.items() for each in held if is_of_a_drive(header, each)}
    return {each.name for header, each in house.named()} - known


def uses(path, code, internal, doors):
    """Internal names in a program, and includes of what is no door."""
    for found in INCLUDE.finditer(code):
        if found[1] not in doors:
            yield f"{path}:{code.count(chr(10), 0, found.start()) + 1}: includes {found[1]}, which is no door"
    plain = declarations.code_of(code)
    for found in IN_DETAIL.finditer(plain):
        yield f"{path}:{plain.count(chr(10), 0, found.start()) + 1}: uses {found.group()}, which is internal"
    has_own_names = pathlib.PurePath(path).parts[0] in OWN_NAMES
    if has_own_names:
        for found in USES_ALL.finditer(plain):
            yield (f"{path}:{plain.count(chr(10), 0, found.start()) + 1}: has `using namespace rtuwire`, which hides "
                   f"which names are the library's")
    for found in WORD.finditer(plain):
        if has_own_names and not QUALIFIED.search(plain, 0, found.start()):
            continue
        if found.group() in internal:
            yield f"{path}:{plain.count(chr(10), 0, found.start()) + 1}: uses {found.group()}, which is internal"


def programs(root):
    for folder in PROGRAMS:
        for path in sorted((root / folder).rglob("*.[ch]pp")):
            yield path.relative_to(root), path.read_text(encoding="utf-8")
    for pattern in PAGES:
        for path in sorted(root.glob(pattern)):
            text = path.read_text(encoding="utf-8")
            for code in CODE.finditer(text) if path.name not in LEFT_OUT else ():
                if TRANSCRIPT.match(code.group()):
                    continue
                yield path.relative_to(root), "\n" * text.count("\n", 0, code.start()) + code.group().strip("`")


def doors_of(house):
    """Headers that stand outside of all rooms, and those of a drive."""
    return {header for header in house.tree.texts if rules.room_of(header) in ("", "altivar")}


def main(project):
    root = pathlib.Path(project)
    house = House(rules.Tree.read(project))
    listed = sections((root / PAGE).read_text(encoding="utf-8"))
    public = {name for names in listed.values() for name in names}
    found = [*unlisted(house, public), *wrongly_listed(house, listed), *twice(listed)]
    internal, doors = internal_names(house, public), doors_of(house)
    found += [each for path, code in programs(root) for each in uses(path, code, internal, doors)]
    print("\n".join(found) or f"{len(public)} public names, "
          f"{sum(len(listed[heading]) for heading in MAIN_DOORS + (EVERY_DOOR,))} of them of the main doors")
    return 1 if found or not public else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1]))
