# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
"""Compares each place that names the version with include/rtuwire/core/version.hpp, where it is decided.

    python3 -B versions.py [PROJECT]
"""
import json
import pathlib
import re
import sys

import yaml

from support import DECIDED, PROJECT, version

# Filled in where a release lays them out, so none of these may name a version itself.
FILLED = ("packaging/conan/conandata.yml", "packaging/conan/config.yml", "packaging/meson/meson.build",
          "packaging/meson/rtuwire.wrap", "packaging/vcpkg/portfile.cmake", "packaging/vcpkg/vcpkg.json",
          "packaging/pkg-config/rtuwire.pc.in", "packaging/arduino/library.properties")

# What shows how the version is named, or asks for it: each of these does, whole or by its first two numbers.
SHOWN = ("README.md", "docs/packaging.md", "docs/start/tool.md", "packaging/debian/tests/headers", "tests/consumer/find_package/CMakeLists.txt",
         "tests/packaging/consumer/meson/meson.build")
AS_SHOWN = re.compile(r"\brtuwire[-/](\d+\.\d+\.\d+)|--version (\d+\.\d+\.\d+)|`(\d+\.\d+\.\d+)` is the version|`v(\d+\.\d+\.\d+)`"
                      r"|find_package\(rtuwire (\d+\.\d+) REQUIRED|'rtuwire', version: '>=(\d+\.\d+)'")


def named(root):
    """What names the version, and what it says."""
    yield "library.json", json.loads((root / "library.json").read_text(encoding="utf-8"))["version"]
    yield "idf_component.yml", yaml.safe_load((root / "idf_component.yml").read_text(encoding="utf-8"))["version"]
    released = (root / "CHANGELOG.md").read_text(encoding="utf-8")
    yield "CHANGELOG.md", re.search(r"^## (\d+\.\d+\.\d+)$", released, re.MULTILINE)[1]
    newest = (root / "packaging/debian/changelog").read_text(encoding="utf-8").partition("\n")[0]
    yield "packaging/debian/changelog", re.match(r"rtuwire \(([\d.]+)-\d+\)", newest)[1]


def complaints(root):
    number = version(root)
    for place, says in named(root):
        if says != number:
            yield f"{place}: says {says}, and {DECIDED} {number}"
    for place in FILLED:
        text = (root / place).read_text(encoding="utf-8")
        if "@VERSION@" not in text and "@PROJECT_VERSION@" not in text:
            yield f"{place}: has no place for the version"
        if number in text:
            yield f"{place}: names {number} itself"
    for place in SHOWN:
        shown = {"".join(each) for each in AS_SHOWN.findall((root / place).read_text(encoding="utf-8"))}
        if not shown:
            yield f"{place}: names no version"
        for says in sorted(shown - {number, number.rpartition(".")[0]}):
            yield f"{place}: says {says}, and {DECIDED} {number}"
    cmake = (root / "CMakeLists.txt").read_text(encoding="utf-8")
    if re.search(r"\bVERSION\s+\"?\d+\.\d+\.\d+\b", cmake):
        yield "CMakeLists.txt: names a version itself"


def main(project=PROJECT):
    root = pathlib.Path(project)
    found = list(complaints(root))
    print("\n".join(found)
          or f"{len(list(named(root))) + len(SHOWN)} places say {version(root)}, {len(FILLED)} are filled in")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
