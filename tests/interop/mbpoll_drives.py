# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
"""mbpoll reads the monitoring registers of five simulated drives on one line, in turn, and brings each of
them to operation and back.

    python3 mbpoll_drives.py SIMULATE
"""
import re
import subprocess
import sys

from simulator import DRIVES, Checks, Registers, Simulator

LINE = ["-m", "rtu", "-b", "19200", "-P", "even", "-0", "-1", "-o", "5"]
ROUNDS = 3
LONG = 300  # in 0.1 s: a drive's own time-out, which must not end between two processes of a busy machine


def mbpoll(device, unit, start, count):
    done = subprocess.run(["mbpoll", *LINE, "-a", str(unit), "-r", str(start), "-c", str(count),
                           device], text=True, stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                          timeout=60, check=False)
    return {int(at): int(word) for at, word in re.findall(r"\[(\d+)\]: \t(\d+)", done.stdout)}


def write(device, unit, address, word):
    done = subprocess.run(["mbpoll", *LINE, "-a", str(unit), "-r", str(address), device, str(word)],
                          text=True, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, timeout=60,
                          check=False)
    return done.returncode == 0


def goes_up_and_down(device, unit, name, check):
    at = Registers(name)
    for word, mask, state in ((0x0006, 0x6F, 0x21), (0x0007, 0x6F, 0x23), (0x000F, 0x6F, 0x27),
                              (0x0007, 0x6F, 0x23), (0x0006, 0x6F, 0x21), (0x0000, 0x4F, 0x40)):
        is_written = write(device, unit, at.cmd, word)
        status = mbpoll(device, unit, at.eta, 1)
        is_right = is_written and status.get(at.eta, 0) & mask == state
        check(is_right, f"{name}: CMD {word:04X} leads to xx{state:02X}", status)


def main(program):
    check = Checks()
    drives = {unit: name for unit, name in enumerate(DRIVES, 1)}
    simulator = Simulator(program, *(f"{name}:{unit}" for unit, name in drives.items()))
    with simulator as device:
        for unit, name in drives.items():
            if Registers(name).tto:
                simulator.suffer(f"{unit} write {Registers(name).tto} {LONG}")
        for _ in range(ROUNDS):
            for unit, name in drives.items():
                at = Registers(name)
                words = mbpoll(device, unit, *at.monitoring)
                is_whole = len(words) == at.monitoring[1] and words[at.rfr] == 0
                status = mbpoll(device, unit, at.eta, 1)
                is_right = is_whole and status[at.eta] & 0x4F == 0x40
                check(is_right, f"{name} at unit {unit}", words)
        for unit, name in drives.items():
            # Others were asked meanwhile: a drive that is switched on again expects nobody yet.
            simulator.suffer(f"{unit} cycle")
            check.soon(lambda at=unit: simulator.shown(at)[0] == "switch on disabled", f"{name} is ready for a start", 20)
            goes_up_and_down(device, unit, name, check)
        check(mbpoll(device, 9, 3201, 1) == {}, "nobody at unit 9")
    return check.status()


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
