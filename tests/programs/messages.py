# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
"""What the demo says of its command line, and what it does with an output that takes nothing.

    python3 messages.py SIMULATE DEMO
"""
import os
import pathlib
import subprocess
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "interop"))

from simulator import DRIVES, Checks, Simulator  # noqa: E402

ALL_DRIVES = "|".join(DRIVES)

# Arguments, and what the message has to hold.
REFUSED = [
    ("--unit 248", ["unit 248", "atv320", "1 to 247"]),
    ("--unit 0", ["unit 0", "atv320", "1 to 247"]),
    ("--drive atv28 --unit 32", ["unit 32", "atv28", "1 to 31"]),
    ("--unit two", ["--unit two", "number"]),
    ("--drive atv99", ["atv99", ALL_DRIVES]),
    ("--speed 3", ["unknown flag --speed"]),
    ("now", ["unexpected word now"]),
    ("--unit", ["--unit needs a value"]),
    ("--port --allow-run", ["--port needs a value"]),
    ("--baud 12", ["--baud 12"]),
    ("--format 7E1", ["--format 7E1", "8E1"]),
]


def run(program, words, stdout=subprocess.PIPE):
    return subprocess.run([program, *words.split()], stdin=subprocess.DEVNULL, stdout=stdout,
                          stderr=subprocess.PIPE, text=True, timeout=60, check=False)


def check_refusals(demo, check):
    for words, parts in REFUSED:
        ended = run(demo, words)
        message = ended.stderr.splitlines()[0] if ended.stderr else ""
        is_named = message.startswith("demo: ") and all(part in message for part in parts)
        check(ended.returncode == 2 and not ended.stdout and is_named, f"demo {words}:", message)
        check("usage: demo" in ended.stderr, "and how it is used")


def check_help(demo, check):
    ended = run(demo, "--help")
    check(ended.returncode == 0 and not ended.stderr and ended.stdout.startswith("usage: demo "), "--help", ended.stdout)
    with open("/dev/full", "wb") as full:
        check(run(demo, "--help", stdout=full).returncode == 1, "--help into a full disk")


def check_drawing(demo, simulate, check):
    with Simulator(simulate, "atv12:1") as device, open(os.devnull, "rb") as nothing:
        ended = subprocess.run([demo, "--drive", "atv12", "--port", device, "--svg", "/dev/full"], stdin=nothing,
                               stdout=subprocess.PIPE, text=True, timeout=60, check=False)
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


def main(simulate, demo):
    check = Checks()
    check_refusals(demo, check)
    check_help(demo, check)
    check_drawing(demo, simulate, check)
    check_signs(simulate, check)
    return check.status()


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
