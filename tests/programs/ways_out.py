# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
"""Lets the demo run a simulated motor, and ends it in one of the ways in which a program ends: the motor stands
before the program is gone.

    python3 ways_out.py SIMULATE DEMO DRIVE WAY

A way is a signal (HUP, TSTP...), or one of: head, full, terminal, nobody, twice. With the program `breaks` in place
of the demo: throw, missing, deep.
"""
import os
import resource
import signal
import subprocess
import tempfile

from controller import UNIT, Drive, closing, demo, gone, own_group, own_terminal, runs, soon, turning

DYING = ("ABRT", "SEGV", "BUS", "FPE", "ILL")  # too late for a ramp: the motor is left without power
HEAD_LINES = 17  # the demo's output up to where the motor has turned for a second
FILE_LIMIT = 900  # bytes, likewise


def by_signal(program, drive, name, check):
    number = getattr(signal, "SIG" + name)
    process = turning(program, drive, check)
    process.send_signal(number)
    if name in DYING:
        gone(process, drive, check, -number, drive.has_no_power)
        check(soon(drive.stands), "the motor stands")
    else:
        gone(process, drive, check, 128 + number)


def by_suspension(program, drive, check):
    process = turning(program, drive, check)
    process.send_signal(signal.SIGTSTP)
    _, status = os.waitpid(process.pid, os.WUNTRACED)
    check(os.WIFSTOPPED(status), "it is suspended")
    check(drive.stands(), "the motor stands by then", drive.shown())
    process.send_signal(signal.SIGCONT)
    gone(process, drive, check, 1)


def by_head(program, drive, check):
    head = subprocess.Popen(["head", "-n", str(HEAD_LINES)], stdin=subprocess.PIPE, stdout=subprocess.DEVNULL)
    process = demo(program, drive, stdout=head.stdin)
    head.stdin.close()
    check(soon(drive.turns), "the motor turns")
    gone(process, drive, check, 1)
    head.wait()


def by_a_full_disk(program, drive, check):
    def limited():
        own_group()
        resource.setrlimit(resource.RLIMIT_FSIZE, (FILE_LIMIT, FILE_LIMIT))

    with tempfile.TemporaryFile() as file:
        gone(turning(program, drive, check, stdout=file, before=limited), drive, check, 1)


def by_its_terminal(program, drive, check):
    near, far = os.openpty()
    process = demo(program, drive, stdout=far, stderr=far, before=own_terminal(far))
    os.close(far)
    check(soon(drive.turns), "the motor turns")
    os.close(near)
    gone(process, drive, check, 128 + signal.SIGHUP)


def with_nobody_listening(program, drive, check):
    for what, name in (("a full disk", "/dev/full"), ("nothing", None)):
        with open(name or os.devnull, "wb") as out:
            process = demo(program, drive, stdout=out, before=closing([] if name else [1]))
            turned = soon(lambda one=process: drive.turns() or one.poll() is not None) and drive.turns()
            gone(process, drive, check, 1)
        check(not turned, f"{what}: the motor never turns", drive.shown())


def by_two_interrupts(program, drive, check):
    process = turning(program, drive, check)
    process.send_signal(signal.SIGINT)
    check(soon(lambda: drive.shown()[0] != "operation enabled"), "the ramp has begun")
    process.send_signal(signal.SIGINT)
    gone(process, drive, check, 128 + signal.SIGINT, drive.has_no_power)


def by_breaking(program, drive, how, check):
    process = subprocess.Popen([program, drive.device, str(UNIT), how], stdin=subprocess.DEVNULL,
                               stdout=subprocess.PIPE, stderr=subprocess.PIPE, preexec_fn=own_group)
    drive.controllers.append(process)
    check(soon(drive.turns), "the motor turns")
    gone(process, drive, check, None, drive.has_no_power)
    check(soon(drive.stands), "the motor stands")


BROKEN = ("throw", "missing", "deep")
WAYS = {"TSTP": by_suspension, "head": by_head, "full": by_a_full_disk, "terminal": by_its_terminal,
        "nobody": with_nobody_listening, "twice": by_two_interrupts}


def main(check, simulate, program, name, way):
    with Drive(simulate, name) as drive:
        if way in WAYS:
            WAYS[way](program, drive, check)
        elif way in BROKEN:
            by_breaking(program, drive, way, check)
        else:
            by_signal(program, drive, way, check)


runs(main)
