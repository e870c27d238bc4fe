# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
"""Lets the demo run a simulated motor, and ends it in one of the ways in which a program ends: the motor stands
before the program is gone.

    python3 ways_out.py SIMULATE DEMO DRIVE WAY

A way is a signal (HUP, TSTP...), or one of: head, full, terminal, nobody, twice. With the program `breaks` in place
of the demo: throw, missing, deep.
"""
import fcntl
import os
import pty
import resource
import signal
import subprocess
import sys
import tempfile
import termios

from controller import LIMIT, UNIT, Checks, Drive, demo, own_group, soon

DYING = ("ABRT", "SEGV", "BUS", "FPE", "ILL")  # too late for a ramp: the motor is left without power
HEAD_LINES = 17  # the demo's output up to where the motor has turned for a second
FILE_LIMIT = 900  # bytes, likewise


def end(process, check):
    """Its status, once it is gone."""
    try:
        process.communicate(timeout=LIMIT)
    except subprocess.TimeoutExpired:
        process.kill()
        check(False, "it ends")
    return process.returncode


def by_signal(program, drive, name, check):
    number = getattr(signal, "SIG" + name)
    process = demo(program, drive)
    check(soon(drive.turns), "the motor turns")
    process.send_signal(number)
    status = end(process, check)
    if name in DYING:
        check(drive.has_no_power(), "no power when the program is gone", drive.shown())
        check(soon(drive.stands), "the motor stands")
        check(status == -number, "the signal ends it", status)
    else:
        check(drive.stands(), "the motor stands when the program is gone", drive.shown())
        check(status == 128 + number, "its status tells the signal", status)


def by_suspension(program, drive, check):
    process = demo(program, drive)
    check(soon(drive.turns), "the motor turns")
    process.send_signal(signal.SIGTSTP)
    _, status = os.waitpid(process.pid, os.WUNTRACED)
    check(os.WIFSTOPPED(status), "it is suspended")
    check(drive.stands(), "the motor stands by then", drive.shown())
    process.send_signal(signal.SIGCONT)
    check(end(process, check) == 1, "it goes on to its end")
    check(drive.stands(), "and the motor still stands", drive.shown())


def by_head(program, drive, check):
    head = subprocess.Popen(["head", "-n", str(HEAD_LINES)], stdin=subprocess.PIPE, stdout=subprocess.DEVNULL)
    process = demo(program, drive, stdout=head.stdin)
    head.stdin.close()
    check(soon(drive.turns), "the motor turns")
    check(end(process, check) == 1, "it ends with an error", process.returncode)
    check(drive.stands(), "the motor stands when the program is gone", drive.shown())
    head.wait()


def by_a_full_disk(program, drive, check):
    def limited():
        own_group()
        resource.setrlimit(resource.RLIMIT_FSIZE, (FILE_LIMIT, FILE_LIMIT))

    with tempfile.TemporaryFile() as file:
        process = demo(program, drive, stdout=file, before=limited)
        check(soon(drive.turns), "the motor turns")
        check(end(process, check) == 1, "it ends with an error", process.returncode)
    check(drive.stands(), "the motor stands when the program is gone", drive.shown())


def by_its_terminal(program, drive, check):
    near, far = pty.openpty()

    def on_the_terminal():
        os.setsid()
        fcntl.ioctl(far, termios.TIOCSCTTY, 0)

    process = demo(program, drive, stdout=far, stderr=far, before=on_the_terminal)
    os.close(far)
    check(soon(drive.turns), "the motor turns")
    os.close(near)
    check(end(process, check) == 128 + signal.SIGHUP, "its status tells the signal", process.returncode)
    check(drive.stands(), "the motor stands when the program is gone", drive.shown())


def with_nobody_listening(program, drive, check):
    for what, name in (("a full disk", "/dev/full"), ("nothing", None)):
        def closed(is_closed=name is None):
            own_group()
            if is_closed:
                os.close(1)

        with open(name or os.devnull, "wb") as out:
            process = demo(program, drive, stdout=out, before=closed)
            turned = soon(lambda one=process: drive.turns() or one.poll() is not None) and drive.turns()
            check(end(process, check) == 1, f"{what}: it ends with an error", process.returncode)
        check(not turned and drive.stands(), f"{what}: the motor never turns", drive.shown())


def by_two_interrupts(program, drive, check):
    process = demo(program, drive)
    check(soon(drive.turns), "the motor turns")
    process.send_signal(signal.SIGINT)
    check(soon(lambda: drive.shown()[0] != "operation enabled"), "the ramp has begun")
    process.send_signal(signal.SIGINT)
    check(end(process, check) == 128 + signal.SIGINT, "its status tells the signal", process.returncode)
    check(drive.has_no_power(), "no power when the program is gone", drive.shown())


def by_breaking(program, drive, how, check):
    process = subprocess.Popen([program, drive.device, str(UNIT), how], stdin=subprocess.DEVNULL,
                               stdout=subprocess.PIPE, stderr=subprocess.PIPE, preexec_fn=own_group)
    drive.controllers.append(process)
    check(soon(drive.turns), "the motor turns")
    status = end(process, check)
    check(drive.has_no_power(), "no power when the program is gone", drive.shown())
    check(soon(drive.stands), "the motor stands")
    check(status < 0, "a signal ends it", status)


BROKEN = ("throw", "missing", "deep")
WAYS = {"TSTP": by_suspension, "head": by_head, "full": by_a_full_disk, "terminal": by_its_terminal,
        "nobody": with_nobody_listening, "twice": by_two_interrupts}


def main(simulate, program, name, way):
    check = Checks()
    with Drive(simulate, name) as drive:
        if way in WAYS:
            WAYS[way](program, drive, check)
        elif way in BROKEN:
            by_breaking(program, drive, way, check)
        else:
            by_signal(program, drive, way, check)
    return check.status()


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
