# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
"""Compiles one source file and looks for symbols that firmware must not need.

    python3 symbols.py OBJECT SOURCE COMPILER FLAGS...
"""
import re
import subprocess
import sys

FORBIDDEN = re.compile(r"_Zn[wa]|_Zd[la]|__cxa_throw|__cxa_guard|_ZT[ISV]|\bmalloc\b|\bfree\b"
                       r"|__(atomic|sync)_")


def main(target, source, compiler, *flags):
    subprocess.run([compiler, *flags, "-c", source, "-o", target], check=True)
    tool = re.sub(r"(clang\+\+|g\+\+|c\+\+)(-\d+)?$", "nm", compiler)
    names = subprocess.run([tool, target], check=True, capture_output=True, text=True).stdout
    if "exercise" not in names:
        print(f"{source}: the code under test is missing from the object")
        return 1
    found = [line for line in names.splitlines() if FORBIDDEN.search(line)]
    print("\n".join(found) or f"{source}: none of the forbidden symbols")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
