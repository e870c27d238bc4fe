# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
"""Typed access against the same by hand, and of a full map against that of a small table, in bytes on a Cortex-M0+:
names must cost nothing.

    /usr/bin/python3 bench/size/twins.py
"""
import pathlib
import subprocess
import sys
import tempfile

HERE = pathlib.Path(__file__).parent
INCLUDE = HERE.parent.parent / "include"
FLAGS = ["-std=c++20", "-Os", "-mcpu=cortex-m0plus", "-mthumb", "-fno-exceptions", "-fno-rtti",
         "-ffunction-sections", f"-I{INCLUDE}"]
# The first may be no larger than the second.
TWINS = [("one", "typed", "by_hand"), ("fifty", "typed", "by_hand"), ("one", "full", "typed")]
KINDS = {".text": "code", ".rodata": "constants", ".data": "data", ".bss": "zeroed"}


def sizes_of(name):
    """Bytes of an object file by kind of section."""
    with tempfile.TemporaryDirectory() as place:
        made = pathlib.Path(place) / "made.o"
        subprocess.check_call(["arm-none-eabi-g++", *FLAGS, "-c", "-o", made, HERE / f"{name}.cpp"])
        listing = subprocess.check_output(["arm-none-eabi-size", "-A", made], text=True)
    total = dict.fromkeys(KINDS.values(), 0)
    for line in listing.splitlines():
        for prefix, kind in KINDS.items():
            if line.startswith(prefix):
                total[kind] += int(line.split()[1])
    return total


def main():
    missed = 0
    for what, one, other in TWINS:
        ours, theirs = sizes_of(f"{what}_{one}"), sizes_of(f"{what}_{other}")
        for kind in KINDS.values():
            is_worse = ours[kind] > theirs[kind]
            missed += is_worse
            print(f"{what:6} {kind:10} {one.replace('_', ' ')} {ours[kind]:6} {other.replace('_', ' ')} {theirs[kind]:6}"
                  f"{'  MORE' if is_worse else ''}")
    return 1 if missed else 0


if __name__ == "__main__":
    sys.exit(main())
