# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
"""Checks the #include lines and the outer form of the headers; the facts of the rule stand first.

    python3 rules.py PROJECT RULE...
"""
import pathlib
import re
import sys

import declarations

# "wire": {"core"} reads "wire may include core" and, with it, whatever core may include.
MAY_INCLUDE = {
    "core": set(),
    "wire": {"core"},
    "rtu": {"wire"},
    "trace": {"rtu"},
    "table": {"core", "wire/errc.hpp", "wire/function.hpp", "wire/limits.hpp", "wire/unit_id.hpp"},
    "ask": {"wire", "table"},
    "client": {"ask", "rtu", "trace"},
    "server": {"rtu", "table", "trace"},
    "cia402": {"core"},
    "altivar/device": {"table", "cia402", "rtu/line.hpp"},
    "altivar/parameters": {"altivar/device"},
    "altivar/procedure": {"altivar/device", "ask"},
    "altivar/cyclic": {"altivar/procedure"},
    "altivar/maintenance": {"altivar/procedure", "altivar/parameters"},
    "altivar": {"altivar/device", "altivar/parameters"},
    "sim/drive": {"server", "altivar/device"},
    "sim/line": {"rtu"},
    "sim/bench.hpp": {"client", "server", "sim/drive", "sim/line"},
    "port": {"core", "rtu/line.hpp", "wire/errc.hpp", "wire/errc_name.hpp", "table/register_text.hpp"},
}
UMBRELLA = "rtuwire.hpp"
# A thousand registers, which only a program that asks for them compiles, and what is done with all of them: these rooms,
# and the doors to them.
APART = re.compile(r"altivar/(parameters/|maintenance/|\w+_parameters\.hpp$)|maintenance\.hpp$")
# The doors of the port need an operating system, or the streams that come with one.
OPERATING_SYSTEM, DOORS_OF_THE_PORT = "port", {"port.hpp", "print.hpp"}

# Each of these is cheap to compile and available on a bare machine.
STANDARD = set("array bit compare concepts cstddef cstdint limits optional ratio span type_traits"
               " utility".split())
# Only these show a name to a person, and may use <string_view> for it.
SHOWS_A_NAME = {"wire/errc_name.hpp", "altivar/procedure/outcome.hpp"}
# The compiler's own headers, behind the macros that say they are there.
MULTIPLIES = {"core/crc16/carryless.hpp": {"wmmintrin.h", "arm_neon.h"}}

SPDX = ("// SPDX-FileCopyrightText: 2026 The rtuwire authors",
        "// SPDX-License-Identifier: BSL-1.0")
LONGEST, LARGEST_CLASS = 350, 200
# Lines of the median header; percent of lines with a comment.
MEDIAN, COMMENTS, TABLE_OF_A_DRIVE = (90, 140), (15, 25), re.compile(r"altivar/(device|parameters)/atv")
# Headers side by side; one file a function there.
MOST_IN_A_FOLDER, AS_LONG_AS_THE_SPECIFICATION = 14, {"wire/pdu"}

INCLUDE = re.compile(r'^[ \t]*#[ \t]*include[ \t]*([<"])([^>"\n]+)[>"]', re.MULTILINE)


class Tree:
    """The headers below include/rtuwire, by path: their text and what they include."""

    def __init__(self, texts):
        self.texts = dict(sorted(texts.items()))
        self.ours, self.others = {}, {}
        for header, text in self.texts.items():
            self.ours[header], self.others[header] = [], []
            for _, target in INCLUDE.findall(text):
                if target.startswith("rtuwire/"):
                    self.ours[header].append(target.removeprefix("rtuwire/"))
                else:
                    self.others[header].append(target)

    @classmethod
    def read(cls, project):
        root = pathlib.Path(project, "include", "rtuwire")
        return cls({path.relative_to(root).as_posix(): path.read_text(encoding="utf-8")
                    for path in root.rglob("*.hpp")})

    def portable(self):
        return [header for header in self.texts
                if room_of(header) != OPERATING_SYSTEM and header not in DOORS_OF_THE_PORT]


def room_of(header):
    """The folder, or both of two, where the outer one has several rooms; a header may be its own."""
    if header in MAY_INCLUDE:
        return header
    folders = header.split("/")[:-1]
    inner = "/".join(folders[:2])
    return inner if inner in MAY_INCLUDE else "/".join(folders[:1])


def is_door(header):
    """A header for programs, above all rooms."""
    return "/" not in header


def reach(room):
    """What a header in `room` may include: rooms, and single headers of other rooms."""
    found, ahead = {room}, list(MAY_INCLUDE[room])
    while ahead:
        target = ahead.pop()
        if target not in found:
            found.add(target)
            ahead += MAY_INCLUDE.get(target, ())
    return found


def form(tree):
    for header, text in tree.texts.items():
        lines = text.splitlines()
        if tuple(lines[:2]) != SPDX:
            yield f"{header}: does not start with the two SPDX lines"
        if len(lines) > LONGEST:
            yield f"{header}: {len(lines)} lines, more than {LONGEST}"


def folders(tree):
    """Rooms that a person can look through."""
    held = {}
    for header in tree.texts:
        held.setdefault(header.rpartition("/")[0], []).append(header)
    for folder, headers in held.items():
        if len(headers) > MOST_IN_A_FOLDER and folder not in AS_LONG_AS_THE_SPECIFICATION:
            yield f"{folder}: {len(headers)} headers side by side, more than {MOST_IN_A_FOLDER}"


def classes(tree):
    """Classes that a person can keep in mind: from the head to the closing brace."""
    for header, text in tree.texts.items():
        code = declarations.code_of(text)
        for space, begin, end in declarations.statements(code):
            words = code[begin:end]
            found = declarations.name_of(words)
            lines = words.strip().count("\n") + 1
            if found and found[0] == "type" and lines > LARGEST_CLASS:
                yield f"{header}: {found[1]} has {lines} lines, more than {LARGEST_CLASS}"


def shape(tree):
    """The house as a whole: the median header, and how much of it is comments. Tables of registers are left out."""
    texts = [text for header, text in tree.texts.items() if "/" in header and not TABLE_OF_A_DRIVE.search(header)]
    lengths = sorted(text.count("\n") for text in texts)
    median = lengths[len(lengths) // 2]
    if not MEDIAN[0] <= median <= MEDIAN[1]:
        yield f"the median header has {median} lines, not {MEDIAN[0]} to {MEDIAN[1]}"
    lines = [line for text in texts for line in text.splitlines()[len(SPDX):]
             if line.strip() and not line.startswith("#include")]
    share = 100 * sum("//" in line for line in lines) // max(len(lines), 1)
    if not COMMENTS[0] <= share <= COMMENTS[1]:
        yield f"{share} % of the lines hold a comment, not {COMMENTS[0]} to {COMMENTS[1]} %"


def layers(tree):
    for header, targets in tree.ours.items():
        room = room_of(header)
        for target in targets:
            if is_door(target) and not is_door(header):
                yield f"{header}: includes {target}, a door"
        if is_door(header):
            continue
        if room not in MAY_INCLUDE:
            yield f"{header}: is in no room of the layer rule"
            continue
        allowed = reach(room)
        for target in targets:
            if target not in tree.texts:
                yield f"{header}: includes {target}, which does not exist"
            elif not is_door(target) and target not in allowed and room_of(target) not in allowed:
                yield f"{header}: {room} may not include {target}"


def standard_includes(tree):
    for header in tree.portable():
        for target in tree.others[header]:
            if target == "string_view" and header in SHOWS_A_NAME:
                continue
            if target in MULTIPLIES.get(header, ()):
                continue
            if target not in STANDARD:
                yield f"{header}: includes {target}, which is not on the list for portable headers"


def cycles(tree):
    done, path = set(), []

    def visit(header):
        if header in path:
            yield "cycle: " + " -> ".join(path[path.index(header):] + [header])
        elif header not in done:
            path.append(header)
            for target in tree.ours.get(header, ()):
                yield from visit(target)
            path.pop()
            done.add(header)

    for header in tree.texts:
        yield from visit(header)


def umbrella(tree):
    if UMBRELLA not in tree.texts:
        yield f"{UMBRELLA} is missing"
        return
    reached, ahead = set(), [UMBRELLA]
    while ahead:
        header = ahead.pop()
        if header not in reached:
            reached.add(header)
            ahead += tree.ours.get(header, ())
    for header in tree.portable():
        if header not in reached and not APART.match(header):
            yield f"{UMBRELLA}: does not include {header}"
    for header in sorted(reached):
        if room_of(header) == OPERATING_SYSTEM:
            yield f"{UMBRELLA}: includes {header}, which needs an operating system"
        if APART.match(header):
            yield f"{UMBRELLA}: includes {header}, which has too many registers for every program"


RULES = {rule.__name__: rule for rule in (form, folders, classes, shape, layers, standard_includes, cycles, umbrella)}


def main(project, *names):
    tree = Tree.read(project)
    if not tree.texts:
        print(f"no headers below {project}/include/rtuwire")
        return 1
    complaints = [complaint for name in names for complaint in RULES[name](tree)]
    print("\n".join(complaints) or f"{len(tree.texts)} headers obey: {', '.join(names)}")
    return 1 if complaints else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
