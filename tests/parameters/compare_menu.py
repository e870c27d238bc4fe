# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
"""Compares the menu numbers of the ATV310 with those that its manuals print beside an address, in atv310_menu.tsv. The
address of 611 and of 502.0, which no manual prints beside them, is that of the setting that the manual describes under
this number.

    python3 compare_menu.py PRINT_MENU
"""
import difflib
import pathlib
import subprocess
import sys

TABLE = pathlib.Path(__file__).resolve().parent / "atv310_menu.tsv"


def main(program):
    printed = subprocess.run([program], check=True, text=True, encoding="utf-8", stdout=subprocess.PIPE).stdout.splitlines()
    lines = [line for line in TABLE.read_text(encoding="utf-8").splitlines() if not line.startswith("#")]
    found = list(difflib.unified_diff(sorted(printed), sorted(lines[1:]), "the program", TABLE.name, lineterm="", n=0))
    print("\n".join(found) or f"{len(printed)} menu numbers as the manuals print them")
    return 1 if found or not printed else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1]))
