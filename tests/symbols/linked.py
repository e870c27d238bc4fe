# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
"""Links one program of two files that were built with different switches, and runs it: each uses its own code.

    python3 linked.py INCLUDE COMPILER FLAG...

The same again with headers whose namespace does not tell the builds apart has to fail: else nothing was shown.
"""
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

HERE = pathlib.Path(__file__).parent
SWITCHES = {"first_facts": ["-DRTUWIRE_CHECKED=1", "-DRTUWIRE_CRC_FORM=byte_table"],
            "second_facts": ["-DRTUWIRE_CHECKED=0", "-DRTUWIRE_CRC_FORM=bitwise"]}


def said_by_program(include, place, compiler, flags):
    """What the linked program says does not hold."""
    command = [compiler, "-I", include, "-I", HERE, *flags, "-O0"]
    objects = []
    for name, switches in SWITCHES.items():
        objects.append(pathlib.Path(place, f"{name}.o"))
        subprocess.check_call([*command, *switches, f"-DFACTS={name}", "-c", "-o", objects[-1], HERE / "linked_file.cpp"])
    program = pathlib.Path(place, "linked")
    subprocess.check_call([*command, "-o", program, HERE / "linked_main.cpp", *objects])
    done = subprocess.run([program], text=True, stdout=subprocess.PIPE, check=False)
    return done.stdout.splitlines() if done.returncode in (0, 1) else [f"the program ended with {done.returncode}"]


def without_builds(include, place):
    """A copy of the headers in a namespace with one name for all builds."""
    copy = pathlib.Path(place, "include")
    shutil.copytree(include, copy)
    changed = False
    for header in copy.rglob("*.hpp"):
        text, count = re.subn(r"^#define RTUWIRE_BUILD .*$", "#define RTUWIRE_BUILD one",
                              header.read_text(encoding="utf-8"), flags=re.MULTILINE)
        if count:
            header.write_text(text, encoding="utf-8")
            changed = True
    return copy if changed else None


def main(include, compiler, *flags):
    with tempfile.TemporaryDirectory() as place:
        failed = said_by_program(include, place, compiler, flags)
        print("\n".join(failed) or "each file runs its own code")
        alike = without_builds(include, place)
        seen = alike and said_by_program(alike, place, compiler, flags)
    print("seen without the namespace of the build:", seen)
    return 0 if not failed and seen else 1


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
