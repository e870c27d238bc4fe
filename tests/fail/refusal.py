# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
"""Compiles a file as it is, then with -DREFUSED, which must fail and say what the file expects.

    python3 refusal.py [--compiles] [--keep FOLDER] COMPILER INCLUDE_DIR FILE

With --compiles it is known that the file compiles as it is; with --keep what the compiler said is kept for the gallery of
errors (docs/generate/gallery.py), under a name that says of what. The file names its sentences on lines that start with
`// EXPECT:`; each must be in the output. A file with a line `// CASES: 6` is compiled with -DREFUSED=1 to 6, and must
fail so each time; of one with a line `// ALONE` nothing else may be said. Where `likeliest.txt` beside the file names it, a reader must find the sentences at once: see `hidden`.
"""
import argparse
import hashlib
import os
import pathlib
import re
import subprocess
import sys

TESTS = pathlib.Path(__file__).resolve().parents[1]
FLAGS = ["-std=c++20", "-Wall", "-Wextra", "-Werror", "-fmessage-length=0", "-fsyntax-only"]
# The compiler's echo of a source line, which has no place in front of it, must not pass for the message.
MESSAGE = re.compile(r"^\S+:(?:\d+:| In ).*", re.MULTILINE)

# What a reader sees at once. Where each header is a file that includes another, the compiler names one more of them.
FIRST_LINES = 5 + int(os.environ.get("RTUWIRE_LINES_OF_SHIM", "0"))
LONGEST_LINE = 400


def compiles(compiler, include_dir, file, *more):
    done = subprocess.run([compiler, *FLAGS, "-I", include_dir, *more, file], text=True, env={**os.environ, "LC_ALL": "C"},
                          stdout=subprocess.PIPE, stderr=subprocess.STDOUT, check=False)
    return done.returncode == 0, done.stdout


def circumstances(compiler, include_dir):
    """A sum over what the outcome of a file depends on beside its own text."""
    found = hashlib.sha256(" ".join(FLAGS).encode())
    found.update(subprocess.run([compiler, "--version"], check=True, capture_output=True).stdout)
    for folder in (pathlib.Path(include_dir), TESTS):
        for path in sorted(folder.rglob("*.hpp")):
            found.update(path.read_bytes())
    return found


def kept_as(of, file):
    """The name under which an outcome is kept."""
    found = of.copy()
    found.update(pathlib.Path(file).read_bytes())
    return f"{pathlib.Path(file).stem}-{found.hexdigest()[:16]}"


def likeliest(folder):
    """The names of the files that stand for the likeliest mistakes."""
    path = os.path.join(folder, "likeliest.txt")
    if not os.path.exists(path):
        return []
    with open(path, encoding="utf-8") as lines:
        return [line.split()[0] for line in lines if line.strip() and not line.startswith("#")]


def hidden(sentence, output):
    """Why a reader of the whole output, echoes included, does not find a sentence at once, or an empty string. In which folder
    the project lies makes no difference: Clang names it with each lambda."""
    for number, line in enumerate(output.splitlines(), 1):
        told = re.sub(r"(?<= at )/\S*/", "", re.sub(r"^\S+?:(\d+:\d+:)? *", "", line))
        if len(told) > LONGEST_LINE:
            return f"line {number} has {len(told)} characters"
        if sentence in told and re.match(r"(error|note|fatal error): ", told):
            return "" if number <= FIRST_LINES else f"it stands in line {number}"
    return "it stands in no message"


def complaint(compiler, include_dir, file, is_known_to_compile=False, keep=None):
    """What is wrong with this file as a compile-fail test, or an empty string; what the compiler says is then in `keep`."""
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
        accepted, output = compiles(compiler, include_dir, file, f"-DREFUSED={case}")
        if accepted:
            return f"is accepted with -DREFUSED={case}"
        for sentence in expected:
            if not any(sentence in message for message in MESSAGE.findall(output)):
                return f"is refused with -DREFUSED={case}, but without saying `{sentence}`:\n{output}"
            reason = hidden(sentence, output) if is_likely else ""
            if reason:
                return f"says `{sentence}` with -DREFUSED={case}, but not at once: {reason}\n{output}"
        errors = len(re.findall(r"^\S+: (?:fatal )?error: ", output, re.MULTILINE))
        if re.search(r"^// ALONE$", text, re.MULTILINE) and errors > 1:
            return f"says `{expected[0]}` with -DREFUSED={case}, but as one of {errors} errors:\n{output}"
        if keep and case == 1:
            keep.parent.mkdir(parents=True, exist_ok=True)
            keep.write_text(output, encoding="utf-8")
    return ""


def main():
    options = argparse.ArgumentParser()
    options.add_argument("--compiles", action="store_true")
    options.add_argument("--keep", type=pathlib.Path)
    options.add_argument("asked", nargs=3)
    given = options.parse_args()
    compiler, include_dir, file = given.asked
    keep = given.keep and given.keep / kept_as(circumstances(compiler, include_dir), file)
    found = complaint(compiler, include_dir, file, given.compiles, keep)
    print(f"{file}: {found or 'refused as expected'}")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
