# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
"""What headers cost to compile: user time of each file against the first of its group, and how many
templates Clang instantiates for it.

    /usr/bin/python3 bench/compile/compile.py [--rounds N]

The files take turns, and the best round of each counts.
"""
import argparse
import json
import pathlib
import resource
import shutil
import subprocess
import tempfile

HERE = pathlib.Path(__file__).parent
INCLUDE = HERE.parent.parent / "include"
GROUPS = [
    [("client", None), ("fifty_registers", 3.0)],
    [("standard", None), ("client_header", 1.3), ("server_header", 1.3), ("umbrella", None)]
    + [(drive, None) for drive in ("atv12", "atv28", "atv310", "atv320")],
    [("standard", None), ("thousand_bank", None), ("thousand_plan", None)],
    [("client", None), ("full_map", None), ("full_map_read", None)],
]
# At most, in seconds.
SECONDS = {("g++", "thousand_bank"): 1.5, ("clang++", "thousand_bank"): 2.0,
           ("g++", "thousand_plan"): 2.0, ("clang++", "thousand_plan"): 2.0}
# At most, in seconds more than the first of its group.
MORE = {"full_map": 1.5, "full_map_read": 1.5}
STANDARD = "array span cstdint optional".split()
# Sources that are nothing but an include.
INCLUDES = {"client_header": "client/client.hpp", "server_header": "server/server.hpp",
            "umbrella": "rtuwire.hpp"}


def text_of(name):
    """A file of this folder, the standard headers that the library uses anyway, or one of its own."""
    path = HERE / f"{name}.cpp"
    if path.exists():
        return path.read_text(encoding="utf-8")
    if name == "standard":
        return "".join(f"#include <{header}>\n" for header in STANDARD)
    return f"#include <rtuwire/{INCLUDES.get(name, f'altivar/{name}.hpp')}>\n"


def user_time(compiler, source):
    before = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime
    subprocess.run([compiler, "-std=c++20", "-Os", f"-I{INCLUDE}", f"-I{HERE}", "-c", "-o", "/dev/null",
                    "-x", "c++", "-"], input=text_of(source), text=True, check=True)
    return resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime - before


def instantiations(source):
    """How many templates Clang instantiates, by its own trace; none where it is missing."""
    if not shutil.which("clang++"):
        return None
    with tempfile.TemporaryDirectory() as folder:
        subprocess.run(["clang++", "-std=c++20", f"-I{INCLUDE}", f"-I{HERE}", "-c", "-o",
                        f"{folder}/made.o", "-ftime-trace", "-ftime-trace-granularity=0",
                        "-x", "c++", "-"], input=text_of(source), text=True, check=True)
        trace = pathlib.Path(folder, "made.json").read_text(encoding="utf-8")
    return sum(event["name"].startswith("Instantiate")
               for event in json.loads(trace)["traceEvents"] if event.get("ph") == "X")


def best_times(compiler, names, rounds):
    best = {}
    for _ in range(rounds):
        for name in names:
            taken = user_time(compiler, name)
            best[name] = min(best.get(name, taken), taken)
    return best


def main():
    options = argparse.ArgumentParser()
    options.add_argument("--rounds", type=int, default=5)
    chosen = options.parse_args()
    for compiler in filter(shutil.which, ("g++", "clang++")):
        for group in GROUPS:
            best = best_times(compiler, [name for name, _ in group], chosen.rounds)
            base = best[group[0][0]]
            for name, bar in group:
                ratio = best[name] / base
                verdict = "" if bar is None else f"  bar {bar} {'met' if ratio <= bar else 'MISSED'}"
                if (compiler, name) in SECONDS:
                    most = SECONDS[compiler, name]
                    verdict = f"  bar {most} s {'met' if best[name] <= most else 'MISSED'}"
                if name in MORE:
                    met = "met" if best[name] - base <= MORE[name] else "MISSED"
                    verdict = f"  {best[name] - base:.2f} s more, bar {MORE[name]} s {met}"
                print(f"{compiler:8} {name:18} {best[name]:6.2f} s {ratio:6.2f} times{verdict}")
    for name in (name for group in GROUPS for name, _ in group):
        print(f"{name:18} {instantiations(name)} instantiations")


if __name__ == "__main__":
    main()
