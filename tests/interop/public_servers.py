# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
"""What `rtuwire check` says of public servers, as the table of docs/public-servers.md; public_servers.sh, which builds and fetches
all of them, calls it.

    python3 public_servers.py BUILD [--node-modules FOLDER] [--sources FOLDER] [--frames] [--page FILE] [SERVER...]

BUILD has the tool and the servers that CMake builds; FOLDER of --node-modules has the npm packages, that of --sources the programs
nanomodbus_server and freemodbus_server. A server that is not there is left out, and named. --frames shows the frames of what fails.
With --page nothing is printed but what that page says otherwise, and the status says whether there is any; a server in another
version than the page has is left out there.
"""
import argparse
import concurrent.futures
import csv
import importlib.metadata
import io
import json
import os
import pathlib
import re
import subprocess
import sys

from pair import Programs

HERE = pathlib.Path(__file__).resolve().parent
COUNT = 128  # of each space, from address 0
HEAD = ("server", "musts that hold", "shoulds that hold", "musts that fail", "shoulds that fail")
ALL = ["--no-listen", "-d", "none", "--write", "--timeout", "0.7"]  # of which a server may take 500 ms before it refuses
ALONE_AT_ONCE = 4
CHECK = ["check", "--scratch", f"{COUNT - 8}-{COUNT - 1}", "--scratch-coils", f"{COUNT - 16}-{COUNT - 1}", "--alone", "--disruptive"]


# One function a server: its name with its version, and its command, in which @ stands for the device; none where it is not there.
def ours(at):
    program = at.build / "tests" / "interop" / "public_rtuwire_server"
    return ("rtuwire", [program, "@"]) if program.exists() else None


def libmodbus(at):
    program = at.build / "tests" / "interop" / "memory_libmodbus"
    version = subprocess.run(["pkg-config", "--modversion", "libmodbus"], capture_output=True, text=True, check=False).stdout.strip()
    return (f"libmodbus {version}", [program, "@", "0", COUNT, "usual"]) if program.exists() else None


def pymodbus(_):
    try:
        version = importlib.metadata.version("pymodbus")
    except importlib.metadata.PackageNotFoundError:
        return None
    return f"pymodbus {version}", [sys.executable, "-B", HERE / "memory_pymodbus.py", "@", "0", COUNT]


def of_npm(at, name):
    told = at.node_modules / name / "package.json"
    return (f"{name} {json.loads(told.read_text(encoding='utf-8'))['version']}",
            ["node", HERE / "memory_npm.js", name, "@", "0", COUNT, "usual"]) if told.exists() else None


def modbus_serial(at):
    return of_npm(at, "modbus-serial")


def jsmodbus(at):
    return of_npm(at, "jsmodbus")


def of_source(at, name):
    """Beside the program stands the commit that it is of."""
    program = at.sources / f"{name.lower()}_server"
    return (f"{name} {program.with_suffix('.commit').read_text(encoding='ascii')[:7]}", [program, "@"]) if program.exists() else None


def nanomodbus(at):
    return of_source(at, "nanoMODBUS")


def freemodbus(at):
    return of_source(at, "FreeMODBUS")


SERVERS = (ours, libmodbus, pymodbus, modbus_serial, jsmodbus, nanomodbus, freemodbus)


def tool(at, *words):
    return subprocess.run([at.build / "tools" / "rtuwire" / "rtuwire", "--csv", *words], capture_output=True, text=True, check=False)


def rows_in(text):
    return list(csv.DictReader(io.StringIO(text)))


def is_missed(row):
    return row["verdict"] == "not tried" and row["why"].startswith("no known state")


def judged(at, command, only):
    """By clause what one run says, of those for which the server came to a known state."""
    with Programs() as others:
        near, far = others.line()
        others.serve(near, [str(word) for word in command], stdin=subprocess.PIPE, stderr=subprocess.DEVNULL,
                     env={**os.environ, "NODE_PATH": str(at.node_modules)})
        ended = tool(at, "--port", far, "--unit", "1", *ALL, *CHECK, "--only", ",".join(only))
    return {row["clause"]: row for row in rows_in(ended.stdout) if not is_missed(row)}


def verdicts(at, command):
    """By clause. Behind one that leaves the server without an answer it is started again for the others; where it does not even
    come to the first of them, as it answers no more behind what the check has to find out, for each of them alone."""
    rows = {row["clause"]: {**row, "verdict": "not tried", "why": "", "frames": ""} for row in rows_in(tool(at, "check", "--list").stdout)}
    missed, starts = list(rows), 0
    while missed:
        tried = judged(at, command, missed)
        starts += 1
        if not tried:
            break
        rows.update(tried)
        missed = [name for name in missed if name not in tried]
    with concurrent.futures.ThreadPoolExecutor(ALONE_AT_ONCE) as pool:
        for tried in pool.map(lambda name: judged(at, command, [name]), missed):
            rows.update(tried)
    return list(rows.values()), starts + len(missed)


def row_of(name, rows):
    def ids(level, *wanted):
        return [row["clause"] for row in rows if row["level"] == level and row["verdict"] in wanted]
    def held(level):
        return f"{len(ids(level, 'holds'))} of {len(ids(level, 'holds', 'fails'))}"
    return (name, held("must"), held("should"), " ".join(ids("must", "fails")) or "none", " ".join(ids("should", "fails")) or "none")


def line_of(cells):
    return "| " + " | ".join(cells) + " |"


def of_page(text):
    """The table's rows by server."""
    lines = text.splitlines()
    start = lines.index(line_of(HEAD)) + 2
    rows = [re.split(r" \| ", line[2:-2]) for line in lines[start:lines.index("", start)]]
    return {row[0]: tuple(row) for row in rows}


def compared(rows, page):
    told = of_page(pathlib.Path(page).read_text(encoding="utf-8"))
    compares = [row for row in rows if row[0] in told]
    for row in rows:
        if row[0] not in told:
            print(f"left out: {page} does not have {row[0]}, but: {', '.join(told)}")
        elif row != told[row[0]]:
            print(f"{page}: {row[0]}\n  the page: {line_of(told[row[0]])}\n  the check: {line_of(row)}")
    print(f"{len(compares)} servers compared")
    return 0 if compares and all(row == told[row[0]] for row in compares) else 1


def main(words):
    parser = argparse.ArgumentParser()
    parser.add_argument("build", type=pathlib.Path)
    parser.add_argument("--node-modules", type=pathlib.Path, default=pathlib.Path("none"))
    parser.add_argument("--sources", type=pathlib.Path, default=pathlib.Path("none"))
    parser.add_argument("--frames", action="store_true")
    parser.add_argument("--page")
    parser.add_argument("servers", nargs="*")
    at = parser.parse_intermixed_args(words)
    wanted = [server for server in SERVERS if server.__name__ in (at.servers or [each.__name__ for each in SERVERS])]
    there = []
    for server in wanted:
        if found := server(at):
            there.append(found)
        else:
            print(f"not there: {server.__name__}", file=sys.stderr)
    # Nearly all of the time is waiting.
    with concurrent.futures.ThreadPoolExecutor(len(there)) as pool:
        found = list(pool.map(lambda each: verdicts(at, each[1]), there))
    rows = [row_of(name, judgements) for (name, _), (judgements, _) in zip(there, found)]
    if at.page:
        return compared(rows, at.page)
    print(line_of(HEAD), line_of(["---"] * len(HEAD)), *map(line_of, rows), sep="\n")
    for (name, _), (judgements, starts) in zip(there, found):
        left = [row["clause"] for row in judgements if row["verdict"] == "not tried" and not row["why"]]
        print(f"{name}: started {starts} times{'; without a verdict: ' + ' '.join(left) if left else ''}", file=sys.stderr)
        for row in judgements if at.frames else ():
            if row["verdict"] == "fails":
                print(f"{name} {row['clause']} {row['level']}: {row['why']}\n    {row['frames']}")
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
