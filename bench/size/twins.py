# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
"""Typed access against the same by hand, in bytes on a Cortex-M0+: names must cost nothing.

    python3 bench/size/twins.py
"""
import pathlib
import subprocess
import sys
import tempfile

HERE = pathlib.Path(__file__).parent
INCLUDE = HERE.parent.parent / "include"
FLAGS = ["-std=c++20", "-Os", "-mcpu=cortex-m0plus", "-mthumb", "-fno-exceptions", "-fno-rtti",
         "-ffunction-sections", f"-I{INCLUDE}"]
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
    for what in ("one", "fifty"):
        typed, by_hand = sizes_of(f"{what}_typed"), sizes_of(f"{what}_by_hand")
        for kind in KINDS.values():
            is_worse = typed[kind] > by_hand[kind]
            missed += is_worse
            print(f"{what:6} {kind:10} typed {typed[kind]:6} by hand {by_hand[kind]:6}"
                  f"{'  MORE' if is_worse else ''}")
    return 1 if missed else 0


if __name__ == "__main__":
    sys.exit(main())
