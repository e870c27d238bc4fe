# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
"""Builds one source with different switches and fails where two of the builds define one function of ours.

    python3 builds.py SOURCE COMPILER FLAG...
"""
import itertools
import pathlib
import subprocess
import sys
import tempfile

BUILDS = {"as delivered": ["-DRTUWIRE_CHECKED=1"], "unchecked": ["-DRTUWIRE_CHECKED=0"],
          "another CRC": ["-DRTUWIRE_CHECKED=1", "-DRTUWIRE_CRC_FORM=byte_table"]}


def functions(source, command, place):
    made = pathlib.Path(place, "one.o")
    subprocess.check_call([*command, "-O0", "-c", "-o", made, source])
    listing = subprocess.check_output(["nm", made], text=True)
    return {line.split()[2] for line in listing.splitlines()
            if len(line.split()) == 3 and line.split()[1] == "W" and "7rtuwire" in line.split()[2]}


def main(source, *command):
    with tempfile.TemporaryDirectory() as place:
        made = {name: functions(source, [*command, *flags], place) for name, flags in BUILDS.items()}
    if not all(made.values()):
        print("a build defines no function of ours: nothing was compared")
        return 1
    shared = False
    for (first, ours), (second, theirs) in itertools.combinations(made.items(), 2):
        for symbol in sorted(ours & theirs):
            shared = True
            print(f"{first} and {second} share {symbol}")
    return 1 if shared else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
