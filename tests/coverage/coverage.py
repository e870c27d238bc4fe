# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
"""What the tests run of the portable headers, by lines and branches.

    cmake --preset clang -B build/coverage -DRTUWIRE_STATIC_TESTS=OFF -DRTUWIRE_BUILD_EXAMPLES=OFF \\
        -DCMAKE_CXX_FLAGS="-fprofile-instr-generate -fcoverage-mapping" && cmake --build build/coverage
    /usr/bin/python3 tests/coverage/coverage.py [--list]

Runs every test program of the build, merges the instantiations of each template, and holds what was not
run against the reasons in accepted.txt. Fails where something else was not run, or a reason is for nothing.
"""
import json
import os
import pathlib
import subprocess
import sys

PROJECT = pathlib.Path(__file__).resolve().parents[2]
BUILD = PROJECT / "build" / "coverage"
HEADERS = PROJECT / "include" / "rtuwire"
ACCEPTED = pathlib.Path(__file__).with_name("accepted.txt")
IN_COMPILER = ("runs only in the compiler", "within `if constexpr`", "needs -mpclmul")
LONG = {"simulation_transactions": ["20000"], "simulation_undetected": ["50000"]}


def tool(name):
    for version in ("-14", "-15", "-16", "-19", ""):
        for folder in os.environ["PATH"].split(os.pathsep):
            if os.access(os.path.join(folder, name + version), os.X_OK):
                return name + version
    raise SystemExit(f"coverage.py: {name} is missing (packages.sh clang)")


def programs():
    found = sorted(BUILD.glob("tests/rtuwire_tests_*")) + sorted(BUILD.glob("fuzz/replay_*")) + \
        [BUILD / "tests" / "simulation" / name for name in LONG]
    runnable = [path for path in found if path.is_file() and os.access(path, os.X_OK)]
    if not runnable:
        raise SystemExit("coverage.py: nothing was built in build/coverage")
    return runnable


def run(path, profile):
    arguments = LONG.get(path.name, [])
    if path.name.startswith("replay_"):
        arguments = [str(PROJECT / "fuzz" / "corpus" / path.name.removeprefix("replay_"))]
    done = subprocess.run([path, *arguments], env={**os.environ, "LLVM_PROFILE_FILE": str(profile)},
                          stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, check=False)
    if done.returncode != 0:
        raise SystemExit(f"coverage.py: {path.name} fails")


def exported(path):
    """What one program ran. Each is looked at alone: programs differ in what they make of a template."""
    raw, merged = BUILD / f"{path.name}.profraw", BUILD / f"{path.name}.profdata"
    run(path, raw)
    subprocess.run([tool("llvm-profdata"), "merge", "-sparse", "-o", merged, raw], check=True)
    done = subprocess.run([tool("llvm-cov"), "export", f"-instr-profile={merged}", str(path),
                           str(HEADERS)], stdout=subprocess.PIPE, check=True)
    return json.loads(done.stdout)["data"][0]


def is_portable(path):
    return HEADERS in path.parents and "port" not in path.relative_to(HEADERS).parts


def counts_of(segments):
    """How often each line was run, from [line, column, count, has count, is entry, is gap] rows."""
    by_line = {}
    for segment in segments:
        by_line.setdefault(segment[0], []).append(segment)
    counts, around = {}, None
    for line in range(segments[0][0], segments[-1][0] + 1):
        here = by_line.get(line, [])
        entries = [each[2] for each in here if each[3] and each[4] and not each[5]]
        if around and around[3] and not around[5]:
            entries.append(around[2])
        if entries:
            counts[line] = max(entries)
        around = here[-1] if here else around
    return counts


def gather(data, lines, branches):
    """Adds a program's lines and branches, by place: how often, the most of all instantiations."""
    for file in data["files"]:
        path = pathlib.Path(file["filename"])
        if is_portable(path) and file["segments"]:
            header = path.relative_to(HEADERS).as_posix()
            for line, count in counts_of(file["segments"]).items():
                lines[header, line] = max(lines.get((header, line), 0), count)
    for function in data["functions"]:
        names = [pathlib.Path(name) for name in function["filenames"]]
        for line, column, _, _, taken, skipped, number, _, _ in function["branches"]:
            path = names[number]
            if is_portable(path):
                key = (path.relative_to(HEADERS).as_posix(), line, column)
                before = branches.get(key, (0, 0))
                branches[key] = (max(before[0], taken), max(before[1], skipped))


def source(header, line):
    return (HEADERS / header).read_text(encoding="utf-8").splitlines()[line - 1].strip()


def is_formal(text):
    """Nothing to run: a brace, a comment; the default that no switch here has, because the compilers hold
    each to naming every value; a comparison that the compiler wrote."""
    return text in ("{", "}", "};", "} else {") or text.startswith(("//", "switch (")) or \
        text.endswith("= default;")


def accepted():
    rows = [row.split(" | ") for row in ACCEPTED.read_text(encoding="utf-8").splitlines()
            if row and not row.startswith("#")]
    return {(row[0], " | ".join(row[1:-1])): row[-1] for row in rows}


def main(options):
    lines, branches = {}, {}
    for path in programs():
        gather(exported(path), lines, branches)
    branches = {key: counts for key, counts in branches.items()
                if any(counts) and not is_formal(source(*key[:2]))}
    known = accepted()
    # A line that has no code in a program cannot run there.
    in_compiler = {key for key, count in lines.items() if count == 0 and
                   known.get((key[0], source(*key)), "").startswith(IN_COMPILER)}
    missed = sorted(key for key, count in lines.items()
                    if count == 0 and not is_formal(source(*key)) and key not in in_compiler)
    ways = [(key, way) for key, counts in sorted(branches.items())
            for way, count in zip(("true", "false"), counts) if count == 0]
    all_ways = 2 * len(branches)
    notes = [(key, "line   {}:{}: {}") for key in missed]
    notes += [(key[:2], f"branch {{}}:{{}} never {way}: {{}}") for key, way in ways]
    new = [(key, form) for key, form in notes if (key[0], source(*key)) not in known]
    for key, form in new:
        print(form.format(*key, source(*key)))
    print(f"{len(new)} places that accepted.txt does not explain")
    met = {(key[0], source(*key)) for key in in_compiler} | {(key[0], source(*key)) for key, _ in notes}
    idle = sorted(set(known) - met)
    for header, text in idle:
        print(f"accepted.txt explains what is run, or gone: {header} | {text}")
    at_run_time = len(lines) - len(in_compiler)
    print(f"{len(in_compiler)} lines run only in the compiler, or are counted wrongly by it (listed)")
    print(f"lines {100 * (1 - len(missed) / at_run_time):.2f} % of {at_run_time}, "
          f"{len(missed)} not run (listed); branches {100 * (1 - len(ways) / all_ways):.2f} % of {all_ways}")
    return 1 if (new or idle) and "--list" not in options else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
