# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
"""Kills the demo's controller at some moment while it runs a simulated drive, which then has to stop by
itself within its time-out, and to stay stopped when the controller comes back.

    python3 killed_controller.py SIMULATE DEMO DRIVE MOMENT...

A moment is a text that the demo prints, or that and what the motor then comes to, in Hz: "Reverse below 10".
"""
import os
import subprocess
import sys
import time

from simulator import Checks, Registers, Simulator, asked, pymodbus_on

UNIT = 3
TTO = 10  # in 0.1 s
LIMIT = 60  # in seconds, for what has to happen


def words_of(device, *addresses):
    line = pymodbus_on(device)
    words = [asked(lambda each=each: line.read_holding_registers(each, 1, slave=UNIT)).registers[0]
             for each in addresses]
    line.close()
    return words


def demo(program, device, drive, *options):
    return subprocess.Popen([program, "--drive", drive, "--port", device, "--unit", str(UNIT),
                             "--svg", os.devnull, *options], stdout=subprocess.PIPE, text=True)


def kill_at(controller, moment, simulator):
    text, _, frequency = moment.partition(" below ")
    for line in controller.stdout:
        if text in line:
            while frequency and simulator.shown(UNIT)[1] >= float(frequency):
                time.sleep(0.01)
            controller.kill()
            return True
    return False


def stands(simulator):
    """Without a request, which would keep a drive running."""
    state, frequency, _ = simulator.shown(UNIT)
    return frequency == 0 and state != "operation enabled"


def is_stopped(device, at):
    frequency, status = words_of(device, at.rfr, at.eta)
    return frequency == 0 and status & 0x6F != 0x27


def main(simulate, program, drive, *moments):
    check = Checks()
    at = Registers(drive)
    for moment in moments:
        simulator = Simulator(simulate, f"{drive}:{UNIT}")
        with simulator as device:
            line = pymodbus_on(device)
            if at.tto:
                asked(lambda: line.write_register(at.tto, TTO, slave=UNIT))
            line.close()
            controller = demo(program, device, drive, "--allow-run")
            check(kill_at(controller, moment, simulator), f"killed at {moment}")
            controller.wait()
            time.sleep(TTO / 10 if at.tto else 7)
            check.soon(lambda: stands(simulator), "the drive stops by itself", LIMIT)
            check(is_stopped(device, at), "the motor stands")
            again = demo(program, device, drive)
            again.communicate(timeout=LIMIT)
            check(again.returncode == 0, "the controller is back")
            check(is_stopped(device, at), "and the motor still stands")
    return check.status()


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
