# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
"""Compiles a file as it is, then with -DREFUSED, which must fail and say what the file expects.

    python3 refusal.py [--compiles] COMPILER INCLUDE_DIR FILE

With --compiles it is known that the file compiles as it is. The file names its sentences on lines that start with
`// EXPECT:`; each must be in the output. A file with a line `// CASES: 6` is compiled with -DREFUSED=1 to 6, and must
fail so each time. Where `likeliest.txt` beside the file names it, a reader must find the sentences at once: see `hidden`.
"""
import os
import re
import subprocess
import sys

# The compiler's echo of a source line must not pass for the message, nor a line break split it.
FLAGS = ["-std=c++20", "-Wall", "-Wextra", "-Werror", "-fmessage-length=0", "-fsyntax-only"]
NO_ECHO = {"clang": "-fno-caret-diagnostics", "gcc": "-fno-diagnostics-show-caret"}

# What a reader sees at once. Where each header is a file that includes another, the compiler names one more of them.
FIRST_LINES = 5 + int(os.environ.get("RTUWIRE_LINES_OF_SHIM", "0"))
LONGEST_LINE = 400


def compiles(compiler, include_dir, file, *more):
    done = subprocess.run([compiler, *FLAGS, "-I", include_dir, *more, file], text=True,
                          stdout=subprocess.PIPE, stderr=subprocess.STDOUT, check=False)
    return done.returncode == 0, done.stdout


def no_echo(compiler):
    return NO_ECHO["clang" if "clang" in os.path.basename(compiler) else "gcc"]


def likeliest(folder):
    """The names of the files that stand for the likeliest mistakes."""
    path = os.path.join(folder, "likeliest.txt")
    if not os.path.exists(path):
        return []
    with open(path, encoding="utf-8") as lines:
        return [line.split()[0] for line in lines if line.strip() and not line.startswith("#")]


def hidden(sentence, output):
    """Why a reader of the whole output, echoes included, does not find a sentence at once, or an empty string."""
    for number, line in enumerate(output.splitlines(), 1):
        told = re.sub(r"^\S+?:(\d+:\d+:)? *", "", line)
        if len(told) > LONGEST_LINE:
            return f"line {number} has {len(told)} characters"
        if sentence in told and re.match(r"(error|note|fatal error): ", told):
            return "" if number <= FIRST_LINES else f"it stands in line {number}"
    return "it stands in no message"


def complaint(compiler, include_dir, file, is_known_to_compile=False):
    """What is wrong with this file as a compile-fail test, or an empty string."""
    with open(file, encoding="utf-8") as source:
        text = source.read()
    expected = re.findall(r"^// EXPECT: *(\S.*?) *$", text, re.MULTILINE)
    cases = re.search(r"^// CASES: *(\d+)$", text, re.MULTILINE)
    if not expected:
        return "no line starts with `// EXPECT:`"
    is_likely = os.path.splitext(os.path.basename(file))[0] in likeliest(os.path.dirname(file))
    accepted, output = (True, "") if is_known_to_compile else compiles(compiler, include_dir, file)
    if not accepted:
        return f"does not compile as it is:\n{output}"
    for case in range(1, int(cases[1]) + 1 if cases else 2):
        # A sentence that a reader finds stands in a message, so that echoes do not matter there.
        echo = [] if is_likely else [no_echo(compiler)]
        accepted, output = compiles(compiler, include_dir, file, f"-DREFUSED={case}", *echo)
        if accepted:
            return f"is accepted with -DREFUSED={case}"
        for sentence in expected:
            if sentence not in output:
                return f"is refused with -DREFUSED={case}, but without saying `{sentence}`:\n{output}"
            reason = hidden(sentence, output) if is_likely else ""
            if reason:
                return f"says `{sentence}` with -DREFUSED={case}, but not at once: {reason}\n{output}"
    return ""


if __name__ == "__main__":
    known = sys.argv[1] == "--compiles"
    found = complaint(*sys.argv[1 + known:], known)
    print(f"{sys.argv[-1]}: {found or 'refused as expected'}")
    sys.exit(1 if found else 0)
