# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
"""mbpoll reads the monitoring registers of five simulated drives on one line, in turn.

    python3 mbpoll_drives.py SIMULATE
"""
import re
import subprocess
import sys

from simulator import DRIVES, Checks, Registers, Simulator

LINE = ["-m", "rtu", "-b", "19200", "-P", "even", "-0", "-1", "-o", "0.5"]
ROUNDS = 3


def mbpoll(device, unit, start, count):
    done = subprocess.run(["mbpoll", *LINE, "-a", str(unit), "-r", str(start), "-c", str(count),
                           device], text=True, stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                          timeout=20, check=False)
    return {int(at): int(word) for at, word in re.findall(r"\[(\d+)\]: \t(\d+)", done.stdout)}


def main(program):
    check = Checks()
    drives = {unit: name for unit, name in enumerate(DRIVES, 1)}
    with Simulator(program, *(f"{name}:{unit}" for unit, name in drives.items())) as device:
        for _ in range(ROUNDS):
            for unit, name in drives.items():
                at = Registers(name)
                words = mbpoll(device, unit, *at.monitoring)
                is_whole = len(words) == at.monitoring[1] and words[at.rfr] == 0
                status = mbpoll(device, unit, at.eta, 1)
                is_right = is_whole and status[at.eta] & 0x4F == 0x40
                check(is_right, f"{name} at unit {unit}", words)
        check(mbpoll(device, 9, 3201, 1) == {}, "nobody at unit 9")
    return check.status()


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
