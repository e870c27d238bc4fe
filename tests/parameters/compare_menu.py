# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
"""Compares the menu numbers of the ATV310 with those that its manuals print beside an address: every number of a manual
is there, and leads to the register of that address. The address of 611 and of 502.0, which no manual prints beside them,
is that of the setting that the manual describes under this number.

    python3 compare_menu.py PRINT_MENU
"""
import collections
import pathlib
import re
import subprocess
import sys

import facts

TABLE = pathlib.Path(__file__).resolve().parent / "atv310_menu.tsv"
MANUALS = {"2014": "000_*.txt", "2026": "003_*.txt"}
# "NMA1 (705. 0) ... = 12701", and "address of the drive 701 ... = 06001".
OF_THE_SCANNER = re.compile(r"\((\d{3})\. ?(\d)\)[^\n]*16#([0-9A-F]{4}) = (\d+)")
OF_THE_LINE = re.compile(r"\b(70\d)\b[^\n]*16#([0-9A-F]{4}) = 0(\d+)")
# The words of the example that reads W3102 to W3105, and what has no address beside its number.
OF_THE_EXAMPLE = {"315": 3102, "308": 3103, "512.2": 3104, "512.0": 3105}
BY_DESCRIPTION = {"2014": {"611": 7010}, "2026": {"611": 7010, "502.0": 11201}}


def rows_of(lines, source):
    rows = [line.rstrip("\n").split("\t") for line in lines]
    for (manual, number), times in collections.Counter((row[0], row[1]) for row in rows).items():
        if times > 1:
            raise ValueError(f"{source}: {number} of {manual} stands there {times} times")
    return {(manual, number): int(address) for manual, number, address in rows}


def of_the_table():
    lines = [line for line in TABLE.read_text(encoding="utf-8").splitlines() if not line.startswith("#")]
    return rows_of(lines[1:], TABLE.name)


def of_a_manual(manual, text):
    """The numbers with their addresses, as the lines of the manual have them."""
    found = dict(BY_DESCRIPTION[manual])
    pairs = [(f"{line[1]}.{line[2]}", line[3], line[4]) for line in OF_THE_SCANNER.finditer(text)]
    pairs += [(line[1], line[2], line[3]) for line in OF_THE_LINE.finditer(text)]
    for number, hexadecimal, address in pairs:
        if int(hexadecimal, 16) != int(address):
            raise ValueError(f"{manual}: {number} has two addresses")
        found[number] = int(address)
    for number, address in OF_THE_EXAMPLE.items():
        if number in text:
            found[number] = address
    return {(manual, number): address for number, address in found.items()}


def differences(ours, theirs, source):
    for key in sorted(ours.keys() | theirs.keys()):
        if ours.get(key) != theirs.get(key):
            yield f"{' '.join(key)}: {ours.get(key)} here, {theirs.get(key)} in {source}"


def complaints(printed):
    table = of_the_table()
    folder = facts.LISTS.parent / "manuals"
    if folder.exists():
        texts = {manual: next(folder.glob(name)).read_text(encoding="utf-8") for manual, name in MANUALS.items()}
        said = {key: value for manual, text in texts.items() for key, value in of_a_manual(manual, text).items()}
        yield from differences(table, said, "the manuals")
    yield from differences(printed, table, TABLE.name)


def main(program):
    lines = subprocess.run([program], check=True, text=True, encoding="utf-8", stdout=subprocess.PIPE).stdout.splitlines()
    printed = rows_of(lines, "the program")
    found = list(complaints(printed))
    print("\n".join(found) or f"{len(printed)} menu numbers as the manuals print them")
    return 1 if found or not printed else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1]))
