# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
"""Runs the demo as a process of its own against a drive of `simulate`, which tells what its motor does."""
import fcntl
import os
import pathlib
import signal
import subprocess
import sys
import termios

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "interop"))

from simulator import DRIVES, Registers, Simulator, runs, soon  # noqa: E402,F401

UNIT = 3
TTO = 300  # in 0.1 s: the drive's own time-out comes too late to be taken for a stop by the program
LIMIT = 60  # in seconds, for what has to happen
SMALLEST_PIPE = 4096  # bytes

DISABLED = "switch on disabled"
RUNS = "operation enabled"


def signals_by_default():
    for each in (signal.SIGHUP, signal.SIGINT, signal.SIGQUIT, signal.SIGTERM, signal.SIGTSTP, signal.SIGPIPE):
        signal.signal(each, signal.SIG_DFL)


def own_group(*ignored):
    """What a shell does for a command: a process group of its own, and the signals as they are by default but for some."""
    os.setpgid(0, 0)
    signals_by_default()
    for each in ignored:
        signal.signal(each, signal.SIG_IGN)


def own_terminal(far, *ignored):
    """What a window does for a command that it is closed with; the signals as they are by default but for some."""
    def before():
        os.setsid()
        fcntl.ioctl(far, termios.TIOCSCTTY, 0)
        signals_by_default()
        for each in ignored:
            signal.signal(each, signal.SIG_IGN)

    return before


def closing(numbers):
    """The same, without these descriptors."""
    def before():
        own_group()
        for each in numbers:
            os.close(each)

    return before


def full_pipe():
    """The reader's end, and that of a writer which has to wait."""
    reader, writer = os.pipe()
    os.write(writer, bytes(fcntl.fcntl(writer, fcntl.F_SETPIPE_SZ, SMALLEST_PIPE)))
    return reader, writer


class Drive:
    """with Drive(simulate, "atv320") as drive: one simulated drive, and what it does."""

    def __init__(self, program, name):
        self.name = name
        self.simulator = Simulator(program, f"{name}:{UNIT}")
        self.controllers = []

    def __enter__(self):
        self.device = self.simulator.__enter__()
        at = Registers(self.name)
        if at.tto:
            self.simulator.suffer(f"{UNIT} write {at.tto} {TTO}")
        return self

    def __exit__(self, *_):
        for each in self.controllers:
            if each.poll() is None:
                each.kill()
                each.wait()
        self.simulator.__exit__()

    def shown(self):
        return self.simulator.shown(UNIT)

    def turns(self):
        state, frequency, _ = self.shown()
        return state == RUNS and frequency > 10

    def turns_back(self):
        return self.shown()[1] < -10

    def stands(self):
        """Not because the drive itself gave up: a fault would show."""
        return self.shown() == (DISABLED, 0, 0)

    def has_no_power(self):
        state, _, fault = self.shown()
        return state == DISABLED and fault == 0


def demo(program, drive, *options, stdout=subprocess.PIPE, stderr=subprocess.PIPE, before=own_group):
    drive.controllers.append(subprocess.Popen(
        [program, "--drive", drive.name, "--port", drive.device, "--unit", str(UNIT), "--svg", os.devnull,
         "--allow-run", *options], stdin=subprocess.DEVNULL, stdout=stdout, stderr=stderr, preexec_fn=before))
    return drive.controllers[-1]


def turning(program, drive, check, **how):
    """The demo, once its motor turns."""
    process = demo(program, drive, **how)
    check(soon(drive.turns), "the motor turns")
    return process


def gone(process, drive, check, status, is_at_rest=None):
    """What it said, once it is gone: with this status, or None for any signal. It leaves the motor standing, or as is said."""
    try:
        said = process.communicate(timeout=LIMIT)
    except subprocess.TimeoutExpired:
        process.kill()
        said = process.communicate()
        check(False, "it ends")
    check((is_at_rest or drive.stands)(), "the motor is at rest when the program is gone", drive.shown())
    found = process.returncode
    check(found < 0 if status is None else found == status, f"its status: {status or 'a signal'}", found)
    return said
