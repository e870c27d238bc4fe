# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
"""Writes the whole library as one header, and a directory in which every header of the library is that one.

    /usr/bin/python3 -B packaging/single_header.py OUTPUT [--shim DIRECTORY]

The header has a part for what needs no operating system, which comes always, and one for each of `port.hpp`, `print.hpp`
and the doors to all parameters and to what is done with all of them, where the program defines RTUWIRE_PORT, RTUWIRE_PRINT or RTUWIRE_PARAMETERS before the
include. Including it again, with another of these defined, adds that part. The shim is for the tests: they include the
headers by their names and get the one.
"""
import argparse
import pathlib
import re
import sys

PROJECT = pathlib.Path(__file__).resolve().parent.parent
HEADERS = PROJECT / "include"
# The macro that asks for a part, and its doors; the first part has no condition.
PARTS = ((None, ("rtuwire/rtuwire.hpp",)),
         ("RTUWIRE_PORT", ("rtuwire/port.hpp",)),
         ("RTUWIRE_PRINT", ("rtuwire/print.hpp",)),
         ("RTUWIRE_PARAMETERS", (*(f"rtuwire/altivar/{drive}_parameters.hpp" for drive in ("atv12", "atv310", "atv320", "own")),
                                 "rtuwire/maintenance.hpp", "rtuwire/rows.hpp")))
OWN = re.compile(r"#include <(rtuwire/[\w/.]+)>\n")
STANDARD = re.compile(r"#include <([\w/.]+)>\n")
CONDITION = re.compile(r"\s*#\s*(if|endif)")
NOTICE = re.compile(r"// SPDX-[^\n]*\n")
HEAD = """\
// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// rtuwire {version} in one file, made by packaging/single_header.py from the headers of that version. Needs C++20. What
// needs an operating system (rtuwire/port.hpp) comes with RTUWIRE_PORT defined before the include, streams
// (rtuwire/print.hpp) with RTUWIRE_PRINT, all parameters of the drives (rtuwire/altivar/atv320_parameters.hpp and the
// like, rtuwire/maintenance.hpp) with RTUWIRE_PARAMETERS. The file may be included again with more of these defined.
"""


class Refused(Exception):
    """What the headers have that this program does not know how to write into one."""


def version_of(headers):
    """The version in figures, from the one place where it stands."""
    text = (headers / "rtuwire/core/version.hpp").read_text(encoding="utf-8")
    number = int(re.search(r"^#define RTUWIRE_VERSION (\d+)$", text, re.MULTILINE)[1])
    return f"{number // 10000}.{number // 100 % 100}.{number % 100}"


class Expansion:
    """Follows includes; each header and each of the standard's is written once."""

    def __init__(self, headers):
        self.headers = headers
        self.seen = {}
        self.standard = {}

    def part(self, doors, owner):
        """What doors add to what is always there: the standard's headers, and the text."""
        text = "".join(line for door in doors for line in self._lines(door, owner))
        # A program may ask for this part alone: what another of them includes does not count.
        always = {name for name, parts in self.standard.items() if owner and None in parts}
        return sorted(name for name, parts in self.standard.items() if owner in parts and name not in always), text

    def _lines(self, name, owner):
        if name in self.seen:
            if self.seen[name] not in (None, owner):
                raise Refused(f"{name}: {owner} needs it, and only {self.seen[name]} brings it")
            return
        self.seen[name] = owner
        depth = 0
        yield f"\n// {name}\n"
        for line in NOTICE.sub("", (self.headers / name).read_text(encoding="utf-8")).splitlines(keepends=True):
            condition = CONDITION.match(line)
            if condition:
                depth += 1 if condition[1] == "if" else -1
            own, standard = OWN.fullmatch(line), STANDARD.fullmatch(line)
            if own and depth:
                raise Refused(f"{name}: <{own[1]}> is included under a condition")
            if own:
                yield from self._lines(own[1], owner)
            elif standard and not depth:
                self.standard.setdefault(standard[1], set()).add(owner)
            elif "#include" in line and not standard:
                raise Refused(f"{name}: {line.strip()} is in no form of this program's")
            elif line != "#pragma once\n":
                yield line


def compact(text):
    """No more than one empty line in a row, none after a comment that had only a notice."""
    return re.sub(r"\n{3,}", "\n\n", re.sub(r"(\n// rtuwire/[\w/.]+\n)//\n", r"\1", text))


def single(headers):
    """The text of the one header, and which part each of the headers is in."""
    whole, expansion = [HEAD.format(version=version_of(headers))], Expansion(headers)
    # Says what an older language lacks before one of the standard's headers does.
    language = expansion.part(("rtuwire/core/version.hpp",), None)[1]
    for wanted, doors in PARTS:
        guard = "RTUWIRE_HAS_" + (wanted or "RTUWIRE").removeprefix("RTUWIRE_")
        condition = f"!defined({guard})" + (f" && defined({wanted})" if wanted else "")
        standard, text = expansion.part(doors, wanted)
        includes = "".join(f"#include <{name}>\n" for name in standard)
        whole.append(f"\n#if {condition}\n#define {guard}\n{compact(language)}\n{includes}{compact(text)}\n#endif // {guard}\n")
        language = ""
    left = sorted({path.relative_to(headers).as_posix() for path in headers.rglob("*.hpp")} - set(expansion.seen))
    if left:
        raise Refused(f"no door reaches {', '.join(left)}")
    return "".join(whole), expansion.seen


def write_shim(headers, directory, text, parts):
    """A directory to compile with in place of include/."""
    one = directory / "rtuwire" / "single.hpp"
    for name, wanted in parts.items():
        place = directory / name
        asked = f"#ifndef {wanted}\n#define {wanted}\n#endif\n" if wanted else ""
        write(place, f"{asked}#include <rtuwire/single.hpp>\n")
    write(one, text)


def write(place, text):
    """Leaves a file alone that has this text, so that no build has to start anew."""
    if place.exists() and place.read_text(encoding="utf-8") == text:
        return
    place.parent.mkdir(parents=True, exist_ok=True)
    place.write_text(text, encoding="utf-8", newline="\n")


def main():
    arguments = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    arguments.add_argument("output", type=pathlib.Path)
    arguments.add_argument("--shim", type=pathlib.Path)
    arguments.add_argument("--headers", type=pathlib.Path, default=HEADERS)
    asked = arguments.parse_args()
    try:
        text, parts = single(asked.headers)
    except Refused as refused:
        print(f"single_header.py: {refused}", file=sys.stderr)
        return 1
    write(asked.output, text)
    if asked.shim:
        write_shim(asked.headers, asked.shim, text, parts)
    return 0


if __name__ == "__main__":
    sys.exit(main())
