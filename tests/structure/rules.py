# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
"""Checks the #include lines and the outer form of the headers; the facts of the rule stand first.

    python3 rules.py PROJECT RULE...
"""
import pathlib
import re
import sys

# "wire": {"core"} reads "wire may include core" and, with it, whatever core may include.
MAY_INCLUDE = {
    "core": set(),
    "wire": {"core"},
    "rtu": {"wire"},
    "table": {"core", "wire/errc.hpp", "wire/function.hpp", "wire/limits.hpp", "wire/unit_id.hpp"},
    "ask": {"wire", "table"},
    "client": {"ask", "rtu"},
    "server": {"rtu", "table"},
    "cia402": {"core"},
    "altivar/device": {"table", "cia402", "rtu/line.hpp"},
    "altivar/procedure": {"altivar/device", "ask"},
    "altivar/cyclic": {"altivar/procedure"},
    "altivar": {"altivar/device"},
    "sim/drive": {"server", "altivar/device"},
    "sim/line": {"rtu"},
    "port": {"core", "rtu/line.hpp", "wire/errc.hpp", "wire/errc_name.hpp"},
}
UMBRELLA = "rtuwire.hpp"
OPERATING_SYSTEM = "port"

# Each of these is cheap to compile and available on a bare machine.
STANDARD = set("array bit compare concepts cstddef cstdint limits optional ratio span type_traits"
               " utility".split())
# Only these show a name to a person, and may use <string_view> for it.
SHOWS_A_NAME = {"wire/errc_name.hpp"}
# The compiler's own headers, behind the macros that say they are there.
MULTIPLIES = {"core/crc16/carryless.hpp": {"wmmintrin.h", "arm_neon.h"}}

SPDX = ("// SPDX-FileCopyrightText: 2026 The rtuwire authors",
        "// SPDX-License-Identifier: BSL-1.0")
LONGEST = 400

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
        return [header for header in self.texts if room_of(header) != OPERATING_SYSTEM]


def room_of(header):
    """The folder, or both of two, where the outer one has several rooms."""
    folders = header.split("/")[:-1]
    inner = "/".join(folders[:2])
    return inner if inner in MAY_INCLUDE else "/".join(folders[:1])


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


def layers(tree):
    for header, targets in tree.ours.items():
        room = room_of(header)
        if header == UMBRELLA:
            continue
        if room not in MAY_INCLUDE:
            yield f"{header}: is in no room of the layer rule"
            continue
        allowed = reach(room)
        for target in targets:
            if target not in tree.texts:
                yield f"{header}: includes {target}, which does not exist"
            elif target not in allowed and room_of(target) not in allowed:
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
        if header not in reached:
            yield f"{UMBRELLA}: does not include {header}"
    for header in sorted(reached):
        if room_of(header) == OPERATING_SYSTEM:
            yield f"{UMBRELLA}: includes {header}, which needs an operating system"


RULES = {rule.__name__: rule for rule in (form, layers, standard_includes, cycles, umbrella)}


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
