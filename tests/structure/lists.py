# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
"""Compares the public list of the drives and the list of PDUs with the headers, finds lists of all drives beside the
one, and conversations that no test uses again.

    python3 lists.py PROJECT
"""
import pathlib
import re
import sys

import declarations

DRIVES, FUNCTIONS = "include/rtuwire/altivar/all_drives.hpp", "include/rtuwire/wire/functions.hpp"
# Headers, by where they are, and what the list of their types is called.
DEVICES_OF, PDUS_OF = "include/rtuwire/altivar", "include/rtuwire/wire"
ALL_DRIVES, ALL_FUNCTIONS = "all_drives", "public_functions"

# Headers of single drives, by where they are or by their namespace; others know no drive. An include of one is no code.
OWN = ("include/rtuwire/altivar/device/", "include/rtuwire/altivar/parameters/", "include/rtuwire/altivar/atv")
# A header that knows the drives, and why.
KNOWS = {"include/rtuwire/port/show.hpp": "an operator is looked for in the namespace of its operand"}
OF_ONE_DRIVE = re.compile(r"^namespace altivar::[\w:]*\batv\d+\w* \{$", re.MULTILINE)
NAMED_DRIVE = re.compile(r"\batv\d+\w*\b(?!\.hpp)")

DRIVE_SPACE = re.compile(r"rtuwire::altivar::(atv\w+)")
DEVICE = re.compile(r"device\w*")
# A function is the class of its request, which has the rules of its frames, by itself or as a lone_request, and says what
# its response is.
RULES = re.compile(r"\busing\s+response\b.*\bframe_rules\s+rules\b|\blone_request<.*\busing\s+response\b", re.DOTALL)

# Every conversation that ends is used again there. What others derive from is tried as these; an endless one has a
# `settled` that is never true.
USED_AGAIN = "tests/altivar/used_again.cpp"
DERIVED = re.compile(r"\bclass\s+(\w+)(?:<[^{;]*?>)?\s*:\s*public\s+(?:detail::)?(\w+)")
ENDLESS = re.compile(r"\bstatic constexpr bool settled\(\) noexcept \{ return false; \}")

# A file that names the first and the rarest drive goes through all of them.
ENUMERATES = (re.compile(r"\batv12\s*::\s*device\b"), re.compile(r"\bdevice_2026\b"))
FOLDERS = ("tests", "fuzz", "bench", "examples")
# Who may name the drives one by one, and why.
ALLOWED = {
    "tests/altivar/device/layouts.cpp": "a value of each drive stands in its row",
    "tests/altivar/device/safeguards.cpp": "each drive is compared with a parameter file of its own",
    "tests/altivar/device/tables.cpp": "facts of single drives",
    "tests/sim/drive/enumerations.cpp": "what single registers take, by the manual of each",
    "tests/lives/far_drive.hpp": "a drive is chosen by its number when the program runs",
    "tests/lives/conversations.hpp": "alternatives of one variant, with orders of single drives among them",
    "examples/support/drive_panel.hpp": "each drive has a panel of its own",
}


def devices(headers):
    """The device types that the drives' headers define: `atv310::device_2026`."""
    for text in headers.values():
        for each in declarations.declarations(text):
            space = DRIVE_SPACE.fullmatch(each.space)
            if space and each.kind == "type" and DEVICE.fullmatch(each.name):
                yield f"{space[1]}::{each.name}"


def functions(headers):
    """The requests."""
    for text in headers.values():
        lines = declarations.code_of(text).splitlines(keepends=True)
        for each in declarations.declarations(text):
            begin = sum(len(line) for line in lines[:each.line - 1])
            if each.kind == "type" and RULES.search("".join(lines)[begin:each.end]):
                yield each.name


def conversations(headers):
    """The conversations that end, and are no base of another."""
    bases, endless = {}, set()
    for text in headers.values():
        code = declarations.code_of(text)
        found = list(DERIVED.finditer(code))
        for each, after in zip(found, [*(other.start() for other in found[1:]), len(code)]):
            bases.setdefault(each[1], set()).add(each[2])
            if ENDLESS.search(code, each.end(), after):
                endless.add(each[1])
    are = {"asker"}
    while more := {name for name, of in bases.items() if of & are} - are:
        are |= more
    used = set().union(*bases.values()) if bases else set()
    return sorted(name for name in are - used - endless if name in bases)


def never_used_again(headers, path, text):
    """Conversations that a test of all of them does not name."""
    found = conversations(headers)
    if not found:
        yield f"{path}: no conversation was found in the headers"
    for each in found:
        if not re.search(rf"\b{each}\b", text):
            yield f"{path}: {each} is not used again"


def listed(text, name):
    """What a list holds, without the outer namespaces and without template arguments; none where it is not there."""
    found = re.search(rf"\busing\s+{name}\s*=\s*\w+<(.*?)>\s*;", declarations.code_of(text), re.DOTALL)
    if not found:
        return None
    names = (part.strip() for part in declarations.angles_cut(found[1]).split(","))
    return [re.sub(r"^((rtuwire|altivar)::)+", "", each) for each in names if each]


def differences(path, text, name, defined):
    """What a list lacks, holds twice, or holds though no header defines it."""
    held = listed(text, name)
    if held is None:
        yield f"{path}: there is no list {name}"
        return
    if not defined:
        yield f"{path}: nothing was found in the headers that {name} should hold"
    for each in sorted(set(defined) - set(held)):
        yield f"{path}: {name} lacks {each}"
    for each in sorted(set(held) - set(defined)):
        yield f"{path}: {name} holds {each}, which no header defines"
    for each in sorted({each for each in held if held.count(each) > 1}):
        yield f"{path}: {name} holds {each} twice"


def enumerates(text):
    code = declarations.code_of(text)
    return all(name.search(code) for name in ENUMERATES)


def second_lists(files, allowed):
    """Files that go through all drives by hand, and permissions that nobody needs."""
    found = {path for path, text in files.items() if enumerates(text)}
    for path in sorted(found - set(allowed)):
        yield f"{path}: names the drives one by one; take {ALL_DRIVES} of {DRIVES}"
    for path in sorted(set(allowed) - found):
        yield f"{path}: does not name the drives one by one, and needs no permission"


def named_drives(headers):
    """Headers that know a drive though they are of all: neither its own, nor the list, nor a door to its registers."""
    for path, text in headers.items():
        code = declarations.code_of(text)
        if path == DRIVES or path in KNOWS or path.startswith(OWN) or OF_ONE_DRIVE.search(code):
            continue
        for found in NAMED_DRIVE.finditer(code):
            yield f"{path}:{code.count(chr(10), 0, found.start()) + 1}: knows {found[0]}; take the data of the drive"


def texts(root, folder, pattern):
    return {path.relative_to(root).as_posix(): path.read_text(encoding="utf-8")
            for path in sorted((root / folder).rglob(pattern))}


def main(project):
    root = pathlib.Path(project)
    drives = list(devices(texts(root, DEVICES_OF, "*.hpp")))
    kinds = list(functions(texts(root, PDUS_OF, "*.hpp")))
    list_of_functions = (root / FUNCTIONS).read_text(encoding="utf-8")
    files = {path: text for folder in FOLDERS for path, text in texts(root, folder, "*.[ch]pp").items()}
    headers = texts(root, "include/rtuwire", "*.hpp")
    # The one list is public; the door of everything includes the doors of all drives.
    files.update({path: text for path, text in headers.items() if path != DRIVES})
    found = [*differences(DRIVES, headers.get(DRIVES, ""), ALL_DRIVES, drives),
             *differences(FUNCTIONS, list_of_functions, ALL_FUNCTIONS, kinds), *second_lists(files, ALLOWED),
             *named_drives(headers),
             *never_used_again(headers, USED_AGAIN, (root / USED_AGAIN).read_text(encoding="utf-8"))]
    print("\n".join(found) or f"{len(drives)} drives and {len(kinds)} functions, each in its list")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1]))
