# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
"""Checks the #include lines, the namespace and the outer form of the headers; the facts of the rule stand first.

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
    "trace": {"rtu"},
    "table": {"core", "wire/errc.hpp", "wire/function.hpp", "wire/unit_id.hpp"},
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
    "port": {"core", "rtu/line.hpp", "wire/adu.hpp", "wire/errc.hpp", "wire/errc_name.hpp", "table/register_text.hpp"},
}
UMBRELLA = "rtuwire.hpp"
# A thousand registers, which only a program that asks for them compiles, and what is done with all of them: these rooms,
# and the doors to them.
APART = re.compile(r"altivar/(parameters/|maintenance/|\w+_parameters\.hpp$)|table/row|rows\.hpp$|maintenance\.hpp$")
# Functions that only a program reads that asks for them: behind none of these doors.
ASKED_FOR, DOORS_WITHOUT = "wire/serial_line/", ("client.hpp", "frames.hpp")
# The doors of the port need an operating system, or the streams that come with one.
OPERATING_SYSTEM, DOORS_OF_THE_PORT = "port", {"port.hpp", "print.hpp"}

# Each of these is cheap to compile and available on a bare machine.
STANDARD = set("array bit compare concepts cstddef cstdint limits optional ratio span type_traits"
               " utility".split())
# Only these show a name to a person, and may use <string_view> for it.
SHOWS_A_NAME = {"wire/errc_name.hpp", "altivar/procedure/outcome.hpp"}
# Does not exist: it ends the compilation behind an error of ours.
END_OF_ERRORS = "rtuwire_needs_cpp20"

# Everything is in the namespace that names the build; before it stand directives and macros only, one of them the include of
# what defines it. The version itself, tests/packaging/versions.py checks.
VERSION = "core/version.hpp"
OURS = re.compile(r"\bnamespace[ \t]+rtuwire\b[^\n{]*\{(?:\s*inline namespace \w+ \{)?")
OF_THE_BUILD = "namespace rtuwire {\ninline namespace RTUWIRE_BUILD {"
COMMENT = re.compile(r"//[^\n]*|/\*.*?\*/", re.DOTALL)
DIRECTIVE = re.compile(r"^[ \t]*#(?:[^\n\\]|\\.|\\\n)*", re.MULTILINE)

SPDX = ("// SPDX-FileCopyrightText: 2026 The rtuwire authors",
        "// SPDX-License-Identifier: BSL-1.0")

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

    def reached(self, door):
        """What a program has that includes this header."""
        found, ahead = set(), [door]
        while ahead:
            header = ahead.pop()
            if header not in found:
                found.add(header)
                ahead += self.ours.get(header, ())
        return found

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
        if tuple(text.splitlines()[:2]) != SPDX:
            yield f"{header}: does not start with the two SPDX lines"


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
            if target not in STANDARD and (header, target) != (VERSION, END_OF_ERRORS):
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
    reached = tree.reached(UMBRELLA)
    for header in tree.portable():
        if header not in reached and not APART.match(header):
            yield f"{UMBRELLA}: does not include {header}"
    for header in sorted(reached):
        if room_of(header) == OPERATING_SYSTEM:
            yield f"{UMBRELLA}: includes {header}, which needs an operating system"
        if APART.match(header):
            yield f"{UMBRELLA}: includes {header}, which has too many registers for every program"
    for door in DOORS_WITHOUT:
        for header in sorted(tree.reached(door)):
            if header.startswith(ASKED_FOR):
                yield f"{door}: includes {header}, which a program asks for by serial_line.hpp"


def build(tree):
    for header, text in tree.texts.items():
        code = COMMENT.sub("", text)
        opened = list(OURS.finditer(code))
        for one in opened:
            if one[0] != OF_THE_BUILD:
                yield f"{header}: opens `{one[0][:-1].strip()}`, not the namespace of the build on a line of its own"
        before = code[:opened[0].start()] if opened else code
        declared = DIRECTIVE.sub("", before).strip()
        if declared:
            yield f"{header}: declares something outside the namespace of the build: {declared.splitlines()[0]}"
        if opened and header != VERSION and ("<", f"rtuwire/{VERSION}") not in INCLUDE.findall(before):
            yield f"{header}: does not include {VERSION} before it opens the namespace"


RULES = {rule.__name__: rule for rule in (form, layers, standard_includes, cycles, umbrella, build)}


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
