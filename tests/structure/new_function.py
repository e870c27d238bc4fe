# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
"""Adds a made-up function, 65, to a copy of the project: a file of its own, its line in the list and a test, and nothing
else; shows that all that is made of the list knows it.

    python3 new_function.py PROJECT COMPILER [OPTION...]
"""
import pathlib
import shutil
import subprocess
import sys
import tempfile

LIST = "include/rtuwire/wire/functions.hpp"
FUNCTION = "include/rtuwire/wire/pdu/double_number.hpp"
TEST = "tests/wire/pdu/double_number.cpp"
GENERIC = ["tests/wire/pdu/all_pdus.cpp"]
# What is added.
MADE_UP = pathlib.Path(__file__).resolve().parent / "new_function"
FOLDERS = ["include", "tests", "fuzz", "bench", "examples"]


def copy_of(project, folder):
    for name in FOLDERS:
        shutil.copytree(project / name, folder / name,
                        ignore=shutil.ignore_patterns("__pycache__", "build"))
    return folder


def add_to_list(text):
    """The include, where the alphabet has it, and the name behind the first one."""
    lines = text.splitlines(keepends=True)
    include = '#include <rtuwire/wire/pdu/double_number.hpp>\n'
    behind = max(at for at, line in enumerate(lines) if line.startswith("#include <rtuwire/wire/pdu/") and line < include)
    lines.insert(behind + 1, include)
    text = "".join(lines)
    last = "read_device_identification>;"
    if text.count(last) != 1:
        raise RuntimeError("the list does not end as it did")
    return text.replace(last, "read_device_identification, double_number>;")


def start(folder, words):
    return subprocess.Popen(words, cwd=folder, text=True, stdout=subprocess.PIPE, stderr=subprocess.STDOUT)


def ended_well(*processes):
    """Whether all of them did; what the others said is printed."""
    told = [(process.communicate()[0], process.returncode) for process in processes]
    for text, status in told:
        if status != 0:
            print(text[-4000:])
    return all(status == 0 for _, status in told)


def build(folder, compiler, options):
    """The test's program, compiled beside the generic tests and without the line in the list."""
    compile_as = [compiler, "-std=gnu++20", "-O0", "-Wall", "-Wextra", "-Werror", "-Itests", "-Iinclude", *options]
    listed = folder / LIST
    unlisted = listed.read_text(encoding="utf-8")
    objects = [start(folder, [*compile_as, "-c", "-o", name, source])
               for name, source in (("main.o", "tests/support/catch_main.cpp"), ("test.o", TEST))]
    generic = [start(folder, [*compile_as, "-fsyntax-only", source]) for source in GENERIC]
    steps = {"its test compiles": ended_well(*objects), "the generic tests take it": ended_well(*generic)}
    steps["its test passes"] = (
        ended_well(start(folder, [compiler, *options, "-o", "double_number", "main.o", "test.o"]))
        and ended_well(start(folder, ["./double_number"])))
    listed.write_text(unlisted.replace(", double_number>", ">"), encoding="utf-8")
    refused = start(folder, [*compile_as, "-fsyntax-only", TEST])
    steps["without its line its test is refused"] = (
        "double_number" in refused.communicate()[0] and refused.returncode != 0)
    return steps


def main(project, compiler, *options):
    project = pathlib.Path(project).resolve()
    with tempfile.TemporaryDirectory(prefix="function-") as name:
        folder = copy_of(project, pathlib.Path(name))
        shutil.copy(MADE_UP / "double_number.hpp", folder / FUNCTION)
        shutil.copy(MADE_UP / "double_number.cpp", folder / TEST)
        listed = folder / LIST
        listed.write_text(add_to_list(listed.read_text(encoding="utf-8")), encoding="utf-8")
        lists = start(folder, [sys.executable, "-B", "tests/structure/lists.py", "."])
        steps = {"the list agrees with the headers": ended_well(lists), **build(folder, compiler, options)}
    for what, is_so in steps.items():
        print("ok  " if is_so else "FAIL", what)
    return 0 if all(steps.values()) else 1


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
