# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
"""What the programs say of their command lines, and what they do with an output that takes nothing.

    python3 messages.py SIMULATE DEMO LIST_REGISTERS
"""
import csv
import io
import os
import pathlib
import subprocess
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "interop"))

from simulator import DRIVES, Checks, Simulator  # noqa: E402

ALL_DRIVES = "|".join(DRIVES)

# Program, arguments, and what the message has to hold.
REFUSED = [
    ("demo", "--unit 248", ["unit 248", "atv320", "1 to 247"]),
    ("demo", "--unit 0", ["unit 0", "atv320", "1 to 247"]),
    ("demo", "--drive atv28 --unit 32", ["unit 32", "atv28", "1 to 31"]),
    ("demo", "--unit two", ["--unit two", "number"]),
    ("demo", "--drive atv99", ["atv99", ALL_DRIVES]),
    ("demo", "--speed 3", ["unknown flag --speed"]),
    ("demo", "now", ["unexpected word now"]),
    ("demo", "--unit", ["--unit needs a value"]),
    ("demo", "--port --allow-run", ["--port needs a value"]),
    ("demo", "--baud 12345", ["--baud 12345"]),
    ("demo", "--format 7E1", ["--format 7E1", "8E1"]),
    ("simulate", "--drive atv28:99", ["unit 99", "atv28", "1 to 31"]),
    ("simulate", "--drive atv320:2 --drive atv28:2", ["unit 2", "twice"]),
    ("simulate", "--drive atv99:1", ["atv99", ALL_DRIVES]),
    ("simulate", "--drive atv320:", ["--drive atv320:", "unit"]),
    ("simulate", "--drives atv320", ["unknown flag --drives"]),
    ("simulate", "--vendor", ["--vendor needs a value"]),
    ("simulate", "--vendor " + 64 * "x", ["--vendor", "63"]),
    ("list_registers", "--drive atv99", ["atv99", ALL_DRIVES]),
    ("list_registers", "--drive", ["--drive needs a value"]),
    ("list_registers", "--cvs", ["unknown flag --cvs"]),
]
COLUMNS = 10


def run(program, words, stdout=subprocess.PIPE):
    return subprocess.run([program, *words.split()], stdin=subprocess.DEVNULL, stdout=stdout,
                          stderr=subprocess.PIPE, text=True, timeout=20, check=False)


def check_refusals(programs, check):
    for name, words, parts in REFUSED:
        ended = run(programs[name], words)
        message = ended.stderr.splitlines()[0] if ended.stderr else ""
        is_named = message.startswith(name + ": ") and all(part in message for part in parts)
        check(ended.returncode == 2 and not ended.stdout and is_named, f"{name} {words}:", message)
        check("usage: " + name in ended.stderr, "and how it is used")


def check_help(programs, check):
    for name, program in programs.items():
        ended = run(program, "--help")
        check(ended.returncode == 0 and not ended.stderr and ended.stdout.startswith(f"usage: {name} "),
              f"{name} --help", ended.stdout)
        with open("/dev/full", "wb") as full:
            check(run(program, "--help", stdout=full).returncode == 1, f"{name} --help into a full disk")


def check_lists(program, check):
    for drive in DRIVES:
        rows = list(csv.reader(io.StringIO(run(program, f"--drive {drive} --csv").stdout), strict=True))
        check(len(rows) > 20 and all(len(row) == COLUMNS for row in rows), f"{drive} as a table of {COLUMNS} columns")
        check(len({row[0] for row in rows}) == len(rows), "each code once")
    for words in ("", "--csv"):
        with open("/dev/full", "wb") as full:
            ended = run(program, words, stdout=full)
        check(ended.returncode == 1 and "standard output" in ended.stderr, "a full disk is a failure", ended.stderr)
    ended = subprocess.run(["sh", "-c", '"$0" >&-', program], stderr=subprocess.PIPE, text=True, check=False)
    check(ended.returncode == 1 and "standard output" in ended.stderr, "a closed output, too", ended.stderr)


def check_drawing(demo, simulate, check):
    with Simulator(simulate, "atv12:1") as device, open(os.devnull, "rb") as nothing:
        ended = subprocess.run([demo, "--drive", "atv12", "--port", device, "--svg", "/dev/full"], stdin=nothing,
                               stdout=subprocess.PIPE, text=True, timeout=20, check=False)
    check(ended.returncode == 1 and "NO drawing could be written to /dev/full" in ended.stdout,
          "a drawing that cannot be written is a failure", ended.returncode)


def check_signs(program, check):
    """A motor that turns backwards is shown with its sign, also below one hertz."""
    simulator = Simulator(program, "atv320:1")
    with simulator:
        for word in (0x0006, 0x0007):
            simulator.suffer(f"1 write 8501 {word}")
        seen = set()
        simulator.suffer(f"1 write 8502 {0x10000 - 5}")
        simulator.suffer("1 write 8501 15")
        check.soon(lambda: seen.add(simulator.shown(1)[1]) or -0.5 in seen, "-0.5 Hz is shown")
        check(max(seen) <= 0, "and nothing above zero before", sorted(seen))


def main(simulate, demo, list_registers):
    check = Checks()
    programs = {"demo": demo, "simulate": simulate, "list_registers": list_registers}
    check_refusals(programs, check)
    check_help(programs, check)
    check_lists(list_registers, check)
    check_drawing(demo, simulate, check)
    check_signs(simulate, check)
    return check.status()


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
