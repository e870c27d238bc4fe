# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
"""Compiles a file as it is, then with -DREFUSED, which must fail and say what the file expects.

    python3 refusal.py COMPILER INCLUDE_DIR FILE

The file names its sentences on lines that start with `// EXPECT:`; each must be in the output. A file with a line
`// CASES: 6` is compiled with -DREFUSED=1 to 6, and must fail so each time.
"""
import os
import re
import subprocess
import sys

# The compiler's echo of a source line must not pass for the message, nor a line break split it.
FLAGS = ["-std=c++20", "-Wall", "-Wextra", "-Werror", "-fmessage-length=0", "-c", "-o", os.devnull]
NO_ECHO = {"clang": "-fno-caret-diagnostics", "gcc": "-fno-diagnostics-show-caret"}


def compiles(compiler, include_dir, file, *more):
    family = "clang" if "clang" in os.path.basename(compiler) else "gcc"
    done = subprocess.run([compiler, *FLAGS, NO_ECHO[family], "-I", include_dir, *more, file], text=True,
                          stdout=subprocess.PIPE, stderr=subprocess.STDOUT, check=False)
    return done.returncode == 0, done.stdout


def complaint(compiler, include_dir, file):
    """What is wrong with this file as a compile-fail test, or an empty string."""
    with open(file, encoding="utf-8") as source:
        text = source.read()
    expected = re.findall(r"^// EXPECT: *(\S.*?) *$", text, re.MULTILINE)
    cases = re.search(r"^// CASES: *(\d+)$", text, re.MULTILINE)
    if not expected:
        return "no line starts with `// EXPECT:`"
    accepted, output = compiles(compiler, include_dir, file)
    if not accepted:
        return f"does not compile as it is:\n{output}"
    for case in range(1, int(cases[1]) + 1 if cases else 2):
        accepted, output = compiles(compiler, include_dir, file, f"-DREFUSED={case}")
        if accepted:
            return f"is accepted with -DREFUSED={case}"
        for sentence in expected:
            if sentence not in output:
                return f"is refused with -DREFUSED={case}, but without saying `{sentence}`:\n{output}"
    return ""


if __name__ == "__main__":
    found = complaint(*sys.argv[1:])
    print(f"{sys.argv[-1]}: {found or 'refused as expected'}")
    sys.exit(1 if found else 0)
