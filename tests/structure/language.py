# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
"""Compiles the doors and a header of each folder for an older language: the first error is our sentence, with the
flag that the tool takes, and behind it stands nothing but the one that ends the compilation. That every header includes core/version.hpp before its own text, rules.py checks.

    python3 language.py INCLUDE COMPILER
"""
import concurrent.futures
import os
import pathlib
import re
import subprocess
import sys

SENTENCE = "rtuwire needs C++20"
# What tells a tool's build from others, and what its sentence must name.
TOOLS = {
    (): ("-std=c++20", "cxx_std_20"),
    ("-DPLATFORMIO=60118",): ("platformio.ini", "build_flags = -std=gnu++20", "build_unflags"),
    ("-DPLATFORMIO=60118", "-DARDUINO=10819", "-DESP_PLATFORM"): ("platformio.ini",),
    ("-DARDUINO=10819",): ("platform.txt", "compiler.cpp.extra_flags=-std=gnu++20"),
    ("-DARDUINO=10819", "-DESP_PLATFORM"): ("platform.txt",),
    ("-DESP_PLATFORM",): ("target_compile_options(${COMPONENT_LIB} PRIVATE -std=gnu++20)",),
}
ERROR = re.compile(r".*?\berror: (.*)")
DOOR = "rtuwire/rtuwire.hpp"


def errors(compiler, include, header, *flags):
    """The compiler's errors for a file that includes this header alone."""
    done = subprocess.run([compiler, "-I", include, *flags, "-fsyntax-only", "-x", "c++", "-"], text=True, check=False,
                          input=f"#include <{header}>\n", stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                          env={**os.environ, "LC_ALL": "C"})
    return [found[1] for found in map(ERROR.match, done.stdout.splitlines()) if found]


def complaints(compiler, include, headers):
    def of_header(header, flag="-std=c++17"):
        said = errors(compiler, include, header, flag)
        if not said or SENTENCE not in said[0]:
            return f"{header} {flag}: the first error is {said[:1]}"
        return None if len(said) <= 2 else f"{header} {flag}: the sentence is one of {len(said)} errors"

    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        yield from filter(None, pool.map(of_header, headers))
    yield from filter(None, (of_header(headers[0], flag) for flag in ("-std=c++14", "-std=gnu++17")))


def complaints_of_tools(compiler, include, header):
    for defines, names in TOOLS.items():
        said = "".join(errors(compiler, include, header, "-std=gnu++17", *defines)[:1])
        for name in (SENTENCE, *names):
            if name not in said:
                yield f"{' '.join(defines) or 'no tool'}: {name!r} is not in {said!r}"


def sample(include):
    """The door to everything, the other doors, and of each folder below them the first header and the last."""
    rooms = {}
    for path in sorted(include.rglob("*.hpp")):
        header = path.relative_to(include).as_posix()
        rooms.setdefault(header.rpartition("/")[0], []).append(header)
    doors = rooms.pop("rtuwire", []) + rooms.pop("rtuwire/altivar", [])
    doors.sort(key=lambda header: header != DOOR)
    return doors + [header for room in rooms.values() for header in dict.fromkeys((room[0], room[-1]))]


def main(include, compiler):
    include = pathlib.Path(include)
    headers = sample(include)
    found = [*complaints(compiler, include, headers), *complaints_of_tools(compiler, include, headers[0])]
    print("\n".join(found) or f"{len(headers)} headers say first: {SENTENCE}")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
