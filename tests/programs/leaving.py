# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
"""The demo tells what it leaves, which then happens; the next one looks first, and starts no motor of a drive in fault.

    python3 leaving.py SIMULATE DEMO
"""
import os
import pathlib
import subprocess
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "interop"))

from simulator import Checks, Simulator  # noqa: E402

LINK_FAULT = 5  # LFT: SLF1


def run(demo, device, *words):
    return subprocess.run([demo, "--drive", "atv12", "--port", device, "--svg", os.devnull, *words], stdin=subprocess.DEVNULL,
                          stdout=subprocess.PIPE, text=True, timeout=60, check=False)


def main(simulate, demo):
    check = Checks()
    simulator = Simulator(simulate, "atv12:1")
    with simulator as device:
        simulator.suffer("1 write 6005 30")  # TTO: 3.0 s
        first = run(demo, device)
        check(first.returncode == 0 and "trips (SLF)" in first.stdout and "-u 1 --write reset" in first.stdout,
              "it says what it leaves, and what resets it", first.stdout[-300:])
        check.soon(lambda: simulator.shown(1)[::2] == ("fault", LINK_FAULT), "and so it is: SLF1")
        second = run(demo, device)
        check(second.returncode == 0 and "in fault: SLF1" in second.stdout, "the next one says so, and reads on", second.stdout)
        third = run(demo, device, "--allow-run")
        check(third.returncode == 1 and "in fault: SLF1" in third.stdout and "Start" not in third.stdout,
              "and where it should run the motor, it leaves the drive alone", third.stdout)
        check(simulator.shown(1)[0] == "fault", "nothing was reset")
    return check.status()


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
