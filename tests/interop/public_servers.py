# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
"""What `rtuwire check` says of public servers and clients, as the tables of docs/public-servers.md; public_servers.sh, which builds
and fetches all of them, calls it.

    python3 public_servers.py BUILD [--node-modules FOLDER] [--sources FOLDER] [--clients] [--frames] [--page FILE] [LIBRARY...]

BUILD has the tool and the programs that CMake builds; FOLDER of --node-modules has the npm packages, that of --sources the programs
nanomodbus_server, nanomodbus_client and freemodbus_server. What is not there is left out, and named. --clients leaves out the
servers, --frames shows the frames of what fails. With --page nothing is printed but what that page says otherwise, and the status
says whether there is any; a version that the page does not have is left out there.
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
import shutil
import subprocess
import sys

from pair import Programs

HERE = pathlib.Path(__file__).resolve().parent
COUNT = 128  # of each space, from address 0
KINDS = ("server", "client")
ALL = ["--no-listen", "-d", "none", "--write", "--timeout", "0.7"]  # of which a server may take 500 ms before it refuses
ALONE_AT_ONCE = 4
CHECK = ["check", "--scratch", f"{COUNT - 8}-{COUNT - 1}", "--scratch-coils", f"{COUNT - 16}-{COUNT - 1}", "--alone", "--disruptive"]
CHECK_CLIENT = ["--timeout", "1", "check", "--client", "--"]  # pymodbus takes whole seconds


# One function a library: its name with its version, the command of its server, in which @ stands for the device, and that of its
# client, behind which the check puts its words; nothing where it is not there.
def ours(at):
    return "rtuwire", [at.interop / "public_rtuwire_server", "@"], [at.interop / "checked_ours"]


def libmodbus(at):
    version = subprocess.run(["pkg-config", "--modversion", "libmodbus"], capture_output=True, text=True, check=False).stdout.strip()
    return f"libmodbus {version}", [at.interop / "memory_libmodbus", "@", "0", COUNT, "usual"], [at.interop / "checked_libmodbus"]


def pymodbus(_):
    try:
        version = importlib.metadata.version("pymodbus")
    except importlib.metadata.PackageNotFoundError:
        return None
    return (f"pymodbus {version}", [sys.executable, "-B", HERE / "memory_pymodbus.py", "@", "0", COUNT],
            [sys.executable, "-B", "-c", client_of_page()])


def client_of_page():
    """The client of pymodbus that docs/tool.md shows."""
    text = (HERE.parents[1] / "docs/tool.md").read_text(encoding="utf-8").partition("\n## Check a client\n")[2]
    return re.search(r"```python\n(.*?)```", text, re.DOTALL)[1]


def of_npm(at, name):
    told = at.node_modules / name / "package.json"
    return (f"{name} {json.loads(told.read_text(encoding='utf-8'))['version']}",
            ["node", HERE / "memory_npm.js", name, "@", "0", COUNT, "usual"],
            ["node", HERE / "checked_npm.js", name]) if told.exists() else None


def modbus_serial(at):
    return of_npm(at, "modbus-serial")


def jsmodbus(at):
    return of_npm(at, "jsmodbus")


def of_source(at, name, has_client):
    """Beside a program stands the commit that it is of."""
    programs = [at.sources / f"{name.lower()}_{kind}" for kind in KINDS]
    commit = programs[0].with_suffix(".commit")
    return (f"{name} {commit.read_text(encoding='ascii')[:7]}", [programs[0], "@"],
            [programs[1]] if has_client else None) if commit.exists() else None


def nanomodbus(at):
    return of_source(at, "nanoMODBUS", True)


def freemodbus(at):
    return of_source(at, "FreeMODBUS", False)


LIBRARIES = (ours, libmodbus, pymodbus, modbus_serial, jsmodbus, nanomodbus, freemodbus)


def head(kind):
    return (kind, "musts that hold", "shoulds that hold", "musts that fail", "shoulds that fail")


def tool(at, *words):
    return subprocess.run([at.build / "tools" / "rtuwire" / "rtuwire", "--csv", *map(str, words)], capture_output=True, text=True,
                          env=with_packages(at), check=False)


def with_packages(at):
    return {**os.environ, "NODE_PATH": str(at.node_modules)}


def rows_in(text):
    return list(csv.DictReader(io.StringIO(text)))


def is_missed(row):
    return row["verdict"] == "not tried" and row["why"].startswith("no known state")


def judged(at, command, only):
    """By clause what one run says, of those for which the server came to a known state."""
    with Programs() as others:
        near, far = others.line()
        others.serve(near, [str(word) for word in command], stdin=subprocess.PIPE, stderr=subprocess.DEVNULL,
                     env=with_packages(at))
        ended = tool(at, "--port", far, "--unit", "1", *ALL, *CHECK, "--only", ",".join(only))
    return {row["clause"]: row for row in rows_in(ended.stdout) if not is_missed(row)}


def verdicts_of_server(at, command):
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


def verdicts_of_client(at, command):
    """It is started again for each clause by the check itself."""
    rows = rows_in(tool(at, *CHECK_CLIENT, *command).stdout)
    return rows, len(rows)


VERDICTS = {"server": verdicts_of_server, "client": verdicts_of_client}


def row_of(name, rows):
    def ids(level, *wanted):
        return [row["clause"] for row in rows if row["level"] == level and row["verdict"] in wanted]
    def held(level):
        return f"{len(ids(level, 'holds'))} of {len(ids(level, 'holds', 'fails'))}"
    return (name, held("must"), held("should"), " ".join(ids("must", "fails")) or "none", " ".join(ids("should", "fails")) or "none")


def line_of(cells):
    return "| " + " | ".join(cells) + " |"


def of_page(text, kind):
    """The rows of the servers' table, or the clients', by name."""
    lines = text.splitlines()
    start = lines.index(line_of(head(kind))) + 2
    rows = [re.split(r" \| ", line[2:-2]) for line in lines[start:lines.index("", start)]]
    return {row[0]: tuple(row) for row in rows}


def compared(at, kind, rows, commands):
    """Whether there are some that the page has, and none of them otherwise. A client that a busy machine keeps from asking looks as if
    it waited, and a server as if it were late: what differs is asked once more, alone, and that is said."""
    told = of_page(pathlib.Path(at.page).read_text(encoding="utf-8"), kind)
    compares = [row for row in rows if row[0] in told]
    for row in rows:
        if row[0] not in told:
            print(f"left out: {at.page} does not have the {kind} {row[0]}, but: {', '.join(told)}")
    same = bool(compares)
    for row in compares:
        if row != told[row[0]]:
            print(f"once more, alone: the {kind} {line_of(row)}")
            row = row_of(row[0], VERDICTS[kind](at, commands[row[0]])[0])
        if row != told[row[0]]:
            same = False
            print(f"{at.page}: the {kind} {row[0]}\n  the page: {line_of(told[row[0]])}\n  the check: {line_of(row)}")
    print(f"{len(compares)} {kind}s compared")
    return same


def those_there(at, libraries, kinds):
    """By kind the name and the command of each."""
    found = {kind: [] for kind in kinds}
    for library in libraries:
        name, *commands = library(at) or [library.__name__]
        for kind, command in zip(KINDS, commands):
            if kind in kinds and command is not None and shutil.which(command[0]):
                found[kind].append((name, command))
        if not commands or any(command is not None and not shutil.which(command[0]) for command in commands):
            print(f"not there: {library.__name__}", file=sys.stderr)
    return found


def main(words):
    parser = argparse.ArgumentParser()
    parser.add_argument("build", type=pathlib.Path)
    parser.add_argument("--node-modules", type=pathlib.Path, default=pathlib.Path("none"))
    parser.add_argument("--sources", type=pathlib.Path, default=pathlib.Path("none"))
    parser.add_argument("--clients", action="store_true")
    parser.add_argument("--frames", action="store_true")
    parser.add_argument("--page")
    parser.add_argument("libraries", nargs="*")
    at = parser.parse_intermixed_args(words)
    at.interop = at.build / "tests" / "interop"
    libraries = [each for each in LIBRARIES if each.__name__ in (at.libraries or [each.__name__ for each in LIBRARIES])]
    there = those_there(at, libraries, KINDS[1:] if at.clients else KINDS)
    # Nearly all of the time is waiting.
    with concurrent.futures.ThreadPoolExecutor(sum(map(len, there.values())) or 1) as pool:
        begun = {kind: [(name, pool.submit(VERDICTS[kind], at, command)) for name, command in each] for kind, each in there.items()}
        found = {kind: [(name, *judging.result()) for name, judging in each] for kind, each in begun.items()}
    rows = {kind: [row_of(name, judgements) for name, judgements, _ in each] for kind, each in found.items()}
    if at.page:
        # Not every library has a client.
        same = [compared(at, kind, each, dict(there[kind])) for kind, each in rows.items() if each]
        return 0 if same and all(same) else 1
    for kind, each in rows.items():
        print(line_of(head(kind)), line_of(["---"] * len(head(kind))), *map(line_of, each), "", sep="\n")
        for told in found[kind]:
            tell(kind, *told, at.frames)
    return 0


def tell(kind, name, judgements, starts, with_frames):
    left = [row["clause"] for row in judgements if row["verdict"] == "not tried" and not row["why"]]
    print(f"{name}, {kind}: started {starts} times{'; without a verdict: ' + ' '.join(left) if left else ''}", file=sys.stderr)
    for row in judgements if with_frames else ():
        if row["verdict"] == "fails":
            print(f"{name} {row['clause']} {row['level']}: {row['why']}\n    {row['frames']}")


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
