# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
"""What headers cost to compile: user time of each file against the first of its group.

    python3 bench/compile/compile.py [--rounds N]

The files take turns, and the best round of each counts.
"""
import argparse
import pathlib
import resource
import shutil
import subprocess

HERE = pathlib.Path(__file__).parent
INCLUDE = HERE.parent.parent / "include"
GROUPS = [[("client", None), ("fifty_registers", 3.0)]]


def user_time(compiler, source):
    before = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime
    subprocess.check_call([compiler, "-std=c++20", "-Os", f"-I{INCLUDE}", "-c", "-o", "/dev/null",
                           HERE / f"{source}.cpp"])
    return resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime - before


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
                print(f"{compiler:8} {name:18} {best[name]:6.2f} s {ratio:6.2f} times{verdict}")


if __name__ == "__main__":
    main()
