# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
"""Checks that everything is in the namespace that names the build: each header opens it, and no other of ours, and
includes core/version.hpp first. The version itself, tests/packaging/versions.py checks.

    python3 builds.py PROJECT
"""
import pathlib
import re
import sys

VERSION = "core/version.hpp"
INCLUDE = re.compile(r"^[ \t]*#[ \t]*include[^\n]*", re.MULTILINE)
OURS = re.compile(r"\bnamespace[ \t]+rtuwire\b([^\n{]*)\{")
BUILD = re.compile(r"::inline RTUWIRE_BUILD\b(::\w+)*\s*$")
COMMENT = re.compile(r"//[^\n]*|/\*.*?\*/", re.DOTALL)
# What stands outside every namespace but the one of the build, and may: directives, and macros.
DIRECTIVE = re.compile(r"^[ \t]*#(?:[^\n\\]|\\.|\\\n)*", re.MULTILINE)


def complaints_of(header, text):
    code = COMMENT.sub("", text)
    opened = list(OURS.finditer(code))
    for one in opened:
        if not BUILD.match(one[1]):
            yield f"{header}: opens `{one[0][:-1].strip()}`, which names no build"
    before = code[:opened[0].start()] if opened else code
    declared = DIRECTIVE.sub("", before).strip()
    if declared:
        yield f"{header}: declares something outside the namespace of the build: {declared.splitlines()[0]}"
    includes = INCLUDE.findall(before)
    if opened and header != VERSION and not any(f"<rtuwire/{VERSION}>" in line for line in includes):
        yield f"{header}: does not include {VERSION} before it opens the namespace"


def main(project):
    root = pathlib.Path(project, "include", "rtuwire")
    texts = {path.relative_to(root).as_posix(): path.read_text(encoding="utf-8") for path in root.rglob("*.hpp")}
    found = [complaint for header, text in sorted(texts.items()) for complaint in complaints_of(header, text)]
    print("\n".join(found) or f"{len(texts)} headers are in the namespace of their build")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
