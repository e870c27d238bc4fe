# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
"""Medians and ratios out of what the benchmark programs wrote.

    /usr/bin/python3 bench/speed/report.py FOLDER    reads FOLDER/bench_*.json, writes speed.json and speed.svg there

Ratios are of times in one run: how many times faster than the baseline a form is. Compared is like with like: the CRC with
the CRC, and whole stacks of both ends with whole stacks over the same pair of sockets. What has no counterpart (the codec
alone, whole engines in memory without a system call) stands as a time without a ratio.
"""
import json
import pathlib
import re
import subprocess
import sys

BASE = "two tables"
# The least that the CRC's default has to be faster, by its bytes.
BARS = {("crc latency", "host (default)"): {8: 2.5, 253: 12.0}}
LEAST_TRANSACTIONS = 1.0


def made_by(folder):
    """The compiler and its flags, from the build's own record."""
    record = (folder / "CMakeCache.txt").read_text(encoding="utf-8")
    value = dict(re.findall(r"^(\w+):\w+=(.*)$", record, re.MULTILINE))
    compiler = value["CMAKE_CXX_COMPILER"]
    version = subprocess.check_output([compiler, "--version"], text=True).splitlines()[0]
    return f"{version}, {value['CMAKE_CXX_FLAGS_RELEASE']}; libmodbus as Debian built it (C, -O2)"


def medians(folder):
    """Nanoseconds by (group, name, argument)."""
    found = {}
    for path in sorted(folder.glob("bench_*.json")):
        for row in json.loads(path.read_text(encoding="utf-8"))["benchmarks"]:
            if row.get("aggregate_name") == "median":
                group, name, *argument = row["run_name"].split("/")
                found[group, name, int(argument[0]) if argument else 0] = row["cpu_time"]
    return found


def ratios_of(found, group):
    """How many times faster than the baseline, by name and argument."""
    base = {argument: time for (kind, name, argument), time in found.items()
            if (kind, name) == (group, BASE)}
    ratios = {}
    for (kind, name, argument), time in found.items():
        if kind == group:
            ratios.setdefault(name, {})[argument] = base[argument] / time
    rows = {name: dict(sorted(row.items())) for name, row in ratios.items()}
    return dict(sorted(rows.items(), key=lambda row: row[1][253]))


def show_ratios(group, ratios):
    sizes = list(next(iter(ratios.values())))
    print(f"\n{group}: times faster than {BASE}, by bytes")
    print(f"{'':18}" + "".join(f"{size:9}" for size in sizes))
    for name, row in ratios.items():
        print(f"{name:18}" + "".join(f"{row[size]:9.2f}" for size in sizes))


def verdicts(group, ratios):
    for (kind, name), bars in BARS.items():
        if kind == group:
            for size, least in bars.items():
                ratio = ratios[name][size]
                yield f"{group}, {name}, {size} bytes: {ratio:.1f}", ratio >= least, least
    if group == "crc latency":
        least = min(ratios["host (default)"].values())
        yield f"{group}, host (default), the least of all sizes: {least:.2f}", least >= 1.0, 1.0


def chart(ratios):
    """Bars of one group on a logarithmic scale, as an SVG."""
    from math import log2
    rows, y = [], 40
    for name, row in ratios.items():
        rows.append(f'<text x="10" y="{y + 12}" font-weight="bold">{name}</text>')
        for size, ratio in row.items():
            y += 16
            width = max(2.0, 60 + 60 * log2(max(ratio, 0.51)))
            rows.append(f'<text x="60" y="{y + 12}">{size} bytes</text>'
                        f'<rect x="140" y="{y + 2}" width="{width:.0f}" height="12" fill="#36c"/>'
                        f'<text x="{146 + width:.0f}" y="{y + 12}">{ratio:.2f}</text>')
        y += 24
    return ('<svg xmlns="http://www.w3.org/2000/svg" font-family="sans-serif" font-size="11" '
            f'width="640" height="{y + 20}"><rect width="100%" height="100%" fill="#fff"/>'
            '<text x="10" y="20" font-size="14">CRC-16/MODBUS, latency: times faster than two '
            'tables</text>' + "".join(rows) + "</svg>\n")


def main(folder):
    folder = pathlib.Path(folder)
    found = medians(folder)
    print(made_by(folder))
    told = []
    for group in ("crc latency", "crc throughput"):
        ratios = ratios_of(found, group)
        show_ratios(group, ratios)
        told += verdicts(group, ratios)
    print("\nnanoseconds, median")
    for (group, name, argument), time in sorted(found.items()):
        if group in ("codec alone", "transactions"):
            print(f"  {group:13}{name:28}{argument or '':5}{time:12.1f}")
    ours = found["transactions", "rtuwire over sockets", 0]
    theirs = found["transactions", "libmodbus over sockets", 0]
    told.append((f"whole stacks over sockets, processor time, times faster than libmodbus: {theirs / ours:.1f}",
                 theirs / ours >= LEAST_TRANSACTIONS, LEAST_TRANSACTIONS))
    print()
    for text, is_met, least in told:
        print(f"{text}, at least {least}: {'met' if is_met else 'MISSED'}")
    rows = [{"group": group, "name": name, "argument": argument, "nanoseconds": time}
            for (group, name, argument), time in found.items()]
    (folder / "speed.json").write_text(json.dumps(rows, indent=1) + "\n", encoding="utf-8")
    (folder / "speed.svg").write_text(chart(ratios_of(found, "crc latency")), encoding="utf-8")
    return 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
